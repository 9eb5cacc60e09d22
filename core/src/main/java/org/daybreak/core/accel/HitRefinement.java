package org.daybreak.core.accel;

import org.jspecify.annotations.Nullable;

/**
 * Turns the answer of an {@link Intersector} into a point in double precision, and tells how far the origin of a ray
 * that leaves this point must be moved off the surface. Mutable; owned by one worker.
 *
 * <p><b>Why offsets of this size.</b> Write ε = 2⁻²⁴. The point lies on its triangle up to 2⁻⁵⁰ of the coordinates. A
 * new ray from it is tested in single precision:
 *
 * <ul>
 *   <li>its origin is rounded, which moves it by at most ε |oᵢ| along each axis, hence at most √3 ε max|oᵢ| across any
 *       plane;
 *   <li>subtracting the origin from a vertex costs ε |Vᵢ − oᵢ| along each axis, and shearing 6 ε E more, E the extent of
 *       the triangle seen from a point in it; weighing and summing the distances costs 4 ε E. A hit is an average of the
 *       vertices with weights in [0, 1], so the tested surface is no farther than 12 ε E from the true one;
 *   <li>the weights have an error of 3 ε E² / |det|. Where that matters, the surface is seen so nearly edge-on that the
 *       plane is crossed at t = −δ / (d·n) with |d·n| ≈ |det| / E²; T is then off by less than 3 ε E³ / |det|, so that it
 *       keeps its sign if the distance δ from the plane exceeds 3 ε E.
 * </ul>
 *
 * Together 2 ε max|o| + 12 ε E is enough; {@link #offset} is at least 4/3 of that. A ray from {@code p ± offset · n} that goes away
 * from the surface therefore meets neither its own triangle nor a coplanar neighbour of similar size. For the same
 * reason the point is kept off the edges of its triangle by four times that distance: otherwise the moved and rounded
 * origin may lie beyond a wall that stands on the edge, and the ray would leave a closed room. (Walls that meet at less
 * than some 15 degrees can still be crossed.)
 *
 * <p>Quadrics are tested in double precision; 2⁻⁴⁴ takes the place of ε. In instances the error arises in the space of
 * the level; a distance between planes there becomes the distance divided by |Mᵀn|, M the linear part of the map from
 * world to object. A step along the world's normal is no step along the normal there if M shears: for each unit off the
 * plane it goes up to |M Mᵀn| / |Mᵀn|² along it, so that the distance from edges grows by this factor.
 */
public final class HitRefinement {
    private static final double FLOAT_EPSILON = 0x1p-24;
    private static final double DOUBLE_EPSILON = 0x1p-44;
    private static final double WORLD_EPSILON = 0x1p-48;
    private static final double POSITION_FACTOR = 4;
    private static final double EXTENT_FACTOR = 12;
    private static final double INSET_FACTOR = 4;

    /** Farthest that a hit is kept off an edge, as a barycentric coordinate. */
    private static final double MOST_INSET = 1.0 / 16;

    /** Points of a disk this far from its centre, and of a cylinder up to this height, are clear of the edge. */
    private static final double CLEAR_RADIUS = 1 - MOST_INSET;

    /** Barycentric coordinates of the second and third vertex; for quadrics undefined. */
    public double u, v;

    /** The point, in world space. */
    public double x, y, z;

    /** The point in the object space of the quadric; for triangles undefined. */
    public double objectX, objectY, objectZ;

    /**
     * Unit geometric normal in world space. For triangles the side from which the vertices run counter-clockwise, seen
     * in the space of their own level (an instance that mirrors does not swap the sides); for quadrics outward, and +z
     * of the disk.
     */
    public double normalX, normalY, normalZ;

    /** Distance along ± the normal by which to move the origin of a ray that leaves the point. */
    public double offset;

    private final Ray local = new Ray();
    private @Nullable Instance within;

    /**
     * Refines the hit that the ray reports.
     *
     * @param set what was intersected
     * @param ray the query with its answer; a hit
     * @param level what the instance that was hit places; ignored for hits outside instances
     */
    public void refine(PrimitiveSet set, Ray ray, PrimitiveSet level) {
        if (ray.instance < 0) {
            refineInLevel(set, ray.primitive, ray);
            return;
        }
        Instance instance = set.instance(ray.instance);
        within = instance;
        instance.toObject(ray, local);
        local.t = ray.t;
        refineInLevel(level, ray.primitive, local);
        within = null;
        toWorld(instance);
    }

    private void refineInLevel(PrimitiveSet set, int primitive, Ray ray) {
        int triangles = set.triangleCount();
        if (primitive >= triangles) {
            quadric(set.quadric(primitive - triangles), ray);
            return;
        }
        float[] positions = set.positions();
        int[] indices = set.triangles();
        triangle(
                positions,
                3 * indices[3 * primitive],
                3 * indices[3 * primitive + 1],
                3 * indices[3 * primitive + 2],
                ray);
    }

    /**
     * Refines a hit on a triangle.
     *
     * @param positions vertices as x, y, z one after the other
     * @param a where in the array the first vertex starts
     * @param b where the second one starts
     * @param c where the third one starts
     * @param ray the query, in the space of the positions
     */
    public void triangle(float[] positions, int a, int b, int c, Ray ray) {
        double ax = positions[a];
        double ay = positions[a + 1];
        double az = positions[a + 2];
        double e1x = positions[b] - ax;
        double e1y = positions[b + 1] - ay;
        double e1z = positions[b + 2] - az;
        double e2x = positions[c] - ax;
        double e2y = positions[c + 1] - ay;
        double e2z = positions[c + 2] - az;
        double nx = e1y * e2z - e1z * e2y;
        double ny = e1z * e2x - e1x * e2z;
        double nz = e1x * e2y - e1y * e2x;
        double inverseDoubleArea = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
        normalX = nx * inverseDoubleArea;
        normalY = ny * inverseDoubleArea;
        normalZ = nz * inverseDoubleArea;
        double sx = ray.ox - ax;
        double sy = ray.oy - ay;
        double sz = ray.oz - az;
        double qx = sy * ray.dz - sz * ray.dy;
        double qy = sz * ray.dx - sx * ray.dz;
        double qz = sx * ray.dy - sy * ray.dx;
        double inverse = -1 / (nx * ray.dx + ny * ray.dy + nz * ray.dz);
        double second = (e2x * qx + e2y * qy + e2z * qz) * inverse;
        double third = -(e1x * qx + e1y * qy + e1z * qz) * inverse;
        // Sums bound the maxima of the derivation above and are cheaper: this runs for every hit.
        double extent = Math.abs(e1x) + Math.abs(e1y) + Math.abs(e1z) + Math.abs(e2x) + Math.abs(e2y) + Math.abs(e2z);
        double magnitude = Math.abs(ax) + Math.abs(ay) + Math.abs(az) + extent;
        double bound = FLOAT_EPSILON * (POSITION_FACTOR * magnitude + EXTENT_FACTOR * extent);
        double inset = Math.min(MOST_INSET, INSET_FACTOR * bound * extent * inverseDoubleArea);
        // In an instance the inset is longer; nearly all hits are farther from the edges than it can be.
        double clear = within == null ? inset : MOST_INSET;
        if (second >= clear && third >= clear && 1 - second - third >= clear) {
            u = second;
            v = third;
        } else {
            setInside(second, third, Math.min(MOST_INSET, inset * slide(normalX, normalY, normalZ)));
        }
        x = ax + u * e1x + v * e2x;
        y = ay + u * e1y + v * e2y;
        z = az + u * e1z + v * e2z;
        offset = bound;
    }

    /** How far a step along the world's normal goes along a plane of the level for each unit off it; at least 1. */
    private double slide(double nx, double ny, double nz) {
        Instance i = within;
        if (i == null) {
            return 1;
        }
        double wx = i.worldToObject(0) * nx + i.worldToObject(4) * ny + i.worldToObject(8) * nz;
        double wy = i.worldToObject(1) * nx + i.worldToObject(5) * ny + i.worldToObject(9) * nz;
        double wz = i.worldToObject(2) * nx + i.worldToObject(6) * ny + i.worldToObject(10) * nz;
        double ox = i.worldToObject(0) * wx + i.worldToObject(1) * wy + i.worldToObject(2) * wz;
        double oy = i.worldToObject(4) * wx + i.worldToObject(5) * wy + i.worldToObject(6) * wz;
        double oz = i.worldToObject(8) * wx + i.worldToObject(9) * wy + i.worldToObject(10) * wz;
        return Math.sqrt(ox * ox + oy * oy + oz * oz) / (wx * wx + wy * wy + wz * wz);
    }

    /** Moves barycentric coordinates into the triangle that is smaller by the inset on all three sides. */
    private void setInside(double second, double third, double inset) {
        double first = Math.max(inset, 1 - second - third);
        double s = Math.max(inset, second);
        double r = Math.max(inset, third);
        double sum = first + s + r;
        if (sum < Double.POSITIVE_INFINITY) {
            double inverse = 1 / sum;
            u = s * inverse;
            v = r * inverse;
        } else {
            u = 1.0 / 3;
            v = 1.0 / 3;
        }
    }

    /**
     * Refines a hit on a quadric.
     *
     * @param quadric what was hit
     * @param ray the query with its parameter t, in the space in which the quadric is placed
     */
    public void quadric(Quadric quadric, Ray ray) {
        double px = ray.ox + ray.t * ray.dx;
        double py = ray.oy + ray.t * ray.dy;
        double pz = ray.oz + ray.t * ray.dz;
        double rounding = Math.max(1, toObject(quadric, px, py, pz));
        double inset = DOUBLE_EPSILON * rounding;
        double nx;
        double ny;
        double nz;
        switch (quadric.kind()) {
            case SPHERE -> {
                double scale = 1 / Math.sqrt(objectX * objectX + objectY * objectY + objectZ * objectZ);
                objectX *= scale;
                objectY *= scale;
                objectZ *= scale;
                nx = objectX;
                ny = objectY;
                nz = objectZ;
            }
            case DISK -> {
                double square = objectX * objectX + objectY * objectY;
                if (!(square <= CLEAR_RADIUS * CLEAR_RADIUS)) {
                    double edge = edgeInset(quadric, inset, 0, 0, 1);
                    double scale = Math.min(1, (1 - edge) / Math.sqrt(square));
                    objectX *= scale;
                    objectY *= scale;
                }
                objectZ = 0;
                nx = 0;
                ny = 0;
                nz = 1;
            }
            case CYLINDER -> {
                double scale = 1 / Math.sqrt(objectX * objectX + objectY * objectY);
                objectX *= scale;
                objectY *= scale;
                if (!(objectZ >= MOST_INSET && objectZ <= CLEAR_RADIUS)) {
                    double edge = edgeInset(quadric, inset, objectX, objectY, 0);
                    objectZ = Math.min(1 - edge, Math.max(edge, objectZ));
                }
                nx = objectX;
                ny = objectY;
                nz = 0;
            }
            case CONE -> {
                double length = Math.sqrt(objectX * objectX + objectY * objectY);
                nx = length > 0 ? objectX / length : 1;
                ny = length > 0 ? objectY / length : 0;
                nz = quadric.taper();
                double edge = edgeInset(quadric, inset, nx, ny, nz);
                objectZ = Math.min(1 - edge, Math.max(edge, objectZ));
                double radius = 1 - nz * objectZ;
                objectX = radius * nx;
                objectY = radius * ny;
            }
            default -> throw new IllegalStateException("unknown kind: " + quadric.kind());
        }
        x = place(quadric, 0);
        y = place(quadric, 4);
        z = place(quadric, 8);
        double wx = quadric.worldToObject(0) * nx + quadric.worldToObject(4) * ny + quadric.worldToObject(8) * nz;
        double wy = quadric.worldToObject(1) * nx + quadric.worldToObject(5) * ny + quadric.worldToObject(9) * nz;
        double wz = quadric.worldToObject(2) * nx + quadric.worldToObject(6) * ny + quadric.worldToObject(10) * nz;
        double scale = 1 / Math.sqrt(wx * wx + wy * wy + wz * wz);
        normalX = wx * scale;
        normalY = wy * scale;
        normalZ = wz * scale;
        offset = inset * scale;
    }

    /** How far to keep off the edge of a quadric, for the reasons that hold for triangles. */
    private double edgeInset(Quadric q, double inset, double nx, double ny, double nz) {
        double wx = q.worldToObject(0) * nx + q.worldToObject(4) * ny + q.worldToObject(8) * nz;
        double wy = q.worldToObject(1) * nx + q.worldToObject(5) * ny + q.worldToObject(9) * nz;
        double wz = q.worldToObject(2) * nx + q.worldToObject(6) * ny + q.worldToObject(10) * nz;
        double ox = q.worldToObject(0) * wx + q.worldToObject(1) * wy + q.worldToObject(2) * wz;
        double oy = q.worldToObject(4) * wx + q.worldToObject(5) * wy + q.worldToObject(6) * wz;
        double oz = q.worldToObject(8) * wx + q.worldToObject(9) * wy + q.worldToObject(10) * wz;
        double square = wx * wx + wy * wy + wz * wz;
        double length = Math.sqrt(square);
        double slide = Math.sqrt(ox * ox + oy * oy + oz * oz) / square;
        return Math.min(MOST_INSET, INSET_FACTOR * inset * slide * slide(wx / length, wy / length, wz / length));
    }

    /** Sets the point in object space. Returns the largest sum of magnitudes that one of its coordinates came from. */
    private double toObject(Quadric q, double px, double py, double pz) {
        double xx = q.worldToObject(0) * px;
        double xy = q.worldToObject(1) * py;
        double xz = q.worldToObject(2) * pz;
        double xw = q.worldToObject(3);
        double yx = q.worldToObject(4) * px;
        double yy = q.worldToObject(5) * py;
        double yz = q.worldToObject(6) * pz;
        double yw = q.worldToObject(7);
        double zx = q.worldToObject(8) * px;
        double zy = q.worldToObject(9) * py;
        double zz = q.worldToObject(10) * pz;
        double zw = q.worldToObject(11);
        objectX = xx + xy + xz + xw;
        objectY = yx + yy + yz + yw;
        objectZ = zx + zy + zz + zw;
        return Math.max(
                Math.abs(xx) + Math.abs(xy) + Math.abs(xz) + Math.abs(xw),
                Math.max(
                        Math.abs(yx) + Math.abs(yy) + Math.abs(yz) + Math.abs(yw),
                        Math.abs(zx) + Math.abs(zy) + Math.abs(zz) + Math.abs(zw)));
    }

    private double place(Quadric q, int at) {
        return q.objectToWorld(at) * objectX
                + q.objectToWorld(at + 1) * objectY
                + q.objectToWorld(at + 2) * objectZ
                + q.objectToWorld(at + 3);
    }

    private void toWorld(Instance i) {
        double px = x;
        double py = y;
        double pz = z;
        x = i.objectToWorld(0) * px + i.objectToWorld(1) * py + i.objectToWorld(2) * pz + i.objectToWorld(3);
        y = i.objectToWorld(4) * px + i.objectToWorld(5) * py + i.objectToWorld(6) * pz + i.objectToWorld(7);
        z = i.objectToWorld(8) * px + i.objectToWorld(9) * py + i.objectToWorld(10) * pz + i.objectToWorld(11);
        double nx = i.worldToObject(0) * normalX + i.worldToObject(4) * normalY + i.worldToObject(8) * normalZ;
        double ny = i.worldToObject(1) * normalX + i.worldToObject(5) * normalY + i.worldToObject(9) * normalZ;
        double nz = i.worldToObject(2) * normalX + i.worldToObject(6) * normalY + i.worldToObject(10) * normalZ;
        double scale = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
        normalX = nx * scale;
        normalY = ny * scale;
        normalZ = nz * scale;
        double magnitude = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        offset = offset * scale + WORLD_EPSILON * magnitude;
    }
}
