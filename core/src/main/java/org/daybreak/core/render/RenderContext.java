package org.daybreak.core.render;

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
}
