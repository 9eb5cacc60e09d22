package org.daybreak.core.math;

/**
 * Arc functions for hot paths, several times as fast as those of {@link Math}, which compute them in portable steps. Off by
 * less than 1.5e-15 relative to the result (the addition theorem costs two roundings); the same bits everywhere.
 */
public final class Arcs {
    /** tan(π/8): up to here the polynomial holds. */
    private static final double TAN_EIGHTH = 0.41421356237309503;

    private Arcs() {}

    /**
     * Angle of the vector (x, y) from the positive x axis, in [−π, π]; as {@link Math#atan2} for finite arguments.
     * 0 for the zero vector.
     */
    public static double atan2(double y, double x) {
        double ax = Math.abs(x);
        double ay = Math.abs(y);
        double large = Math.max(ax, ay);
        if (large == 0) {
            return 0;
        }
        double small = Math.min(ax, ay);
        // Octant angle of small/large in [0, 1]; above tan(π/8) by the addition theorem about π/4.
        double octant;
        if (small <= TAN_EIGHTH * large) {
            octant = atanSmall(small / large);
        } else {
            octant = 0.25 * Math.PI + atanSmall((small - large) / (small + large));
        }
        double quadrant = ay > ax ? 0.5 * Math.PI - octant : octant;
        return Math.copySign(x < 0 ? Math.PI - quadrant : quadrant, y);
    }

    /** Arc cosine of a number in [−1, 1]; arguments beyond by rounding are taken as the ends. */
    public static double acos(double x) {
        return atan2(Math.sqrt(Math.max(0, (1 - x) * (1 + x))), x);
    }

    /**
     * Arc tangent for |x| ≤ tan(π/8): Chebyshev fit of atan(√s)/√s on [0, tan²(π/8)], error 3.5e-17 before rounding.
     */
    private static double atanSmall(double x) {
        double s = x * x;
        double p = 0.021135373157693246;
        p = p * s - 0.04348052215716462;
        p = p * s + 0.056883492268090106;
        p = p * s - 0.06640233930429408;
        p = p * s + 0.07689953496306857;
        p = p * s - 0.09090773074808414;
        p = p * s + 0.11111106180455944;
        p = p * s - 0.1428571418096647;
        p = p * s + 0.1999999999885511;
        p = p * s - 0.3333333333332844;
        return x + x * (s * p);
    }
}
