package org.daybreak.metropolis.primary;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.metropolis.chains.ChainRenderer;
import org.daybreak.metropolis.chains.ChainSettings;

/** What both renderers by chains over random numbers have in common. */
abstract class PrimaryRendererFactory implements RendererFactory {
    private final String id;
    private final boolean multiplexed;

    PrimaryRendererFactory(String id, boolean multiplexed) {
        this.id = id;
        this.multiplexed = multiplexed;
    }

    @Override
    public final String id() {
        return id;
    }

    @Override
    public final List<Parameter> parameters() {
        List<Parameter> all = new ArrayList<>(ChainSettings.PARAMETERS);
        all.addAll(PrimarySettings.PARAMETERS);
        return List.copyOf(all);
    }

    @Override
    public final Optional<String> samplesParameter() {
        return Optional.of(ChainSettings.MUTATIONS_PER_PIXEL);
    }

    @Override
    public final Renderer create(ParameterValues values) {
        PrimarySettings settings = PrimarySettings.of(values);
        return new ChainRenderer(
                new PrimaryAlgorithm(id, settings, multiplexed),
                ChainSettings.of(values),
                settings.paths().maxEyeDepth(),
                settings.paths().maxDepth());
    }
}
