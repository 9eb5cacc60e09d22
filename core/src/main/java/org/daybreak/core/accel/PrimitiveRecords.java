package org.daybreak.core.accel;

/**
 * Bounds and numbers of the primitives to build over, one record of eight floats each, so that partitioning moves
 * whole cache-line halves instead of chasing indices: minimum x, y, z, number (as int bits), maximum x, y, z, unused.
 *
 * <p>Coordinates are multiplied by a power of two that brings the largest one into [0.5, 1]. That is exact, and it keeps
 * products of coordinates in the range of single precision whatever the unit of the scene.
 */
final class PrimitiveRecords {
    static final int STRIDE = 8;

    /** Eight floats for each record, and 2³¹ − 1 elements at most in an array. */
    static final int MAX_COUNT = 1 << 27;

    final float[] data;
    final int count;

    /** The power of two by which coordinates were multiplied. */
    final double scale;

    /** Scaled bounds of everything; minimum +∞ and maximum −∞ if there is nothing. */
    final float[] bounds;

    final PrimitiveSet set;

    private PrimitiveRecords(PrimitiveSet set, float[] data, int count, double scale, float[] bounds) {
        this.set = set;
        this.data = data;
        this.count = count;
        this.scale = scale;
        this.bounds = bounds;
    }

    /** Triangles of no area and empty instances get no record: no ray can hit them. */
    static PrimitiveRecords of(PrimitiveSet set) {
        int size = set.size();
        if (size > MAX_COUNT) {
            throw new IllegalArgumentException(
                    "too many primitives for one index: " + size + ", the limit is " + MAX_COUNT);
        }
        checkVertices(set.positions());
        float[] data = new float[STRIDE * size];
        int end = addTriangles(set, data);
        end = addOthers(set, data, end);
        int count = end / STRIDE;
        float[] bounds = bounds(data, end);
        double scale = scaleFor(bounds);
        if (scale != 1) {
            float factor = (float) scale;
            double exact = scale;
            boolean representable = factor == exact && factor != 0;
            for (int i = 0; i < end; i++) {
                if ((i & 3) != 3) {
                    data[i] = representable ? data[i] * factor : (float) (data[i] * exact);
                }
            }
            for (int i = 0; i < 6; i++) {
                bounds[i] = (float) (bounds[i] * exact);
            }
        }
        return new PrimitiveRecords(set, data, count, scale, bounds);
    }

    /** Number of the primitive in a record. */
    int number(int record) {
        return Float.floatToRawIntBits(data[STRIDE * record + 3]);
    }

    /** Scaled coordinate of a vertex. */
    static float scaled(float coordinate, double scale) {
        return (float) (coordinate * scale);
    }

    private static void checkVertices(float[] positions) {
        float sum = 0;
        for (float p : positions) {
            sum += p * 0;
        }
        if (sum == 0) {
            return;
        }
        for (int i = 0; i < positions.length; i++) {
            if (!Float.isFinite(positions[i])) {
                throw new IllegalArgumentException(
                        "vertex " + i / 3 + " has the coordinate " + "xyz".charAt(i % 3) + " = " + positions[i]);
            }
        }
    }

    private static int addTriangles(PrimitiveSet set, float[] data) {
        float[] p = set.positions();
        int[] corners = set.triangles();
        int vertexCount = p.length / 3;
        int at = 0;
        for (int i = 0; i < corners.length; i += 3) {
            int a = corners[i];
            int b = corners[i + 1];
            int c = corners[i + 2];
            if (Integer.compareUnsigned(a, vertexCount) >= 0
                    || Integer.compareUnsigned(b, vertexCount) >= 0
                    || Integer.compareUnsigned(c, vertexCount) >= 0) {
                throw new IllegalArgumentException("triangle " + i / 3 + " has the corners " + a + ", " + b + ", " + c
                        + " but there are " + vertexCount + " vertices");
            }
            a *= 3;
            b *= 3;
            c *= 3;
            float ax = p[a];
            float ay = p[a + 1];
            float az = p[a + 2];
            float bx = p[b];
            float by = p[b + 1];
            float bz = p[b + 2];
            float cx = p[c];
            float cy = p[c + 1];
            float cz = p[c + 2];
            if (hasNoArea(ax, ay, az, bx, by, bz, cx, cy, cz)) {
                continue;
            }
            data[at] = Math.min(ax, Math.min(bx, cx));
            data[at + 1] = Math.min(ay, Math.min(by, cy));
            data[at + 2] = Math.min(az, Math.min(bz, cz));
            data[at + 3] = Float.intBitsToFloat(i / 3);
            data[at + 4] = Math.max(ax, Math.max(bx, cx));
            data[at + 5] = Math.max(ay, Math.max(by, cy));
            data[at + 6] = Math.max(az, Math.max(bz, cz));
            at += STRIDE;
        }
        return at;
    }

    /**
     * Whether the corners lie on a line. Differences of floats are exact in double (up to extreme ratios of exponents)
     * and their products carry 2⁻⁵³ relative error, so a true zero stays below this bound and a triangle above it is
     * at least 2⁻⁴⁸ times as high as long.
     */
    private static boolean hasNoArea(
            double ax, double ay, double az, double bx, double by, double bz, double cx, double cy, double cz) {
        double ux = bx - ax;
        double uy = by - ay;
        double uz = bz - az;
        double vx = cx - ax;
        double vy = cy - ay;
        double vz = cz - az;
        return isZeroDifference(uy * vz, uz * vy)
                && isZeroDifference(uz * vx, ux * vz)
                && isZeroDifference(ux * vy, uy * vx);
    }

    private static boolean isZeroDifference(double a, double b) {
        return Math.abs(a - b) <= 0x1p-48 * (Math.abs(a) + Math.abs(b));
    }

    private static int addOthers(PrimitiveSet set, float[] data, int start) {
        int at = start;
        int triangles = set.triangleCount();
        double[] box = new double[6];
        for (int i = 0; i < set.quadricCount() + set.instanceCount(); i++) {
            boolean quadric = i < set.quadricCount();
            if (quadric) {
                set.quadric(i).bounds(box);
            } else {
                set.instance(i - set.quadricCount()).bounds(box);
            }
            if (!(box[0] <= box[3])) {
                continue;
            }
            for (int axis = 0; axis < 3; axis++) {
                data[at + axis] = Affine.roundDown(box[axis]);
                data[at + 4 + axis] = Affine.roundUp(box[axis + 3]);
                if (!Float.isFinite(data[at + axis]) || !Float.isFinite(data[at + 4 + axis])) {
                    throw new IllegalArgumentException(
                            (quadric ? "quadric " + i : "instance " + (i - set.quadricCount()))
                                    + " exceeds the range of single precision: from " + box[axis]
                                    + " to " + box[axis + 3] + " along " + "xyz".charAt(axis));
                }
            }
            data[at + 3] = Float.intBitsToFloat(triangles + i);
            at += STRIDE;
        }
        return at;
    }

    private static float[] bounds(float[] data, int end) {
        float[] box = {
            Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
            Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY
        };
        for (int i = 0; i < end; i += STRIDE) {
            for (int axis = 0; axis < 3; axis++) {
                box[axis] = Math.min(box[axis], data[i + axis]);
                box[axis + 3] = Math.max(box[axis + 3], data[i + 4 + axis]);
            }
        }
        return box;
    }

    private static double scaleFor(float[] bounds) {
        float largest = 0;
        for (float b : bounds) {
            if (!Float.isFinite(b)) {
                return 1;
            }
            largest = Math.max(largest, Math.abs(b));
        }
        return largest == 0 ? 1 : Math.scalb(1.0, -1 - Math.getExponent((double) largest));
    }
}
