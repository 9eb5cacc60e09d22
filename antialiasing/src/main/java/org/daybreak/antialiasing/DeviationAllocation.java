package org.daybreak.antialiasing;

import java.util.Arrays;
import org.daybreak.core.render.SampleAllocation;

/**
 * Samples in proportion to the standard deviation, as powers of two, of which Sobol′ points make the best sets.
 *
 * @param firstPass samples per pixel of the first pass
 * @param relative whether the deviation is taken over the mean
 * @param uniformShare part of the samples that is divided evenly, in (0, 1]
 */
record DeviationAllocation(int firstPass, boolean relative, double uniformShare) implements SampleAllocation {
    /** Added to the means, as a part of the image's mean: black pixels are not worth all samples. */
    private static final double RELATIVE_OFFSET = 0.05;

    private static final int LARGEST_EXPONENT = 30;
    private static final int BISECTIONS = 48;

    @Override
    public long[] passes(long samplesPerPixel) {
        long[] passes = new long[Long.SIZE];
        int n = 0;
        long sum = 0;
        while (sum < samplesPerPixel) {
            passes[n] = Math.min(Math.max(firstPass, sum), samplesPerPixel - sum);
            sum += passes[n++];
        }
        return Arrays.copyOf(passes, n);
    }

    @Override
    public void allocate(int width, int height, double[] means, double[] deviations, long average, int[] counts) {
        double[] shares = importance(width, height, means, deviations);
        double sum = 0;
        for (double share : shares) {
            sum += share;
        }
        int n = shares.length;
        for (int p = 0; p < n; p++) {
            double adaptive = sum > 0 ? shares[p] * n / sum : 1;
            double share = uniformShare + (1 - uniformShare) * adaptive;
            shares[p] = Math.log(average * share) / Math.log(2);
        }
        fill(shares, scale(shares, (double) average * n), counts);
    }

    /** What the number of samples should be proportional to: the deviation, smoothed over 3×3 pixels, over the mean. */
    private double[] importance(int width, int height, double[] means, double[] deviations) {
        double mean = 0;
        double variance = 0;
        int known = 0;
        for (int p = 0; p < means.length; p++) {
            mean += means[p] / means.length;
            if (Double.isFinite(deviations[p])) {
                variance += deviations[p] * deviations[p];
                known++;
            }
        }
        double usual = known == 0 ? 1 : Math.sqrt(variance / known);
        double[] importance = new double[means.length];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double squares = 0;
                double brightness = 0;
                int pixels = 0;
                for (int j = Math.max(0, y - 1); j <= Math.min(height - 1, y + 1); j++) {
                    for (int i = Math.max(0, x - 1); i <= Math.min(width - 1, x + 1); i++) {
                        double deviation = deviations[j * width + i];
                        double d = Double.isFinite(deviation) ? deviation : usual;
                        squares += d * d;
                        brightness += Math.max(0, means[j * width + i]);
                        pixels++;
                    }
                }
                double deviation = Math.sqrt(squares / pixels);
                // In a black image every error is as good as any other.
                importance[y * width + x] =
                        relative && mean > 0 ? deviation / (brightness / pixels + RELATIVE_OFFSET * mean) : deviation;
            }
        }
        return importance;
    }

    /** The largest addend to the logarithms with which the rounded numbers do not exceed the budget. */
    private static double scale(double[] logarithms, double budget) {
        double low = -LARGEST_EXPONENT;
        double high = LARGEST_EXPONENT;
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = 0.5 * (low + high);
            double sum = 0;
            for (double logarithm : logarithms) {
                sum += 1L << exponent(logarithm + middle);
            }
            if (sum <= budget) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private static void fill(double[] logarithms, double scale, int[] counts) {
        for (int p = 0; p < counts.length; p++) {
            counts[p] = 1 << exponent(logarithms[p] + scale);
        }
    }

    private static int exponent(double logarithm) {
        return (int) Math.max(0, Math.min(LARGEST_EXPONENT, Math.rint(logarithm)));
    }
}
