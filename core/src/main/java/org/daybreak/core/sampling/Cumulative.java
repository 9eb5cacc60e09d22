package org.daybreak.core.sampling;

/**
 * Cumulative distributions of equal length n in one array: each is a segment of n + 1 entries, from 0 to 1.
 *
 * <p>A guide table holds the answers at equal steps of u (Chen and Asau, “On Generating Random Variates from an
 * Empirical Distribution”, AIIE Trans. 6, 1974), so that a search looks at few entries, next to each other.
 */
final class Cumulative {
    /** One entry of the guide for this many weights: a search then ends within one or two cache lines. */
    private static final int WEIGHTS_PER_GUIDE = 4;

    private final int n;
    private final double[] segments;
    /** Steps of the guide: a power of two, so that products and quotients by it are exact. */
    private final int steps;

    private final int[] guide;

    /**
     * Creates segments for weights to be {@linkplain #setWeight set}.
     *
     * @param n weights per segment, positive
     * @param segmentCount number of segments
     */
    Cumulative(int n, int segmentCount) {
        this.n = n;
        segments = new double[(n + 1) * segmentCount];
        steps = Integer.highestOneBit(Math.max(1, n / WEIGHTS_PER_GUIDE));
        guide = new int[steps * segmentCount];
    }

    /** Weights per segment. */
    int size() {
        return n;
    }

    /** Stores a weight, until its segment is {@linkplain #accumulate accumulated}. */
    void setWeight(int segment, int index, double weight) {
        segments[segment * (n + 1) + 1 + index] = weight;
    }

    /**
     * Turns the weights of a segment into their cumulative distribution, uniform if all are 0.
     *
     * @return the sum of the weights
     * @throws IllegalArgumentException if a weight is negative or not finite, or their sum overflows
     */
    double accumulate(int segment) {
        int offset = segment * (n + 1);
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double weight = segments[offset + 1 + i];
            if (!(weight >= 0) || weight == Double.POSITIVE_INFINITY) {
                throw new IllegalArgumentException("weight " + i + " of a distribution is " + weight);
            }
            sum += weight;
            segments[offset + 1 + i] = sum;
        }
        if (sum == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException("the sum of the weights of a distribution overflows");
        }
        for (int i = 1; i <= n; i++) {
            segments[offset + i] = sum > 0 ? segments[offset + i] / sum : (double) i / n;
        }
        int answer = 0;
        for (int step = 0; step < steps; step++) {
            answer = search(offset, answer, n, (double) step / steps);
            guide[segment * steps + step] = answer;
        }
        return sum;
    }

    /** The index i in 0 … n − 1 whose share [c(i), c(i + 1)) of a segment holds u; it is not empty. */
    int find(int segment, double u) {
        int step = (int) (u * steps);
        int entry = segment * steps + step;
        int high = step + 1 < steps ? guide[entry + 1] + 1 : n;
        return search(segment * (n + 1), guide[entry], high, u);
    }

    /** The share of an index. */
    double probability(int segment, int index) {
        int entry = segment * (n + 1) + index;
        return segments[entry + 1] - segments[entry];
    }

    /** The position of u in the share of an index, in [0, 1). */
    double remainder(int segment, int index, double u) {
        int entry = segment * (n + 1) + index;
        double share = segments[entry + 1] - segments[entry];
        return Math.min((u - segments[entry]) / share, Math.nextDown(1.0));
    }

    private int search(int offset, int from, int to, double u) {
        int low = from;
        int high = to;
        // c(low) ≤ u < c(high) throughout, so the result is the last of the entries that are equal to c(low).
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (segments[offset + middle] <= u) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
