package org.daybreak.antialiasing;

import java.util.List;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.Sampler;

/**
 * Jittered strata in each pair of dimensions, film position and all decisions of the path alike, each pair in a random
 * order of its own. The strata come from the number of samples asked for; beyond {@value #LARGEST_SIDE}² samples they are
 * used again with new random numbers.
 */
public final class StratifiedSampling implements AntialiasingFactory, Antialiasing {
    private static final int LARGEST_SIDE = 32;

    /** Creates the method; it has no settings. */
    public StratifiedSampling() {}

    @Override
    public String id() {
        return "stratified";
    }

    @Override
    public String description() {
        return "jittered strata for the position in the pixel and for each pair of numbers of a path";
    }

    @Override
    public List<Parameter> parameters() {
        return List.of();
    }

    @Override
    public Antialiasing create(ParameterValues values) {
        return this;
    }

    /** Rounds up to whole grids of strata as near to square as possible. */
    @Override
    public long samplesPerPixel(long requested) {
        long strata = (long) columns(requested) * rows(requested);
        return (requested + strata - 1) / strata * strata;
    }

    @Override
    public Sampler newSampler(long seed, long samplesPerPixel) {
        return new StratifiedSampler(seed, columns(samplesPerPixel), rows(samplesPerPixel));
    }

    private static int columns(long samples) {
        return (int) Math.min(LARGEST_SIDE, Math.ceil(Math.sqrt((double) samples)));
    }

    private static int rows(long samples) {
        int columns = columns(samples);
        return (int) Math.min(LARGEST_SIDE, (samples + columns - 1) / columns);
    }
}
