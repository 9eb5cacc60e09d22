package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.FilmState;
import org.daybreak.core.render.CheckpointSink;
import org.daybreak.core.render.Checkpoints;
import org.daybreak.core.render.NonFiniteLog;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ProgressReporter;
import org.daybreak.core.render.RenderClock;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.sampling.Mixing;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.Reports;
import org.jspecify.annotations.Nullable;

/** One render by chains: see {@link ChainRenderer}. */
final class ChainRun {
    /** Entries of the position of a state: of the direct light, whether it is done; of the chains, how far they are. */
    private static final String DIRECT = "direct";

    private static final String CHAINS = "chains";

    /** The first of two stages has one in so many steps and candidates, and as much of the time. */
    private static final int FIRST_STAGE = 10;

    /** Part of the time that is left which the candidates may take. */
    private static final double BOOTSTRAP_SHARE = 0.2;

    /** Mutations per pixel in the first pass; up to the largest pass, the number at the end of each is double that before. */
    private static final double FIRST_PASS = 0.25;

    private static final int LARGEST_PASS = 16;

    /** Chains are divided into so many lanes, if the images of these have no more pixels than that together. */
    private static final int MOST_LANES = 16;

    private static final int LEAST_LANES = 4;
    private static final long PIXELS_OF_LANES = 1L << 24;

    private final ChainAlgorithm algorithm;
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

    private final int allChains;
    private final int lanes;
    private final int firstChain;
    private final int endChain;
    private final RoundSchedule schedule;
    private final ProgressReporter progress;
    private final NonFiniteLog nonFinite = new NonFiniteLog();
    private final ChainStatistics statistics;
    private final ChainConvergence convergence;
    private final List<ChainWorkers> allWorkers = new ArrayList<>();
    private final List<String> warnings = new ArrayList<>();
    private final Map<String, Double> seconds = new LinkedHashMap<>();
    private final long resumedSamples;
    private final double resumedSeconds;
    private @Nullable RenderReport directReport;
    private @Nullable RenderState directState;
    private List<FilmSettings.Crop> regions = List.of();
    private Chain[] chains = new Chain[0];
    private boolean begun;
    private boolean complete;
    private double b = Double.NaN;
    private double standardError = Double.NaN;
    private long candidates;
    private long withoutLight;
    private ImageImportance importance = ImageImportance.UNIFORM;
    private double phaseStart;

    /** State of commits, read by the thread that watches. */
    private volatile long directSamples;

    private volatile long steps;
    private volatile long passes;
    private volatile boolean targetReached;

    ChainRun(
            ChainAlgorithm algorithm,
            ChainSettings settings,
            DirectPart direct,
            Scene scene,
            Camera camera,
            Film film,
            RenderContext context) {
        this.algorithm = algorithm;
        this.settings = settings;
        this.direct = direct;
        this.scene = scene;
        this.camera = camera;
        this.film = film;
        this.context = context;
        clock = new RenderClock(context);
        checkpoints = new Checkpoints(context, clock);
        pixels = (long) film.settings().width() * film.settings().height();
        limited = context.budget().samplesPerPixel() < Integer.MAX_VALUE;
        long total = limited ? settings.steps(pixels) : Long.MAX_VALUE;
        allChains = (int) Math.min(settings.seedPaths(), total);
        long fitting = Math.max(LEAST_LANES, Math.min(MOST_LANES, PIXELS_OF_LANES / pixels));
        lanes = (int) Math.min(allChains, fitting);
        RenderPart part = context.part();
        if (part.count() > lanes && !direct.isAll()) {
            throw new ParameterException("what " + allChains + " Markov chains bring to an image of " + pixels
                    + " pixels is added up in " + lanes + " lanes: it can be cut into at most so many parts, not "
                    + part.count());
        }
        firstChain = laneStart(part.first(lanes));
        endChain = laneStart(part.end(lanes));
        schedule = new RoundSchedule(total, allChains, firstChain, endChain);
        statistics = new ChainStatistics(algorithm.moves().size());
        convergence = new ChainConvergence(film.settings(), firstChain, endChain);
        RenderState start = context.start();
        resumedSamples = start == null ? 0 : start.samples();
        resumedSeconds = start == null ? 0 : start.seconds();
        double mutations = limited ? schedule.steps() : (double) Integer.MAX_VALUE * pixels;
        double share = direct.exists() ? direct.share() : 0;
        double all = share == 1 ? (double) settings.directSamples() * pixels : mutations / (1 - share);
        progress = new ProgressReporter(context, clock, film, all, resumedSamples);
        film.useDependentSplats();
    }

    private int laneStart(long lane) {
        return (int) (allChains * lane / lanes);
    }

    /** The largest lane that starts at or before a chain. */
    private int laneOf(int chain) {
        return (int) ((lanes * (chain + 1L) - 1) / allChains);
    }

    RenderReport run() {
        RenderState start = context.start();
        if (start != null && start.complete()) {
            // Nothing follows a complete render, and one that was merged from parts has no position.
            restoreFilm(start);
            complete = true;
        } else if (start != null && start.position().containsKey(CHAINS)) {
            restoreFilm(start);
            resumeChains(start);
        } else {
            renderDirect(start);
            endPhase("direct");
            if (direct.isAll()) {
                complete = isDirectDone();
            } else if (!isStopped()) {
                beginChains();
            }
        }
        if (begun) {
            moveChains();
        }
        return finish();
    }

    private boolean isStopped() {
        return clock.shouldStop() || Thread.currentThread().isInterrupted();
    }

    private void endPhase(String name) {
        double now = clock.seconds();
        seconds.merge(name, now - phaseStart, Double::sum);
        phaseStart = now;
    }

    private void restoreFilm(RenderState start) {
        film.restore(start.film());
        regions = start.film().regions();
        nonFinite.addAll(start.nonFiniteSamples(), start.nonFiniteAddresses());
        directSamples = start.film().samples();
        steps = start.samples() - directSamples;
    }

    // Direct light.

    private boolean isDirectDone() {
        RenderReport report = directReport;
        RenderState state = directState;
        return state != null
                ? state.complete()
                : report != null
                        && !report.cancelled()
                        && !Thread.currentThread().isInterrupted();
    }

    private void renderDirect(@Nullable RenderState start) {
        boolean done = start != null && start.position(DIRECT, 1)[0] != 0;
        if (start != null && (done || !direct.exists())) {
            restoreFilm(start);
            return;
        }
        if (!direct.exists()) {
            return;
        }
        RenderReport report =
                direct.render(scene, camera, film, context.withStart(start).withCheckpoints(new DirectSink()));
        directReport = report;
        directSamples = report.samples();
        nonFinite.addAll(report.nonFiniteSamples(), report.nonFiniteAddresses());
        warnings.addAll(report.warnings());
        RenderState state = directState;
        if (state != null) {
            regions = state.film().regions();
            if (state.complete()
                    && !direct.isAll()
                    && context.checkpoints().intervalSeconds() < Double.POSITIVE_INFINITY) {
                context.checkpoints().save(withPosition(state, true, false));
            }
        }
    }

    /** A state of the direct light as one of the whole render. */
    private static RenderState withPosition(RenderState state, boolean done, boolean complete) {
        Map<String, long[]> position = new LinkedHashMap<>(state.position());
        position.put(DIRECT, new long[] {done ? 1 : 0});
        return new RenderState(
                state.film(),
                position,
                state.samples(),
                0,
                complete,
                state.nonFiniteSamples(),
                state.nonFiniteAddresses(),
                state.seconds());
    }

    /** Takes the states of the direct light. The last one is kept: it need not be that of the whole render. */
    private final class DirectSink implements CheckpointSink {
        private final CheckpointSink whole = context.checkpoints();

        @Override
        public double intervalSeconds() {
            return whole.intervalSeconds();
        }

        @Override
        public boolean takesStates() {
            return whole.takesStates();
        }

        @Override
        public void save(RenderState state) {
            directState = state;
            if (!state.complete()) {
                whole.save(withPosition(state, false, false));
            }
        }
    }

    // The start of the chains.

    private ChainWorkers newWorkers(long seed) {
        ChainWorkers workers =
                new ChainWorkers(algorithm, scene, camera, seed, direct.shortestOfChains(), context.threads());
        allWorkers.add(workers);
        return workers;
    }

    private void beginChains() {
        if (settings.twoStage()) {
            importance = firstStage();
        }
        ChainWorkers workers = newWorkers(context.seed());
        endPhase("prepare");
        workers.setImportance(importance);
        StartDistribution distribution =
                bootstrap(workers, context.seed(), settings.candidates(pixels), BOOTSTRAP_SHARE);
        if (isStopped()) {
            return;
        }
        b = distribution.mean();
        standardError = distribution.standardError();
        candidates = distribution.candidates();
        withoutLight = distribution.withoutLight();
        if (b > 0) {
            chains = start(workers, distribution, context.seed(), firstChain, endChain, allChains);
            begun = chains.length > 0;
        } else {
            complete = true;
        }
        endPhase("start");
    }

    /** Renders the rough image. */
    private ImageImportance firstStage() {
        long seed = Mixing.absorb(context.seed(), FIRST_STAGE);
        ChainWorkers workers = newWorkers(seed);
        endPhase("prepare");
        double end = clock.seconds() + clock.secondsLeft() / FIRST_STAGE;
        int least = Math.max(1, settings.candidates(pixels) / FIRST_STAGE);
        StartDistribution distribution = bootstrap(workers, seed, least, BOOTSTRAP_SHARE / FIRST_STAGE);
        long total = Math.max(1, settings.steps(pixels) / FIRST_STAGE);
        int count = (int) Math.min(settings.seedPaths(), total);
        RoughImage image = new RoughImage(film.settings(), settings.reduction());
        if (distribution.mean() > 0) {
            Chain[] rough = start(workers, distribution, seed, 0, count, count);
            RoundSchedule rounds = new RoundSchedule(rough.length == 0 ? 0 : total, count, 0, count);
            new ChainRounds(workers, rounds, rough, 0, algorithm.moves().size()) {
                @Override
                boolean isStopped() {
                    return clock.shouldStop() || clock.seconds() > end;
                }

                @Override
                void commit(Unit unit) {
                    image.add(unit.splats, unit.steps);
                    addNonFinite(unit, seed);
                }

                @Override
                protected void watch() {
                    showProgress();
                }
            }.run(workers.count());
        }
        endPhase("start");
        return image.importance(count);
    }

    private StartDistribution bootstrap(ChainWorkers workers, long seed, int count, double share) {
        double end = clock.seconds() + clock.secondsLeft() * share;
        return new Bootstrap(
                        workers,
                        seed,
                        count,
                        () -> clock.shouldStop() || clock.seconds() > end,
                        this::showProgress,
                        nonFinite)
                .draw();
    }

    private Chain[] start(
            ChainWorkers workers, StartDistribution distribution, long seed, int first, int end, int all) {
        // No candidate has this index.
        double u = new RandomStream(seed, StreamDomain.BOOTSTRAP, -1, 0).nextDouble();
        StartDistribution.Starts starts = distribution.draw(u, first, end, all);
        return new ChainStarts(workers, distribution, starts, first, clock::shouldStop, this::showProgress).start();
    }

    private void showProgress() {
        progress.update(directSamples + steps, passes);
    }

    private void addNonFinite(ChainRounds.Unit unit, long seed) {
        if (unit.statistics.nonFinite > 0) {
            String address = String.format(
                    Locale.ROOT,
                    "seed %d, chain %d, steps %d to %d",
                    seed,
                    unit.chain,
                    unit.firstStep,
                    unit.firstStep + unit.steps - 1);
            nonFinite.addAll(unit.statistics.nonFinite, List.of(address));
        }
    }

    // The chains.

    /** Number of passes that are complete after a number of mutations per pixel: ¼, ½, 1, … 16, 32, 48, … */
    private static long passes(double mutations) {
        long done = (long) (mutations / LARGEST_PASS);
        for (double end = FIRST_PASS; end < LARGEST_PASS && end <= mutations; end *= 2) {
            done++;
        }
        return done;
    }

    private void moveChains() {
        ChainWorkers workers = allWorkers.get(allWorkers.size() - 1);
        film.setSplatScale(b * pixels, standardError / b);
        Rounds rounds = new Rounds(workers);
        rounds.run(workers.count());
        complete = targetReached || schedule.isDone();
        endPhase("render");
    }

    /** The rounds that make the image. */
    private final class Rounds extends ChainRounds {
        Rounds(ChainWorkers workers) {
            super(workers, schedule, chains, firstChain, algorithm.moves().size());
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
            film.commit(unit.splats, unit.steps, laneOf(unit.chain));
            statistics.add(unit.statistics);
            convergence.add(unit.chain, unit.splats, unit.steps);
            addNonFinite(unit, context.seed());
            // Commits are made one at a time; only those who watch read meanwhile.
            long done = steps + unit.steps;
            steps = done;
            long now = passes(done / (double) pixels);
            if (now > passes) {
                passes = now;
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
            showProgress();
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
        return (double) steps / pixels * allChains / (endChain - firstChain);
    }

    private long finishedMutationsPerPixel() {
        return complete && limited && !targetReached ? settings.mutationsPerPixel() : (long) mutationsPerPixel();
    }

    private RenderState chainState(boolean isComplete) {
        StateWriter out = new StateWriter();
        schedule.save(out);
        out.put(steps);
        out.put(directSamples);
        out.put(b);
        out.put(standardError);
        out.put(candidates);
        out.put(withoutLight);
        out.put(passes);
        importance.save(out);
        statistics.save(out);
        convergence.save(out);
        for (Chain chain : chains) {
            chain.save(out);
        }
        return state(film.state(regions), Map.of(CHAINS, out.toArray()), isComplete);
    }

    private RenderState state(FilmState filmState, Map<String, long[]> position, boolean isComplete) {
        return new RenderState(
                filmState,
                position,
                directSamples + steps,
                finishedMutationsPerPixel(),
                isComplete,
                nonFinite.count(),
                nonFinite.addresses(),
                resumedSeconds + clock.seconds());
    }

    private void resumeChains(RenderState start) {
        long[] values = start.position().get(CHAINS);
        StateReader in = new StateReader(values == null ? new long[0] : values);
        schedule.restore(in);
        steps = in.next();
        directSamples = in.next();
        b = in.nextDouble();
        standardError = in.nextDouble();
        candidates = in.next();
        withoutLight = in.next();
        passes = in.next();
        importance = ImageImportance.load(in);
        statistics.load(in);
        convergence.load(in);
        ChainWorkers workers = newWorkers(context.seed());
        workers.setImportance(importance);
        chains = new Chain[endChain - firstChain];
        for (int i = 0; i < chains.length; i++) {
            chains[i] = workers.get(0).newChain(firstChain + i);
            chains[i].load(in);
        }
        begun = true;
        endPhase("prepare");
    }

    // The end.

    private RenderReport finish() {
        progress.finish(directSamples + steps, passes);
        if (context.checkpoints().takesStates()) {
            saveLastState();
        }
        return new RenderReport(
                algorithm.id(),
                !complete && Reports.cancelled(context),
                directSamples + steps,
                resumedSamples,
                finishedMutationsPerPixel(),
                seconds,
                rays(),
                nonFinite.count(),
                nonFinite.addresses(),
                figures(),
                allWarnings());
    }

    private void saveLastState() {
        RenderState state = directState;
        if (begun) {
            checkpoints.finish(() -> chainState(complete));
        } else if (complete || state == null) {
            RenderState now = state(film.state(regions), Map.of(DIRECT, new long[] {1}), complete);
            checkpoints.finish(() -> now);
        } else if (state.complete()) {
            checkpoints.finish(() -> withPosition(state, true, false));
        }
    }

    private Map<String, Long> rays() {
        RenderReport report = directReport;
        Map<String, Long> rays = new LinkedHashMap<>();
        for (Map.Entry<String, Long> kind :
                Reports.raysByKind(allWorkers, ChainWorkers::rays).entrySet()) {
            long others = report == null ? 0 : report.raysByKind().getOrDefault(kind.getKey(), 0L);
            rays.put(kind.getKey(), kind.getValue() + others);
        }
        return rays;
    }

    /** NaN if chains are not comparable. */
    private double rHat() {
        return algorithm.hasOneTarget() ? convergence.rHat() : Double.NaN;
    }

    private Map<String, Double> figures() {
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("relativeError", progress.relativeError());
        if (!Double.isNaN(b)) {
            figures.put("b", b);
            figures.put("bStandardError", standardError);
            figures.put("seeds", (double) candidates);
            figures.put("seedsWithoutLight", (double) withoutLight);
        }
        if (begun) {
            figures.put("chains", (double) allChains);
            figures.put("mutationsPerPixel", mutationsPerPixel());
            figures.put("longestRejection", (double) statistics.longestRejection);
            figures.put("rHat", rHat());
            figures.put("regionError", convergence.regionError());
            figures.putAll(ChainReports.moveFigures(algorithm.moves(), statistics));
        }
        return figures;
    }

    private List<String> allWarnings() {
        List<String> all = new ArrayList<>(algorithm.warnings());
        all.addAll(warnings);
        if (direct.isImpossible()) {
            all.add("with maxEyeDepth below 3 path tracing finds other paths than the chains: direct lighting is not"
                    + " rendered apart");
        }
        if (!direct.exists() && film.layers().stream().anyMatch(layer -> layer != FilmLayer.VARIANCE)) {
            all.add("without direct lighting apart no image samples are taken: the albedo, normal and depth images stay"
                    + " empty");
        }
        if (b == 0) {
            all.add(candidates + " candidates found no light"
                    + (direct.exists() ? " but what is lit directly" : "")
                    + ": there is none, or bootstrapSamples must be raised");
        } else if (!complete && !begun) {
            all.add("the render ended before the Markov chains began: "
                    + (direct.exists() ? "the image shows direct lighting only" : "the image is black"));
        }
        if (begun && steps > 0) {
            all.addAll(ChainReports.warnings(
                    b,
                    standardError,
                    rHat(),
                    convergence.regionError(),
                    statistics.longestRejection,
                    (double) steps / (endChain - firstChain)));
        }
        return all;
    }
}
