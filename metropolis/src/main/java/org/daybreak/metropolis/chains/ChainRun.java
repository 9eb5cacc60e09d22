package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.Checkpoints;
import org.daybreak.core.render.ProgressReporter;
import org.daybreak.core.render.RenderClock;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.Reports;
import org.jspecify.annotations.Nullable;

/** One render by chains, from phase to phase, its states and its report: see {@link ChainRenderer}. */
final class ChainRun {
    /** Entry of the position of a state: how far the chains are. */
    private static final String POSITION = "chains";

    private final ChainAlgorithm whole;

    /** With the target that the plan leaves to chains. */
    private final ChainAlgorithm algorithm;

    private final Map<String, Long> raysOfPilot;
    private final SamplePlan plan;
    private final Amounts amounts;
    private final ChainSettings settings;
    private final DirectPart direct;
    private final Scene scene;
    private final Camera camera;
    private final Film film;
    private final RenderContext context;
    private final RenderClock clock;
    private final Checkpoints checkpoints;
    private final long pixels;

    /** Whether the number of steps is limited. */
    private final boolean limited;

    private final ChainLanes lanes;
    private final RoundSchedule schedule;
    private final ChainProgress progress;
    private final DirectPhase directPhase;
    private final ChainStartUp startUp;
    private final ChainTally tally;
    private final List<ChainWorkers> allWorkers = new ArrayList<>();
    private final List<String> warnings = new ArrayList<>();
    private final long resumedSamples;
    private final double resumedSeconds;
    private List<FilmSettings.Crop> regions = List.of();
    private Brightness brightness = Brightness.UNKNOWN;
    private ImageImportance importance = ImageImportance.UNIFORM;
    private Chain[] chains = new Chain[0];
    private boolean begun;
    private boolean complete;

    /** Set by commits, read by those who ask whether to go on. */
    private volatile boolean targetReached;

    private ChainRun(
            ChainAlgorithm algorithm,
            SamplePilot.Outcome pilot,
            ChainSettings settings,
            DirectPart direct,
            Scene scene,
            Camera camera,
            Film film,
            RenderContext context,
            RenderClock clock) {
        whole = algorithm;
        raysOfPilot = pilot.rays();
        plan = pilot.plan();
        this.algorithm = plan.ofSamples().isEmpty() ? algorithm : algorithm.remainder(plan.ofSamples());
        this.settings = settings;
        this.direct = direct;
        this.scene = scene;
        this.camera = camera;
        this.film = film;
        this.context = context;
        this.clock = clock;
        checkpoints = new Checkpoints(context, clock);
        pixels = (long) film.settings().width() * film.settings().height();
        limited = context.budget().samplesPerPixel() < Integer.MAX_VALUE;
        amounts = Amounts.of(settings, plan, pixels);
        long total = limited ? amounts.steps() : Long.MAX_VALUE;
        lanes = new ChainLanes((int) Math.min(settings.seedPaths(), total), pixels, context.part());
        if (!direct.isAll()) {
            lanes.check(context.part(), pixels);
        }
        schedule = new RoundSchedule(total, lanes.chains(), lanes.first(), lanes.end());
        tally = new ChainTally(this.algorithm, film.settings(), lanes);
        RenderState start = context.start();
        resumedSamples = start == null ? 0 : start.samples();
        resumedSeconds = start == null ? 0 : start.seconds();
        ProgressReporter reporter = new ProgressReporter(context, clock, film, allSamples(), resumedSamples);
        progress = new ChainProgress(clock, reporter, pixels);
        directPhase = new DirectPhase(direct, context);
        startUp = new ChainStartUp(
                settings,
                film.settings(),
                settings.candidates(limited ? amounts.steps() : settings.steps(pixels)),
                limited,
                this.algorithm.moves().size(),
                context.seed(),
                this::newWorkers,
                clock,
                progress);
        film.useDependentSplats();
    }

    /** Samples of the direct light and steps of the chains that will be taken if nothing stops the render. */
    private double allSamples() {
        double mutations = limited ? schedule.steps() : (double) Integer.MAX_VALUE * pixels;
        return direct.isAll() ? (double) amounts.samplesPerPixel() * pixels : mutations / (1 - shareOfSamples());
    }

    /** What part of all samples and steps are samples. */
    private double shareOfSamples() {
        if (!direct.exists()) {
            return 0;
        }
        if (direct.isAll()) {
            return 1;
        }
        return limited ? amounts.shareOfSamples(pixels) : settings.directShare();
    }

    private ChainWorkers newWorkers(long seed) {
        ChainWorkers workers =
                new ChainWorkers(algorithm, scene, camera, seed, direct.shortestOfChains(), context.threads());
        allWorkers.add(workers);
        return workers;
    }

    /** Renders. */
    static RenderReport of(
            ChainAlgorithm algorithm,
            ChainSettings settings,
            DirectPart direct,
            Scene scene,
            Camera camera,
            Film film,
            RenderContext context) {
        RenderClock clock = new RenderClock(context);
        boolean hasPilot = hasPilot(algorithm, direct, context);
        SamplePilot.Outcome pilot = hasPilot
                ? SamplePilot.of(
                        seed -> algorithm.newPilotWorker(scene, camera, seed, direct.shortestOfChains()),
                        film.settings(),
                        context,
                        clock,
                        algorithm.sharing())
                : SamplePilot.Outcome.NONE;
        ChainRun run = new ChainRun(algorithm, pilot, settings, direct, scene, camera, film, context, clock);
        if (hasPilot) {
            run.progress.endPhase("pilot");
        }
        return run.run();
    }

    /** A pilot is the same for each part of a render and whenever it is resumed, unless that is complete. */
    private static boolean hasPilot(ChainAlgorithm algorithm, DirectPart direct, RenderContext context) {
        RenderState start = context.start();
        boolean isComplete = start != null && start.complete();
        return !isComplete && direct.exists() && !direct.isAll() && algorithm.sharing() != Sharing.NEVER;
    }

    private RenderReport run() {
        RenderState start = context.start();
        if (start != null && start.complete()) {
            // Nothing follows a complete render, and one that was merged from parts has no position.
            restoreFilm(start);
            complete = true;
        } else {
            proceed(start);
        }
        if (begun) {
            moveChains();
        }
        return finish();
    }

    private void proceed(@Nullable RenderState start) {
        if (start != null && start.position().containsKey(POSITION)) {
            restoreFilm(start);
            resumeChains(start);
        } else {
            renderDirect(start);
            progress.endPhase("direct");
            if (direct.isAll()) {
                complete = directPhase.isDone();
            } else if (!isStopped()) {
                beginChains();
            }
        }
    }

    private boolean isStopped() {
        return clock.shouldStop() || Thread.currentThread().isInterrupted();
    }

    private void restoreFilm(RenderState start) {
        film.restore(start.film());
        regions = start.film().regions();
        progress.restore(start);
    }

    private void renderDirect(@Nullable RenderState start) {
        if (directPhase.isLeft(start)) {
            Renderer renderer = plan.ofSamples().isEmpty()
                    ? direct.pathTracer()
                    : whole.samples(plan.ofSamples(), direct.shortestOfChains());
            DirectPart.Samples samples = new DirectPart.Samples(
                    renderer, direct.timeShare(plan), amounts.samplesPerPixel(), shareOfSamples());
            RenderReport report = directPhase.render(samples, scene, camera, film, start, clock.seconds());
            progress.addDirect(report);
            warnings.addAll(report.warnings());
            RenderState state = directPhase.state();
            if (state != null) {
                regions = state.film().regions();
            }
        } else if (start != null) {
            restoreFilm(start);
        }
    }

    private void beginChains() {
        if (settings.twoStage()) {
            importance = startUp.roughImage();
        }
        ChainWorkers workers = newWorkers(context.seed());
        progress.endPhase("prepare");
        workers.setImportance(importance);
        StartDistribution distribution = startUp.candidates(workers);
        if (isStopped()) {
            return;
        }
        brightness = Brightness.of(distribution);
        if (brightness.mean() > 0) {
            chains = startUp.start(workers, distribution, lanes);
            begun = chains.length > 0;
        } else {
            complete = true;
        }
        progress.endPhase("start");
    }

    private void moveChains() {
        ChainWorkers workers = allWorkers.get(allWorkers.size() - 1);
        film.setSplatScale(brightness.mean() * pixels, brightness.standardError() / brightness.mean());
        Rounds rounds = new Rounds(workers);
        rounds.run(workers.count());
        complete = targetReached || schedule.isDone();
        progress.endPhase("render");
    }

    /** The rounds that make the image. */
    private final class Rounds extends ChainRounds {
        Rounds(ChainWorkers workers) {
            super(workers, schedule, chains, lanes.first(), algorithm.moves().size());
        }

        @Override
        boolean isStopped() {
            return targetReached || clock.shouldStop();
        }

        @Override
        void commit(Unit unit) {
            if (targetReached) {
                return;
            }
            film.commit(unit.splats, unit.steps, lanes.laneOf(unit.chain));
            tally.add(unit);
            progress.addNonFinite(unit, context.seed());
            if (progress.addSteps(unit.steps)) {
                checkTarget();
            }
        }

        @Override
        boolean isStateDue() {
            return checkpoints.isDue();
        }

        @Override
        void takeState() {
            checkpoints.beforeCommit(true, () -> chainState(false));
        }

        @Override
        protected void watch() {
            progress.show();
            checkpoints.watch();
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

    /** Mutations per pixel that the whole image would have if its other parts were as far. */
    private double mutationsPerPixel() {
        return (double) progress.steps() / pixels * lanes.chains() / lanes.count();
    }

    private long finishedMutationsPerPixel() {
        return complete && limited && !targetReached ? settings.mutationsPerPixel() : (long) mutationsPerPixel();
    }

    // States.

    private RenderState chainState(boolean isComplete) {
        StateWriter out = new StateWriter();
        schedule.save(out);
        out.put(progress.steps());
        out.put(progress.directSamples());
        brightness.save(out);
        out.put(progress.passes());
        importance.save(out);
        tally.save(out);
        for (Chain chain : chains) {
            chain.save(out);
        }
        return state(Map.of(POSITION, out.toArray()), isComplete);
    }

    private RenderState state(Map<String, long[]> position, boolean isComplete) {
        return new RenderState(
                film.state(regions),
                position,
                progress.samples(),
                finishedMutationsPerPixel(),
                isComplete,
                progress.nonFinite().count(),
                progress.nonFinite().addresses(),
                resumedSeconds + clock.seconds());
    }

    private void resumeChains(RenderState start) {
        long[] values = start.position().get(POSITION);
        StateReader in = new StateReader(values == null ? new long[0] : values);
        schedule.restore(in);
        long steps = in.next();
        long directSamples = in.next();
        brightness = Brightness.load(in);
        progress.restore(directSamples, steps, in.next());
        importance = ImageImportance.load(in);
        tally.load(in);
        ChainWorkers workers = newWorkers(context.seed());
        workers.setImportance(importance);
        chains = new Chain[lanes.count()];
        for (int i = 0; i < chains.length; i++) {
            chains[i] = workers.get(0).newChain(lanes.first() + i);
            chains[i].load(in);
        }
        begun = true;
        progress.endPhase("prepare");
    }

    private void saveLastState() {
        RenderState state = directPhase.state();
        if (begun) {
            checkpoints.finish(() -> chainState(complete));
        } else if (complete || state == null) {
            RenderState now = state(DirectPhase.donePosition(), complete);
            checkpoints.finish(() -> now);
        } else if (state.complete()) {
            checkpoints.finish(() -> DirectPhase.ofWhole(state, true));
        }
    }

    // The report.

    private RenderReport finish() {
        progress.finish();
        if (context.checkpoints().takesStates()) {
            saveLastState();
        }
        return new RenderReport(
                algorithm.id(),
                !complete && Reports.cancelled(context),
                progress.samples(),
                resumedSamples,
                finishedMutationsPerPixel(),
                progress.seconds(),
                rays(),
                progress.nonFinite().count(),
                progress.nonFinite().addresses(),
                figures(),
                allWarnings());
    }

    private Map<String, Long> rays() {
        Map<String, Long> rays = new LinkedHashMap<>();
        Reports.raysByKind(allWorkers, ChainWorkers::rays)
                .forEach((kind, count) ->
                        rays.put(kind, count + directPhase.rays(kind) + raysOfPilot.getOrDefault(kind, 0L)));
        return rays;
    }

    private Map<String, Double> figures() {
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("relativeError", progress.relativeError());
        if (!Double.isNaN(brightness.mean())) {
            figures.put("b", brightness.mean());
            figures.put("bStandardError", brightness.standardError());
            figures.put("seeds", (double) brightness.candidates());
            figures.put("seedsWithoutLight", (double) brightness.withoutLight());
        }
        if (!plan.ofSamples().isEmpty()) {
            figures.put("patternsOfSamples", (double) plan.ofSamples().size());
            figures.put("gainBySamples", plan.gain());
            figures.put("timeShareOfSamples", plan.timeShare());
        }
        if (begun) {
            figures.put("chains", (double) lanes.chains());
            figures.put("mutationsPerPixel", mutationsPerPixel());
            figures.putAll(tally.figures());
        }
        return figures;
    }

    private List<String> allWarnings() {
        List<String> all = new ArrayList<>(algorithm.warnings());
        all.addAll(warnings);
        all.addAll(direct.warnings(film));
        if (brightness.mean() == 0) {
            all.add(brightness.candidates() + " candidates found no light"
                    + (direct.exists() ? " but what is lit directly" : "")
                    + ": there is none, or bootstrapSamples must be raised");
        } else if (!complete && !begun) {
            all.add("the render ended before the Markov chains began: "
                    + (direct.exists() ? "the image shows direct lighting only" : "the image is black"));
        }
        if (begun && progress.steps() > 0) {
            all.addAll(tally.warnings(brightness, (double) progress.steps() / lanes.count()));
        }
        return all;
    }
}
