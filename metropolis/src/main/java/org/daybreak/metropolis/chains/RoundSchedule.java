package org.daybreak.metropolis.chains;

/**
 * Divides steps among chains and rounds. Each chain takes the same number of steps, up to one; in each round each chain takes the
 * same number of them. The first rounds are short, so that there soon is an image; later ones are {@value #LONGEST} steps,
 * which bounds the memory for splats and the time until the render stops when it is asked to. Not thread-safe.
 */
final class RoundSchedule {
    /** Steps of a chain in a round, at most. */
    static final int LONGEST = 1024;

    private static final int SHORTEST = 16;

    private final long total;
    private final int chains;
    private final int first;
    private final int end;
    private int round;
    private long roundStart;
    private int next;

    /**
     * Creates a schedule.
     *
     * @param total steps of all chains together
     * @param chains number of all chains
     * @param first the first chain that is moved here
     * @param end the chain after the last one
     */
    RoundSchedule(long total, int chains, int first, int end) {
        this.total = total;
        this.chains = chains;
        this.first = first;
        this.end = end;
        next = first;
        skipFinished();
    }

    /** Steps that a chain takes in all. */
    long share(int chain) {
        return total / chains + (chain < total % chains ? 1 : 0);
    }

    /** Steps of all chains that are moved here. */
    long steps() {
        long longer = Math.max(0, Math.min(end, total % chains) - first);
        return Math.multiplyExact(total / chains, (long) (end - first)) + longer;
    }

    /** True if no unit remains. */
    boolean isDone() {
        return next == end;
    }

    /** The chain of the next unit. */
    int chain() {
        return next;
    }

    /** Number of the first step, within the chain, that the next unit takes. */
    long firstStep() {
        return roundStart;
    }

    /** How many steps the next unit takes. */
    int stepsOfUnit() {
        return (int) Math.min(length(), share(next) - roundStart);
    }

    /** True if the next unit is the last one of its round. */
    boolean endsRound() {
        return next == end - 1 || share(next + 1) <= roundStart;
    }

    /** Goes on to the unit after the next one. */
    void advance() {
        next++;
        skipFinished();
    }

    private int length() {
        return round < 6 ? SHORTEST << round : LONGEST;
    }

    /** Chains with a smaller number have at least as many steps, so no unit follows a chain without one. */
    private void skipFinished() {
        if (next < end && share(next) > roundStart) {
            return;
        }
        if (next > first && share(first) > roundStart + length()) {
            roundStart += length();
            round++;
            next = first;
        } else {
            next = end;
        }
    }

    /** Where it is: what {@link #restore} takes. */
    void save(StateWriter out) {
        out.put(round);
        out.put(roundStart);
        out.put(next);
    }

    /** Goes on from where another one was. */
    void restore(StateReader in) {
        round = in.nextInt();
        roundStart = in.next();
        next = in.nextInt();
    }
}
