package org.daybreak.core.testing;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.Locale;

/**
 * Tests whether means agree. Where the variance is estimated, from samples or from independent runs, the statistic is
 * compared with Student's distribution, so that few runs do not raise the false-alarm rate.
 *
 * <p>All tests are two-sided. Their p-value is below α with probability α if the means agree.
 */
public final class ZTest {
    private static final double ROUNDING = 1e-6;

    private ZTest() {}

    /** p-value of a mean with a known standard error against its expectation. */
    public static double known(double mean, double standardError, double expected) {
        return ofDifference(mean - expected, standardError * standardError, Double.POSITIVE_INFINITY);
    }

    /** p-value of the mean of independent numbers against its expectation (one-sample t-test). */
    public static double oneSample(Moments sample, double expected) {
        return ofDifference(sample.mean() - expected, sample.varianceOfMean(), sample.count() - 1.0);
    }

    /** p-value of two means with known variances (two-sample z-test). */
    public static double twoSampleKnown(double mean1, double varianceOfMean1, double mean2, double varianceOfMean2) {
        return ofDifference(mean1 - mean2, varianceOfMean1 + varianceOfMean2, Double.POSITIVE_INFINITY);
    }

    /** p-value of the means of two sets of independent numbers of unequal variances (Welch's t-test). */
    public static double twoSample(Moments sample1, Moments sample2) {
        return twoSample(sample1, sample2, 0);
    }

    private static double twoSample(Moments sample1, Moments sample2, double rounding) {
        double v1 = sample1.varianceOfMean();
        double v2 = sample2.varianceOfMean();
        double degreesOfFreedom =
                (v1 + v2) * (v1 + v2) / (v1 * v1 / (sample1.count() - 1) + v2 * v2 / (sample2.count() - 1));
        double difference = Math.abs(sample1.mean() - sample2.mean());
        double counted = Math.max(0, difference - rounding * Math.abs(sample1.mean()));
        return ofDifference(counted, v1 + v2, degreesOfFreedom);
    }

    /**
     * Fails if a p-value is below the significance level.
     *
     * @param what what was tested, for the message
     * @param pValue the p-value
     * @param significance the false-alarm rate of this assertion
     */
    public static void assertNotRejected(String what, double pValue, double significance) {
        if (!(pValue >= significance)) {
            fail(String.format(Locale.ROOT, "%s: p = %.3g is below %.3g", what, pValue, significance));
        }
    }

    /**
     * Fails if any p-value is below Šidák's level for all of them.
     *
     * @param what what was tested, for the message
     * @param pValues p-values of independent tests, such as those of the tiles of a picture
     * @param significance the false-alarm rate of the whole assertion
     */
    public static void assertNoneRejected(String what, double[] pValues, double significance) {
        double level = Significance.sidak(significance, pValues.length);
        int worst = 0;
        int rejected = 0;
        for (int i = 0; i < pValues.length; i++) {
            if (!(pValues[i] >= level)) {
                rejected++;
            }
            if (!(pValues[i] >= pValues[worst])) {
                worst = i;
            }
        }
        if (rejected > 0) {
            fail(String.format(
                    Locale.ROOT,
                    "%s: %d of %d tests rejected; the worst is number %d with p = %.3g, below %.3g",
                    what,
                    rejected,
                    pValues.length,
                    worst,
                    pValues[worst],
                    level));
        }
    }

    /**
     * p-values of a picture against expected values with known variances, tile by tile.
     *
     * @param means tile means of the picture
     * @param variancesOfMeans variances of these means
     * @param expected tile means of the reference
     * @param expectedVariances variances of the means of the reference; all 0 for a closed form
     */
    public static double[] tiles(
            double[] means, double[] variancesOfMeans, double[] expected, double[] expectedVariances) {
        double[] pValues = new double[means.length];
        for (int i = 0; i < pValues.length; i++) {
            pValues[i] = twoSampleKnown(means[i], variancesOfMeans[i], expected[i], expectedVariances[i]);
        }
        return pValues;
    }

    /**
     * p-values of two renderers tile by tile, from independent runs of each. A relative difference of {@value #ROUNDING} is not counted: pictures are in
     * single precision, and where no sample differs from another nothing else would be left.
     *
     * @param runs1 tile means of each run of the first
     * @param runs2 tile means of each run of the second
     */
    public static double[] tilesOfRuns(double[][] runs1, double[][] runs2) {
        double[] pValues = new double[runs1[0].length];
        for (int i = 0; i < pValues.length; i++) {
            pValues[i] = twoSample(column(runs1, i), column(runs2, i), ROUNDING);
        }
        return pValues;
    }

    private static Moments column(double[][] runs, int tile) {
        Moments moments = new Moments();
        for (double[] run : runs) {
            moments.add(run[tile]);
        }
        return moments;
    }

    private static double ofDifference(double difference, double variance, double degreesOfFreedom) {
        if (variance == 0) {
            return difference == 0 ? 1 : 0;
        }
        double t = difference / Math.sqrt(variance);
        return degreesOfFreedom < Double.POSITIVE_INFINITY
                ? Significance.student(t, degreesOfFreedom)
                : Significance.normal(t);
    }
}
