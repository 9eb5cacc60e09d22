package org.daybreak.metropolis.strategy;

import org.daybreak.core.sampling.RandomStream;

/**
 * Moves the image point of a path a little and follows its ideal reflections and refractions from the lens to the first other vertex,
 * which it joins to the rest: a path …(L|D)DS*E, or LS*E (the thesis' class of that name; Veach 1997, §11.4.3).
 *
 * <p>The density on the film is symmetric; what remains of T are the densities of the vertices given the image point.
 */
public final class LensPerturbationStrat extends MutationStrategy {
    private final double smallest;
    private final double largest;

    /**
     * Creates the strategy.
     *
     * @param weight relative probability of choosing it
     * @param smallest r₁, in pixels
     * @param largest r₂, in pixels
     */
    public LensPerturbationStrat(double weight, double smallest, double largest) {
        super(weight);
        this.smallest = smallest;
        this.largest = largest;
    }

    @Override
    public String id() {
        return "lens";
    }

    @Override
    protected boolean applies(LightPath x) {
        int d = LensPiece.diffuse(x);
        return d == 0 ? !x.deltaLight : x.joins(d - 1);
    }

    @Override
    public boolean propose(
            LightPath x, LightPath y, Move move, PathBuilder builder, RandomStream random, long stratum) {
        int d = LensPiece.diffuse(x);
        move.set(d - 1, x.length, x.length);
        return LensPiece.perturbFilm(x, y, smallest, largest, builder, random) && LensPiece.join(x, y, d, builder);
    }

    @Override
    public double transition(LightPath from, LightPath to, Move move, PathBuilder builder) {
        int d = move.kept + 1;
        double density = LensPiece.density(to, to.length, d);
        return d == 0 ? density / builder.light().landings(to) : density;
    }
}
