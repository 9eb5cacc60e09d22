package org.daybreak.core.film;

/**
 * Draws offsets of samples from the centres of their pixels in proportion to the absolute value of a filter (Ernst, Stamminger
 * and Greiner, “Filter Importance Sampling”, RT 2006), along each axis by inversion of a table. The mean of radiance times
 * factor is the pixel's value: the factor is 1 for filters without negative lobes, up to the table's steps. Near the edges of
 * the film offsets are drawn from the part of the filter that lies on it, as in {@link Film}. Immutable.
 */
public final class FilterSampler {
    private final FilterKernel kernel;
    private final int width;
    private final int height;

    FilterSampler(FilmSettings settings, FilterKernel kernel) {
        this.kernel = kernel;
        width = settings.width();
        height = settings.height();
    }

    /**
     * Draws a film position.
     *
     * @param x column of the pixel
     * @param y row of the pixel
     * @param u uniform number in [0,1) for the horizontal offset
     * @param v uniform number in [0,1) for the vertical offset
     * @param dest receives the film position, in pixels, and the factor on the radiance
     */
    public void sample(int x, int y, double u, double v, double[] dest) {
        double factorX = sampleAxis(x, width, u, dest, 0);
        double factorY = sampleAxis(y, height, v, dest, 1);
        dest[2] = factorX * factorY;
    }

    /** Draws the position along one axis and returns its factor. */
    double sampleAxis(int pixel, int size, double u, double[] dest, int axis) {
        double from = -(pixel + 0.5);
        double to = size - (pixel + 0.5);
        double below = kernel.absoluteIntegral(0, from);
        double total = kernel.absoluteIntegral(from, to);
        double offset = kernel.absoluteQuantile(below + u * total);
        double position = pixel + 0.5 + offset;
        dest[axis] = Math.max(0, Math.min(position, Math.nextDown((double) size)));
        // Weight over density, the weight scaled to integrate to 1 over the film.
        double density = kernel.absoluteStep(offset) / total;
        return density > 0 ? kernel.weight(offset) / (density * kernel.integral(from, to)) : 0;
    }
}
