package org.daybreak.core.render;

import java.util.Map;

/**
 * What a render is given besides scene, camera and film. Immutable.
 *
 * @param seed seed of all random streams
 * @param threads number of worker threads, at least 1; never influences the image
 * @param budget when to stop
 * @param antialiasing where image samples are taken
 * @param cancellation asks to stop
 * @param listener hears of progress
 */
public record RenderContext(
        long seed,
        int threads,
        RenderBudget budget,
        Antialiasing antialiasing,
        CancellationToken cancellation,
        RenderListener listener) {
    /** Checks the number of threads. */
    public RenderContext {
        if (threads < 1) {
            throw new ParameterException("the number of threads must be at least 1 but is " + threads);
        }
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
        return new RenderContext(seed, threads, budget, antialiasing, cancellation, other);
    }
}
