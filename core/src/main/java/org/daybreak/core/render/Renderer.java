package org.daybreak.core.render;

import java.util.Optional;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.scene.Scene;

/**
 * A rendering algorithm with its settings. Stateless between calls: two renders in one virtual machine, even of the
 * same renderer, do not disturb each other.
 */
public interface Renderer {
    /**
     * Renders until the budget is spent or the context is cancelled; blocks meanwhile. The film is valid at any time from
     * the first finished pass on, and the same seed gives the same bits for any number of threads as long as the
     * budget is given in samples.
     *
     * @param scene what to render
     * @param camera from where; usually {@code scene.camera()}
     * @param film receives the image; a fresh film
     * @param context threads, seed, budget, cancellation and listeners
     * @return what was done; {@link RenderReport#cancelled()} if the context was cancelled
     * @throws ParameterException if the settings do not fit the scene
     * @throws CheckpointException if a checkpoint could not be saved
     */
    RenderReport render(Scene scene, Camera camera, Film film, RenderContext context);

    /**
     * Computes a single sample of a render once more, with the same random numbers.
     *
     * @return all that happened; empty if the renderer cannot tell
     * @throws ParameterException if the settings do not fit the scene
     */
    default Optional<SampleRecord> replay(Scene scene, Camera camera, SampleRequest request) {
        return Optional.empty();
    }

    /**
     * Whether the renderer can go on from a state, hand out its state and render parts. If not, it ignores these settings of
     * the context, and programs must not offer them.
     */
    default boolean isResumable() {
        return false;
    }
}
