package org.daybreak.metropolis.primary;

import org.daybreak.bidirectional.BiDirectionalProcessor;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Chain;

/**
 * Chains of whole samples of bidirectional path tracing (Kelemen et al. 2002): a state is an eye and a light subpath with all their
 * connections, and brings radiance to the film position of the eye subpath and splats to others.
 */
final class SampleWorker extends PrimaryWorker {
    private final BiDirectionalProcessor processor;
    private final StateImage image = new StateImage();

    SampleWorker(Scene scene, Camera camera, PrimarySettings settings, long seed, int shortest) {
        super(camera, settings, seed);
        processor = new BiDirectionalProcessor(
                scene, camera, false, settings.paths().singleSample().withMinDepth(shortest), null);
    }

    @Override
    boolean evaluate(PrimarySample numbers, int edges, StateImage out) {
        numbers.setDimension(0);
        double filmX = filmX(numbers.next());
        double filmY = filmY(numbers.next());
        boolean finite = processor.trace(filmX, filmY, numbers, sample(), splats());
        gather(filmX, filmY, 1, out);
        return finite;
    }

    @Override
    public void candidate(long index, Candidates found) {
        begin(candidate, index);
        if (evaluate(candidate, 0, image)) {
            double weight = image.target(importance);
            if (weight > 0 && weight < Double.POSITIVE_INFINITY) {
                found.found(0, image.filmX(), image.filmY(), weight);
            }
        }
    }

    @Override
    public void start(Chain chain, long index, int number) {
        PrimaryChain started = (PrimaryChain) chain;
        begin(started.numbers, index);
        evaluate(started.numbers, 0, started.image);
    }

    @Override
    public long rays(RayKind kind) {
        return processor.rays(kind);
    }
}
