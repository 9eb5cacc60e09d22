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

    /** Radii in pixels of the neighbourhoods whose variances are averaged. */
    private static final int CLOSE = 1;

    private static final int WIDE = 8;
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

    /**
     * What the number of samples should be proportional to: the deviation, over the mean if the error is relative.
     *
     * <p>Light that is seldom found makes the deviation of most pixels look too small and that of a few too large, and pixels
     * with too few samples then show that light many times too bright. So variances are the mean of those of a pixel's
     * closest and of its wider neighbourhood.
     */
    private double[] importance(int width, int height, double[] means, double[] deviations) {
        double usual = usualVariance(deviations);
        double[] variances = new double[means.length];
        double[] brightness = new double[means.length];
        double mean = 0;
        for (int p = 0; p < means.length; p++) {
            double variance = deviations[p] * deviations[p];
            variances[p] = Double.isFinite(variance) ? variance : usual;
            brightness[p] = Math.max(0, means[p]);
            mean += brightness[p] / means.length;
        }
        double[] close = smoothed(width, height, variances, CLOSE);
        double[] wide = smoothed(width, height, variances, WIDE);
        double[] closeBrightness = smoothed(width, height, brightness, CLOSE);
        double[] importance = new double[means.length];
        for (int p = 0; p < importance.length; p++) {
            double deviation = Math.sqrt(Math.max(0, 0.5 * (close[p] + wide[p])));
            // In a black image every error is as good as any other.
            importance[p] =
                    relative && mean > 0 ? deviation / (closeBrightness[p] + RELATIVE_OFFSET * mean) : deviation;
        }
        return importance;
    }

    /** The mean variance of the pixels where it is known; 1 if it is nowhere. */
    private static double usualVariance(double[] deviations) {
        double sum = 0;
        int known = 0;
        for (double deviation : deviations) {
            if (Double.isFinite(deviation)) {
                sum += deviation * deviation;
                known++;
            }
        }
        return known == 0 ? 1 : sum / known;
    }

    /** Means over squares of pixels, cut off at the edges of the image; first along rows, then along columns. */
    private static double[] smoothed(int width, int height, double[] values, int radius) {
        double[] rows = new double[values.length];
        for (int y = 0; y < height; y++) {
            smooth(values, y * width, 1, width, radius, rows);
        }
        double[] smooth = new double[values.length];
        for (int x = 0; x < width; x++) {
            smooth(rows, x, width, height, radius, smooth);
        }
        return smooth;
    }

    private static void smooth(double[] values, int first, int step, int count, int radius, double[] out) {
        for (int i = 0; i < count; i++) {
            int from = Math.max(0, i - radius);
            int to = Math.min(count - 1, i + radius);
            double sum = 0;
            for (int j = from; j <= to; j++) {
                sum += values[first + j * step];
            }
            out[first + i * step] = sum / (to - from + 1);
        }
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
