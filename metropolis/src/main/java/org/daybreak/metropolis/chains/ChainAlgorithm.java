package org.daybreak.metropolis.chains;

import java.util.List;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.scene.Scene;

/**
 * What differs between renderers by Markov chains: what a state is, how candidates for the first state are drawn, and how the
 * chain moves. Immutable; makes one {@link ChainWorker} per thread.
 */
public interface ChainAlgorithm {
    /** Identifier of the renderer, for reports. */
    String id();

    /** Names of the kinds of moves, in the order of their numbers in {@link ChainStatistics}. */
    List<String> moves();

    /** What the user should know before it starts: a set of moves that cannot reach everything, say. */
    default List<String> warnings() {
        return List.of();
    }

    /** Whether all chains have the same target, so that differences between them tell how far they are from it. */
    default boolean hasOneTarget() {
        return true;
    }

    /**
     * Creates what a thread needs.
     *
     * @param seed of the render
     * @param shortest smallest number of edges of the paths that count: the others are rendered apart
     */
    ChainWorker newWorker(Scene scene, Camera camera, long seed, int shortest);
}
