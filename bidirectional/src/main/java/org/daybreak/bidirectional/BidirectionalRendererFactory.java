package org.daybreak.bidirectional;

import java.util.ArrayList;
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
        List<Parameter> all = new ArrayList<>(BidirectionalSettings.PARAMETERS);
        all.addAll(TechniqueViews.PARAMETERS);
        return List.copyOf(all);
    }

    @Override
    public Renderer create(ParameterValues values) {
        BidirectionalSettings settings = BidirectionalSettings.of(values);
        return new BidirectionalRenderer(settings, TechniqueViews.of(settings, values));
    }
}
