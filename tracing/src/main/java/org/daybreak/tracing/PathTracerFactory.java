package org.daybreak.tracing;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;

/** The path tracer as users see it. */
public final class PathTracerFactory implements RendererFactory {
    /** Creates the factory. */
    public PathTracerFactory() {}

    @Override
    public String id() {
        return "path";
    }

    @Override
    public String description() {
        return "path tracing with next-event estimation and multiple importance sampling";
    }

    @Override
    public List<Parameter> parameters() {
        return PathTracerSettings.PARAMETERS;
    }

    @Override
    public Renderer create(ParameterValues values) {
        PathTracerSettings settings = PathTracerSettings.of(values);
        return new PixelwiseRenderer(
                id(), (scene, camera, features) -> new PathTracer(scene, camera, features, settings));
    }
}
