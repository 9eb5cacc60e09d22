package org.daybreak.metropolis.chains;

import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.SplatBuffer;

/** The image of the first of two stages: the luminance in square cells of the film (thesis eq. 5.5; Veach 1997, §11.5). */
final class RoughImage {
    /**
     * Smallest luminance of a cell, as a part of the mean: with it steps are nowhere more than 20 times as dense as without the image.
     */
    private static final double FLOOR = 0.05;

    /**
     * The floor is raised to the luminance of cells that so many independent samples are expected in. Below, what is found is chance:
     * many cells would be taken for black that are not, and would get most of the steps.
     */
    private static final double SAMPLES_OF_FLOOR = 2;

    /** A guess at after how many steps a chain has forgotten where it was; the mean of the image does not depend on it. */
    private static final double STEPS_OF_SAMPLE = 100;

    private final int width;
    private final int height;
    private final int cell;
    private final int columns;
    private final int rows;
    private final double[] sums;
    private long steps;

    /** Creates a black image with cells of a number of pixels in each direction. */
    RoughImage(FilmSettings film, int cell) {
        width = film.width();
        height = film.height();
        this.cell = cell;
        columns = (width + cell - 1) / cell;
        rows = (height + cell - 1) / cell;
        sums = new double[Math.multiplyExact(columns, rows)];
    }

    /** Adds the splats of steps; they lie on the film. */
    void add(SplatBuffer splats, long taken) {
        steps += taken;
        for (int i = 0; i < splats.size(); i++) {
            int x = Math.min(columns - 1, Math.max(0, (int) (splats.filmX(i) / cell)));
            int y = Math.min(rows - 1, Math.max(0, (int) (splats.filmY(i) / cell)));
            sums[y * columns + x] += splats.luminance(i);
        }
    }

    /**
     * One over the image, in units of its mean: the brightness b of the second stage is then about that of the first. 1
     * everywhere if the image is black.
     *
     * @param chains how many chains have made the image
     */
    ImageImportance importance(int chains) {
        double total = 0;
        for (double sum : sums) {
            total += sum;
        }
        if (!(total > 0)) {
            return ImageImportance.UNIFORM;
        }
        double mean = total / ((double) width * height);
        double samples = Math.max(chains, steps / STEPS_OF_SAMPLE);
        double floor = Math.max(FLOOR, Math.min(1, SAMPLES_OF_FLOOR * sums.length / samples));
        double[] factors = new double[sums.length];
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                double area = (double) Math.min(cell, width - x * cell) * Math.min(cell, height - y * cell);
                double luminance = sums[y * columns + x] / area / mean;
                factors[y * columns + x] = 1 / Math.max(floor, luminance);
            }
        }
        return new ImageImportance(columns, rows, cell, factors);
    }
}
