package org.daybreak.core.math;

/**
 * Right-handed orthonormal basis (s, t, n). Mutable: one per worker, set anew at each surface point.
 *
 * <p>Local coordinates are (x·s, x·t, x·n), so the local z axis is the normal.
 */
public final class Frame {
    public double sx = 1;
    public double sy;
    public double sz;
    public double tx;
    public double ty = 1;
    public double tz;
    public double nx;
    public double ny;
    public double nz = 1;

    /** Creates the frame of the coordinate axes. */
    public Frame() {}

    /**
     * Completes a unit normal to a basis, without branches and without a singular direction.
     *
     * <p>Duff et al., “Building an Orthonormal Basis, Revisited”, JCGT 6(1), 2017.
     */
    public void set(double normalX, double normalY, double normalZ) {
        double sign = Math.copySign(1.0, normalZ);
        double a = -1 / (sign + normalZ);
        double b = normalX * normalY * a;
        sx = 1 + sign * normalX * normalX * a;
        sy = sign * b;
        sz = -sign * normalX;
        tx = b;
        ty = sign + normalY * normalY * a;
        tz = -normalY;
        nx = normalX;
        ny = normalY;
        nz = normalZ;
    }

    /**
     * Sets the basis from a unit normal and a preferred direction of s, which is made orthogonal to the normal. If the
     * preferred direction is zero, not finite or parallel to the normal, s is arbitrary as in {@link #set(double,
     * double, double)}.
     */
    public void set(double normalX, double normalY, double normalZ, double tangentX, double tangentY, double tangentZ) {
        double along = tangentX * normalX + tangentY * normalY + tangentZ * normalZ;
        double x = tangentX - along * normalX;
        double y = tangentY - along * normalY;
        double z = tangentZ - along * normalZ;
        double squaredLength = x * x + y * y + z * z;
        // What is left of a parallel tangent is rounding noise; 1e-20 is (1e-10)², far above it.
        double tangentSquared = tangentX * tangentX + tangentY * tangentY + tangentZ * tangentZ;
        if (!(squaredLength > 1e-20 * tangentSquared) || !(squaredLength < Double.POSITIVE_INFINITY)) {
            set(normalX, normalY, normalZ);
            return;
        }
        double scale = 1 / Math.sqrt(squaredLength);
        sx = x * scale;
        sy = y * scale;
        sz = z * scale;
        tx = normalY * sz - normalZ * sy;
        ty = normalZ * sx - normalX * sz;
        tz = normalX * sy - normalY * sx;
        nx = normalX;
        ny = normalY;
        nz = normalZ;
    }

    /** Writes the local coordinates of a world vector into {@code dest[0..2]}. */
    public void toLocal(double x, double y, double z, double[] dest) {
        dest[0] = x * sx + y * sy + z * sz;
        dest[1] = x * tx + y * ty + z * tz;
        dest[2] = x * nx + y * ny + z * nz;
    }

    /** Writes the world coordinates of a local vector into {@code dest[0..2]}. */
    public void toWorld(double x, double y, double z, double[] dest) {
        dest[0] = x * sx + y * tx + z * nx;
        dest[1] = x * sy + y * ty + z * ny;
        dest[2] = x * sz + y * tz + z * nz;
    }
}
