package org.daybreak.tracing;

import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.SampleAddress;
import org.daybreak.core.render.SampleRequest;
import org.daybreak.core.sampling.Sampler;

/** The samples that come before one in its work unit: what a processor learns from them has a part in that one. */
public final class EarlierSamples {
    private EarlierSamples() {}

    /**
     * Begins a work unit and computes its samples up to one, without that one: as a render of the whole image does that ends by its
     * number of samples.
     *
     * @param request which one; all pixels have the same number of samples
     * @param processor computes the samples
     */
    public static void trace(SampleRequest request, RayProcessor processor) {
        SampleAddress address = request.address();
        FilmSettings.Crop tile = TileGrid.tileOf(request.film(), address.x(), address.y());
        long first = UniformSchedule.passStart(address.sample(), request.samplesPerPixel());
        long size = UniformSchedule.passSize(first, request.samplesPerPixel());
        PixelSampling position = PixelSampling.of(request);
        Sampler sampler = request.antialiasing().newSampler(address.seed(), request.samplesPerPixel());
        RaySample sample = new RaySample();
        SplatBuffer splats = new SplatBuffer();
        processor.beginUnit();
        for (int y = tile.y(); y <= address.y(); y++) {
            int endX = y < address.y() ? tile.x() + tile.width() : address.x() + 1;
            for (int x = tile.x(); x < endX; x++) {
                boolean last = x == address.x() && y == address.y();
                long end = last ? address.sample() : first + size;
                for (long i = first; i < end; i++) {
                    position.start(sampler, x, y, i);
                    splats.clear();
                    processor.trace(position.filmX, position.filmY, sampler, sample, splats);
                }
            }
        }
    }
}
