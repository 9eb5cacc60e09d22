package org.daybreak.metropolis.primary;

import java.util.List;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.ChainAlgorithm;
import org.daybreak.metropolis.chains.ChainWorker;

/**
 * An algorithm whose chains go over random numbers.
 *
 * @param id of the renderer
 * @param multiplexed whether states are single paths of a fixed length, rather than samples of bidirectional path tracing
 */
record PrimaryAlgorithm(String id, PrimarySettings settings, boolean multiplexed) implements ChainAlgorithm {
    @Override
    public List<String> moves() {
        return PrimaryWorker.MOVES;
    }

    @Override
    public List<String> warnings() {
        return settings.warnings();
    }

    /** {@inheritDoc} A chain of single paths has those of one length. */
    @Override
    public boolean hasOneTarget() {
        return !multiplexed;
    }

    @Override
    public ChainWorker newWorker(Scene scene, Camera camera, long seed, int shortest) {
        return multiplexed
                ? new TechniqueWorker(scene, camera, settings, seed, shortest)
                : new SampleWorker(scene, camera, settings, seed, shortest);
    }
}
