package org.daybreak.metropolis;

import java.util.HashMap;
import java.util.Map;
import org.daybreak.core.testing.Significance;

/**
 * Bowker's test of symmetry: whether moves between two cells are as frequent in one direction as in the other. If steps start from
 * the stationary distribution of a reversible chain (detailed balance) they are, for any cells and any number of steps; then of n
 * moves between two cells the number in one direction is binomial with probability 1/2, and (a − b)²/(a + b) is near χ² with one
 * degree of freedom (Bowker, JASA 43, 1948).
 */
final class Symmetry {
    /** Pairs of cells with fewer moves between them are pooled, each in the direction of their numbers. */
    private static final int FEWEST = 12;

    private final Map<Long, long[]> moves = new HashMap<>();
    private long total;

    /**
     * Counts a move.
     *
     * @param from number of a cell, which must not depend on what moves there were, or pooled pairs would not be symmetric
     */
    void add(int from, int to) {
        if (from == to) {
            return;
        }
        long key = ((long) Math.min(from, to) << 32) | (Math.max(from, to) & 0xffffffffL);
        moves.computeIfAbsent(key, k -> new long[2])[from < to ? 0 : 1]++;
        total++;
    }

    /** Number of moves from one cell to another. */
    long moves() {
        return total;
    }

    /** p-value of the hypothesis that all pairs are symmetric; 1 if there are too few moves to tell. */
    double pValue() {
        double statistic = 0;
        int degreesOfFreedom = 0;
        long forth = 0;
        long back = 0;
        for (long[] pair : moves.values()) {
            if (pair[0] + pair[1] < FEWEST) {
                forth += pair[0];
                back += pair[1];
            } else {
                statistic += part(pair[0], pair[1]);
                degreesOfFreedom++;
            }
        }
        if (forth + back >= FEWEST) {
            statistic += part(forth, back);
            degreesOfFreedom++;
        }
        return degreesOfFreedom == 0 ? 1 : Significance.chiSquare(statistic, degreesOfFreedom);
    }

    private static double part(long a, long b) {
        double difference = (double) a - b;
        return difference * difference / (a + b);
    }
}
