package org.daybreak.core.render;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * What a render is given besides scene, camera and film. Immutable.
 *
 * @param seed seed of all random streams
 * @param threads number of worker threads, at least 1; never influences the image
 * @param budget when to stop
 * @param antialiasing where image samples are taken
 * @param cancellation asks to stop
 * @param listener hears of progress
 * @param part which part of the work is done
 * @param start where an earlier render of the same settings stopped, to go on from there; null to begin
 * @param checkpoints takes the state of the render from time to time and at its end
 */
public record RenderContext(
        long seed,
        int threads,
        RenderBudget budget,
        Antialiasing antialiasing,
        CancellationToken cancellation,
        RenderListener listener,
        RenderPart part,
        @Nullable RenderState start,
        CheckpointSink checkpoints) {
    /** Checks the number of threads. */
    public RenderContext {
        if (threads < 1) {
            throw new ParameterException("the number of threads must be at least 1 but is " + threads);
        }
    }

    /** A render from the beginning, of everything, without checkpoints. */
    public RenderContext(
            long seed,
            int threads,
            RenderBudget budget,
            Antialiasing antialiasing,
            CancellationToken cancellation,
            RenderListener listener) {
        this(seed, threads, budget, antialiasing, cancellation, listener, RenderPart.WHOLE, null, CheckpointSink.NONE);
    }

    /**
     * A context with seed 0, all processors, the default antialiasing method, and nobody who listens or cancels.
     *
     * @throws ParameterException if the default antialiasing method is not on the class path
     */
    public static RenderContext of(RenderBudget budget) {
        return new RenderContext(
                0,
                Runtime.getRuntime().availableProcessors(),
                budget,
                Renderers.createAntialiasing(Renderers.DEFAULT_ANTIALIASING, Map.of()),
                new CancellationToken(),
                RenderListener.NONE);
    }

    /** The same context with another listener. */
    public RenderContext withListener(RenderListener other) {
        return new RenderContext(seed, threads, budget, antialiasing, cancellation, other, part, start, checkpoints);
    }

    /** The same context for a part of the work. */
    public RenderContext withPart(RenderPart other) {
        return new RenderContext(
                seed, threads, budget, antialiasing, cancellation, listener, other, start, checkpoints);
    }

    /** The same context with a state to go on from, null to begin. */
    public RenderContext withStart(@Nullable RenderState other) {
        return new RenderContext(seed, threads, budget, antialiasing, cancellation, listener, part, other, checkpoints);
    }

    /** The same context with somebody who takes checkpoints. */
    public RenderContext withCheckpoints(CheckpointSink other) {
        return new RenderContext(seed, threads, budget, antialiasing, cancellation, listener, part, start, other);
    }
}
