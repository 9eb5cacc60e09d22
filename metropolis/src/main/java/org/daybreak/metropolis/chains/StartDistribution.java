package org.daybreak.metropolis.chains;

import java.util.Arrays;

/**
 * What the candidates for the starts of chains have shown: the brightness b, and where chains may start.
 *
 * <p>Chains start at states drawn in proportion to their weights, by systematic resampling: one random number u places the points
 * (k + u)·W/C, k = 0 … C − 1, on the states lined up with their weights, whose sum is W. A state of weight w is then
 * expected to be drawn C·w/W times. With b̂ = W/n from the same n candidates, E[b̂/C·Σ h(start)] = E[Σ w·h]/n = ∫ f*·h: the estimate
 * is unbiased, not only consistent, whatever the chains do afterwards (Veach 1997, §11.3.1).
 */
final class StartDistribution {
    private final double[] weights;
    private final double total;
    private final double standardError;
    private final long withoutLight;

    /**
     * Creates a distribution.
     *
     * @param weights sum of the weights of the states of each candidate, finite and not negative
     */
    StartDistribution(double[] weights) {
        this.weights = weights;
        double sum = 0;
        long dark = 0;
        for (double weight : weights) {
            sum += weight;
            dark += weight > 0 ? 0 : 1;
        }
        total = sum;
        withoutLight = dark;
        double mean = mean();
        double squares = 0;
        for (double weight : weights) {
            squares += (weight - mean) * (weight - mean);
        }
        long n = weights.length;
        standardError = n < 2 ? Double.NaN : Math.sqrt(squares / n / (n - 1));
    }

    /** Number of candidates. */
    int candidates() {
        return weights.length;
    }

    /** Number of candidates that offer no state. */
    long withoutLight() {
        return withoutLight;
    }

    /** The estimate of b; 0 without candidates. */
    double mean() {
        return weights.length == 0 ? 0 : total / weights.length;
    }

    /** Standard error of b; NaN if there are fewer than two candidates. */
    double standardError() {
        return standardError;
    }

    /** Sum of the weights of the states of a candidate. */
    double weight(long candidate) {
        return weights[(int) candidate];
    }

    /**
     * Draws the starts of chains.
     *
     * @param u uniform in [0, 1)
     * @param first number of the first chain to draw for
     * @param end number after the last one
     * @param chains number of all chains
     */
    Starts draw(double u, int first, int end, int chains) {
        Starts starts = new Starts(new long[end - first], new double[end - first]);
        int candidate = 0;
        double before = 0;
        int last = lastWithLight();
        for (int chain = 0; chain < end; chain++) {
            double point = (chain + u) / chains * total;
            while (candidate < last && (weights[candidate] == 0 || before + weights[candidate] <= point)) {
                before += weights[candidate];
                candidate++;
            }
            if (chain >= first) {
                starts.candidates[chain - first] = candidate;
                starts.offsets[chain - first] = Math.min(Math.max(0, point - before), weights[candidate]);
            }
        }
        return starts;
    }

    /** Rounding may let the last point lie beyond the sum of the weights. */
    private int lastWithLight() {
        int last = weights.length - 1;
        while (last > 0 && weights[last] == 0) {
            last--;
        }
        return last;
    }

    /**
     * Where chains start.
     *
     * @param candidates indices of candidates
     * @param offsets which of the candidate's states: that in whose share of the summed weights this lies
     */
    record Starts(long[] candidates, double[] offsets) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Starts starts
                    && Arrays.equals(candidates, starts.candidates)
                    && Arrays.equals(offsets, starts.offsets);
        }

        @Override
        public int hashCode() {
            return 31 * Arrays.hashCode(candidates) + Arrays.hashCode(offsets);
        }

        @Override
        public String toString() {
            return Arrays.toString(candidates) + " at " + Arrays.toString(offsets);
        }
    }
}
