package org.daybreak.antialiasing;

import java.util.List;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.Sampler;

/** No antialiasing: every sample goes through the centre of its pixel. The paths behind it use independent numbers. */
public final class CentreSampling implements AntialiasingFactory, Antialiasing {
    /** Creates the method; it has no settings. */
    public CentreSampling() {}

    @Override
    public String id() {
        return "none";
    }

    @Override
    public String description() {
        return "every sample through the pixel centre; edges are not smoothed";
    }

    @Override
    public List<Parameter> parameters() {
        return List.of();
    }

    @Override
    public Antialiasing create(ParameterValues values) {
        return this;
    }

    @Override
    public long samplesPerPixel(long requested) {
        return requested;
    }

    @Override
    public Sampler newSampler(long seed, long samplesPerPixel) {
        return new GridSampler(seed, 1, false);
    }
}
