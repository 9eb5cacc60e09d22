package org.daybreak.antialiasing;

import org.daybreak.core.sampling.Mixing;

/** Strata of the unit interval and random orders of them. */
final class Strata {
    private static final int ROUNDS = 6;

    private Strata() {}

    /** The number in [0, 1) at a position, in [0, 1), within a stratum out of {@code count}. */
    static double within(long stratum, long count, double position) {
        // Rounding may yield 1 in the last stratum.
        return Math.min((stratum + position) / count, Math.nextDown(1.0));
    }

    /**
     * A random permutation of 0 … count − 1, computed for one index: a Feistel network over the smallest even number of bits
     * that holds them, applied again until the result lies in range ("cycle walking": Black and Rogaway, "Ciphers with
     * Arbitrary Finite Domains", 2002), and then a random rotation.
     *
     * <p>On small domains a Feistel network is far from a uniform choice among all permutations. The rotation makes the image
     * of each single index uniform, which is what keeps estimates unbiased that pair strata of different dimensions.
     *
     * @param index 0 … count − 1
     * @param count at most 2³⁰
     * @param key selects the permutation
     */
    static int permute(int index, int count, long key) {
        if (count == 1) {
            return 0;
        }
        int half = (32 - Integer.numberOfLeadingZeros(count - 1) + 1) / 2;
        int mask = (1 << half) - 1;
        int value = index;
        do {
            int left = value >>> half;
            int right = value & mask;
            for (int round = 0; round < ROUNDS; round++) {
                int mixed = left ^ ((int) hash(key, round, right) & mask);
                left = right;
                right = mixed;
            }
            value = left << half | right;
        } while (value >= count);
        int rotation = (int) (((hash(key, ROUNDS, 0) >>> 33) * count) >>> 31);
        return value < count - rotation ? value + rotation : value - (count - rotation);
    }

    private static long hash(long key, int round, int half) {
        return Mixing.mix64(key + (((long) round << 32) | half) * Mixing.GOLDEN_GAMMA);
    }
}
