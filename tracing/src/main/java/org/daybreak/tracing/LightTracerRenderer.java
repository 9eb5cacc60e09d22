package org.daybreak.tracing;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.Checkpoints;
import org.daybreak.core.render.NonFiniteLog;
import org.daybreak.core.render.OrderedWork;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ProgressReporter;
import org.daybreak.core.render.RenderClock;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;

/**
 * Renders by light tracing alone. The budget's samples per pixel are light subpaths per pixel of the whole film, so that a crop
 * is a part of the whole image, bit for bit. The antialiasing method plays no part.
 *
 * <p>The subpaths are cut into {@value #LANES} lanes whose splats are added up apart. A part of a render is a range of lanes.
 *
 * <p>What it cannot show: surfaces that scatter in ideal directions only, and what is seen through or in them, as their
 * points cannot be joined to the lens. Auxiliary images other than the variance stay empty.
 */
public final class LightTracerRenderer implements Renderer {
    private static final int PATHS_PER_UNIT = 2048;
    private static final int LANES = 16;
    private static final String POSITION = "unit";
    private static final int PATHS_BETWEEN_CHECKS = 16;

    private final LightTracerSettings settings;

    /** Creates a renderer. */
    public LightTracerRenderer(LightTracerSettings settings) {
        this.settings = settings;
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
        return true;
    }

    /** Consecutive light subpaths: which, and what came out. */
    private static final class Unit {
        final SplatBuffer splats = new SplatBuffer();
        final NonFiniteLog nonFinite = new NonFiniteLog();
        long number;
        long first;
        int count;
        int traced;
    }

    /** One render. */
    private final class Work extends OrderedWork<Unit> {
        private final Scene scene;
        private final Camera camera;
        private final Film film;
        private final RenderContext context;
        private final RenderClock clock;
        private final ProgressReporter progress;
        private final long pixels;
        private final long paths;
        private final List<LightTracer> created = new ArrayList<>();
        private final NonFiniteLog nonFinite = new NonFiniteLog();
        private final Checkpoints checkpoints;
        private final long units;
        private final long firstUnit;
        private final long endUnit;
        private final long pathsOfPart;
        private final long resumedPaths;
        private final double resumedSeconds;
        private double preparedAt;
        private final AtomicLong traced = new AtomicLong();
        private long nextUnit;
        private volatile boolean targetReached;

        Work(Scene scene, Camera camera, Film film, RenderContext context) {
            this.scene = scene;
            this.camera = camera;
            this.film = film;
            this.context = context;
            clock = new RenderClock(context);
            pixels = (long) film.settings().width() * film.settings().height();
            paths = Math.multiplyExact(pixels, context.budget().samplesPerPixel());
            units = (paths + PATHS_PER_UNIT - 1) / PATHS_PER_UNIT;
            RenderPart part = context.part();
            if (part.count() > LANES) {
                throw new ParameterException(
                        "light tracing can be cut into at most " + LANES + " parts, not " + part.count());
            }
            firstUnit = laneStart(part.first(LANES));
            endUnit = laneStart(part.end(LANES));
            pathsOfPart = Math.min(paths, endUnit * PATHS_PER_UNIT) - Math.min(paths, firstUnit * PATHS_PER_UNIT);
            if (!part.isWhole()) {
                film.keepSplatLanes();
            }
            nextUnit = firstUnit;
            RenderState start = context.start();
            if (start != null) {
                film.restore(start.film());
                // Nothing follows a complete render, and one that was merged from parts has no position.
                nextUnit = start.complete() ? endUnit : start.position(POSITION, 1)[0];
                nonFinite.addAll(start.nonFiniteSamples(), start.nonFiniteAddresses());
                traced.set(start.samples());
                targetReached = start.complete();
            }
            resumedPaths = traced.get();
            resumedSeconds = start == null ? 0 : start.seconds();
            checkpoints = new Checkpoints(context, clock);
            progress = new ProgressReporter(context, clock, film, pathsOfPart, resumedPaths);
        }

        private long laneStart(long lane) {
            return Math.multiplyExact(units, lane) / LANES;
        }

        /** True if a lane ends before a unit. */
        private boolean isLaneStart(long unit) {
            // laneStart(lane) = unit for the smallest lane with lane·units/LANES ≥ unit, or for none.
            long lane = (unit * LANES + units - 1) / units;
            return laneStart(lane) == unit;
        }

        @Override
        protected Unit newSlot() {
            return new Unit();
        }

        @Override
        protected Worker<Unit> newWorker() {
            LightTracer tracer = new LightTracer(scene, camera, context.seed(), settings);
            created.add(tracer);
            preparedAt = clock.seconds();
            return (number, unit) -> compute(tracer, unit);
        }

        @Override
        protected boolean claim(long number, Unit unit) {
            if (targetReached || nextUnit >= endUnit || clock.shouldStop()) {
                return false;
            }
            unit.number = nextUnit++;
            unit.first = unit.number * PATHS_PER_UNIT;
            unit.count = (int) Math.min(PATHS_PER_UNIT, paths - unit.first);
            return true;
        }

        private void compute(LightTracer tracer, Unit unit) {
            unit.splats.clear();
            unit.nonFinite.clear();
            unit.traced = 0;
            while (unit.traced < unit.count) {
                if (unit.traced % PATHS_BETWEEN_CHECKS == 0 && clock.shouldStop()) {
                    return;
                }
                long path = unit.first + unit.traced;
                if (!tracer.trace(path, unit.splats)) {
                    unit.nonFinite.addLightPath(context.seed(), path);
                }
                unit.traced++;
            }
        }

        @Override
        protected void commit(long number, Unit unit) {
            if (targetReached) {
                return;
            }
            checkpoints.beforeCommit(unit.traced == unit.count, () -> state(unit.number, false));
            film.commit(unit.splats, unit.traced);
            if (isLaneStart(unit.number + 1)) {
                film.closeSplatLane();
            }
            nonFinite.addAll(unit.nonFinite);
            long passesBefore = traced.get() / pixels;
            if (traced.addAndGet(unit.traced) / pixels > passesBefore) {
                checkTarget();
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

        private RenderState state(long unit, boolean complete) {
            return new RenderState(
                    film.state(List.of()),
                    Map.of(POSITION, new long[] {unit}),
                    traced.get(),
                    traced.get() / pixels,
                    complete,
                    nonFinite.count(),
                    nonFinite.addresses(),
                    resumedSeconds + clock.seconds());
        }

        @Override
        protected void watch() {
            progress.update(traced.get(), traced.get() / pixels);
            checkpoints.watch();
        }

        RenderReport report() {
            long total = traced.get();
            boolean complete = targetReached || total >= pathsOfPart;
            progress.finish(total, total / pixels);
            checkpoints.finish(() -> state(nextUnit, complete));
            return new RenderReport(
                    "light",
                    !complete && Reports.cancelled(context),
                    total,
                    resumedPaths,
                    total / pixels,
                    Reports.phases(preparedAt, clock.seconds()),
                    Reports.raysByKind(created, LightTracer::rays),
                    nonFinite.count(),
                    nonFinite.addresses(),
                    Map.of("relativeError", progress.relativeError()),
                    warnings());
        }

        private List<String> warnings() {
            List<String> warnings = new ArrayList<>();
            if (film.layers().stream().anyMatch(layer -> layer != FilmLayer.VARIANCE)) {
                warnings.add("light tracing takes no image samples: the albedo, normal and depth images stay empty");
            }
            for (int i = 0; i < scene.shapeCount(); i++) {
                if (!scene.bsdf(i).connectable()) {
                    warnings.add("light tracing cannot show ideal mirrors and glass: they stay black");
                    break;
                }
            }
            return warnings;
        }
    }
}
