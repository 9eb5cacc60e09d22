package org.daybreak.core.sampling;

/**
 * Distribution over the indices 0 … n − 1 in proportion to given weights. Immutable.
 *
 * <p>Sampled by inversion of the cumulative distribution, which keeps the stratification of the number put in; what is
 * left of that number can be used again.
 */
public final class DiscreteDistribution {
    private final Cumulative cumulative;
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
        cumulative = new Cumulative(weights.length, 1);
        for (int i = 0; i < weights.length; i++) {
            cumulative.setWeight(0, i, weights[i]);
        }
        total = cumulative.accumulate(0);
    }

    /** How many indices there are. */
    public int size() {
        return cumulative.size();
    }

    /** The sum of the weights. */
    public double total() {
        return total;
    }

    /** The index of a number in [0, 1). Its probability is positive. */
    public int sample(double u) {
        return cumulative.find(0, u);
    }

    /** The probability with which {@link #sample} returns an index. */
    public double probability(int index) {
        return cumulative.probability(0, index);
    }

    /** The position of u within the share of the index that {@link #sample} chose for it: uniform in [0, 1) again. */
    public double remainder(double u, int index) {
        return cumulative.remainder(0, index, u);
    }
}
