package org.daybreak.core.render;

import java.util.Optional;
import org.daybreak.core.sampling.Sampler;

/** Decides where in a pixel samples are taken and which random numbers the paths through them use. Immutable. */
public interface Antialiasing {
    /** Identifier: {@code sobol}. */
    String id();

    /**
     * The number of samples per pixel that will be taken when a number is asked for: a grid method rounds up to its grid.
     */
    long samplesPerPixel(long requested);

    /**
     * Creates a sampler for one worker. Its first two dimensions are the position in the pixel, in [0,1)².
     *
     * @param seed seed of the render
     * @param samplesPerPixel number of samples per pixel as {@link #samplesPerPixel} returned it
     */
    Sampler newSampler(long seed, long samplesPerPixel);

    /** How samples are divided among the pixels; empty if each pixel has the same number. */
    default Optional<SampleAllocation> allocation() {
        return Optional.empty();
    }
}
