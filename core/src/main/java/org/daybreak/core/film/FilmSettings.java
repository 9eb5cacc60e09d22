package org.daybreak.core.film;

/**
 * Size and filter of a film. Immutable.
 *
 * @param width full width in pixels
 * @param height full height in pixels
 * @param crop part that is rendered
 * @param filter reconstruction filter
 * @param filterSampling whether the offsets of samples from the centres of their pixels are drawn in proportion to the
 *     filter's absolute value, and samples count for their own pixel only (Ernst, Stamminger and Greiner, “Filter Importance
 *     Sampling”, RT 2006): errors of neighbouring pixels are then independent. Otherwise samples are spread evenly and each
 *     counts for all pixels that the filter reaches.
 */
public record FilmSettings(int width, int height, Crop crop, ReconstructionFilter filter, boolean filterSampling) {
    /** Largest side of a film in pixels. */
    public static final int MAX_SIZE = 65_536;

    /** Checks the numbers. */
    public FilmSettings {
        if (width < 1 || height < 1 || width > MAX_SIZE || height > MAX_SIZE) {
            throw new IllegalArgumentException(
                    "the film must have 1 to " + MAX_SIZE + " pixels in each direction but is " + width + "x" + height);
        }
        if (crop.x() < 0
                || crop.y() < 0
                || crop.width() < 1
                || crop.height() < 1
                || (long) crop.x() + crop.width() > width
                || (long) crop.y() + crop.height() > height) {
            throw new IllegalArgumentException(
                    "the crop " + crop + " must lie within the film of " + width + "x" + height);
        }
    }

    /** A film whose samples are spread evenly. */
    public FilmSettings(int width, int height, Crop crop, ReconstructionFilter filter) {
        this(width, height, crop, filter, false);
    }

    /** The same film with or without filter sampling. */
    public FilmSettings withFilterSampling(boolean sampling) {
        return new FilmSettings(width, height, crop, filter, sampling);
    }

    /** A whole film. */
    public FilmSettings(int width, int height, ReconstructionFilter filter) {
        this(width, height, new Crop(0, 0, width, height), filter);
    }

    /**
     * A rectangle of pixels.
     *
     * @param x first column
     * @param y first row
     * @param width number of columns
     * @param height number of rows
     */
    public record Crop(int x, int y, int width, int height) {
        @Override
        public String toString() {
            return x + "," + y + "," + width + "," + height;
        }
    }
}
