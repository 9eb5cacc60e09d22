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
 * More samples where the image is noisier. The first pass is uniform; each later one has as many samples as all before it
 * together and divides them in proportion to the standard deviation of a pixel's samples so far, which makes the mean squared error
 * least (Neyman 1934), or to its ratio to the pixel's mean. Unbiased, see {@link SampleAllocation}.
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
                        "Samples per pixel of the first pass",
                        8,
                        2,
                        1 << 16,
                        "What the first estimate is made from. The number of samples per pixel is rounded up to a power"
                                + " of two times this."),
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
            long samples = firstPass;
            while (samples < requested) {
                samples *= 2;
            }
            return samples;
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
