package org.daybreak.metropolis.chains;

import java.util.function.BooleanSupplier;
import org.daybreak.core.render.OrderedWork;

/** Puts chains on their starts. */
final class ChainStarts extends OrderedWork<ChainStarts.Slot> {
    private final ChainWorkers workers;
    private final StartDistribution distribution;
    private final StartDistribution.Starts starts;
    private final int first;
    private final BooleanSupplier stop;
    private final Runnable watch;
    private final Chain[] chains;
    private int started;
    private int nextWorker;

    /** A chain to put on its start. */
    static final class Slot {
        private int number;
    }

    /** Finds the state of a candidate in whose share of the summed weights an offset lies. */
    private static final class Search implements ChainWorker.Candidates {
        private double offset;
        private double sum;
        private int chosen;
        private boolean passed;

        void begin(double searched) {
            offset = searched;
            sum = 0;
            chosen = -1;
            passed = false;
        }

        @Override
        public void found(int number, double filmX, double filmY, double weight) {
            if (passed || !Double.isFinite(weight) || weight <= 0) {
                return;
            }
            chosen = number;
            sum += weight;
            passed = sum > offset;
        }
    }

    /**
     * Creates the work.
     *
     * @param distribution from which the starts were drawn
     * @param starts of the chains
     * @param first number of the first chain
     * @param stop ends it early: then there are no chains
     * @param watch called several times a second
     */
    ChainStarts(
            ChainWorkers workers,
            StartDistribution distribution,
            StartDistribution.Starts starts,
            int first,
            BooleanSupplier stop,
            Runnable watch) {
        this.workers = workers;
        this.distribution = distribution;
        this.starts = starts;
        this.first = first;
        this.stop = stop;
        this.watch = watch;
        chains = new Chain[starts.candidates().length];
    }

    /** Starts the chains; none if it was stopped. */
    Chain[] start() {
        run(workers.count());
        return started == chains.length ? chains : new Chain[0];
    }

    @Override
    protected Slot newSlot() {
        return new Slot();
    }

    @Override
    protected Worker<Slot> newWorker() {
        int thread = nextWorker++;
        Search search = new Search();
        return (unit, slot) -> {
            ChainWorker worker = workers.renewed(thread);
            long candidate = starts.candidates()[slot.number];
            search.begin(starts.offsets()[slot.number]);
            worker.candidate(candidate, search);
            if (search.chosen < 0) {
                throw new IllegalStateException("candidate " + candidate + " had states of weight "
                        + distribution.weight(candidate) + " and has none when it is drawn again");
            }
            Chain chain = worker.newChain(first + slot.number);
            worker.start(chain, candidate, search.chosen);
            chains[slot.number] = chain;
        };
    }

    @Override
    protected boolean claim(long unit, Slot slot) {
        if (unit >= chains.length || stop.getAsBoolean()) {
            return false;
        }
        slot.number = (int) unit;
        return true;
    }

    @Override
    protected void commit(long unit, Slot slot) {
        started++;
    }

    @Override
    protected void watch() {
        watch.run();
    }
}
