package org.daybreak.metropolis.chains;

import java.util.Arrays;
import java.util.function.BooleanSupplier;
import org.daybreak.core.render.NonFiniteLog;
import org.daybreak.core.render.OrderedWork;

/** Draws the candidates for the starts of chains. */
final class Bootstrap extends OrderedWork<Bootstrap.Block> {
    private static final int BLOCK = 64;

    /** Relative standard error with which b is known well enough, if time is short: no pixel will be known as well. */
    private static final double GOOD_ENOUGH = 0.01;

    private final ChainWorkers workers;
    private final long seed;
    private final int candidates;
    private final BooleanSupplier stop;
    private final BooleanSupplier hurry;
    private final Runnable watch;
    private final int enough;
    private final NonFiniteLog nonFinite;
    private double[] weights = new double[BLOCK];
    private int drawn;
    private int nextWorker;
    private double sum;
    private double squares;

    /** Set by commits, read by those who ask whether to go on. */
    private volatile boolean known;

    /** Set by commits: no candidate after these counts. */
    private volatile boolean done;

    /** Consecutive candidates. */
    static final class Block {
        private final double[] weights = new double[BLOCK];
        private final NonFiniteLog nonFinite = new NonFiniteLog();
        private int first;
        private int count;
        private double sum;
        private boolean finite;

        private void add(double weight) {
            if (Double.isFinite(weight)) {
                sum += weight;
            } else {
                finite = false;
            }
        }
    }

    /**
     * Creates the work.
     *
     * @param seed of the workers, for addresses
     * @param candidates how many to draw
     * @param enough how many of them are enough if they tell b well: the same number for any number of threads
     * @param stop ends it early: what was drawn until then counts
     * @param hurry ends it as soon as b is known well
     * @param watch called several times a second
     * @param nonFinite receives candidates with a weight that is not finite; such a state is left out
     */
    Bootstrap(
            ChainWorkers workers,
            long seed,
            int candidates,
            int enough,
            BooleanSupplier stop,
            BooleanSupplier hurry,
            Runnable watch,
            NonFiniteLog nonFinite) {
        this.workers = workers;
        this.seed = seed;
        this.candidates = candidates;
        this.enough = enough;
        this.stop = stop;
        this.hurry = hurry;
        this.watch = watch;
        this.nonFinite = nonFinite;
    }

    /** Draws. */
    StartDistribution draw() {
        run(workers.count());
        return new StartDistribution(Arrays.copyOf(weights, drawn));
    }

    @Override
    protected Block newSlot() {
        return new Block();
    }

    @Override
    protected Worker<Block> newWorker() {
        int thread = nextWorker++;
        return (unit, block) -> {
            ChainWorker worker = workers.renewed(thread);
            block.nonFinite.clear();
            ChainWorker.Candidates found = (number, filmX, filmY, weight) -> block.add(weight);
            for (int i = 0; i < block.count; i++) {
                block.sum = 0;
                block.finite = true;
                worker.candidate(block.first + i, found);
                block.weights[i] = block.sum;
                if (!block.finite) {
                    block.nonFinite.add("seed " + seed + ", candidate " + (block.first + i));
                }
            }
        };
    }

    @Override
    protected boolean claim(long unit, Block block) {
        long first = unit * BLOCK;
        if (first >= candidates || done || stop.getAsBoolean() || (known && hurry.getAsBoolean())) {
            return false;
        }
        block.first = (int) first;
        block.count = (int) Math.min(BLOCK, candidates - first);
        return true;
    }

    @Override
    protected void commit(long unit, Block block) {
        if (done) {
            return;
        }
        if (drawn + block.count > weights.length) {
            weights = Arrays.copyOf(weights, Math.min(candidates, Math.max(2 * weights.length, drawn + block.count)));
        }
        System.arraycopy(block.weights, 0, weights, drawn, block.count);
        drawn += block.count;
        for (int i = 0; i < block.count; i++) {
            sum += block.weights[i];
            squares += block.weights[i] * block.weights[i];
        }
        // (standard error / mean)², of so many that n and n − 1 are the same.
        known = squares / (sum * sum) - 1.0 / drawn < GOOD_ENOUGH * GOOD_ENOUGH;
        done = known && drawn >= enough;
        nonFinite.addAll(block.nonFinite);
    }

    @Override
    protected void watch() {
        watch.run();
    }
}
