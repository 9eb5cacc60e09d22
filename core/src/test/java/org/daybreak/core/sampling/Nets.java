package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;

/** Checks that point sets are (t, m, s)-nets in base 2. */
final class Nets {
    private Nets() {}

    /**
     * Fails if an elementary interval of volume 2^(t − m) does not hold 2^t of the points.
     *
     * @param m 2^m points are looked at
     * @param t quality of the net
     * @param blocks how many successive blocks of 2^m points to check
     * @param coordinates for each dimension, the points' coordinates as fractions of 2³²
     */
    static void assertNet(int m, int t, int blocks, int[]... coordinates) {
        for (int block = 0; block < blocks; block++) {
            checkShapes(m, t, block << m, new int[coordinates.length], 0, m - t, coordinates);
        }
    }

    /** Tries every way to share the remaining bits among the dimensions from {@code dimension} on. */
    private static void checkShapes(
            int m, int t, int first, int[] bits, int dimension, int remaining, int[][] coordinates) {
        if (remaining < 0) {
            return;
        }
        if (dimension == bits.length - 1) {
            bits[dimension] = remaining;
            checkShape(m, t, first, bits, coordinates);
            return;
        }
        for (int b = 0; b <= remaining; b++) {
            bits[dimension] = b;
            checkShapes(m, t, first, bits, dimension + 1, remaining - b, coordinates);
        }
    }

    private static void checkShape(int m, int t, int first, int[] bits, int[][] coordinates) {
        int[] counts = new int[1 << (m - t)];
        for (int i = first; i < first + (1 << m); i++) {
            int cell = 0;
            for (int d = 0; d < bits.length; d++) {
                // A shift by 32 would shift by nothing.
                int prefix = bits[d] == 0 ? 0 : coordinates[d][i] >>> (32 - bits[d]);
                cell = cell << bits[d] | prefix;
            }
            counts[cell]++;
        }
        for (int cell = 0; cell < counts.length; cell++) {
            assertEquals(1 << t, counts[cell], "points in interval " + cell + " of " + Arrays.toString(bits));
        }
    }
}
