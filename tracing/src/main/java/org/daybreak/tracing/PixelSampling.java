package org.daybreak.tracing;

import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.FilterSampler;
import org.daybreak.core.render.SampleAddress;
import org.daybreak.core.render.SampleRequest;
import org.daybreak.core.sampling.Sampler;
import org.jspecify.annotations.Nullable;

/** Starts the samples of pixels: sets the sampler to their random numbers and finds their film positions. One object per worker. */
public final class PixelSampling {
    /** Film position of the sample in pixels. */
    public double filmX;

    public double filmY;

    /** Factor on the radiance of the sample: 1 but for filters with negative lobes and filter sampling. */
    public double factor = 1;

    private final int width;
    private final @Nullable FilterSampler filterSampler;
    private final double[] position = new double[3];

    /** Sampling for a film. */
    PixelSampling(Film film) {
        width = film.settings().width();
        filterSampler = film.settings().filterSampling() ? film.filterSampler() : null;
    }

    /** Sampling for a single sample of a render. */
    public static PixelSampling of(SampleRequest request) {
        FilmSettings film = request.film();
        SampleAddress address = request.address();
        FilmSettings.Crop pixel = new FilmSettings.Crop(address.x(), address.y(), 1, 1);
        return new PixelSampling(
                new Film(new FilmSettings(film.width(), film.height(), pixel, film.filter(), film.filterSampling())));
    }

    /**
     * Starts a single sample of a render.
     *
     * @param request which one; the sampling must be {@linkplain #of made} for it
     * @return the sampler, whose next dimension is {@link Dimensions#FIRST_DIRECT}
     */
    public Sampler start(SampleRequest request) {
        SampleAddress address = request.address();
        Sampler sampler = request.antialiasing().newSampler(address.seed(), request.samplesPerPixel());
        start(sampler, address.x(), address.y(), address.sample());
        return sampler;
    }

    /**
     * Starts a sample.
     *
     * @param sampler of the render's seed; its next dimension is then {@link Dimensions#FIRST_DIRECT}
     * @param x column of the pixel in the whole film
     * @param index number of the sample within the pixel
     */
    void start(Sampler sampler, int x, int y, long index) {
        sampler.start((long) y * width + x, index);
        filmX = x + sampler.next();
        filmY = y + sampler.next();
        FilterSampler filter = filterSampler;
        if (filter != null) {
            filter.sample(x, y, filmX - x, filmY - y, position);
            filmX = position[0];
            filmY = position[1];
            factor = position[2];
        }
    }
}
