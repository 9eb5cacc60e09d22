package org.daybreak.metropolis;

import java.util.List;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.metropolis.chains.Outcome;
import org.daybreak.metropolis.strategy.LightPath;
import org.daybreak.metropolis.strategy.Move;
import org.daybreak.metropolis.strategy.MutationStrategy;
import org.daybreak.metropolis.strategy.PathBuilder;

/**
 * Chooses a strategy for a path, lets it propose another, and computes with which probability that is accepted (the thesis' class of that
 * name). One object per worker; the only place where acceptance is computed.
 */
public final class MetropolisPathMutator {
    private final MutationStrategy[] strategies;
    private final PathBuilder builder;
    private final Move move = new Move();
    private int strategy;
    private Outcome outcome = Outcome.BLACK;
    private double acceptance;

    /** Creates a mutator of a worker. */
    public MetropolisPathMutator(List<MutationStrategy> strategies, PathBuilder builder) {
        this.strategies = strategies.toArray(new MutationStrategy[0]);
        this.builder = builder;
    }

    /** Index of the strategy that was chosen last. */
    public int strategy() {
        return strategy;
    }

    /** How the last proposal ended. */
    public Outcome outcome() {
        return outcome;
    }

    /** Probability with which the last proposal is to be accepted; 0 if there is none, NaN if it could not be computed. */
    public double acceptance() {
        return acceptance;
    }

    /** What the last proposal replaces. */
    public Move move() {
        return move;
    }

    /** True if the strategy that was chosen last used up the stratum. */
    public boolean usedStratum() {
        return strategies[strategy].usesStrata();
    }

    /**
     * Proposes a path.
     *
     * @param x where the chain is
     * @param y receives the proposal
     * @param importance factor on the target, see {@link ImageImportance}
     * @param stratum number of the next proposal that is to be spread over the film
     * @return false if there is no proposal: it counts as rejected
     */
    public boolean propose(LightPath x, LightPath y, ImageImportance importance, RandomStream random, long stratum) {
        acceptance = 0;
        double sum = weights(x);
        strategy = choose(x, sum, random);
        MutationStrategy chosen = strategies[strategy];
        if (!chosen.propose(x, y, move, builder, random, stratum)) {
            outcome = builder.failure();
            return false;
        }
        outcome = Outcome.PROPOSED;
        double forward = chosen.transition(x, y, move, builder) * chosen.weight(x) / sum;
        double chosenBack = chosen.weight(y);
        double ratio = 0;
        if (chosenBack > 0) {
            move.reverse();
            double back = chosen.transition(y, x, move, builder) * chosenBack / weights(y);
            move.reverse();
            double targetX = x.contribution() * importance.at(x.filmX(), x.filmY());
            double targetY = y.contribution() * importance.at(y.filmX(), y.filmY());
            ratio = targetY / targetX * (back / forward);
        }
        acceptance = Math.min(1, ratio);
        return true;
    }

    private double weights(LightPath path) {
        double sum = 0;
        for (MutationStrategy candidate : strategies) {
            sum += candidate.weight(path);
        }
        return sum;
    }

    private int choose(LightPath x, double sum, RandomStream random) {
        double left = random.nextDouble() * sum;
        int last = 0;
        for (int i = 0; i < strategies.length; i++) {
            double weight = strategies[i].weight(x);
            if (weight > 0) {
                last = i;
                left -= weight;
                if (left < 0) {
                    return i;
                }
            }
        }
        return last;
    }
}
