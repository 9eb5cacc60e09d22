package org.daybreak.cli.flip;

/** Filters planes of numbers by kernels that are products of one along x and one along y; pixels repeat beyond the edges. */
final class SeparableFilter {
    private final int width;
    private final int height;

    SeparableFilter(int width, int height) {
        this.width = width;
        this.height = height;
    }

    /**
     * Filters a plane.
     *
     * @param alongX kernel of odd length; index 0 is for the leftmost pixel
     * @param alongY kernel of odd length; index 0 is for the topmost pixel
     */
    double[] apply(double[] plane, double[] alongX, double[] alongY) {
        double[] rows = new double[plane.length];
        int rx = alongX.length / 2;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double sum = 0;
                for (int i = -rx; i <= rx; i++) {
                    int from = Math.max(0, Math.min(width - 1, x + i));
                    sum += alongX[i + rx] * plane[y * width + from];
                }
                rows[y * width + x] = sum;
            }
        }
        double[] filtered = new double[plane.length];
        int ry = alongY.length / 2;
        for (int y = 0; y < height; y++) {
            for (int i = -ry; i <= ry; i++) {
                double weight = alongY[i + ry];
                int from = Math.max(0, Math.min(height - 1, y + i)) * width;
                for (int x = 0; x < width; x++) {
                    filtered[y * width + x] += weight * rows[from + x];
                }
            }
        }
        return filtered;
    }
}
