package org.daybreak.metropolis.strategy;

import java.util.function.LongUnaryOperator;

/** Spreads image points over the film: a pixel for each number of a proposal, and a point in it. Immutable. */
public final class FilmStrata {
    private final int width;
    private final LongUnaryOperator pixels;

    /**
     * Creates strata of one pixel.
     *
     * @param width of the film in pixels
     * @param pixels gives the pixel of a number, counted by rows
     */
    public FilmStrata(int width, LongUnaryOperator pixels) {
        this.width = width;
        this.pixels = pixels;
    }

    /** The pixel for the number of a proposal. */
    long pixel(long stratum) {
        return pixels.applyAsLong(stratum);
    }

    /** Film position, in pixels, of a point in a pixel; the number is uniform. */
    double x(long pixel, double u) {
        return pixel % width + u;
    }

    /** The same downwards. */
    double y(long pixel, double v) {
        return Math.floorDiv(pixel, width) + v;
    }
}
