package org.daybreak.tracing;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;

/** The light tracer as users see it. */
public final class LightTracerFactory implements RendererFactory {
    /** Creates the factory. */
    public LightTracerFactory() {}

    @Override
    public String id() {
        return "light";
    }

    @Override
    public String description() {
        return "light tracing: paths from the lights joined to the lens; mirrors and glass themselves stay black";
    }

    @Override
    public List<Parameter> parameters() {
        return LightTracerSettings.PARAMETERS;
    }

    @Override
    public Renderer create(ParameterValues values) {
        return new LightTracerRenderer(LightTracerSettings.of(values));
    }
}
