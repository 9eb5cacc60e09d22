package org.daybreak.antialiasing;

import java.util.Arrays;
import org.daybreak.core.render.SampleAllocation;

/**
 * Samples in proportion to the standard error that a pixel would have with equal numbers, which makes the sum of the squared errors
 * least (Neyman, J. Royal Statistical Society 97, 1934), or to its ratio to the pixel's brightness.
 *
 * <p><b>Error.</b> Taken from the difference of two passes, whose samples are stratified apart. The scatter of the samples within a
 * pixel would not do: stratification removes nearly all of it at edges and in soft shadows, and nearly nothing where light is seldom
 * found (Rousselle, Knaus and Zwicker, ACM TOG 31(6), 2012, section 4.1). A single difference says little, and light that is
 * seldom found shows in few pixels, while its next hit may come in any of their neighbours; so squared errors are averaged over
 * a close and a wide neighbourhood.
 *
 * <p><b>Numbers</b> are 2ᵏ or 3·2ᵏ, of which Sobol′ points make good sets: rounded up or down so that their mean is what was wanted,
 * by thresholds that are spread evenly over the image.
 *
 * @param firstPass samples per pixel of each of the first two passes, which are uniform
 * @param relative whether the error is taken over the brightness
 * @param uniformShare part of the samples that is divided evenly, in (0, 1]
 */
record DeviationAllocation(int firstPass, boolean relative, double uniformShare) implements SampleAllocation {
    /** Added to the brightness in squares, as a part of the image's mean: black pixels are not worth all samples. */
    private static final double RELATIVE_OFFSET = 0.25;

    /** Radii in pixels of the neighbourhoods whose squared errors are averaged. */
    private static final int CLOSE = 4;

    private static final int WIDE = 16;

    /** Radius of the neighbourhood whose brightness is averaged. */
    private static final int BRIGHTNESS = 1;

    /** The growth of passes, the last one apart, which takes what is left. */
    private static final int GROWTH = 4;

    private static final int SMALLEST_REST = 3;

    private static final int LARGEST_COUNT = 1 << 30;
    private static final int BISECTIONS = 48;

    /** Irrational steps of the thresholds from column to column and row to row (the plastic number's powers −1 and −2). */
    private static final double COLUMN_STEP = 0.7548776662466927;

    private static final double ROW_STEP = 0.5698402909980532;

    @Override
    public long[] passes(long samplesPerPixel) {
        if (samplesPerPixel < 4L * firstPass) {
            // Too few to learn anything from.
            return new long[] {samplesPerPixel};
        }
        long[] passes = new long[Long.SIZE];
        passes[0] = firstPass;
        passes[1] = firstPass;
        int n = 2;
        long sum = 2L * firstPass;
        while (sum < samplesPerPixel) {
            long next = GROWTH * sum;
            long end = SMALLEST_REST * next <= samplesPerPixel ? next : samplesPerPixel;
            passes[n++] = end - sum;
            sum = end;
        }
        return Arrays.copyOf(passes, n);
    }

    @Override
    public void allocate(Statistics statistics, long average, int[] counts) {
        double[] shares = errors(statistics);
        double sum = 0;
        for (double share : shares) {
            sum += share;
        }
        int n = shares.length;
        for (int p = 0; p < n; p++) {
            double adaptive = sum > 0 ? shares[p] * n / sum : 1;
            shares[p] = uniformShare + (1 - uniformShare) * adaptive;
        }
        double scale = scale(shares, statistics.width(), average);
        for (int p = 0; p < n; p++) {
            counts[p] = count(shares[p] * scale, threshold(p, statistics.width()));
        }
    }

    /** What the number of samples should be proportional to; all 0 if nothing is known. */
    private double[] errors(Statistics statistics) {
        double[] squares = squares(statistics.deviations(), importance(statistics));
        double[] close = smoothed(statistics, squares, CLOSE);
        double[] wide = smoothed(statistics, squares, WIDE);
        double[] errors = new double[squares.length];
        for (int p = 0; p < errors.length; p++) {
            errors[p] = Math.sqrt(Math.max(0, 0.5 * (close[p] + wide[p])));
        }
        return errors;
    }

    /** What a squared error of a pixel is multiplied by. */
    private double[] importance(Statistics statistics) {
        int n = statistics.means().length;
        double[] brightness = new double[n];
        double mean = 0;
        for (int p = 0; p < n; p++) {
            brightness[p] = Math.max(0, statistics.means()[p]);
            mean += brightness[p] / n;
        }
        double[] smooth = smoothed(statistics, brightness, BRIGHTNESS);
        double offset = RELATIVE_OFFSET * mean;
        for (int p = 0; p < n; p++) {
            // In a black image every error is as good as any other.
            brightness[p] = relative && mean > 0 ? 1 / (smooth[p] * smooth[p] + offset * offset) : 1;
        }
        return brightness;
    }

    /** Squares times importance, with the mean of the known ones where they are unknown; all 0 if none is known. */
    private static double[] squares(double[] deviations, double[] importance) {
        double[] squares = new double[deviations.length];
        double sum = 0;
        int known = 0;
        for (int p = 0; p < squares.length; p++) {
            squares[p] = deviations[p] * deviations[p] * importance[p];
            if (Double.isFinite(squares[p])) {
                sum += squares[p];
                known++;
            }
        }
        double usual = known == 0 ? 0 : sum / known;
        for (int p = 0; p < squares.length; p++) {
            if (!Double.isFinite(squares[p])) {
                squares[p] = usual;
            }
        }
        return squares;
    }

    /** Means over squares of pixels, cut off at the edges of the image; first along rows, then along columns. */
    private static double[] smoothed(Statistics statistics, double[] values, int radius) {
        int width = statistics.width();
        int height = statistics.height();
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

    /** The largest factor on the shares with which the rounded numbers do not exceed the budget. */
    private static double scale(double[] shares, int width, long average) {
        double budget = (double) average * shares.length;
        double low = 0;
        double high = 2.0 * average * shares.length;
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = 0.5 * (low + high);
            double sum = 0;
            for (int p = 0; p < shares.length; p++) {
                sum += count(shares[p] * middle, threshold(p, width));
            }
            if (sum <= budget) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private static double threshold(int pixel, int width) {
        int row = pixel / width;
        int column = pixel - row * width;
        double t = column * COLUMN_STEP + row * ROW_STEP;
        return t - Math.floor(t);
    }

    /** The largest 2ᵏ or 3·2ᵏ below a number or the next one, so that the mean over thresholds is the number. */
    private static int count(double wanted, double threshold) {
        if (wanted <= 1) {
            return 1;
        }
        if (wanted >= LARGEST_COUNT) {
            return LARGEST_COUNT;
        }
        int power = Integer.highestOneBit((int) wanted);
        int middle = power + power / 2;
        int below = wanted < middle ? power : middle;
        int above = wanted < middle ? middle : 2 * power;
        return threshold * (above - below) < wanted - below ? above : below;
    }
}
