package org.daybreak.antialiasing;

import org.daybreak.core.sampling.Mixing;

/**
 * Random orders of numbers, without memory: {@link #permute} gives the number at any place of an order at once. With the pixels
 * of a film numbered row by row it visits each of them once per round, in an order that differs from round to round, however
 * large the film and whoever asks.
 *
 * <p>A Feistel network on the words of the smallest number of bits that hold all numbers — the halves of the word are changed in
 * turn by a hash of the other one (Luby and Rackoff, SIAM J. Computing 17(2), 1988) — iterated until it leads to one of the
 * numbers (cycle walking: Black and Rogaway, “Ciphers with Arbitrary Finite Domains”, CT-RSA 2002, section 3), which takes less
 * than two iterations on average.
 */
public final class PixelPermutation {
    private static final int ROUNDS = 4;

    private PixelPermutation() {}

    /**
     * The number at a place of a random order of 0 … n − 1.
     *
     * @param index place in the order, from 0 to n − 1
     * @param n how many numbers there are, at least 1
     * @param key selects the order
     * @return from 0 to n − 1; different for different places
     */
    public static long permute(long index, long n, long key) {
        if (n == 1) {
            return 0;
        }
        long hashed = Mixing.mix64(key + Mixing.GOLDEN_GAMMA);
        int bits = Long.SIZE - Long.numberOfLeadingZeros(n - 1);
        int lowBits = (bits + 1) >>> 1;
        long lowMask = (1L << lowBits) - 1;
        long highMask = (1L << (bits - lowBits)) - 1;
        long x = index;
        do {
            long low = x & lowMask;
            long high = x >>> lowBits;
            for (int round = 0; round < ROUNDS; round++) {
                low ^= Mixing.absorb(hashed + 2L * round, high) & lowMask;
                high ^= Mixing.absorb(hashed + 2L * round + 1, low) & highMask;
            }
            x = high << lowBits | low;
        } while (x >= n);
        return x;
    }
}
