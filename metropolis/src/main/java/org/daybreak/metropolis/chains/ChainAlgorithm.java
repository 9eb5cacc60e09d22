package org.daybreak.metropolis.chains;

import java.util.List;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.render.Renderer;
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

    /** Whether samples may take a part of the light off the chains; only if it has all of {@link #newPilotWorker}, {@link #remainder} and {@link #samples} then. */
    default Sharing sharing() {
        return Sharing.NEVER;
    }

    /**
     * Creates what a thread needs for a pilot.
     *
     * @param seed of the pilot
     * @param shortest smallest number of edges of the chains' paths
     */
    default PilotWorker newPilotWorker(Scene scene, Camera camera, long seed, int shortest) {
        throw new UnsupportedOperationException(id() + " leaves nothing to samples");
    }

    /**
     * The same without those paths in the target that samples find.
     *
     * @param patterns kinds of paths that samples find
     */
    default ChainAlgorithm remainder(PatternSet patterns) {
        throw new UnsupportedOperationException(id() + " leaves nothing to samples");
    }

    /**
     * Renders what {@link #remainder} leaves out, and all paths that are too short for chains.
     *
     * @param patterns kinds of paths that samples find
     * @param shortest smallest number of edges of the chains' paths
     */
    default Renderer samples(PatternSet patterns, int shortest) {
        throw new UnsupportedOperationException(id() + " leaves nothing to samples");
    }

    /**
     * Creates what a thread needs.
     *
     * @param seed of the render
     * @param shortest smallest number of edges of the paths that count: the others are rendered apart
     */
    ChainWorker newWorker(Scene scene, Camera camera, long seed, int shortest);
}
