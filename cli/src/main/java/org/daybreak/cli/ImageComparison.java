package org.daybreak.cli;

/**
 * How far channels of an image are from those of a reference. Pixels where one of the two is infinite or not a number are
 * counted and left out. Not thread-safe.
 */
final class ImageComparison {
    /** Keeps the relative error finite in black pixels; the value used throughout the field. */
    private static final double RELATIVE_OFFSET = 0.01;

    private long count;
    private long nonFinite;
    private double squares;
    private double relativeSquares;
    private double sum;
    private double referenceSum;

    /** Adds a channel; both arrays have the same length. */
    void add(float[] image, float[] reference) {
        for (int i = 0; i < image.length; i++) {
            double r = reference[i];
            double d = image[i] - r;
            if (Double.isFinite(d)) {
                count++;
                squares += d * d;
                relativeSquares += d * d / (r * r + RELATIVE_OFFSET);
                sum += d;
                referenceSum += r;
            } else {
                nonFinite++;
            }
        }
    }

    /** Root of the mean squared difference. */
    double rmse() {
        return Math.sqrt(squares / count);
    }

    /** Mean of the squared difference over (reference² + 0.01). */
    double relMse() {
        return relativeSquares / count;
    }

    /** Mean of image − reference. */
    double bias() {
        return sum / count;
    }

    /** The bias over the mean of the reference. */
    double relativeBias() {
        return sum / referenceSum;
    }

    /** Number of values that were left out. */
    long nonFinite() {
        return nonFinite;
    }
}
