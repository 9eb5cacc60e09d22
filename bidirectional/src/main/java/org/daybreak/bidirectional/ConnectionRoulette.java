package org.daybreak.bidirectional;

import org.daybreak.core.sampling.Mixing;

/**
 * Efficiency-optimised Russian roulette for occlusion tests (Veach 1997, §10.4.1; thesis §4.4, eq. 4.7–4.10): a contribution t
 * is tested with probability q = min(1, t/δ) and divided by q, where δ = σ/√n, with σ² the variance of a sample and n its cost in
 * occlusion tests. Veach counts rays alone, which once were nearly all the cost: where vertices cost more than tests, that leaves out
 * tests that are worth their price. One object per worker.
 *
 * <p>σ and n are running averages over the samples of a work unit, so they depend on nothing but the unit. δ is set before a
 * sample and kept for all of it, and is 0 for the first ones: there is no bias. σ comes from the differences of
 * successive samples, which mostly are in one pixel, so that it is not the contrast of the image. Their mean is taken instead of
 * their mean square, and each counts as a small multiple of the mean so far at most: rare bright samples would else end all tests in
 * a neighbourhood, which shows as dark streaks.
 */
final class ConnectionRoulette {
    private static final int WARM_UP = 8;

    /** Weight of a new sample in the averages once there are many. */
    private static final double LEAST_SHARE = 1.0 / 256;

    /** So many times the average so far is the most that a sample counts. */
    private static final double MOST = 4;

    /** For a normal distribution σ is this many times the mean absolute difference of two samples. */
    private static final double DEVIATION = 0.5 * Math.sqrt(Math.PI);

    private final boolean on;
    private double difference;
    private double mean;
    private double averageCost;
    private double last;
    private int samples;
    private double threshold;
    private long state;

    ConnectionRoulette(boolean on) {
        this.on = on;
    }

    /** Forgets all samples: a work unit begins. */
    void beginUnit() {
        samples = 0;
        difference = 0;
        mean = 0;
        averageCost = 0;
        threshold = 0;
    }

    /**
     * A sample begins.
     *
     * @param u uniform number in [0,1) from which all decisions of the sample follow
     */
    void beginSample(double u) {
        state = Double.doubleToRawLongBits(u);
        threshold = on && samples >= WARM_UP && averageCost > 0 ? DEVIATION * difference / Math.sqrt(averageCost) : 0;
    }

    /**
     * Decides about a contribution.
     *
     * @param contribution its luminance, unoccluded, in units of the image
     * @return the factor 1/q on it if it shall be tested, 0 if not
     */
    double survive(double contribution) {
        // What is not a number must reach whoever counts such samples.
        if (!(contribution < threshold)) {
            return 1;
        }
        state += Mixing.GOLDEN_GAMMA;
        double u = (Mixing.mix64(state) >>> 11) * 0x1.0p-53;
        return u * threshold < contribution ? threshold / contribution : 0;
    }

    /**
     * A sample has ended.
     *
     * @param luminance sum of its contributions
     * @param cost its cost, in occlusion tests
     */
    void endSample(double luminance, long cost) {
        if (!(luminance < Double.POSITIVE_INFINITY)) {
            return;
        }
        if (samples > 0) {
            double share = Math.max(1.0 / samples, LEAST_SHARE);
            double step = Math.abs(luminance - last);
            // Growth from nothing is by the mean luminance, bounded likewise.
            mean += share
                    * (Math.min(luminance, MOST * mean + (samples < WARM_UP || mean == 0 ? luminance : 0)) - mean);
            difference += share * (Math.min(step, MOST * difference + mean) - difference);
            averageCost += share * (cost - averageCost);
        }
        last = luminance;
        samples++;
    }
}
