package org.daybreak.core.math;

/**
 * Axis-aligned box, closed, in double precision. The empty box has every minimum +∞ and every maximum −∞.
 *
 * @param minX smallest x
 * @param minY smallest y
 * @param minZ smallest z
 * @param maxX largest x
 * @param maxY largest y
 * @param maxZ largest z
 */
public record Bounds(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {
    /** The box without points; neutral element of {@link #union}. */
    public static final Bounds EMPTY = new Bounds(
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY,
            Double.NEGATIVE_INFINITY);

    /** Whether the box holds no point. */
    public boolean isEmpty() {
        return !(minX <= maxX && minY <= maxY && minZ <= maxZ);
    }

    /** Whether the point lies in the box, its faces included. */
    public boolean contains(double x, double y, double z) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY && z >= minZ && z <= maxZ;
    }

    /** The smallest box around both. */
    public Bounds union(Bounds other) {
        return new Bounds(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.min(minZ, other.minZ),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY),
                Math.max(maxZ, other.maxZ));
    }

    /** The axis-aligned box around the transformed box; never smaller than the box of the transformed contents. */
    public Bounds transform(Transform transform) {
        if (isEmpty()) {
            return EMPTY;
        }
        Builder builder = new Builder();
        double[] corner = new double[3];
        for (int i = 0; i < 8; i++) {
            transform.applyPoint(
                    (i & 1) == 0 ? minX : maxX, (i & 2) == 0 ? minY : maxY, (i & 4) == 0 ? minZ : maxZ, corner);
            builder.include(corner[0], corner[1], corner[2]);
        }
        return builder.build();
    }

    /** The x coordinate of the centre; NaN for the empty box. */
    public double centerX() {
        return 0.5 * minX + 0.5 * maxX;
    }

    /** The y coordinate of the centre; NaN for the empty box. */
    public double centerY() {
        return 0.5 * minY + 0.5 * maxY;
    }

    /** The z coordinate of the centre; NaN for the empty box. */
    public double centerZ() {
        return 0.5 * minZ + 0.5 * maxZ;
    }

    /** Radius of the sphere about the centre through the corners: half the diagonal; 0 for the empty box. */
    public double boundingSphereRadius() {
        if (isEmpty()) {
            return 0;
        }
        double x = 0.5 * maxX - 0.5 * minX;
        double y = 0.5 * maxY - 0.5 * minY;
        double z = 0.5 * maxZ - 0.5 * minZ;
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Collects points and boxes. */
    public static final class Builder {
        private double minX = Double.POSITIVE_INFINITY;
        private double minY = Double.POSITIVE_INFINITY;
        private double minZ = Double.POSITIVE_INFINITY;
        private double maxX = Double.NEGATIVE_INFINITY;
        private double maxY = Double.NEGATIVE_INFINITY;
        private double maxZ = Double.NEGATIVE_INFINITY;

        /** Creates an empty builder. */
        public Builder() {}

        /** Extends the box to the point. A NaN coordinate makes the box empty and not extensible. */
        public void include(double x, double y, double z) {
            minX = Math.min(minX, x);
            minY = Math.min(minY, y);
            minZ = Math.min(minZ, z);
            maxX = Math.max(maxX, x);
            maxY = Math.max(maxY, y);
            maxZ = Math.max(maxZ, z);
        }

        /** Extends the box to the other box. */
        public void include(Bounds other) {
            minX = Math.min(minX, other.minX);
            minY = Math.min(minY, other.minY);
            minZ = Math.min(minZ, other.minZ);
            maxX = Math.max(maxX, other.maxX);
            maxY = Math.max(maxY, other.maxY);
            maxZ = Math.max(maxZ, other.maxZ);
        }

        /** The box so far. */
        public Bounds build() {
            return new Bounds(minX, minY, minZ, maxX, maxY, maxZ);
        }
    }
}
