package org.daybreak.metropolis;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.ChainRenderer;

/** Renders by Metropolis light transport (the thesis' class of that name): chains of paths in the life of {@link ChainRenderer}. */
public final class MetropolisRenderer implements Renderer {
    private final ChainRenderer chains;

    /** Creates a renderer. */
    public MetropolisRenderer(MetropolisSettings settings) {
        chains = new ChainRenderer(
                new MetropolisAlgorithm(settings),
                settings.chains(),
                settings.bidirectional().maxEyeDepth(),
                settings.bidirectional().maxDepth());
    }

    @Override
    public RenderReport render(Scene scene, Camera camera, Film film, RenderContext context) {
        return chains.render(scene, camera, film, context);
    }

    @Override
    public boolean isResumable() {
        return chains.isResumable();
    }
}
