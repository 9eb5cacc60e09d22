package org.daybreak.metropolis.chains;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.daybreak.core.render.OrderedWork;

/** Draws a few samples that show what samples and what chains are good at: see {@link SamplePlan}. */
final class SamplePilot extends OrderedWork<SamplePilot.Block> {
    private static final int BLOCK = 16;

    private final Supplier<PilotWorker> workers;
    private final PilotGrid grid;
    private final BooleanSupplier stop;
    private final Runnable watch;
    private final PilotPaths all = new PilotPaths();

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
     * @param watch called several times a second
     */
    SamplePilot(Supplier<PilotWorker> workers, PilotGrid grid, BooleanSupplier stop, Runnable watch) {
        this.workers = workers;
        this.grid = grid;
        this.stop = stop;
        this.watch = watch;
    }

    /** Draws, with a number of threads. */
    PilotPaths draw(int threads) {
        run(threads);
        return all;
    }

    @Override
    protected Block newSlot() {
        return new Block();
    }

    @Override
    protected Worker<Block> newWorker() {
        PilotWorker worker = workers.get();
        return (unit, block) -> {
            block.paths.clear();
            long before = worker.rays();
            for (int i = block.first; i < block.end; i++) {
                worker.survey(i, grid.column(i), grid.row(i), block.paths);
                block.paths.endSurvey();
            }
            block.paths.addRays(worker.rays() - before);
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
        watch.run();
    }
}
