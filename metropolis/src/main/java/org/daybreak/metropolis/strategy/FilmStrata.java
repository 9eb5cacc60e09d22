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

    /** Film position, in pixels, for the number of a proposal and a uniform number. */
    double x(long stratum, double u) {
        return pixels.applyAsLong(stratum) % width + u;
    }

    /** The same downwards. */
    double y(long stratum, double v) {
        return Math.floorDiv(pixels.applyAsLong(stratum), width) + v;
    }
}
