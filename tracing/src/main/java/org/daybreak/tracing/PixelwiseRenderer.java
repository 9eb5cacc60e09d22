package org.daybreak.tracing;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.FilmTile;
import org.daybreak.core.film.FilterSampler;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.NonFiniteLog;
import org.daybreak.core.render.OrderedWork;
import org.daybreak.core.render.ProgressReporter;
import org.daybreak.core.render.RenderClock;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Renders pixel by pixel: asks the antialiasing method for samples in each pixel and a {@link RayProcessor} for their
 * radiance (the thesis' class of that name).
 *
 * <p>Work is cut into tiles and passes. The first passes take 1, 1, 2, 4, … samples per pixel, so that a complete image is there
 * soon; later ones {@value #LARGEST_PASS}. Their sizes depend on nothing but the budget in samples, and tiles
 * are committed in order: the image is the same, bit for bit, for any number of threads. Under a time limit, passes
 * that would not be complete in time are made smaller; the last one stops wherever time runs out, and each pixel
 * is the mean of the samples that it has.
 */
public final class PixelwiseRenderer implements Renderer {
    private static final int TILE_SIZE = 32;
    private static final int LARGEST_PASS = 16;
    private static final int SAMPLES_BETWEEN_CHECKS = 16;

    private final String id;
    private final RayProcessor.Factory processors;

    /**
     * Creates a renderer.
     *
     * @param id identifier for reports
     * @param processors makes the algorithm's part, one per thread
     */
    public PixelwiseRenderer(String id, RayProcessor.Factory processors) {
        this.id = id;
        this.processors = processors;
    }

    @Override
    public RenderReport render(Scene scene, Camera camera, Film film, RenderContext context) {
        Reports.checkFilm(camera, film);
        Work work = new Work(scene, camera, film, context);
        work.run(context.threads());
        return work.report();
    }

    /** A tile of a pass: what to do and what came out. */
    private static final class Unit {
        final FilmTile tile;
        final SplatBuffer splats = new SplatBuffer();
        final NonFiniteLog nonFinite = new NonFiniteLog();
        int x;
        int y;
        int width;
        int height;
        long firstSample;
        int samplesPerPixel;
        boolean endsPass;
        long samples;

        Unit(FilmTile tile) {
            this.tile = tile;
        }
    }

    /** One render. */
    private final class Work extends OrderedWork<Unit> {
        private final Scene scene;
        private final Camera camera;
        private final Film film;
        private final RenderContext context;
        private final RenderClock clock;
        private final ProgressReporter progress;
        private final FilmSettings.Crop area;
        private final int tilesX;
        private final long tiles;
        private final long samplesPerPixel;
        private final List<RayProcessor> created = new ArrayList<>();
        private final NonFiniteLog nonFinite = new NonFiniteLog();
        private double preparedAt;

        /** State of {@link #claim}. */
        private long nextTile;

        private long passStart;
        private int passSize;

        /** State of {@link #commit}, read by {@link #watch}. */
        private final AtomicLong samples = new AtomicLong();

        private final AtomicLong passes = new AtomicLong();
        private volatile long finishedSamplesPerPixel;

        Work(Scene scene, Camera camera, Film film, RenderContext context) {
            this.scene = scene;
            this.camera = camera;
            this.film = film;
            this.context = context;
            clock = new RenderClock(context);
            area = film.sampleArea();
            tilesX = (area.width() + TILE_SIZE - 1) / TILE_SIZE;
            tiles = (long) tilesX * ((area.height() + TILE_SIZE - 1) / TILE_SIZE);
            samplesPerPixel =
                    context.antialiasing().samplesPerPixel(context.budget().samplesPerPixel());
            progress =
                    new ProgressReporter(context, clock, film, (double) samplesPerPixel * area.width() * area.height());
            passSize = 1;
        }

        @Override
        protected Unit newSlot() {
            return new Unit(film.newTile());
        }

        @Override
        protected Worker<Unit> newWorker() {
            RayProcessor processor = processors.create(scene, camera, film.needsFeatures());
            created.add(processor);
            preparedAt = clock.seconds();
            return new TileWorker(
                    processor,
                    context.antialiasing().newSampler(context.seed(), samplesPerPixel),
                    film,
                    context,
                    clock);
        }

        @Override
        protected boolean claim(long number, Unit unit) {
            if (clock.shouldStop()) {
                return false;
            }
            if (nextTile == tiles) {
                passStart += passSize;
                if (passStart >= samplesPerPixel) {
                    return false;
                }
                passSize = nextPassSize();
                nextTile = 0;
            }
            int tx = (int) (nextTile % tilesX) * TILE_SIZE;
            int ty = (int) (nextTile / tilesX) * TILE_SIZE;
            unit.x = area.x() + tx;
            unit.y = area.y() + ty;
            unit.width = Math.min(TILE_SIZE, area.width() - tx);
            unit.height = Math.min(TILE_SIZE, area.height() - ty);
            unit.firstSample = passStart;
            unit.samplesPerPixel = passSize;
            nextTile++;
            unit.endsPass = nextTile == tiles;
            return true;
        }

        private int nextPassSize() {
            long size = Math.min(Math.min(passStart, LARGEST_PASS), samplesPerPixel - passStart);
            double left = clock.secondsLeft();
            if (left < Double.POSITIVE_INFINITY) {
                double secondsPerSample = (clock.seconds() - preparedAt) / passStart;
                size = Math.max(1, Math.min(size, (long) (left / secondsPerSample)));
            }
            return (int) size;
        }

        @Override
        protected void commit(long number, Unit unit) {
            film.commit(unit.tile);
            film.commit(unit.splats, unit.samples);
            nonFinite.addAll(unit.nonFinite);
            samples.addAndGet(unit.samples);
            if (unit.endsPass && !clock.shouldStop()) {
                passes.incrementAndGet();
                finishedSamplesPerPixel = unit.firstSample + unit.samplesPerPixel;
            }
        }

        @Override
        protected void watch() {
            progress.update(samples.get(), passes.get());
        }

        RenderReport report() {
            boolean complete = samples.get() >= samplesPerPixel * area.width() * area.height();
            if (complete && finishedSamplesPerPixel < samplesPerPixel) {
                finishedSamplesPerPixel = samplesPerPixel;
                passes.incrementAndGet();
            }
            progress.finish(samples.get(), passes.get());
            double seconds = clock.seconds();
            List<String> warnings = new ArrayList<>();
            if (finishedSamplesPerPixel == 0) {
                warnings.add("the render ended before every pixel had a sample");
            }
            return new RenderReport(
                    id,
                    !complete && Reports.cancelled(context),
                    samples.get(),
                    finishedSamplesPerPixel,
                    Reports.phases(preparedAt, seconds),
                    Reports.raysByKind(created, RayProcessor::rays),
                    nonFinite.count(),
                    nonFinite.addresses(),
                    Map.of("relativeError", progress.relativeError()),
                    warnings);
        }
    }

    /** Takes the samples of tiles. */
    private static final class TileWorker implements OrderedWork.Worker<Unit> {
        private final RayProcessor processor;
        private final Sampler sampler;
        private final RenderClock clock;
        private final long seed;
        private final int filmWidth;
        private final boolean features;
        private final RaySample sample = new RaySample();
        private final @Nullable FilterSampler filterSampler;
        /** Film position and factor of a sample. */
        private final double[] position = new double[3];

        TileWorker(RayProcessor processor, Sampler sampler, Film film, RenderContext context, RenderClock clock) {
            this.processor = processor;
            this.sampler = sampler;
            this.clock = clock;
            seed = context.seed();
            filmWidth = film.settings().width();
            features = film.needsFeatures();
            filterSampler = film.settings().filterSampling() ? film.filterSampler() : null;
        }

        @Override
        public void compute(long number, Unit unit) {
            unit.tile.begin(unit.x, unit.y, unit.width, unit.height);
            unit.splats.clear();
            unit.nonFinite.clear();
            unit.samples = 0;
            int untilCheck = 1;
            for (int y = unit.y; y < unit.y + unit.height; y++) {
                for (int x = unit.x; x < unit.x + unit.width; x++) {
                    for (int i = 0; i < unit.samplesPerPixel; i++) {
                        if (--untilCheck == 0) {
                            if (clock.shouldStop()) {
                                return;
                            }
                            untilCheck = SAMPLES_BETWEEN_CHECKS;
                        }
                        takeSample(unit, x, y, unit.firstSample + i);
                    }
                }
            }
        }

        private void takeSample(Unit unit, int x, int y, long index) {
            sampler.start((long) y * filmWidth + x, index);
            double filmX = x + sampler.next();
            double filmY = y + sampler.next();
            FilterSampler filter = filterSampler;
            if (filter != null) {
                filter.sample(x, y, filmX - x, filmY - y, position);
                filmX = position[0];
                filmY = position[1];
            }
            boolean finite = processor.trace(filmX, filmY, sampler, sample, unit.splats);
            if (filter != null) {
                finite &= unit.tile.addToPixel(x, y, position[2], sample.radiance, features ? sample.features : null);
            } else {
                finite &= features
                        ? unit.tile.add(filmX, filmY, sample.radiance, sample.features)
                        : unit.tile.add(filmX, filmY, sample.radiance);
            }
            if (!finite) {
                unit.nonFinite.addSample(seed, x, y, index);
            }
            unit.samples++;
        }
    }
}
