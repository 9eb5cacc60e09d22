package org.daybreak.bidirectional;

import java.util.Optional;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.SampleRecord;
import org.daybreak.core.render.SampleRequest;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.FurtherImages;
import org.daybreak.tracing.PixelwiseRenderer;
import org.daybreak.tracing.RayProcessor;
import org.jspecify.annotations.Nullable;

/**
 * Renders by bidirectional path tracing: pixel by pixel for eye subpaths, while the light subpath of each sample adds to the
 * light image of the film ({@link CausticMap}).
 */
public final class BidirectionalRenderer implements Renderer {
    private final BidirectionalSettings settings;
    private final PixelwiseRenderer pixelwise;

    /** Creates a renderer. */
    public BidirectionalRenderer(BidirectionalSettings settings) {
        this(settings, FurtherImages.NONE);
    }

    /**
     * Creates a renderer for a part of the light.
     *
     * @param settings without light subpaths at the lens
     * @param filter which paths count
     */
    public BidirectionalRenderer(BidirectionalSettings settings, PathFilter filter) {
        this(settings, FurtherImages.NONE, filter);
    }

    /**
     * Creates a renderer.
     *
     * @param further images to make besides the film's: {@link TechniqueViews}, or none
     */
    BidirectionalRenderer(BidirectionalSettings settings, FurtherImages further) {
        this(settings, further, null);
    }

    private BidirectionalRenderer(BidirectionalSettings settings, FurtherImages further, @Nullable PathFilter filter) {
        this.settings = settings;
        pixelwise = new PixelwiseRenderer(
                BidirectionalRendererFactory.ID, new Processors(settings, further, filter), further);
    }

    /** Makes processors, which tell their contributions to the views of techniques if there are any. */
    private record Processors(
            BidirectionalSettings settings,
            FurtherImages further,
            @Nullable PathFilter filter) implements RayProcessor.Factory {
        @Override
        public RayProcessor create(Scene scene, Camera camera, boolean features) {
            if (filter != null) {
                return BiDirectionalProcessor.filtered(scene, camera, features, settings, filter);
            }
            return further instanceof TechniqueViews views
                    ? views.record(listener -> new BiDirectionalProcessor(scene, camera, features, settings, listener))
                    : new BiDirectionalProcessor(scene, camera, features, settings, null);
        }

        @Override
        public boolean splats() {
            return settings.splats();
        }

        @Override
        public boolean learns() {
            return settings.roulette() == BidirectionalSettings.Roulette.EFFICIENCY;
        }
    }

    @Override
    public RenderReport render(Scene scene, Camera camera, Film film, RenderContext context) {
        return pixelwise.render(scene, camera, film, context);
    }

    @Override
    public Optional<SampleRecord> replay(Scene scene, Camera camera, SampleRequest request) {
        return Optional.of(SampleTrace.of(scene, camera, settings, request));
    }

    @Override
    public boolean isResumable() {
        return pixelwise.isResumable();
    }
}
