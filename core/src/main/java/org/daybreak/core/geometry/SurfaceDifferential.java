package org.daybreak.core.geometry;

/**
 * How a surface goes on around a point: two tangents, and how the normals turn along them. Mutable and owned by one worker;
 * filled by {@code Scene.differential}.
 *
 * <p>The parameters u and v are lengths in world units along two orthonormal directions of the tangent plane, those of
 * {@link #setFlat}: they have nothing to do with texture coordinates, have no poles, and a determinant in them is one per
 * area. Derivatives are those at the point itself, in world space, of the unit normals with the signs that
 * {@link SurfacePoint} gives them; they scale as one over length.
 */
public final class SurfaceDifferential {
    /** ∂p/∂u, a unit tangent. */
    public double pux;

    public double puy;
    public double puz;

    /** ∂p/∂v, the unit tangent with ∂p/∂u × ∂p/∂v = n_g. */
    public double pvx;

    public double pvy;
    public double pvz;

    /** ∂n_g/∂u, derivative of the geometric normal: 0 on triangles. */
    public double gux;

    public double guy;
    public double guz;

    /** ∂n_g/∂v. */
    public double gvx;

    public double gvy;
    public double gvz;

    /** ∂n_s/∂u, derivative of the shading normal. */
    public double nux;

    public double nuy;
    public double nuz;

    /** ∂n_s/∂v. */
    public double nvx;

    public double nvy;
    public double nvz;

    /**
     * Makes this the differential of a plane: tangents across the geometric normal (Duff et al., JCGT 6(1), 2017), and
     * normals that do not turn.
     */
    public void setFlat(SurfacePoint point) {
        double sign = Math.copySign(1.0, point.gz);
        double a = -1 / (sign + point.gz);
        double b = point.gx * point.gy * a;
        pux = 1 + sign * point.gx * point.gx * a;
        puy = sign * b;
        puz = -sign * point.gx;
        pvx = b;
        pvy = sign + point.gy * point.gy * a;
        pvz = -point.gy;
        gux = 0;
        guy = 0;
        guz = 0;
        gvx = 0;
        gvy = 0;
        gvz = 0;
        nux = 0;
        nuy = 0;
        nuz = 0;
        nvx = 0;
        nvy = 0;
        nvz = 0;
    }

    /** Copies all values of another differential. */
    public void set(SurfaceDifferential o) {
        pux = o.pux;
        puy = o.puy;
        puz = o.puz;
        pvx = o.pvx;
        pvy = o.pvy;
        pvz = o.pvz;
        gux = o.gux;
        guy = o.guy;
        guz = o.guz;
        gvx = o.gvx;
        gvy = o.gvy;
        gvz = o.gvz;
        nux = o.nux;
        nuy = o.nuy;
        nuz = o.nuz;
        nvx = o.nvx;
        nvy = o.nvy;
        nvz = o.nvz;
    }
}
