package org.daybreak.core.sampling;

/** Cumulative distributions in segments of an array: a segment of n weights has n + 1 entries, from 0 to 1. */
final class Cumulative {
    private Cumulative() {}

    /**
     * Turns the weights at offset + 1 … offset + n into their cumulative distribution, uniform if all are 0.
     *
     * @return the sum of the weights
     * @throws IllegalArgumentException if a weight is negative or not finite, or their sum overflows
     */
    static double accumulate(double[] segments, int offset, int n) {
        double sum = 0;
        for (int i = 1; i <= n; i++) {
            double weight = segments[offset + i];
            if (!(weight >= 0) || weight == Double.POSITIVE_INFINITY) {
                throw new IllegalArgumentException("weight " + (i - 1) + " of a distribution is " + weight);
            }
            sum += weight;
            segments[offset + i] = sum;
        }
        if (sum == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException("the sum of the weights of a distribution overflows");
        }
        segments[offset] = 0;
        for (int i = 1; i <= n; i++) {
            segments[offset + i] = sum > 0 ? segments[offset + i] / sum : (double) i / n;
        }
        return sum;
    }

    /** The index i in 0 … n − 1 whose share [c(i), c(i + 1)) holds u; it is not empty. */
    static int find(double[] segments, int offset, int n, double u) {
        int low = 0;
        int high = n;
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

    /** The position of u in the share that starts at an entry of the array, in [0, 1). */
    static double remainder(double[] segments, int entry, double u) {
        double share = segments[entry + 1] - segments[entry];
        return Math.min((u - segments[entry]) / share, Math.nextDown(1.0));
    }
}
