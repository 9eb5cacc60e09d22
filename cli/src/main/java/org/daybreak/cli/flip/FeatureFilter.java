package org.daybreak.cli.flip;

/** Finds edges and points by derivatives of a Gaussian, and how they differ between images (2020, section 4.2). */
final class FeatureFilter {
    /** Distance between the peak and the trough of the eye's edge detector, in degrees. */
    private static final double PEAK_TO_TROUGH = 0.082;

    private final SeparableFilter filter;
    private final double[] gaussian;
    private final double[] first;
    private final double[] second;

    FeatureFilter(int width, int height, double pixelsPerDegree) {
        filter = new SeparableFilter(width, height);
        double deviation = 0.5 * PEAK_TO_TROUGH * pixelsPerDegree;
        int radius = (int) Math.ceil(3 * deviation);
        gaussian = new double[2 * radius + 1];
        first = new double[2 * radius + 1];
        second = new double[2 * radius + 1];
        double sum = 0;
        for (int i = -radius; i <= radius; i++) {
            double g = Math.exp(-i * i / (2 * deviation * deviation));
            gaussian[i + radius] = g;
            first[i + radius] = -i * g;
            second[i + radius] = (i * i / (deviation * deviation) - 1) * g;
            sum += g;
        }
        for (int i = 0; i <= 2 * radius; i++) {
            gaussian[i] /= sum;
        }
        normalise(first);
        normalise(second);
    }

    /** Scales the positive numbers to a sum of 1 and the negative ones to −1. */
    private static void normalise(double[] kernel) {
        double positive = 0;
        double negative = 0;
        for (double value : kernel) {
            positive += Math.max(0, value);
            negative -= Math.min(0, value);
        }
        for (int i = 0; i < kernel.length; i++) {
            kernel[i] /= kernel[i] < 0 ? negative : positive;
        }
    }

    /** For each pixel the larger of the differences in the strength of edges and of points, from 0 to √2. */
    float[] difference(double[] lumaA, double[] lumaB) {
        double[] a = achromatic(lumaA);
        double[] b = achromatic(lumaB);
        double[] edgesA = strength(a, first);
        double[] edgesB = strength(b, first);
        double[] pointsA = strength(a, second);
        double[] pointsB = strength(b, second);
        float[] difference = new float[a.length];
        for (int p = 0; p < a.length; p++) {
            difference[p] = (float) Math.max(Math.abs(edgesA[p] - edgesB[p]), Math.abs(pointsA[p] - pointsB[p]));
        }
        return difference;
    }

    private static double[] achromatic(double[] luma) {
        double[] y = new double[luma.length];
        for (int p = 0; p < y.length; p++) {
            y[p] = (luma[p] + 16) / 116;
        }
        return y;
    }

    private double[] strength(double[] y, double[] kernel) {
        double[] alongX = filter.apply(y, kernel, gaussian);
        double[] alongY = filter.apply(y, gaussian, kernel);
        for (int p = 0; p < alongX.length; p++) {
            alongX[p] = Math.hypot(alongX[p], alongY[p]);
        }
        return alongX;
    }
}
