package org.daybreak.cli.flip;

/**
 * Takes from an image in YCxCz what the eye cannot resolve, by contrast sensitivity functions for the achromatic, red-green and
 * blue-yellow channels (2020, section 4.1.1 and table 1). A function is a sum of two Gaussians, a·√(π/b)·exp(−π²d²/b) with the
 * distance d in degrees.
 */
final class ContrastFilter {
    private static final double[][] A = {{1}, {1}, {34.1, 13.5}};
    private static final double[][] B = {{0.0047}, {0.0053}, {0.04, 0.025}};
    private static final double WIDEST = 0.04;

    private final SeparableFilter filter;
    /** For each channel and Gaussian the kernel along an axis, and the weight of the Gaussian. */
    private final double[][][] kernels = new double[3][][];

    private final double[][] weights = new double[3][];

    ContrastFilter(int width, int height, double pixelsPerDegree) {
        filter = new SeparableFilter(width, height);
        int radius = (int) Math.ceil(3 * Math.sqrt(WIDEST / (2 * Math.PI * Math.PI)) * pixelsPerDegree);
        for (int c = 0; c < 3; c++) {
            kernels[c] = new double[A[c].length][2 * radius + 1];
            weights[c] = new double[A[c].length];
            double total = 0;
            for (int k = 0; k < A[c].length; k++) {
                double sum = 0;
                for (int i = -radius; i <= radius; i++) {
                    double d = i / pixelsPerDegree;
                    double value = Math.exp(-Math.PI * Math.PI * d * d / B[c][k]);
                    kernels[c][k][i + radius] = value;
                    sum += value;
                }
                for (int i = 0; i <= 2 * radius; i++) {
                    kernels[c][k][i] /= sum;
                }
                weights[c][k] = A[c][k] * Math.sqrt(Math.PI / B[c][k]) * sum * sum;
                total += weights[c][k];
            }
            for (int k = 0; k < A[c].length; k++) {
                weights[c][k] /= total;
            }
        }
    }

    /** Filters all three planes in place. */
    void apply(double[][] planes) {
        for (int c = 0; c < 3; c++) {
            double[] sum = new double[planes[c].length];
            for (int k = 0; k < kernels[c].length; k++) {
                double[] one = filter.apply(planes[c], kernels[c][k], kernels[c][k]);
                for (int p = 0; p < sum.length; p++) {
                    sum[p] += weights[c][k] * one[p];
                }
            }
            planes[c] = sum;
        }
    }
}
