package org.daybreak.core.film;

/**
 * What the samples of a film say of the luminance of each pixel of its crop, row by row. Splats have no part in it. Immutable as
 * long as the arrays are not written to.
 *
 * @param weights sums of the weights of samples, Σw
 * @param effectiveSamples how many equally weighted samples would err as much, (Σw)²/Σw²; 0 without samples
 * @param means means, 0 without samples
 */
public record LuminanceStatistics(double[] weights, double[] effectiveSamples, double[] means) {
    /**
     * The standard deviation that a single sample would have were samples independent, estimated for each pixel from one
     * difference: that between the mean of the samples since an earlier moment and the mean before it. The mean over many pixels of
     * the squares is unbiased if both sets of samples are independent of each other, however the samples within each set are
     * stratified (the two buffers of Rousselle, Knaus and Zwicker, ACM TOG 31(6), 2012, section 4.1).
     *
     * @param earlier the same film's statistics at the earlier moment
     * @return not negative; NaN where there are no samples before or since
     */
    public double[] deviationsSince(LuminanceStatistics earlier) {
        double[] result = new double[means.length];
        for (int p = 0; p < result.length; p++) {
            double before = earlier.weights[p];
            double since = weights[p] - before;
            if (!(before > 0 && since > 0)) {
                result[p] = Double.NaN;
                continue;
            }
            double mean = (weights[p] * means[p] - before * earlier.means[p]) / since;
            double squaredWeights =
                    weights[p] * weights[p] / effectiveSamples[p] - before * before / earlier.effectiveSamples[p];
            double variances = squaredWeights / (since * since) + 1 / earlier.effectiveSamples[p];
            result[p] = Math.abs(mean - earlier.means[p]) / Math.sqrt(variances);
        }
        return result;
    }
}
