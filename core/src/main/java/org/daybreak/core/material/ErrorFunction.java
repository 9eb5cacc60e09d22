package org.daybreak.core.material;

/** The complementary error function, scaled so that it neither underflows nor loses relative accuracy. */
final class ErrorFunction {
    /** Where the mapping of [0, ∞) onto [−1, 1) has its zero. */
    private static final double CENTRE = 3.75;

    /** Chebyshev coefficients of (1 + 2x)·erfcx(x) in y = (x − 3.75)/(x + 3.75), computed to 40 digits. */
    private static final double[] COEFFICIENTS = {
        1.1775789345674017,
        -0.004590054580646478,
        -0.08424913336651792,
        0.05920993999819189,
        -0.026658668435305753,
        0.009074997670705265,
        -0.002413163540417608,
        0.0004907758365258086,
        -6.916973302501207e-5,
        4.13902798607301e-6,
        7.74038306619849e-7,
        -2.1886401049234397e-7,
        1.076499946567091e-8,
        4.521959811221829e-9,
        -7.754400208831351e-10,
        -6.318088340886684e-11,
        2.86879501093067e-11,
        1.9455868545777347e-13,
        -9.65469674843344e-13,
        3.25254814814874e-14,
        3.3478119482868056e-14,
        -1.864562880419313e-15,
        -1.2507950530688648e-15
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
