package org.daybreak.metropolis.chains;

import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.SplatBuffer;

/** The image of the first of two stages: the luminance in square cells of the film (thesis eq. 5.5; Veach 1997, §11.5). */
final class RoughImage {
    /**
     * Smallest luminance of a cell, as a part of the mean. Cells in which the first stage found next to nothing may still hold some
     * light: with this floor their steps are at most 20 times as dense as without the image, however little was found.
     * And no cell darker than that takes away from others what their brightness asks for.
     */
    private static final double FLOOR = 0.05;

    private final int width;
    private final int height;
    private final int cell;
    private final int columns;
    private final int rows;
    private final double[] sums;

    /** Creates a black image with cells of a number of pixels in each direction. */
    RoughImage(FilmSettings film, int cell) {
        width = film.width();
        height = film.height();
        this.cell = cell;
        columns = (width + cell - 1) / cell;
        rows = (height + cell - 1) / cell;
        sums = new double[Math.multiplyExact(columns, rows)];
    }

    /** Adds splats; they lie on the film. */
    void add(SplatBuffer splats) {
        for (int i = 0; i < splats.size(); i++) {
            int x = Math.min(columns - 1, Math.max(0, (int) (splats.filmX(i) / cell)));
            int y = Math.min(rows - 1, Math.max(0, (int) (splats.filmY(i) / cell)));
            sums[y * columns + x] += splats.luminance(i);
        }
    }

    /**
     * One over the image, in units of its mean: the brightness b of the second stage is then about that of the first. 1
     * everywhere if the image is black.
     */
    ImageImportance importance() {
        double total = 0;
        for (double sum : sums) {
            total += sum;
        }
        if (!(total > 0)) {
            return ImageImportance.UNIFORM;
        }
        double mean = total / ((double) width * height);
        double[] factors = new double[sums.length];
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                double area = (double) Math.min(cell, width - x * cell) * Math.min(cell, height - y * cell);
                double luminance = sums[y * columns + x] / area / mean;
                factors[y * columns + x] = 1 / Math.max(FLOOR, luminance);
            }
        }
        return new ImageImportance(columns, rows, cell, factors);
    }
}
