package org.daybreak.metropolis;

import java.util.List;
import java.util.Optional;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.metropolis.chains.ChainSettings;

/** Metropolis light transport as users see it. */
public final class MetropolisRendererFactory implements RendererFactory {
    /** Creates the factory. */
    public MetropolisRendererFactory() {}

    @Override
    public String id() {
        return MetropolisAlgorithm.ID;
    }

    @Override
    public String description() {
        return "Metropolis light transport: paths that bring light are changed again and again";
    }

    @Override
    public List<Parameter> parameters() {
        return MetropolisSettings.PARAMETERS;
    }

    @Override
    public Optional<String> samplesParameter() {
        return Optional.of(ChainSettings.MUTATIONS_PER_PIXEL);
    }

    @Override
    public Renderer create(ParameterValues values) {
        return new MetropolisRenderer(MetropolisSettings.of(values));
    }
}
