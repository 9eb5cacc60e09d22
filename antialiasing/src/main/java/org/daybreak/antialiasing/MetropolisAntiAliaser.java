package org.daybreak.antialiasing;

import org.daybreak.core.sampling.Mixing;

/**
 * Decides where on the film the eye edges of mutated paths go (the thesis' class of that name, section 5.3): for the
 * mutation of the lens subpath stratified over the film, for the lens perturbation near where the path was. In the place of the
 * thesis' list of pixels that are not yet covered it has orders of all pixels, so it needs no memory of what it was asked before and
 * serves all chains at once. Immutable.
 *
 * <p>Filtering is not its matter: paths that were accepted are splatted through the filter of the film like all others.
 */
public final class MetropolisAntiAliaser {
    private final int width;
    private final int height;
    private final long key;

    /**
     * Creates one.
     *
     * @param width of the film in pixels
     * @param height of the film in pixels
     * @param key selects the orders in which pixels are visited
     */
    public MetropolisAntiAliaser(int width, int height, long key) {
        this.width = width;
        this.height = height;
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

    /**
     * Distance, in pixels, of a perturbed point from where it was: r = r₂·exp(−ln(r₂/r₁)·ξ), which is distributed evenly on a
     * logarithmic scale (Veach 1997, eq. 11.9). In a direction that is uniform, the density on the film is
     * 1/(2πr²·ln(r₂/r₁)): it depends on the distance only, so it is the same there and back.
     *
     * @param smallest r₁, greater than 0
     * @param largest r₂, at least the smallest
     * @param number ξ, uniform in [0, 1)
     */
    public static double distance(double smallest, double largest, double number) {
        return largest * Math.exp(-Math.log(largest / smallest) * number);
    }
}
