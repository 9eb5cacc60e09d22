package org.daybreak.bidirectional;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.PixelwiseRenderer;

/**
 * Renders by bidirectional path tracing: pixel by pixel for eye subpaths, while the light subpath of each sample adds to the
 * light image of the film ({@link CausticMap}).
 */
public final class BidirectionalRenderer implements Renderer {
    private final PixelwiseRenderer pixelwise;

    /** Creates a renderer. */
    public BidirectionalRenderer(BidirectionalSettings settings) {
        pixelwise = new PixelwiseRenderer(
                BidirectionalRendererFactory.ID,
                (scene, camera, features) -> new BiDirectionalProcessor(scene, camera, features, settings, null));
    }

    @Override
    public RenderReport render(Scene scene, Camera camera, Film film, RenderContext context) {
        return pixelwise.render(scene, camera, film, context);
    }

    @Override
    public boolean isResumable() {
        return pixelwise.isResumable();
    }
}
