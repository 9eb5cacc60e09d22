package org.daybreak.metropolis.strategy;

import org.daybreak.core.sampling.RandomStream;

/**
 * A way to change a path (the thesis' class of that name; Veach 1997, §11.4). Holds configuration only: the state of the chain and
 * its random numbers are arguments. Immutable and thread-safe.
 *
 * <p>A proposal is a move and a path: what is replaced, and by what. Detailed balance holds for each move and its way back by
 * itself: with f* the scalar contribution, P(S|x) the probability of choosing the strategy and {@link #transition} T, the proposal is
 * accepted with probability min(1, f*(y) P(S|y) T(y→x) / (f*(x) P(S|x) T(x→y))). That ratio is computed in one place,
 * {@code MetropolisProcessor}.
 */
public abstract class MutationStrategy {
    private final double weight;

    /**
     * Creates a strategy.
     *
     * @param weight relative probability of choosing it for a path that it applies to
     */
    protected MutationStrategy(double weight) {
        this.weight = weight;
    }

    /** Name for settings and reports. */
    public abstract String id();

    /** Relative probability of choosing the strategy for a path; 0 where it does not apply. */
    public final double weight(LightPath x) {
        return applies(x) ? weight : 0;
    }

    /** True if the strategy can do something with a path. */
    protected abstract boolean applies(LightPath x);

    /**
     * Proposes a path.
     *
     * @param x a path that the strategy applies to
     * @param y receives the proposal, evaluated and seen to be unoccluded; of no use if the result is false
     * @param move receives what was replaced
     * @param stratum number that proposals of all chains which spread over the film are to be counted by
     * @return false if there is no path: {@code builder.failure()} says why
     */
    public abstract boolean propose(
            LightPath x, LightPath y, Move move, PathBuilder builder, RandomStream random, long stratum);

    /** True if proposals use up the stratum that they are given. */
    public boolean usesStrata() {
        return false;
    }

    /**
     * Density of proposing one path from the other with the vertices that the move replaces, per area as in {@link LightPath}; factors
     * that are the same for the way back may be left out.
     *
     * @param move from {@code from} to {@code to}
     */
    public abstract double transition(LightPath from, LightPath to, Move move, PathBuilder builder);
}
