package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;

class DiscreteDistributionTest {
    /** False-alarm rate of each statistical assertion. */
    private static final double SIGNIFICANCE = 1e-4;

    @Test
    void indicesAndRemaindersFollowTheWeights() {
        double[] weights = {0, 1, 3, 0, 0, 0.5, 2, 0};
        DiscreteDistribution distribution = new DiscreteDistribution(weights);
        assertEquals(8, distribution.size());
        assertEquals(6.5, distribution.total());
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        int n = 100_000;
        long[] counts = new long[8 * 10];
        for (int i = 0; i < n; i++) {
            double u = random.nextDouble();
            int index = distribution.sample(u);
            double remainder = distribution.remainder(u, index);
            assertTrue(remainder >= 0 && remainder < 1);
            counts[10 * index + (int) (10 * remainder)]++;
        }
        double[] expected = new double[80];
        for (int i = 0; i < 80; i++) {
            assertEquals(weights[i / 10] / 6.5, distribution.probability(i / 10), 1e-15);
            expected[i] = n * distribution.probability(i / 10) / 10;
        }
        double p = ChiSquareTest.compare("indices", counts, expected).pValue();
        ZTest.assertNotRejected("indices and remainders", p, SIGNIFICANCE);
    }

    @Test
    void endsNeverChooseAnIndexOfProbabilityZero() {
        DiscreteDistribution distribution = new DiscreteDistribution(new double[] {0, 0, 0.1, 0.7, 0.2, 0, 0});
        assertEquals(2, distribution.sample(0));
        assertEquals(4, distribution.sample(Math.nextDown(1.0)));
        assertTrue(distribution.remainder(Math.nextDown(1.0), 4) < 1);
        DiscreteDistribution single = new DiscreteDistribution(new double[] {5});
        assertEquals(0, single.sample(0.3));
        assertEquals(0.3, single.remainder(0.3, 0));
        assertEquals(1, single.probability(0));
    }

    @Test
    void inversionIsMonotonous() {
        DiscreteDistribution distribution = new DiscreteDistribution(new double[] {3, 0, 1, 4, 1, 5, 9, 2, 6});
        int previous = 0;
        for (int i = 0; i < 1000; i++) {
            int index = distribution.sample(i / 1000.0);
            assertTrue(index >= previous);
            previous = index;
        }
        assertEquals(8, previous);
    }

    @Test
    void searchFindsTheShareForEveryLengthAndAtEveryBorder() {
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        for (int n = 1; n < 300; n += 1 + n / 20) {
            double[] weights = new double[n];
            for (int i = 0; i < n; i++) {
                // Many zeros, and weights of very different size.
                weights[i] = random.nextDouble() < 0.4 ? 0 : Math.pow(random.nextDouble(), 20);
            }
            weights[n / 2] += 1e-3;
            DiscreteDistribution distribution = new DiscreteDistribution(weights);
            double sum = 0;
            for (int i = 0; i < n; i++) {
                double probability = distribution.probability(i);
                if (probability > 0) {
                    double next = sum + weights[i];
                    assertEquals(i, distribution.sample(sum / distribution.total()));
                    assertEquals(i, distribution.sample(Math.nextDown(next / distribution.total())));
                }
                sum += weights[i];
            }
            for (int k = 0; k < 64; k++) {
                assertTrue(distribution.probability(distribution.sample(k / 64.0)) > 0);
            }
        }
    }

    @Test
    void zeroWeightsAreUniform() {
        DiscreteDistribution distribution = new DiscreteDistribution(new double[4]);
        assertEquals(0, distribution.total());
        for (int i = 0; i < 4; i++) {
            assertEquals(0.25, distribution.probability(i));
            assertEquals(i, distribution.sample(0.25 * i));
        }
    }

    @Test
    void badWeightsAreRefused() {
        for (double bad : new double[] {-1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> new DiscreteDistribution(new double[] {1, bad}));
        }
        assertThrows(IllegalArgumentException.class, () -> new DiscreteDistribution(new double[] {1e308, 1e308}));
        assertThrows(IllegalArgumentException.class, () -> new DiscreteDistribution(new double[0]));
    }
}
