package org.daybreak.antialiasing;

import java.util.List;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.sampling.SobolSampler;
import org.daybreak.core.sampling.StreamDomain;

/**
 * Owen-scrambled Sobol′ points for the position in the pixel and all decisions of the path, in independent groups of four
 * dimensions. The default: the lowest error at the same number of samples; powers of two are best.
 */
public final class SobolSampling implements AntialiasingFactory, Antialiasing {
    private static final int GROUP_SIZE = 4;

    /** Creates the method; it has no settings. */
    public SobolSampling() {}

    @Override
    public String id() {
        return "sobol";
    }

    @Override
    public String description() {
        return "scrambled Sobol' points for the position in the pixel and for the paths; best in powers of two";
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
        return new SobolSampler(seed, StreamDomain.PIXEL, GROUP_SIZE);
    }
}
