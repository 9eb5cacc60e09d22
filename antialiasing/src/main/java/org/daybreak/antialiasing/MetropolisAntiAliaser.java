package org.daybreak.antialiasing;

import org.daybreak.core.sampling.Mixing;

/**
 * Decides where on the film the eye edges of mutated paths go (the thesis' class of that name, section 5.3): for the
 * mutation of the lens subpath stratified over the film, for the lens perturbation near where the path was. Immutable, without
 * memory of what it was asked before.
 *
 * <p>Filtering is not its matter: paths that were accepted are splatted through the filter of the film like all others.
 */
public final class MetropolisAntiAliaser {
    private final int width;
    private final int height;
    private final double smallest;
    private final double largest;
    private final long key;

    /**
     * Creates one.
     *
     * @param width of the film in pixels
     * @param height of the film in pixels
     * @param smallest r₁, the smallest distance of a perturbation in pixels, greater than 0
     * @param largest r₂, the largest distance, at least the smallest
     * @param key selects the orders in which pixels are visited
     */
    public MetropolisAntiAliaser(int width, int height, double smallest, double largest, long key) {
        this.width = width;
        this.height = height;
        this.smallest = smallest;
        this.largest = largest;
        this.key = key;
    }

    /**
     * The pixel for a proposal: of width·height consecutive numbers from a multiple of it on, a round, each leads to another pixel, in
     * an order that is a new one in each round. So no pixel is visited twice before all others were once. The pixel of a number
     * chosen at random is uniform.
     *
     * @param proposal number of the proposal, from 0
     * @return counted by rows
     */
    public long pixel(long proposal) {
        long pixels = (long) width * height;
        return PixelPermutation.permute(proposal % pixels, pixels, Mixing.absorb(key, proposal / pixels));
    }

    /** Film x of a point in a pixel, in pixels; the number is uniform in [0, 1). */
    public double x(long pixel, double number) {
        return pixel % width + number;
    }

    /** Film y of a point in a pixel, in pixels; the number is uniform in [0, 1). */
    public double y(long pixel, double number) {
        return Math.floorDiv(pixel, (long) width) + number;
    }

    /**
     * Distance, in pixels, of a perturbed point from where it was: r = r₂·exp(−ln(r₂/r₁)·ξ), which is distributed evenly on a
     * logarithmic scale (Veach 1997, eq. 11.9). In a direction that is uniform, the density on the film is
     * 1/(2πr²·ln(r₂/r₁)): it depends on the distance only, so it is the same there and back.
     *
     * @param number ξ, uniform in [0, 1)
     */
    public double distance(double number) {
        return largest * Math.exp(-Math.log(largest / smallest) * number);
    }

    /** Whether a film position lies on the film. */
    public boolean contains(double filmX, double filmY) {
        return filmX >= 0 && filmY >= 0 && filmX < width && filmY < height;
    }
}
