package org.daybreak.core.accel;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Bounds and numbers of the primitives to build over, one record of eight ints each, so that partitioning moves records
 * instead of chasing indices: minimum x, y, z, number, maximum x, y, z, unused.
 *
 * <p>Bounds are in steps of 2⁻²⁹ of the largest extent of everything: the minimum and maximum of ints take one instruction
 * each, those of floats, with Java's rules for NaN and −0, five. The heuristic needs no more precision; the boxes that
 * rays are tested against are computed from the vertices themselves.
 */
final class PrimitiveRecords {
    static final int STRIDE = 8;

    /** Eight ints for each record, and 2³¹ − 1 elements at most in an array. */
    static final int MAX_COUNT = 1 << 27;

    private static final int GRAIN = 1 << 14;
    private static final double STEPS = 1 << 29;

    final PrimitiveSet set;
    final int[] data;
    final int count;

    /**
     * The power of two by which an index multiplies coordinates: it brings the largest one into [0.5, 1]. That is exact,
     * and keeps products of coordinates in the range of single precision whatever the unit of the scene.
     */
    final double scale;

    /** Bounds of everything: minimum x, y, z, maximum x, y, z; +∞ and −∞ if there is nothing. */
    final float[] bounds;

    /** Bounds of the primitives that are no triangles, six floats each. */
    private final float[] otherBounds;

    private final int triangleCount;

    /** Triangles of no area and empty instances get no record: no ray can hit them. */
    PrimitiveRecords(PrimitiveSet set) {
        this.set = set;
        int size = set.size();
        if (size > MAX_COUNT) {
            throw new IllegalArgumentException(
                    "too many primitives for one index: " + size + ", the limit is " + MAX_COUNT);
        }
        checkVertices(set.positions());
        triangleCount = set.triangleCount();
        bounds = emptyBox();
        ForkJoinRange.run(triangleCount, GRAIN, this::boundTriangles);
        otherBounds = boundOthers();
        scale = scaleFor(bounds);
        data = new int[STRIDE * size];
        AtomicInteger dropped = new AtomicInteger();
        double extent = 0;
        for (int axis = 0; axis < 3; axis++) {
            extent = Math.max(extent, (double) bounds[axis + 3] - bounds[axis]);
        }
        double steps = extent > 0 ? STEPS / extent : 0;
        ForkJoinRange.run(triangleCount, GRAIN, (from, to) -> dropped.addAndGet(recordTriangles(from, to, steps)));
        recordOthers(dropped, steps);
        count = dropped.get() == 0 ? size : compact();
        if (count == 0) {
            clear(bounds);
        }
    }

    private static float[] emptyBox() {
        return new float[] {
            Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY, Float.POSITIVE_INFINITY,
            Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NEGATIVE_INFINITY
        };
    }

    /** Number of the primitive in a record. */
    int number(int record) {
        return data[STRIDE * record + 3];
    }

    /** Whether the record is one of a triangle. */
    boolean isTriangle(int record) {
        return number(record) < triangleCount;
    }

    /** Scaled coordinate of a vertex. */
    float scaled(float coordinate) {
        return (float) (coordinate * scale);
    }

    /** Writes the scaled bounds of a range of records to a box of six floats. */
    void fit(int start, int count, float[] box) {
        float[] p = set.positions();
        int[] corners = set.triangles();
        clear(box);
        for (int i = start; i < start + count; i++) {
            int number = number(i);
            if (number < triangleCount) {
                for (int corner = 3 * number; corner < 3 * number + 3; corner++) {
                    int vertex = 3 * corners[corner];
                    extend(box, p[vertex], p[vertex + 1], p[vertex + 2]);
                }
            } else {
                int at = 6 * (number - triangleCount);
                extend(box, otherBounds[at], otherBounds[at + 1], otherBounds[at + 2]);
                extend(box, otherBounds[at + 3], otherBounds[at + 4], otherBounds[at + 5]);
            }
        }
        for (int i = 0; i < 6; i++) {
            box[i] = scaled(box[i]);
        }
    }

    private static void clear(float[] box) {
        for (int i = 0; i < 3; i++) {
            box[i] = Float.POSITIVE_INFINITY;
            box[i + 3] = Float.NEGATIVE_INFINITY;
        }
    }

    private static void extend(float[] box, float x, float y, float z) {
        box[0] = x < box[0] ? x : box[0];
        box[1] = y < box[1] ? y : box[1];
        box[2] = z < box[2] ? z : box[2];
        box[3] = x > box[3] ? x : box[3];
        box[4] = y > box[4] ? y : box[4];
        box[5] = z > box[5] ? z : box[5];
    }

    private static void checkVertices(float[] positions) {
        int largest = 0;
        for (float p : positions) {
            largest = Math.max(largest, Float.floatToRawIntBits(p) & Integer.MAX_VALUE);
        }
        if (largest < Float.floatToRawIntBits(Float.POSITIVE_INFINITY)) {
            return;
        }
        for (int i = 0; i < positions.length; i++) {
            if (!Float.isFinite(positions[i])) {
                throw new IllegalArgumentException(
                        "vertex " + i / 3 + " has the coordinate " + "xyz".charAt(i % 3) + " = " + positions[i]);
            }
        }
    }

    private void boundTriangles(int from, int to) {
        float[] p = set.positions();
        int[] corners = set.triangles();
        int vertexCount = p.length / 3;
        float[] box = emptyBox();
        for (int i = 3 * from; i < 3 * to; i++) {
            int vertex = corners[i];
            if (Integer.compareUnsigned(vertex, vertexCount) >= 0) {
                throw new IllegalArgumentException("triangle " + i / 3 + " refers to vertex " + vertex
                        + " but there are " + vertexCount + " vertices");
            }
            extend(box, p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]);
        }
        unite(box);
    }

    private synchronized void unite(float[] box) {
        if (box[0] <= box[3]) {
            extend(bounds, box[0], box[1], box[2]);
            extend(bounds, box[3], box[4], box[5]);
        }
    }

    private float[] boundOthers() {
        int quadrics = set.quadricCount();
        int others = quadrics + set.instanceCount();
        float[] boxes = new float[6 * others];
        double[] box = new double[6];
        for (int i = 0; i < others; i++) {
            boolean quadric = i < quadrics;
            if (quadric) {
                set.quadric(i).bounds(box);
            } else {
                set.instance(i - quadrics).bounds(box);
            }
            for (int axis = 0; axis < 3; axis++) {
                float low = Affine.roundDown(box[axis]);
                float high = Affine.roundUp(box[axis + 3]);
                if (box[axis] <= box[axis + 3] && (!Float.isFinite(low) || !Float.isFinite(high))) {
                    throw new IllegalArgumentException(
                            (quadric ? "quadric " + i : "instance " + (i - quadrics)) + " exceeds the range of single"
                                    + " precision: from " + box[axis] + " to " + box[axis + 3] + " along "
                                    + "xyz".charAt(axis));
                }
                boxes[6 * i + axis] = low;
                boxes[6 * i + 3 + axis] = high;
            }
            if (boxes[6 * i] <= boxes[6 * i + 3]) {
                extend(bounds, boxes[6 * i], boxes[6 * i + 1], boxes[6 * i + 2]);
                extend(bounds, boxes[6 * i + 3], boxes[6 * i + 4], boxes[6 * i + 5]);
            }
        }
        return boxes;
    }

    private static double scaleFor(float[] bounds) {
        float largest = 0;
        for (float b : bounds) {
            largest = Math.max(largest, Math.abs(b));
        }
        return largest == 0 || largest == Float.POSITIVE_INFINITY
                ? 1
                : Math.scalb(1.0, -1 - Math.getExponent((double) largest));
    }

    /** Returns how many were dropped; their records have the number −1. */
    private int recordTriangles(int from, int to, double steps) {
        float[] p = set.positions();
        int[] corners = set.triangles();
        int[] d = data;
        double lowX = bounds[0];
        double lowY = bounds[1];
        double lowZ = bounds[2];
        int dropped = 0;
        for (int i = from; i < to; i++) {
            int a = 3 * corners[3 * i];
            int b = 3 * corners[3 * i + 1];
            int c = 3 * corners[3 * i + 2];
            double ax = p[a];
            double ay = p[a + 1];
            double az = p[a + 2];
            double bx = p[b];
            double by = p[b + 1];
            double bz = p[b + 2];
            double cx = p[c];
            double cy = p[c + 1];
            double cz = p[c + 2];
            int at = STRIDE * i;
            if (hasNoArea(bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az)) {
                d[at + 3] = -1;
                dropped++;
                continue;
            }
            int x0 = (int) ((ax - lowX) * steps);
            int x1 = (int) ((bx - lowX) * steps);
            int x2 = (int) ((cx - lowX) * steps);
            int y0 = (int) ((ay - lowY) * steps);
            int y1 = (int) ((by - lowY) * steps);
            int y2 = (int) ((cy - lowY) * steps);
            int z0 = (int) ((az - lowZ) * steps);
            int z1 = (int) ((bz - lowZ) * steps);
            int z2 = (int) ((cz - lowZ) * steps);
            d[at] = Math.min(x0, Math.min(x1, x2));
            d[at + 1] = Math.min(y0, Math.min(y1, y2));
            d[at + 2] = Math.min(z0, Math.min(z1, z2));
            d[at + 3] = i;
            d[at + 4] = Math.max(x0, Math.max(x1, x2));
            d[at + 5] = Math.max(y0, Math.max(y1, y2));
            d[at + 6] = Math.max(z0, Math.max(z1, z2));
        }
        return dropped;
    }

    /**
     * Whether two edges of a triangle are parallel. Differences of floats are exact in double (up to extreme ratios of
     * exponents) and products of those carry 2⁻⁵³ relative error, so a true zero stays below this bound and a triangle
     * above it is at least 2⁻⁴⁸ times as high as long.
     */
    private static boolean hasNoArea(double ux, double uy, double uz, double vx, double vy, double vz) {
        return isZeroDifference(uy * vz, uz * vy)
                && isZeroDifference(uz * vx, ux * vz)
                && isZeroDifference(ux * vy, uy * vx);
    }

    private static boolean isZeroDifference(double a, double b) {
        return Math.abs(a - b) <= 0x1p-48 * (Math.abs(a) + Math.abs(b));
    }

    private void recordOthers(AtomicInteger dropped, double steps) {
        for (int i = 0; i < otherBounds.length / 6; i++) {
            int at = STRIDE * (triangleCount + i);
            if (!(otherBounds[6 * i] <= otherBounds[6 * i + 3])) {
                data[at + 3] = -1;
                dropped.incrementAndGet();
                continue;
            }
            data[at + 3] = triangleCount + i;
            for (int axis = 0; axis < 3; axis++) {
                data[at + axis] = (int) (((double) otherBounds[6 * i + axis] - bounds[axis]) * steps);
                data[at + 4 + axis] = (int) (((double) otherBounds[6 * i + 3 + axis] - bounds[axis]) * steps);
            }
        }
    }

    private int compact() {
        int end = 0;
        for (int at = 0; at < data.length; at += STRIDE) {
            if (data[at + 3] >= 0) {
                System.arraycopy(data, at, data, end, STRIDE);
                end += STRIDE;
            }
        }
        return end / STRIDE;
    }
}
