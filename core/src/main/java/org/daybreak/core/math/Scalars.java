package org.daybreak.core.math;

/** Robust scalar functions. */
public final class Scalars {
    private Scalars() {}

    /** The square of {@code x}. */
    public static double square(double x) {
        return x * x;
    }

    /** Linear interpolation, exact at both ends: {@code a} for t = 0 and {@code b} for t = 1. */
    public static double lerp(double t, double a, double b) {
        return (1 - t) * a + t * b;
    }

    /** The value of [{@code low}, {@code high}] nearest to {@code x}; NaN stays NaN. */
    public static double clamp(double x, double low, double high) {
        return Math.min(Math.max(x, low), high);
    }

    /** Square root of a quantity that rounding may have pushed below zero; 0 for negative arguments. */
    public static double sqrtClamped(double x) {
        return Math.sqrt(Math.max(0, x));
    }

    /** Arc cosine of a quantity that rounding may have pushed out of [−1, 1]. */
    public static double acosClamped(double x) {
        return Math.acos(clamp(x, -1, 1));
    }

    /**
     * {@code ab − cd} without the cancellation of the plain formula; the error is below 1.5 ulp.
     *
     * <p>Kahan's method; see Jeannerod, Louvet and Muller, “Further analysis of Kahan's algorithm for the accurate
     * computation of 2×2 determinants”, Math. Comp. 82 (2013).
     */
    public static double differenceOfProducts(double a, double b, double c, double d) {
        double cd = c * d;
        double error = Math.fma(-c, d, cd);
        return Math.fma(a, b, -cd) + error;
    }
}
