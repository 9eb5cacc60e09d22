package org.daybreak.antialiasing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.BitSet;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Each statistical test rejects a right permutation with a probability of 1e-4, for the fixed keys once and for all. */
class PixelPermutationTest {
    private static final double LEVEL = 1e-4;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 7, 8, 9, 63, 64, 65, 1000, 65_536, 100_003})
    void visitsEachNumberOnce(long n) {
        for (long key = -3; key < 3; key++) {
            BitSet seen = new BitSet();
            for (long i = 0; i < n; i++) {
                int number = (int) PixelPermutation.permute(i, n, key);
                assertTrue(number >= 0 && number < n);
                assertFalse(seen.get(number), "number " + number + " of " + n + " comes twice");
                seen.set(number);
            }
        }
    }

    @Test
    void numbersBeyondIntsArePossible() {
        long n = 1L << 33;
        for (long i = n - 100; i < n; i++) {
            long number = PixelPermutation.permute(i, n, 5);
            assertTrue(number >= 0 && number < n);
        }
    }

    /** Over keys, any two places hold any two numbers alike. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6, 7, 8, 12})
    void pairsAreUniform(int n) {
        int keys = 400 * n * n;
        long[] counts = new long[n * n];
        double[] expected = new double[n * n];
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < n; b++) {
                expected[a * n + b] = a == b ? 0 : (double) keys / (n * (n - 1));
            }
        }
        for (int first = 0; first < n; first++) {
            int second = (first + 1 + first % (n - 1)) % n;
            Arrays.fill(counts, 0);
            for (int key = 0; key < keys; key++) {
                int a = (int) PixelPermutation.permute(first, n, key);
                int b = (int) PixelPermutation.permute(second, n, key);
                counts[a * n + b]++;
            }
            String what = "places " + first + " and " + second + " of " + n;
            ZTest.assertNotRejected(what, pValue(what, counts, expected), LEVEL / 60);
        }
    }

    /** The start of an order already spreads over the film: pixels are not visited row by row, nor one after its neighbour. */
    @Test
    void startOfAnOrderIsSpread() {
        int n = 300 * 200;
        int cells = 60;
        long[] counts = new long[cells];
        double[] expected = new double[cells];
        Arrays.fill(expected, 50);
        long[] steps = new long[cells];
        long previous = 0;
        for (int i = 0; i < 50 * cells; i++) {
            long number = PixelPermutation.permute(i, n, 77);
            counts[(int) (number * cells / n)]++;
            steps[(int) (Math.floorMod(number - previous, (long) n) * cells / n)]++;
            previous = number;
        }
        // Drawn without replacement, so a little more even than χ² has it: the test may only be too lenient.
        ZTest.assertNotRejected("parts of the film", pValue("parts of the film", counts, expected), LEVEL);
        ZTest.assertNotRejected("distances", pValue("distances", steps, expected), LEVEL);
    }

    private static double pValue(String what, long[] observed, double[] expected) {
        return ChiSquareTest.compare(what, observed, expected).pValue();
    }

    @Test
    void keysSelectOrders() {
        int same = 0;
        for (int i = 0; i < 1000; i++) {
            same += PixelPermutation.permute(i, 1000, 1) == PixelPermutation.permute(i, 1000, 2) ? 1 : 0;
        }
        assertTrue(same < 8, "numbers at the same place in both orders: " + same);
        assertEquals(PixelPermutation.permute(3, 1000, 1), PixelPermutation.permute(3, 1000, 1));
    }
}
