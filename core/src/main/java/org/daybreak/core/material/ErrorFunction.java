package org.daybreak.core.material;

/** The complementary error function, scaled so that it neither underflows nor loses relative accuracy. */
final class ErrorFunction {
    /** Where the mapping of [0, ∞) onto [−1, 1) has its zero. */
    private static final double CENTRE = 3.75;

    /** Chebyshev coefficients of (1 + 2x)·erfcx(x) in y = (x − 3.75)/(x + 3.75), computed to 40 digits. */
    private static final double[] COEFFICIENTS = {
        1.17757893456740175,
        -4.59005458064647733e-3,
        -8.42491333665179156e-2,
        5.92099399981918905e-2,
        -2.66586684353057523e-2,
        9.07499767070526509e-3,
        -2.41316354041760819e-3,
        4.90775836525808632e-4,
        -6.91697330250120637e-5,
        4.13902798607301017e-6,
        7.74038306619849067e-7,
        -2.18864010492343957e-7,
        1.07649994656709104e-8,
        4.52195981122182890e-9,
        -7.75440020883135111e-10,
        -6.31808834088668449e-11,
        2.86879501093066990e-11,
        1.94558685457773472e-13,
        -9.65469674843343891e-13,
        3.25254814814873984e-14,
        3.34781194828680539e-14,
        -1.86456288041931310e-15,
        -1.25079505306886471e-15
    };

    private ErrorFunction() {}

    /**
     * erfcx(x) = exp(x²)·erfc(x), to a relative error of about 1e-15.
     *
     * <p>The form is that of Shepherd and Laframboise, “Chebyshev approximation of (1 + 2x) exp(x²) erfc x in
     * 0 ≤ x &lt; ∞”, Math. Comp. 36 (1981).
     *
     * @param x not negative; infinity gives 0
     */
    static double scaledComplement(double x) {
        if (x == Double.POSITIVE_INFINITY) {
            return 0;
        }
        double y = (x - CENTRE) / (x + CENTRE);
        double twice = 2 * y;
        double next = 0;
        double current = 0;
        for (int i = COEFFICIENTS.length - 1; i > 0; i--) {
            double sum = COEFFICIENTS[i] + twice * current - next;
            next = current;
            current = sum;
        }
        return (COEFFICIENTS[0] + y * current - next) / (1 + 2 * x);
    }

    /**
     * erfc(x) for any x, where the caller has exp(−x²) at hand.
     *
     * @param gaussian exp(−x²)
     */
    static double complement(double x, double gaussian) {
        return x >= 0 ? gaussian * scaledComplement(x) : 2 - gaussian * scaledComplement(-x);
    }
}
