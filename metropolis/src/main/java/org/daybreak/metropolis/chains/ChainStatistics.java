package org.daybreak.metropolis.chains;

import java.util.Arrays;

/** Counts what the moves of chains came to, by kind of move. Mutable; work units have one each, which are added in order. */
public final class ChainStatistics {
    private static final Outcome[] OUTCOMES = Outcome.values();

    private final int moves;
    private final long[] outcomes;
    private final long[] accepted;
    private final double[] acceptance;
    private final double[] distance;

    /** Steps taken. */
    public long steps;

    /** The longest run of rejections that any chain has had. */
    public long longestRejection;

    /** Proposals and splats that were not finite and are left out. */
    public long nonFinite;

    /** Creates empty statistics for a number of kinds of moves. */
    public ChainStatistics(int moves) {
        this.moves = moves;
        outcomes = new long[moves * OUTCOMES.length];
        accepted = new long[moves];
        acceptance = new double[moves];
        distance = new double[moves];
    }

    /** Counts a proposal of a kind of move. */
    public void count(int move, Outcome outcome) {
        outcomes[move * OUTCOMES.length + outcome.ordinal()]++;
    }

    /** Adds the probability with which a proposal is accepted. */
    public void addAcceptance(int move, double probability) {
        acceptance[move] += probability;
    }

    /**
     * Counts an accepted proposal.
     *
     * @param pixels how far the image position moved
     */
    public void countAccepted(int move, double pixels) {
        accepted[move]++;
        distance[move] += pixels;
    }

    /** Number of kinds of moves. */
    public int moves() {
        return moves;
    }

    /** Number of proposals of a kind of move that ended so. */
    public long outcomes(int move, Outcome outcome) {
        return outcomes[move * OUTCOMES.length + outcome.ordinal()];
    }

    /** Number of proposals of a kind of move, those that failed included. */
    public long tried(int move) {
        long sum = 0;
        for (Outcome outcome : OUTCOMES) {
            sum += outcomes(move, outcome);
        }
        return sum;
    }

    /** Number of accepted proposals of a kind of move. */
    public long accepted(int move) {
        return accepted[move];
    }

    /** Mean probability of acceptance of a kind of move over all tries, failed ones as 0; NaN if there was none. */
    public double meanAcceptance(int move) {
        return acceptance[move] / tried(move);
    }

    /** Mean distance in pixels that accepted proposals of a kind of move have moved the image position; NaN if there was none. */
    public double meanDistance(int move) {
        return distance[move] / accepted[move];
    }

    /** Adds others. */
    public void add(ChainStatistics other) {
        for (int i = 0; i < outcomes.length; i++) {
            outcomes[i] += other.outcomes[i];
        }
        for (int i = 0; i < moves; i++) {
            accepted[i] += other.accepted[i];
            acceptance[i] += other.acceptance[i];
            distance[i] += other.distance[i];
        }
        steps += other.steps;
        nonFinite += other.nonFinite;
        longestRejection = Math.max(longestRejection, other.longestRejection);
    }

    /** Sets all to zero. */
    public void clear() {
        Arrays.fill(outcomes, 0);
        Arrays.fill(accepted, 0);
        Arrays.fill(acceptance, 0);
        Arrays.fill(distance, 0);
        steps = 0;
        nonFinite = 0;
        longestRejection = 0;
    }

    /** Writes all counts. */
    public void save(StateWriter out) {
        for (long outcome : outcomes) {
            out.put(outcome);
        }
        for (int i = 0; i < moves; i++) {
            out.put(accepted[i]);
            out.put(acceptance[i]);
            out.put(distance[i]);
        }
        out.put(steps);
        out.put(nonFinite);
        out.put(longestRejection);
    }

    /** Reads what {@link #save} has written. */
    public void load(StateReader in) {
        for (int i = 0; i < outcomes.length; i++) {
            outcomes[i] = in.next();
        }
        for (int i = 0; i < moves; i++) {
            accepted[i] = in.next();
            acceptance[i] = in.nextDouble();
            distance[i] = in.nextDouble();
        }
        steps = in.next();
        nonFinite = in.next();
        longestRejection = in.next();
    }
}
