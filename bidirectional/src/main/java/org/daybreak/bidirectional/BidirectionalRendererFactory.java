package org.daybreak.bidirectional;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;

/** Bidirectional path tracing as users see it. */
public final class BidirectionalRendererFactory implements RendererFactory {
    static final String ID = "bidirectional";

    /** Creates the factory. */
    public BidirectionalRendererFactory() {}

    @Override
    public String id() {
        return ID;
    }

    @Override
    public String description() {
        return "bidirectional path tracing: paths from the camera and from the lights, joined in all ways";
    }

    @Override
    public List<Parameter> parameters() {
        return BidirectionalSettings.PARAMETERS;
    }

    @Override
    public Renderer create(ParameterValues values) {
        return new BidirectionalRenderer(BidirectionalSettings.of(values));
    }
}
