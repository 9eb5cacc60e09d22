package org.daybreak.core.accel;

/**
 * A ray in single precision, as the traversal kernels want it. For implementations of {@link Intersector}.
 *
 * <p>Coordinates are scaled like those of the index. The direction is multiplied by the power of two that brings its
 * largest component into [1, 2), so that distances T have the magnitude of coordinates; see {@link #parameter}. Neither can then overflow or vanish, whatever the length of the direction and the size of the scene. A ray that starts
 * far from the scene is moved up to it in double precision first, so that no digits are lost on the way.
 *
 * <p>There are no branches on the direction: for rays in all directions each would be mispredicted half of the time, and
 * the whole preparation costs no more than one node of the hierarchy.
 *
 * <p><b>Boxes.</b> The parameter at which the ray meets the plane x = b is {@code fma(b, inverseX, -originX * inverseX)}.
 * That is off by the rounding of the origin (2⁻²⁴ of it at most) and of the constant (2⁻²⁴ |originX · inverseX|), so
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
    private static final float LEAST_DIRECTION = 0x1p-60f;

    private static final long INFINITY = 0x7ff0000000000000L;

    /** Origins whose coordinates sum up to more are far from the scene. */
    private static final float FAR = 8;

    private static final float SLACK = 0x1p-21f;

    /** Reciprocals of the scaled direction; never zero, infinite, or not a number, if the direction is proper. */
    public float inverseX, inverseY, inverseZ;

    /** Constants for near and far planes. */
    public float nearX, nearY, nearZ, farX, farY, farZ;

    /** The axis W of the largest component of the direction, and the two after it, as 0, 1, 2. */
    public int axisU, axisV, axisW;

    /** Origin along these axes. */
    public float originU, originV, originW;

    /** Shear that maps the direction to the axis W. */
    public float shearU, shearV;

    /** Reciprocal of the scaled direction along the axis W. */
    public float inverseW;

    /** The end of the ray in units of T; negative if the direction is zero or not finite, so that nothing is hit. */
    public float tMax;

    /** Power of two by which distances are multiplied to get parameters, and back. */
    private double toParameter;

    private double fromParameter;

    /** Distance by which the origin was moved up to the scene. */
    private double start;

    private final float[] origin = new float[3];
    private final float[] direction = new float[3];
    private final float[] inverse = new float[3];

    void set(Ray ray, double scale) {
        long ax = Double.doubleToRawLongBits(ray.dx) & Long.MAX_VALUE;
        long ay = Double.doubleToRawLongBits(ray.dy) & Long.MAX_VALUE;
        long az = Double.doubleToRawLongBits(ray.dz) & Long.MAX_VALUE;
        // Magnitudes order like their bits; differences of those do not overflow.
        long yLarger = (ax - ay) >>> 63;
        long larger = ax + ((ay - ax) & -yLarger);
        long zLarger = (larger - az) >>> 63;
        long largest = larger + ((az - larger) & -zLarger);
        int w = (int) (yLarger + ((2 - yLarger) & -zLarger));
        long exponent = Math.max(1, Math.min(2045, largest >>> 52));
        double shrink = Double.longBitsToDouble((2046 - exponent) << 52);
        fromParameter = scale * Double.longBitsToDouble(exponent << 52);
        toParameter = 1 / fromParameter;
        start = 0;
        float ox = (float) (ray.ox * scale);
        float oy = (float) (ray.oy * scale);
        float oz = (float) (ray.oz * scale);
        if (Math.abs(ox) + Math.abs(oy) + Math.abs(oz) > FAR) {
            start = approach(ray, scale, shrink);
            ox = (float) (ray.ox * scale + start * (ray.dx * shrink));
            oy = (float) (ray.oy * scale + start * (ray.dy * shrink));
            oz = (float) (ray.oz * scale + start * (ray.dz * shrink));
        }
        tMax = largest == 0 || largest >= INFINITY ? -1 : distance(ray.tMax);
        float dx = (float) (ray.dx * shrink);
        float dy = (float) (ray.dy * shrink);
        float dz = (float) (ray.dz * shrink);
        float ix = reciprocal(dx);
        float iy = reciprocal(dy);
        float iz = reciprocal(dz);
        origin[0] = ox;
        origin[1] = oy;
        origin[2] = oz;
        direction[0] = dx;
        direction[1] = dy;
        direction[2] = dz;
        inverse[0] = ix;
        inverse[1] = iy;
        inverse[2] = iz;
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
        // (w + 1) mod 3 and (w + 2) mod 3, from tables of two bits each.
        int u = (0b001001 >> (2 * w)) & 3;
        int v = (0b010010 >> (2 * w)) & 3;
        axisU = u;
        axisV = v;
        axisW = w;
        originU = origin[u];
        originV = origin[v];
        originW = origin[w];
        float iw = inverse[w];
        inverseW = iw;
        shearU = direction[u] * iw;
        shearV = direction[v] * iw;
    }

    /** A distance after which the ray is still outside of [-2, 2]³; the scene lies in [-1, 1]³. */
    private static double approach(Ray ray, double scale, double shrink) {
        double away = scale * Math.max(Math.abs(ray.ox), Math.max(Math.abs(ray.oy), Math.abs(ray.oz)));
        double speed = shrink * Math.max(Math.abs(ray.dx), Math.max(Math.abs(ray.dy), Math.abs(ray.dz)));
        double distance = (away - 2) / speed;
        return distance > 0 && distance < Double.POSITIVE_INFINITY ? distance : 0;
    }

    /** The parameter t on the ray of a distance T from the prepared origin. */
    public double parameter(float distance) {
        return (distance + start) * toParameter;
    }

    /** The distance T from the prepared origin of a parameter t on the ray. */
    public float distance(double parameter) {
        return (float) (parameter * fromParameter - start);
    }

    /**
     * Where, in a node of {@link WideBvh}, the planes x = b begin that the ray meets first. Those that it meets last begin
     * at {@code 3 * width} less that.
     *
     * @param width number of children
     */
    public int nearPlanesX(int width) {
        return planes(inverseX, width);
    }

    /** The same for the planes y = b; those that the ray meets last begin at {@code 5 * width} less that. */
    public int nearPlanesY(int width) {
        return width + planes(inverseY, width);
    }

    /** The same for the planes z = b; those that the ray meets last begin at {@code 7 * width} less that. */
    public int nearPlanesZ(int width) {
        return 2 * width + planes(inverseZ, width);
    }

    /** Zero if the direction is positive, else how far the maxima lie behind the minima. */
    private static int planes(float inverse, int width) {
        return (Float.floatToRawIntBits(inverse) >> 31) & (3 * width);
    }

    private static float reciprocal(float d) {
        return Math.abs(d) < LEAST_DIRECTION ? Math.copySign(1 / LEAST_DIRECTION, d) : 1 / d;
    }
}
