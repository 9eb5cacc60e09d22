package org.daybreak.tracing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.FilmTile;
import org.daybreak.core.render.Checkpoints;
import org.daybreak.core.render.NonFiniteLog;
import org.daybreak.core.render.OrderedWork;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ProgressReporter;
import org.daybreak.core.render.RenderClock;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.SampleAllocation;
import org.daybreak.core.render.ThreadOwned;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/**
 * Renders pixel by pixel: asks the antialiasing method for samples in each pixel and a {@link RayProcessor} for their
 * radiance (the thesis' class of that name).
 *
 * <p>Work is cut into tiles and passes ({@link UniformSchedule}, {@link AdaptiveSchedule}). The sizes of passes depend on
 * nothing but the budget in samples, and tiles are committed in order: the image is the same, bit for bit, for any number
 * of threads. Under a time limit, passes that would not be complete in time are made smaller; the last one stops
 * wherever time runs out, and each pixel is the mean of the samples that it has.
 *
 * <p>A part of a render is a range of tiles, and for algorithms that splat one of lanes of tiles, see {@link TileGrid}.
 */
public final class PixelwiseRenderer implements Renderer {
    private static final int SAMPLES_BETWEEN_CHECKS = 16;

    private final String id;
    private final RayProcessor.Factory processors;
    private final FurtherImages furtherImages;

    /**
     * Creates a renderer.
     *
     * @param id identifier for reports
     * @param processors makes the algorithm's part, one per thread
     */
    public PixelwiseRenderer(String id, RayProcessor.Factory processors) {
        this(id, processors, FurtherImages.NONE);
    }

    /**
     * Creates a renderer that makes further images.
     *
     * @param id identifier for reports
     * @param processors makes the algorithm's part, one per thread
     * @param furtherImages what is made besides the film's image; with any, nothing can be resumed or cut into parts
     */
    public PixelwiseRenderer(String id, RayProcessor.Factory processors, FurtherImages furtherImages) {
        this.id = id;
        this.processors = processors;
        this.furtherImages = furtherImages;
    }

    @Override
    public RenderReport render(Scene scene, Camera camera, Film film, RenderContext context) {
        Reports.checkFilm(camera, film);
        Work work = new Work(scene, camera, film, context);
        work.run(context.threads());
        return work.report();
    }

    @Override
    public boolean isResumable() {
        return furtherImages.count() == 0;
    }

    /** One render. */
    private final class Work extends OrderedWork<TileUnit> {
        private final Scene scene;
        private final Camera camera;
        private final Film film;
        private final Film[] furtherFilms;
        private final RenderContext context;
        private final RenderClock clock;
        private final ProgressReporter progress;
        private final Checkpoints checkpoints;
        private final TileGrid grid;
        private final SampleSchedule schedule;
        private final long samplesPerPixel;
        private final List<TileWorker> workers = new ArrayList<>();
        private final NonFiniteLog nonFinite = new NonFiniteLog();
        private final long resumedSamples;
        private final double resumedSeconds;
        private double preparedAt;

        /** State of {@link #commit}, read by {@link #watch}. */
        private final AtomicLong samples = new AtomicLong();

        private final AtomicLong passes = new AtomicLong();
        private volatile long finishedSamplesPerPixel;
        private boolean passIsWhole = true;
        private boolean cutShort;
        private volatile boolean targetReached;

        Work(Scene scene, Camera camera, Film film, RenderContext context) {
            this.scene = scene;
            this.camera = camera;
            this.film = film;
            this.context = context;
            furtherFilms = furtherFilms();
            clock = new RenderClock(context);
            checkpoints = new Checkpoints(context, clock);
            checkSplats();
            grid = new TileGrid(film, context.part(), processors.splats(), processors.learns());
            samplesPerPixel =
                    context.antialiasing().samplesPerPixel(context.budget().samplesPerPixel());
            schedule = context.antialiasing()
                    .allocation()
                    .<SampleSchedule>map(this::adaptive)
                    .orElseGet(this::uniform);
            RenderState start = context.start();
            if (start != null) {
                film.restore(start.film());
                // Nothing follows a complete render, and one that was merged from parts has no position.
                if (!start.complete()) {
                    schedule.restore(start);
                }
                nonFinite.addAll(start.nonFiniteSamples(), start.nonFiniteAddresses());
                samples.set(start.samples());
                finishedSamplesPerPixel = start.samplesPerPixel();
                targetReached = start.complete();
            }
            resumedSamples = samples.get();
            resumedSeconds = start == null ? 0 : start.seconds();
            progress = new ProgressReporter(
                    context, clock, film, (double) samplesPerPixel * grid.pixels(), resumedSamples);
        }

        private Film[] furtherFilms() {
            Film[] films = new Film[furtherImages.count()];
            if (films.length > 0 && (context.start() != null || !context.part().isWhole())) {
                throw new ParameterException("renderer '" + id
                        + "' can make further images neither of a part nor from a state to go on from");
            }
            for (int i = 0; i < films.length; i++) {
                films[i] = new Film(film.settings());
            }
            return films;
        }

        private SampleSchedule uniform() {
            return new UniformSchedule(grid, samplesPerPixel, context.seed(), this::affordableSamples);
        }

        private SampleSchedule adaptive(SampleAllocation allocation) {
            if (!context.part().isWhole()) {
                throw new ParameterException(
                        "antialiasing '" + context.antialiasing().id()
                                + "' cannot render parts: its numbers of samples depend on the whole image");
            }
            film.useSampleWeights();
            for (Film further : furtherFilms) {
                further.useSampleWeights();
            }
            return new AdaptiveSchedule(grid, film, allocation, samplesPerPixel, context.seed());
        }

        private int affordableSamples(long takenPerPixel) {
            double left = clock.secondsLeft();
            if (left == Double.POSITIVE_INFINITY) {
                return Integer.MAX_VALUE;
            }
            double takenHere = (double) samples.get() - resumedSamples;
            double secondsPerSample = (clock.seconds() - preparedAt) * grid.pixels() / Math.max(1, takenHere);
            return (int) (left / secondsPerSample);
        }

        @Override
        protected TileUnit newSlot() {
            FilmTile[] tiles = new FilmTile[furtherFilms.length];
            for (int i = 0; i < tiles.length; i++) {
                tiles[i] = furtherFilms[i].newTile();
            }
            return new TileUnit(film.newTile(), tiles);
        }

        @Override
        protected Worker<TileUnit> newWorker() {
            TileWorker worker = new TileWorker(this::newSampleTaker, furtherFilms.length == 0);
            workers.add(worker);
            preparedAt = clock.seconds();
            return worker;
        }

        private SampleTaker newSampleTaker() {
            RayProcessor processor = processors.create(scene, camera, film.needsFeatures());
            return new SampleTaker(
                    processor, new RaySample(furtherFilms.length), samplesPerPixel, film, context, clock);
        }

        @Override
        protected boolean needsCommits() {
            return schedule.needsCommits() && !clock.shouldStop();
        }

        @Override
        protected boolean claim(long number, TileUnit unit) {
            if (targetReached || schedule.isDone() || clock.shouldStop()) {
                return false;
            }
            schedule.next(unit);
            return true;
        }

        @Override
        protected void commit(long number, TileUnit unit) {
            if (targetReached) {
                return;
            }
            boolean whole = unit.samples == unit.expected;
            checkpoints.beforeCommit(whole, () -> state(schedule.position(unit), false));
            if (unit.splats.size() > 0 && !processors.splats()) {
                throw new IllegalStateException("renderer '" + id + "' splats but does not say so");
            }
            unit.commit(film, furtherFilms, processors.splats());
            if (unit.counted) {
                nonFinite.addAll(unit.nonFinite);
                samples.addAndGet(unit.samples);
            }
            cutShort |= !whole;
            passIsWhole &= whole;
            if (unit.endsPass) {
                if (passIsWhole) {
                    finishedSamplesPerPixel = unit.samplesPerPixelThen;
                    passes.incrementAndGet();
                    checkTarget();
                }
                passIsWhole = true;
            }
        }

        private void checkSplats() {
            if (processors.splats() && context.antialiasing().allocation().isPresent()) {
                throw new ParameterException("renderer '" + id + "' cannot be used with antialiasing '"
                        + context.antialiasing().id()
                        + "': what it finds in other pixels has their numbers of samples");
            }
        }

        /** In order with the commits, and not when somebody looks: so it does not depend on how fast things go. */
        private void checkTarget() {
            double target = context.budget().targetError();
            if (target > 0 && film.relativeError() < target) {
                targetReached = true;
                clock.stop();
            }
        }

        private RenderState state(Map<String, long[]> position, boolean complete) {
            return new RenderState(
                    film.state(grid.regions()),
                    position,
                    samples.get(),
                    finishedSamplesPerPixel,
                    complete,
                    nonFinite.count(),
                    nonFinite.addresses(),
                    resumedSeconds + clock.seconds());
        }

        @Override
        protected void watch() {
            progress.update(samples.get(), passes.get());
            checkpoints.watch();
        }

        RenderReport report() {
            boolean complete = targetReached || (schedule.isDone() && !cutShort);
            progress.finish(samples.get(), passes.get());
            checkpoints.finish(() -> state(schedule.position(), complete));
            double seconds = clock.seconds();
            List<String> warnings = new ArrayList<>();
            if (finishedSamplesPerPixel == 0) {
                warnings.add("the render ended before every pixel had a sample");
            }
            return new RenderReport(
                    id,
                    !complete && Reports.cancelled(context),
                    samples.get(),
                    resumedSamples,
                    finishedSamplesPerPixel,
                    Reports.phases(preparedAt, seconds),
                    Reports.raysByKind(workers, TileWorker::rays),
                    nonFinite.count(),
                    nonFinite.addresses(),
                    Map.of("relativeError", progress.relativeError()),
                    warnings,
                    furtherImages.sheets(
                            Arrays.stream(furtherFilms).map(Film::develop).toList()));
        }
    }

    /** Has tiles sampled. */
    private static final class TileWorker implements OrderedWork.Worker<TileUnit> {
        private final ThreadOwned<SampleTaker> taker;
        private final boolean renewable;
        private final long[] raysBefore = new long[RayKind.values().length];

        /**
         * Creates a worker.
         *
         * @param renewable whether what takes samples may be made anew; not with further images, which know their processors
         */
        TileWorker(Supplier<SampleTaker> maker, boolean renewable) {
            taker = new ThreadOwned<>(maker, this::retire);
            this.renewable = renewable;
        }

        @Override
        public void compute(long number, TileUnit unit) {
            (renewable ? taker.renewed() : taker.current()).compute(unit);
        }

        private void retire(SampleTaker old) {
            for (RayKind kind : RayKind.values()) {
                raysBefore[kind.ordinal()] += old.processor.rays(kind);
            }
        }

        long rays(RayKind kind) {
            return raysBefore[kind.ordinal()] + taker.current().processor.rays(kind);
        }
    }

    /** Takes the samples of tiles. */
    private static final class SampleTaker {
        private final RayProcessor processor;
        private final RenderContext context;
        private final long samplesPerPixel;
        private final RenderClock clock;
        private final FilmSettings.Crop area;
        private final boolean features;
        private final RaySample sample;
        private final boolean filterSampling;
        private final PixelSampling position;

        private Sampler sampler;
        private long samplerSeed;
        private int untilCheck;
        private long taken;

        SampleTaker(
                RayProcessor processor,
                RaySample sample,
                long samplesPerPixel,
                Film film,
                RenderContext context,
                RenderClock clock) {
            this.processor = processor;
            this.sample = sample;
            this.samplesPerPixel = samplesPerPixel;
            this.context = context;
            this.clock = clock;
            samplerSeed = context.seed();
            sampler = context.antialiasing().newSampler(samplerSeed, samplesPerPixel);
            position = new PixelSampling(film);
            area = film.sampleArea();
            features = film.needsFeatures();
            filterSampling = film.settings().filterSampling();
        }

        void compute(TileUnit unit) {
            unit.begin();
            taken = 0;
            takeAll(unit);
            unit.samples = taken;
        }

        private void takeAll(TileUnit unit) {
            sample.further.beginUnit(unit.furtherSplats);
            processor.beginUnit();
            if (unit.seed != samplerSeed) {
                samplerSeed = unit.seed;
                sampler = context.antialiasing().newSampler(samplerSeed, samplesPerPixel);
            }
            int[] counts = unit.counts;
            untilCheck = 1;
            for (int y = unit.y; y < unit.y + unit.height; y++) {
                for (int x = unit.x; x < unit.x + unit.width; x++) {
                    long from = unit.firstSample;
                    long end = from + unit.samplesPerPixel;
                    if (counts != null) {
                        int count = counts[(y - area.y()) * area.width() + x - area.x()];
                        from = AdaptiveSchedule.first(unit, count);
                        end = AdaptiveSchedule.end(unit, count);
                        unit.setSampleWeight(unit.passWeight / count);
                    }
                    if (!takeSamples(unit, x, y, from, end)) {
                        return;
                    }
                }
            }
        }

        /** Takes samples of a pixel; false if the render should stop. */
        private boolean takeSamples(TileUnit unit, int x, int y, long from, long end) {
            for (long i = from; i < end; i++) {
                if (--untilCheck == 0) {
                    if (clock.shouldStop()) {
                        return false;
                    }
                    untilCheck = SAMPLES_BETWEEN_CHECKS;
                }
                takeSample(unit, x, y, i);
            }
            return true;
        }

        private void takeSample(TileUnit unit, int x, int y, long index) {
            position.start(sampler, x, y, index);
            double filmX = position.filmX;
            double filmY = position.filmY;
            FilmTile[] further = unit.furtherTiles;
            if (further.length > 0) {
                sample.further.beginSample();
            }
            boolean finite = processor.trace(filmX, filmY, sampler, sample, unit.splats);
            boolean added = filterSampling
                    ? unit.tile.addToPixel(x, y, position.factor, sample.radiance, features ? sample.features : null)
                    : unit.tile.add(filmX, filmY, sample.radiance, features ? sample.features : null);
            if (added) {
                for (int i = 0; i < further.length; i++) {
                    if (filterSampling) {
                        further[i].addToPixel(x, y, position.factor, sample.further.value(i), null);
                    } else {
                        further[i].add(filmX, filmY, sample.further.value(i));
                    }
                }
            }
            if (!finite || !added) {
                unit.nonFinite.addSample(unit.seed, x, y, index);
            }
            taken++;
        }
    }
}
