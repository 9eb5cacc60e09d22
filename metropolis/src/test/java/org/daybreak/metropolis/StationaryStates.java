package org.daybreak.metropolis;

import java.util.List;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.metropolis.chains.PatternSet;
import org.daybreak.metropolis.strategy.BidirectionalMutationStrat;
import org.daybreak.metropolis.strategy.CausticPerturbationStrat;
import org.daybreak.metropolis.strategy.FilmStrata;
import org.daybreak.metropolis.strategy.LensPerturbationStrat;
import org.daybreak.metropolis.strategy.LensSubpathStrat;
import org.daybreak.metropolis.strategy.LightPath;
import org.daybreak.metropolis.strategy.ManifoldPerturbationStrat;
import org.daybreak.metropolis.strategy.MultiChainPerturbationStrat;
import org.daybreak.metropolis.strategy.MutationStrategy;
import org.daybreak.metropolis.strategy.PathLimits;

/**
 * States that are independent of each other and have the density f*·v/b of chains: of each bidirectional sample, whose paths' weights
 * w·f*·v/p add up to W, one path is taken in proportion to its weight, with probability W/c. What exceeds the bound c gives more
 * copies, so the number of states that a sample gives has the expectation W/c in any case.
 */
final class StationaryStates {
    /** Edges are short below this part of the way to the lens: enough of them are. */
    static final double SHORT = 0.6;

    private static final int PILOT = 4000;

    /** Light from a flat lamp to itself: rounding noise, that may not be there if the path is built again. */
    private static final double NOTHING = 1e-20;

    private final Scene scene;
    private final long seed;
    private final BidirectionalSettings settings;
    private final PathLimits limits;
    private final ImageImportance importance;
    private final MetropolisProcessor candidates;
    private final RandomStream choices = new RandomStream();
    private final double bound;

    private double total;
    private int chosen;

    /**
     * Creates them.
     *
     * @param shortest smallest number of edges
     * @param longest largest number of edges
     * @param importance v
     */
    StationaryStates(Scene scene, long seed, int shortest, int longest, ImageImportance importance) {
        this.scene = scene;
        this.seed = seed;
        this.importance = importance;
        settings = new BidirectionalSettings(-1, -1, longest, 2, BidirectionalSettings.Roulette.NONE, 3, 1, false, true)
                .withMinDepth(shortest);
        limits = new PathLimits(shortest, longest + 1L, Integer.MAX_VALUE, Integer.MAX_VALUE);
        candidates = processor("B", 1);
        double largest = 0;
        for (int i = 0; i < PILOT; i++) {
            choose(i);
            largest = Math.max(largest, total);
        }
        bound = largest;
    }

    /** Strategies by letters: bidirectional, with Importance, lens Subpath, Lens, Caustic, Multi-chain. */
    List<MutationStrategy> strategies(String letters) {
        return letters.chars().mapToObj(letter -> strategy((char) letter)).toList();
    }

    private MutationStrategy strategy(char letter) {
        double[] deleted = {0.25, 0.5, 0.125};
        double[] added = {0.5, 0.15, 0.05};
        double smallest = 0.1;
        double largest = 0.3 * scene.camera().width();
        return switch (letter) {
            case 'B' -> new BidirectionalMutationStrat(1, limits, 0.2, deleted, added, false);
            case 'I' -> new BidirectionalMutationStrat(1, limits, 0.2, deleted, added, true);
            // Pixels of all proposals are independent, not spread evenly.
            case 'S' ->
                new LensSubpathStrat(2, limits, new FilmStrata(scene.camera().width(), this::pixel));
            case 'L' -> new LensPerturbationStrat(1.5, smallest, largest);
            case 'F' -> new ManifoldPerturbationStrat(0.6, smallest, largest, smallest, 0.7 * largest);
            case 'C' -> new CausticPerturbationStrat(0.7, smallest, largest);
            case 'M' -> new MultiChainPerturbationStrat(1.2, smallest, largest, smallest, 0.7 * largest, SHORT);
            default -> throw new IllegalArgumentException("no strategy " + letter);
        };
    }

    private long pixel(long number) {
        long pixels = (long) scene.camera().width() * scene.camera().height();
        return Long.remainderUnsigned(new RandomStream(seed, StreamDomain.LENS, number, 0).nextLong(), pixels);
    }

    /** A processor of chains of these states. */
    MetropolisProcessor processor(String letters, int chains) {
        MetropolisProcessor processor = new MetropolisProcessor(
                scene, scene.camera(), seed, settings, strategies(letters), PatternSet.NONE, true, chains);
        processor.setImportance(importance);
        return processor;
    }

    /** c: a state stands for this much of b. */
    double bound() {
        return bound;
    }

    /** Draws a sample; returns W, the sum of the weights of its paths. */
    double draw(long sample) {
        choose(sample);
        return total;
    }

    private void choose(long sample) {
        total = 0;
        chosen = -1;
        choices.seat(seed, StreamDomain.SELF_CHECK, sample, 0);
        candidates.candidate(sample, (number, x, y, weight) -> {
            if (weight < NOTHING) {
                return;
            }
            total += weight;
            if (choices.nextDouble() * total < weight) {
                chosen = number;
            }
        });
    }

    /** How many states the last sample gives. */
    int copies() {
        return (int) (total / bound + choices.nextDouble());
    }

    /** Puts a chain of some processor of {@link #processor} on the path that was chosen of the last sample. */
    void start(MetropolisProcessor processor, PathChain chain, long sample) {
        processor.start(chain, sample, chosen);
    }

    /** The path that was chosen of the last sample. */
    LightPath path(PathChain chain, long sample) {
        candidates.start(chain, sample, chosen);
        return chain.current;
    }
}
