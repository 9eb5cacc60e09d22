package org.daybreak.core.accel;

/**
 * A ray in single precision, as the traversal kernels want it. For implementations of {@link Intersector}.
 *
 * <p>Coordinates are scaled like those of the index. The direction is divided by its largest component, so that
 * distances T count along that axis: t = T · {@link #toParameter}. Neither can then overflow or vanish, whatever the
 * length of the direction and the size of the scene.
 *
 * <p><b>Boxes.</b> The parameter at which the ray meets the plane x = b is {@code fma(b, inverseX, -originX * inverseX)}.
 * That is off by the rounding of the origin (2⁻²⁴ |originX| at most) and of the constant (2⁻²⁴ |originX · inverseX|), so
 * the constant of near planes is lowered, and that of far planes raised, by 2⁻²¹ |originX · inverseX|. The error of the
 * inverse and of the sum is relative to the result; kernels raise the far end by {@link #ULPS} units in the last place
 * before they compare. The error of the triangle test is relative to the extent of the triangle; the boxes in the index
 * are widened by that ({@link BoxWidening}). Together: no box that holds a hit is missed.
 *
 * <p><b>Triangles</b> are tested as by Woop, Benthin and Wald ("Watertight Ray/Triangle Intersection", JCGT 2(1), 2013):
 * vertices relative to the origin are sheared along the ray into the plane, and the signs of the three 2D cross products
 * decide. Each is a difference of two rounded products, hence its sign is right or it is zero, for the sheared vertices,
 * which triangles that share a vertex share bit for bit. Zero counts as inside. So no ray passes between triangles.
 */
public final class PreparedRay {
    /** By how many units in the last place the far end of a box is raised. */
    public static final int ULPS = 8;

    /** Least magnitude that a component of the direction is taken to have, relative to the largest. */
    private static final double LEAST_DIRECTION = 0x1p-60;

    private static final float SLACK = 0x1p-21f;

    /** Scaled origin. */
    public float originX, originY, originZ;

    /** Reciprocals of the scaled direction; never zero, infinite, or not a number, if the direction is proper. */
    public float inverseX, inverseY, inverseZ;

    /** Constants for near and far planes. */
    public float nearX, nearY, nearZ, farX, farY, farZ;

    /** The axis of the largest component of the direction, and the two after it, as 0, 1, 2. */
    public int axisU, axisV, axisW;

    /** Origin along these axes. */
    public float originU, originV, originW;

    /** Shear that maps the direction to the axis W. */
    public float shearU, shearV;

    /** Sign of the direction along the axis W. */
    public float sign;

    /** The end of the ray in units of T. */
    public float tMax;

    /** t = T · this. */
    public double toParameter;

    /** T = t · this. */
    public double fromParameter;

    /** Kernels may keep their best hit here while other primitives are tested. */
    public float best;

    void set(Ray ray, double scale) {
        double dx = ray.dx;
        double dy = ray.dy;
        double dz = ray.dz;
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        double largest = Math.max(ax, Math.max(ay, az));
        double shrink = 1 / largest;
        dx *= shrink;
        dy *= shrink;
        dz *= shrink;
        fromParameter = scale * largest;
        toParameter = shrink / scale;
        tMax = (float) (ray.tMax * fromParameter);
        float ox = (float) (ray.ox * scale);
        float oy = (float) (ray.oy * scale);
        float oz = (float) (ray.oz * scale);
        originX = ox;
        originY = oy;
        originZ = oz;
        float ix = inverse(dx);
        float iy = inverse(dy);
        float iz = inverse(dz);
        inverseX = ix;
        inverseY = iy;
        inverseZ = iz;
        float cx = -ox * ix;
        float cy = -oy * iy;
        float cz = -oz * iz;
        float sx = Math.abs(cx) * SLACK;
        float sy = Math.abs(cy) * SLACK;
        float sz = Math.abs(cz) * SLACK;
        nearX = cx - sx;
        nearY = cy - sy;
        nearZ = cz - sz;
        farX = cx + sx;
        farY = cy + sy;
        farZ = cz + sz;
        if (az >= ax && az >= ay) {
            frame(0, 1, 2, ox, oy, oz, dx, dy, dz);
        } else if (ay >= ax) {
            frame(2, 0, 1, oz, ox, oy, dz, dx, dy);
        } else {
            frame(1, 2, 0, oy, oz, ox, dy, dz, dx);
        }
    }

    private static float inverse(double direction) {
        float d = (float) direction;
        if (Math.abs(d) < LEAST_DIRECTION) {
            return Math.copySign((float) (1 / LEAST_DIRECTION), d);
        }
        return 1 / d;
    }

    private void frame(int u, int v, int w, float ou, float ov, float ow, double du, double dv, double dw) {
        axisU = u;
        axisV = v;
        axisW = w;
        originU = ou;
        originV = ov;
        originW = ow;
        float s = (float) Math.signum(dw);
        sign = s;
        shearU = (float) (du * s);
        shearV = (float) (dv * s);
    }
}
