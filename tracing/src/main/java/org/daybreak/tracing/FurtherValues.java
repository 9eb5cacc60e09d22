package org.daybreak.tracing;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;

/** What a sample brings to {@link FurtherImages}. Mutable, owned by one worker, reused. */
public final class FurtherValues {
    private final Spectrum[] values;
    private SplatBuffer[] splats = new SplatBuffer[0];

    /** Values for a number of images. */
    FurtherValues(int count) {
        values = new Spectrum[count];
        for (int i = 0; i < count; i++) {
            values[i] = new Spectrum();
        }
    }

    /** A work unit begins, whose splats go into buffers, one for each image. */
    void beginUnit(SplatBuffer[] buffers) {
        splats = buffers;
    }

    /** A sample begins. */
    void beginSample() {
        for (Spectrum value : values) {
            value.setZero();
        }
    }

    /** Radiance of the sample in an image. */
    Spectrum value(int image) {
        return values[image];
    }

    /** Adds to the radiance of the sample in an image. */
    public void add(int image, double r, double g, double b) {
        Spectrum value = values[image];
        value.r += r;
        value.g += g;
        value.b += b;
    }

    /**
     * Adds a splat to an image, as {@link SplatBuffer#add(double, double, double, double, double)} does; one that is not finite is
     * left out.
     */
    public void splat(int image, double filmX, double filmY, double r, double g, double b) {
        splats[image].add(filmX, filmY, r, g, b);
    }
}
