package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.OrderedWork;
import org.daybreak.core.render.RenderClock;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.sampling.Mixing;
import org.daybreak.tracing.Reports;

/** Draws a few samples that show what samples and what chains are good at: see {@link SamplePlan}. */
final class SamplePilot extends OrderedWork<SamplePilot.Block> {
    private static final int BLOCK = 16;

    /** Tells its random numbers from all others of a render. */
    private static final int PILOT = 1;

    private final Supplier<PilotWorker> workers;
    private final PilotGrid grid;
    private final BooleanSupplier stop;
    private final PilotPaths all = new PilotPaths();
    private final List<PilotWorker> made = Collections.synchronizedList(new ArrayList<>());

    /**
     * What a pilot leaves behind.
     *
     * @param rays number of rays traced, by the name of their kind
     */
    record Outcome(SamplePlan plan, Map<String, Long> rays) {
        /** Where there is no pilot. */
        static final Outcome NONE = new Outcome(SamplePlan.CHAINS_ALONE, Map.of());
    }

    /** Consecutive samples. */
    static final class Block {
        private final PilotPaths paths = new PilotPaths();
        private int first;
        private int end;
    }

    /**
     * Creates the work.
     *
     * @param workers makes one for each thread
     * @param grid where on the film to survey
     * @param stop ends it early: the samples are then fewer
     */
    private SamplePilot(Supplier<PilotWorker> workers, PilotGrid grid, BooleanSupplier stop) {
        this.workers = workers;
        this.grid = grid;
        this.stop = stop;
    }

    /**
     * Finds out how to divide the light of a render between samples and chains. The random numbers are its own, and the number of samples is fixed: so
     * is the plan, whatever the time or the number of threads, unless the render is stopped meanwhile.
     *
     * @param workers makes workers with a seed
     */
    static Outcome of(
            LongFunction<PilotWorker> workers,
            FilmSettings film,
            RenderContext context,
            RenderClock clock,
            Sharing sharing) {
        long ownSeed = Mixing.absorb(context.seed(), PILOT);
        PilotGrid grid = new PilotGrid(film, ownSeed);
        SamplePilot pilot = new SamplePilot(() -> workers.apply(ownSeed), grid, clock::shouldStop);
        pilot.run(context.threads());
        boolean isWhole = pilot.all.surveys() == grid.surveys();
        SamplePlan plan = isWhole ? SamplePlan.of(grid, pilot.all, sharing) : SamplePlan.CHAINS_ALONE;
        return new Outcome(plan, Reports.raysByKind(pilot.made, PilotWorker::rays));
    }

    @Override
    protected Block newSlot() {
        return new Block();
    }

    @Override
    protected Worker<Block> newWorker() {
        PilotWorker worker = workers.get();
        made.add(worker);
        return (unit, block) -> {
            block.paths.clear();
            double before = worker.work();
            for (int i = block.first; i < block.end; i++) {
                worker.survey(i, grid.column(i), grid.row(i), block.paths);
                block.paths.endSurvey();
            }
            block.paths.addWork(worker.work() - before);
        };
    }

    @Override
    protected boolean claim(long unit, Block block) {
        block.first = (int) Math.min(grid.surveys(), unit * BLOCK);
        block.end = Math.min(grid.surveys(), block.first + BLOCK);
        return block.first < block.end && !stop.getAsBoolean();
    }

    @Override
    protected void commit(long unit, Block block) {
        all.addAll(block.paths);
    }

    @Override
    protected void watch() {
        // It is over in a second, and until then nobody knows how much there is to do.
    }
}
