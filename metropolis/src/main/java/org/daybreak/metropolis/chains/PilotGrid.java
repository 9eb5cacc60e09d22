package org.daybreak.metropolis.chains;

import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;

/** Cells of the film, in each of which a pilot surveys some pixels at random. Immutable. */
final class PilotGrid {
    /** Number of cells at most. */
    private static final int CELLS = 64;

    /** Number of pixels that are surveyed in each. */
    private static final int PER_CELL = 10;

    private final int width;
    private final int height;
    private final int columns;
    private final int rows;
    private final long seed;

    /** Divides a film; the pixels depend on the seed. */
    PilotGrid(FilmSettings film, long seed) {
        width = film.width();
        height = film.height();
        this.seed = seed;
        double edge = Math.sqrt((double) width * height / CELLS);
        columns = (int) Math.max(1, Math.min(Math.min(width, CELLS), Math.round(width / edge)));
        rows = Math.max(1, Math.min(height, CELLS / columns));
    }

    /** Number of cells. */
    int cells() {
        return columns * rows;
    }

    /** Number of surveys. */
    int surveys() {
        return PER_CELL * cells();
    }

    private int cellOfSurvey(int survey) {
        return survey % cells();
    }

    /** The cell of a film position in pixels. */
    int cell(double filmX, double filmY) {
        int x = Math.min(columns - 1, Math.max(0, (int) (filmX / width * columns)));
        int y = Math.min(rows - 1, Math.max(0, (int) (filmY / height * rows)));
        return y * columns + x;
    }

    /** Column of the pixel of a survey. */
    int column(int survey) {
        return place(survey, 0, cellOfSurvey(survey) % columns, columns, width);
    }

    /** Row of the pixel of a survey. */
    int row(int survey) {
        return place(survey, 1, cellOfSurvey(survey) / columns, rows, height);
    }

    private int place(int survey, int axis, int part, int parts, int size) {
        double u = new RandomStream(seed, StreamDomain.PIXEL, survey, axis).nextDouble();
        return Math.min(size - 1, (int) ((part + u) / parts * size));
    }
}
