package org.daybreak.antialiasing;

import java.util.List;
import java.util.Optional;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.SampleAllocation;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.sampling.SobolSampler;
import org.daybreak.core.sampling.StreamDomain;

/**
 * More samples where the image is noisier: two small uniform passes show where that is, and a large one divides its samples by it. Very
 * many samples are divided in several passes, of which each is four times as large as all before it. Unbiased, see
 * {@link SampleAllocation}.
 */
public final class AdaptiveSampling implements AntialiasingFactory {
    private static final int GROUP_SIZE = 4;

    /** Creates the factory. */
    public AdaptiveSampling() {}

    @Override
    public String id() {
        return "adaptive";
    }

    @Override
    public String description() {
        return "more samples where the error estimate is high, in passes of independent Sobol' points; unbiased";
    }

    @Override
    public List<Parameter> parameters() {
        return List.of(
                Parameter.integer(
                        "firstPass",
                        "Samples per pixel of each of the first two passes",
                        4,
                        2,
                        1 << 16,
                        "What the first estimate of the error is made from. A render of less than four times this number"
                                + " is uniform."),
                Parameter.choice(
                        "error",
                        "Error to be made small",
                        "relative",
                        List.of("relative", "absolute"),
                        "relative: the error over the brightness of a pixel, as the eye sees it; absolute: the error itself,"
                                + " which favours bright parts."),
                Parameter.real(
                        "uniformShare",
                        "Share of uniform samples",
                        0.5,
                        0.01,
                        1,
                        "Part of the samples of each pass that is divided evenly, for the sake of what earlier passes have"
                                + " missed. Small shares make light that is seldom found noisier."));
    }

    @Override
    public Antialiasing create(ParameterValues values) {
        return new Method(
                values.integer("firstPass"), values.choice("error").equals("relative"), values.real("uniformShare"));
    }

    private record Method(int firstPass, boolean relative, double uniformShare) implements Antialiasing {
        @Override
        public String id() {
            return "adaptive";
        }

        @Override
        public long samplesPerPixel(long requested) {
            return requested;
        }

        @Override
        public Sampler newSampler(long seed, long samplesPerPixel) {
            return new SobolSampler(seed, StreamDomain.PIXEL, GROUP_SIZE);
        }

        @Override
        public Optional<SampleAllocation> allocation() {
            return Optional.of(new DeviationAllocation(firstPass, relative, uniformShare));
        }
    }
}
