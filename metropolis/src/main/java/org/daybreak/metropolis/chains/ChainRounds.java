package org.daybreak.metropolis.chains;

import java.util.Arrays;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.OrderedWork;

/**
 * Moves chains in rounds. A unit of work is a chain in a round; units are committed in order, so that the image has the same bits for
 * any number of threads. A unit is never cut short: when the work stops, each chain stands where its last unit has ended, and
 * goes on from there.
 */
abstract class ChainRounds extends OrderedWork<ChainRounds.Unit> {
    private final ChainWorkers workers;
    private final RoundSchedule schedule;
    private final Chain[] chains;
    private final int first;
    private final int moves;

    /** Number of the last unit of each chain. */
    private final long[] lastUnits;

    private volatile long committed;
    private int nextWorker;

    /** A chain in a round. */
    static final class Unit {
        final SplatBuffer splats = new SplatBuffer();
        final ChainStatistics statistics;
        int chain;
        long firstStep;
        int steps;
        boolean endsRound;

        private Unit(int moves) {
            statistics = new ChainStatistics(moves);
        }
    }

    /**
     * Creates the work.
     *
     * @param schedule which chains are moved, and how far; empty if there are none
     * @param chains the chains, from number {@code first} on
     * @param moves number of kinds of moves
     */
    ChainRounds(ChainWorkers workers, RoundSchedule schedule, Chain[] chains, int first, int moves) {
        this.workers = workers;
        this.schedule = schedule;
        this.chains = chains;
        this.first = first;
        this.moves = moves;
        lastUnits = new long[chains.length];
        Arrays.fill(lastUnits, -1);
    }

    /** True if no further unit shall begin. */
    abstract boolean isStopped();

    /** Takes over what a unit has done. */
    abstract void commit(Unit unit);

    /** True if the state shall be taken before the next unit. */
    boolean isStateDue() {
        return false;
    }

    /** Takes the state. Nothing is under way. */
    void takeState() {}

    @Override
    protected final Unit newSlot() {
        return new Unit(moves);
    }

    @Override
    protected final Worker<Unit> newWorker() {
        int thread = nextWorker++;
        return (number, unit) -> {
            unit.splats.clear();
            unit.statistics.clear();
            workers.renewed(thread).advance(chains[unit.chain - first], unit.steps, unit.splats, unit.statistics);
        };
    }

    /** A chain goes on when what it did before is committed; its state is then in nobody's hands. */
    @Override
    protected final boolean needsCommits() {
        return !schedule.isDone() && (isStateDue() || lastUnits[schedule.chain() - first] >= committed);
    }

    @Override
    protected final boolean claim(long number, Unit unit) {
        if (schedule.isDone() || isStopped()) {
            return false;
        }
        if (number == committed && isStateDue()) {
            takeState();
        }
        unit.chain = schedule.chain();
        unit.firstStep = schedule.firstStep();
        unit.steps = schedule.stepsOfUnit();
        unit.endsRound = schedule.endsRound();
        lastUnits[unit.chain - first] = number;
        schedule.advance();
        return true;
    }

    @Override
    protected final void commit(long number, Unit unit) {
        commit(unit);
        committed = number + 1;
    }
}
