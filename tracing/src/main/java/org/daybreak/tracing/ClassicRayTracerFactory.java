package org.daybreak.tracing;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;

/** The classic ray tracer as users see it. */
public final class ClassicRayTracerFactory implements RendererFactory {
    /** Creates the factory. */
    public ClassicRayTracerFactory() {}

    @Override
    public String id() {
        return "raytracer";
    }

    @Override
    public String description() {
        return "classic ray tracing: direct light of all lights, mirrors and glass; no indirect light";
    }

    @Override
    public List<Parameter> parameters() {
        return ClassicRayTracerSettings.PARAMETERS;
    }

    @Override
    public Renderer create(ParameterValues values) {
        ClassicRayTracerSettings settings = ClassicRayTracerSettings.of(values);
        return new PixelwiseRenderer(
                id(), (scene, camera, features) -> new ClassicRayTracer(scene, camera, features, settings));
    }
}
