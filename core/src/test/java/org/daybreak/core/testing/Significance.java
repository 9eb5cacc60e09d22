package org.daybreak.core.testing;

import org.apache.commons.numbers.gamma.Erfc;
import org.apache.commons.numbers.gamma.RegularizedBeta;
import org.apache.commons.numbers.gamma.RegularizedGamma;

/** p-values of the standard tests, and their correction for repetition. */
public final class Significance {
    private Significance() {}

    /** Probability that a standard normal variable is at least as far from 0 as z; 0 for NaN. */
    public static double normal(double z) {
        return Double.isNaN(z) ? 0 : Erfc.value(Math.abs(z) / Math.sqrt(2));
    }

    /** Probability that a variable of Student's distribution is at least as far from 0 as t; 0 for NaN. */
    public static double student(double t, double degreesOfFreedom) {
        if (Double.isNaN(t) || Double.isInfinite(t)) {
            return 0;
        }
        double x = degreesOfFreedom / (degreesOfFreedom + t * t);
        return RegularizedBeta.value(x, 0.5 * degreesOfFreedom, 0.5);
    }

    /** Probability that a χ² variable is at least as large as the statistic; 0 for NaN. */
    public static double chiSquare(double statistic, double degreesOfFreedom) {
        if (Double.isNaN(statistic) || Double.isInfinite(statistic)) {
            return 0;
        }
        return RegularizedGamma.Q.value(0.5 * degreesOfFreedom, 0.5 * statistic);
    }

    /**
     * Šidák's level for each of several independent tests, such that the probability of any false alarm among them is
     * {@code significance}.
     */
    public static double sidak(double significance, int tests) {
        return -Math.expm1(Math.log1p(-significance) / tests);
    }
}
