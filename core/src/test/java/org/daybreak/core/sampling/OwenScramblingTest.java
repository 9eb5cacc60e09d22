package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;

class OwenScramblingTest {
    /** False-alarm rate of each statistical assertion. */
    private static final double SIGNIFICANCE = 1e-4;

    @Test
    void givesThePinnedNumbers() {
        // From an independent implementation of the definition.
        assertEquals(0x1679D7F6, OwenScrambling.scramble(0x00000000, 0x12345678));
        assertEquals(0x87E32B06, OwenScrambling.scramble(0x80000000, 0x12345678));
        assertEquals(0xFB54716E, OwenScrambling.scramble(0xDEADBEEF, 0xCAFEBABE));
    }

    @Test
    void eachBitDependsOnItselfAndTheBitsAboveOnly() {
        for (int i = 0; i < 2000; i++) {
            int bits = (int) Mixing.mix64(i + 1);
            int seed = (int) Mixing.mix64(-i - 1);
            int b = i % 32;
            int change = OwenScrambling.scramble(bits, seed) ^ OwenScrambling.scramble(bits ^ (1 << b), seed);
            // Nothing above bit b changes, and bit b does, so the map is a bijection.
            assertEquals(1, change >>> b);
        }
    }

    @Test
    void scrambledPointsAreNets() {
        for (int seed = 0; seed < 20; seed++) {
            int[][] points = scrambled(8, seed);
            Nets.assertNet(8, 0, 1, points[0], points[1]);
            Nets.assertNet(8, 3, 1, points);
            Nets.assertNet(5, 0, 8, points[0], points[1]);
        }
    }

    /**
     * The flips at the nodes of the binary tree are fair coins, independent between any two nodes of a depth. This is
     * what makes the scrambling Owen's, and it is what the published constants of Laine and Karras lack.
     */
    @Test
    void flipsAreFairAndPairwiseIndependentOverSeeds() {
        int seeds = 50_000;
        List<Double> pValues = new ArrayList<>();
        for (int depth = 0; depth <= 5; depth++) {
            int nodes = 1 << depth;
            int[] flips = new int[nodes];
            int[] unequal = new int[nodes * nodes];
            for (int s = 0; s < seeds; s++) {
                int seed = (int) Mixing.mix64(s * Mixing.GOLDEN_GAMMA);
                long flipped = 0;
                for (int node = 0; node < nodes; node++) {
                    int bits = depth == 0 ? 0 : node << (32 - depth);
                    flipped |= (long) (OwenScrambling.scramble(bits, seed) >>> (31 - depth) & 1) << node;
                }
                for (int i = 0; i < nodes; i++) {
                    flips[i] += (int) (flipped >>> i & 1);
                    for (int j = 0; j < i; j++) {
                        unequal[i * nodes + j] += (int) ((flipped >>> i ^ flipped >>> j) & 1);
                    }
                }
            }
            for (int i = 0; i < nodes; i++) {
                pValues.add(ZTest.known(flips[i], Math.sqrt(seeds / 4.0), seeds / 2.0));
                for (int j = 0; j < i; j++) {
                    pValues.add(ZTest.known(unequal[i * nodes + j], Math.sqrt(seeds / 4.0), seeds / 2.0));
                }
            }
        }
        double[] all = pValues.stream().mapToDouble(Double::doubleValue).toArray();
        ZTest.assertNoneRejected("flips of nodes and of pairs of nodes", all, SIGNIFICANCE);
    }

    @Test
    void meanOverSeedsIsUnbiasedAndItsVarianceIsThatOfStratification() {
        // ∫ x = 1/2 from 16 points: for each seed one point per stratum, uniform in it, so the variance is 1/(12 n³).
        int n = 16;
        Moments means = new Moments();
        Moments squares = new Moments();
        for (int s = 0; s < 100_000; s++) {
            int seed = (int) Mixing.mix64(s * Mixing.GOLDEN_GAMMA + 99);
            double mean = 0;
            for (int i = 0; i < n; i++) {
                mean += (OwenScrambling.scramble(Sobol.sobol(i, 0), seed) & 0xFFFFFFFFL) * 0x1p-32 / n;
            }
            means.add(mean);
            squares.add((mean - 0.5) * (mean - 0.5));
        }
        ZTest.assertNotRejected("mean", ZTest.oneSample(means, 0.5), SIGNIFICANCE);
        ZTest.assertNotRejected("variance", ZTest.oneSample(squares, 1.0 / (12.0 * n * n * n)), SIGNIFICANCE);
    }

    private static int[][] scrambled(int m, int seed) {
        int[][] points = new int[4][1 << m];
        for (int d = 0; d < 4; d++) {
            int dimensionSeed = (int) Mixing.mix64(4L * seed + d + 1);
            for (int i = 0; i < points[d].length; i++) {
                points[d][i] = OwenScrambling.scramble(Sobol.sobol(i, d), dimensionSeed);
            }
        }
        return points;
    }
}
