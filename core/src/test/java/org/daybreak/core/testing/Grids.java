package org.daybreak.core.testing;

/** Averages over the tiles of a picture. */
public final class Grids {
    private Grids() {}

    /** How many tiles cover a length, the last one perhaps in part. */
    public static int tiles(int length, int tile) {
        return (length + tile - 1) / tile;
    }

    /**
     * The mean of the values of each tile, row by row.
     *
     * @param values one value per pixel, row by row
     * @param width pixels per row
     * @param tile edge of a tile in pixels
     * @throws IllegalArgumentException if the values do not fill the rows
     */
    public static double[] tileMeans(double[] values, int width, int tile) {
        return tileSums(values, width, tile, false);
    }

    /**
     * The variance of the mean of each tile, for independent pixels: the sum of their variances by the squared count.
     *
     * @param variances variance of each pixel, row by row
     * @param width pixels per row
     * @param tile edge of a tile in pixels
     * @throws IllegalArgumentException if the values do not fill the rows
     */
    public static double[] tileVariances(double[] variances, int width, int tile) {
        return tileSums(variances, width, tile, true);
    }

    private static double[] tileSums(double[] values, int width, int tile, boolean squaredCount) {
        if (width < 1 || values.length % width != 0) {
            throw new IllegalArgumentException(values.length + " values do not fill rows of " + width);
        }
        int height = values.length / width;
        int columns = tiles(width, tile);
        double[] sums = new double[columns * tiles(height, tile)];
        int[] counts = new int[sums.length];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int index = y / tile * columns + x / tile;
                sums[index] += values[y * width + x];
                counts[index]++;
            }
        }
        for (int i = 0; i < sums.length; i++) {
            sums[i] /= squaredCount ? (double) counts[i] * counts[i] : counts[i];
        }
        return sums;
    }
}
