package org.daybreak.metropolis;

import java.util.List;
import org.daybreak.bidirectional.Contribution;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.metropolis.chains.PilotWorker;
import org.daybreak.metropolis.strategy.LightPath;
import org.daybreak.metropolis.strategy.MutationStrategy;
import org.daybreak.metropolis.strategy.PathBuilder;
import org.daybreak.metropolis.strategy.PathPattern;

/**
 * Tries steps from the paths of a candidate, to see what they cost. It starts from one of these paths, with a probability in proportion to
 * its contribution over its density; with the sum of these as weight, its states are those that chains have.
 */
final class PilotChain {
    /** From each candidate. */
    static final int STEPS = 3;

    /** What a step takes beside its rays, in such. */
    private static final double WORK_BESIDE_RAYS = 0.5;

    private final long seed;
    private final PathBuilder builder;
    private final MetropolisPathMutator mutator;
    private final RandomStream random = new RandomStream();
    private LightPath current = new LightPath();
    private LightPath proposal = new LightPath();
    private long stratum;
    private double sum;
    private boolean assembled;

    PilotChain(Scene scene, Camera camera, long seed, List<MutationStrategy> strategies) {
        this.seed = seed;
        builder = new PathBuilder(scene, camera);
        mutator = new MetropolisPathMutator(strategies, builder);
    }

    /** Forgets the paths of the last candidate. */
    void begin(long candidate) {
        random.seat(seed, StreamDomain.CHAIN, candidate, 0);
        stratum = candidate;
        sum = 0;
        assembled = false;
    }

    /** Takes note of a path of the candidate. */
    void offer(Contribution path, double weight) {
        sum += weight;
        if (random.nextDouble() * sum < weight) {
            assembled = builder.assemble(path, current);
        }
    }

    /** Tries the steps, if there is a path to start from. */
    void move(PilotWorker.Survey receiver) {
        for (int i = 0; i < STEPS && assembled; i++) {
            long pattern = PathPattern.of(current);
            double before = work();
            boolean proposed = mutator.propose(current, proposal, ImageImportance.UNIFORM, random, stratum);
            receiver.moved(pattern, sum, WORK_BESIDE_RAYS + work() - before);
            if (proposed && random.nextDouble() < mutator.acceptance()) {
                LightPath swapped = current;
                current = proposal;
                proposal = swapped;
            }
        }
    }

    /** Number of rays of a kind traced so far. */
    long rays(RayKind kind) {
        return builder.rays(kind);
    }

    private double work() {
        double work = 0;
        for (RayKind kind : RayKind.values()) {
            work += MetropolisPilot.workOf(kind) * rays(kind);
        }
        return work;
    }
}
