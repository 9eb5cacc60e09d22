package org.daybreak.core.sampling;

/**
 * Distribution over the indices 0 … n − 1 in proportion to given weights. Immutable.
 *
 * <p>Sampled by inversion of the cumulative distribution, which keeps the stratification of the number put in; what is
 * left of that number can be used again.
 */
public final class DiscreteDistribution {
    private final double[] cumulative;
    private final double total;

    /**
     * Creates the distribution. If all weights are 0, it is uniform.
     *
     * @throws IllegalArgumentException if there is no weight, a weight is negative or not finite, or their sum
     *     overflows
     */
    public DiscreteDistribution(double[] weights) {
        if (weights.length == 0) {
            throw new IllegalArgumentException("a distribution needs at least one weight");
        }
        cumulative = new double[weights.length + 1];
        for (int i = 0; i < weights.length; i++) {
            cumulative[i + 1] = weights[i];
        }
        total = Cumulative.accumulate(cumulative, 0, weights.length);
    }

    /** How many indices there are. */
    public int size() {
        return cumulative.length - 1;
    }

    /** The sum of the weights. */
    public double total() {
        return total;
    }

    /** The index of a number in [0, 1). Its probability is positive. */
    public int sample(double u) {
        return Cumulative.find(cumulative, 0, size(), u);
    }

    /** The probability with which {@link #sample} returns an index. */
    public double probability(int index) {
        return cumulative[index + 1] - cumulative[index];
    }

    /** The position of u within the share of the index that {@link #sample} chose for it: uniform in [0, 1) again. */
    public double remainder(double u, int index) {
        return Cumulative.remainder(cumulative, index, u);
    }
}
