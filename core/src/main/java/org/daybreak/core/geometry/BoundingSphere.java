package org.daybreak.core.geometry;

import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;

/**
 * A sphere around something.
 *
 * @param x its centre, x
 * @param y its centre, y
 * @param z its centre, z
 * @param radius its radius, not negative
 */
public record BoundingSphere(double x, double y, double z, double radius) {
    /** A sphere around a shape that is placed by a map. */
    public static BoundingSphere of(Shape shape, Transform toWorld) {
        if (shape instanceof TriangleMesh mesh) {
            return ofVertices(mesh, toWorld);
        }
        if (shape instanceof Sphere sphere) {
            return ofUnitSphere(toWorld.multiply(ShapeFrames.of(sphere)));
        }
        if (shape instanceof Disk) {
            return ofUnitSphere(toWorld);
        }
        if (shape instanceof Cylinder cylinder) {
            return of(new Bounds(-1, -1, 0, 1, 1, 1), toWorld.multiply(ShapeFrames.of(cylinder)));
        }
        if (shape instanceof Cone cone) {
            return of(new Bounds(-1, -1, 0, 1, 1, 1), toWorld.multiply(ShapeFrames.of(cone)));
        }
        double height = shape instanceof Cube ? 1 : 0;
        return of(new Bounds(-1, -1, -height, 1, 1, height), toWorld);
    }

    /** The sphere around a box that is not empty and that is placed by a map. */
    public static BoundingSphere of(Bounds box, Transform toWorld) {
        Builder builder = new Builder(box.centerX(), box.centerY(), box.centerZ(), toWorld);
        for (int corner = 0; corner < 8; corner++) {
            builder.include(
                    (corner & 1) == 0 ? box.minX() : box.maxX(),
                    (corner & 2) == 0 ? box.minY() : box.maxY(),
                    (corner & 4) == 0 ? box.minZ() : box.maxZ());
        }
        return builder.build();
    }

    /** The smallest sphere around two. */
    public BoundingSphere union(BoundingSphere other) {
        double dx = other.x - x;
        double dy = other.y - y;
        double dz = other.z - z;
        double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (distance + other.radius <= radius) {
            return this;
        }
        if (distance + radius <= other.radius) {
            return other;
        }
        double all = 0.5 * (distance + radius + other.radius);
        double along = (all - radius) / distance;
        return new BoundingSphere(x + along * dx, y + along * dy, z + along * dz, all);
    }

    /** The image of the unit sphere lies in the sphere whose radius is the norm of the map. */
    private static BoundingSphere ofUnitSphere(Transform map) {
        double[] m = map.rows();
        double squares = 0;
        double largest = 0;
        for (int column = 0; column < 3; column++) {
            double square = m[column] * m[column] + m[4 + column] * m[4 + column] + m[8 + column] * m[8 + column];
            squares += square;
            largest = Math.max(largest, square);
        }
        boolean similar = Math.abs(squares - 3 * largest) < 1e-9 * squares && orthogonal(m, 1e-9 * squares);
        return new BoundingSphere(m[3], m[7], m[11], Math.sqrt(similar ? largest : squares));
    }

    private static boolean orthogonal(double[] m, double tolerance) {
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            if (Math.abs(m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j]) > tolerance) {
                return false;
            }
        }
        return true;
    }

    private static BoundingSphere ofVertices(TriangleMesh mesh, Transform toWorld) {
        float[] p = mesh.positions();
        Bounds.Builder box = new Bounds.Builder();
        for (int i = 0; i < p.length; i += 3) {
            box.include(p[i], p[i + 1], p[i + 2]);
        }
        Bounds bounds = box.build();
        if (bounds.isEmpty()) {
            return new BoundingSphere(0, 0, 0, 0);
        }
        Builder builder = new Builder(bounds.centerX(), bounds.centerY(), bounds.centerZ(), toWorld);
        for (int i = 0; i < p.length; i += 3) {
            builder.include(p[i], p[i + 1], p[i + 2]);
        }
        return builder.build();
    }

    /** Sphere about the image of a point. */
    private static final class Builder {
        private final Transform map;
        private final double[] centre = new double[3];
        private final double[] point = new double[3];
        private double squared;

        Builder(double x, double y, double z, Transform map) {
            this.map = map;
            map.applyPoint(x, y, z, centre);
        }

        void include(double x, double y, double z) {
            map.applyPoint(x, y, z, point);
            double dx = point[0] - centre[0];
            double dy = point[1] - centre[1];
            double dz = point[2] - centre[2];
            squared = Math.max(squared, dx * dx + dy * dy + dz * dz);
        }

        BoundingSphere build() {
            return new BoundingSphere(centre[0], centre[1], centre[2], Math.sqrt(squared));
        }
    }
}
