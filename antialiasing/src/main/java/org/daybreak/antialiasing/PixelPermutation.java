package org.daybreak.antialiasing;

import org.daybreak.core.sampling.Mixing;

/**
 * Random orders of numbers, without memory: {@link #permute} gives the number at any place of an order at once. With the pixels
 * of a film numbered row by row it visits each of them once per round, in an order that differs from round to round, however
 * large the film and whoever asks.
 *
 * <p>It is a swap-or-not shuffle (Hoang, Morris and Rogaway, “An Enciphering Scheme Based on a Card Shuffle”, CRYPTO 2012): in each
 * round the numbers are paired, x with K − x modulo n for a random K, and a random bit of each pair tells whether the two change
 * places. By their theorem 2, what few places can tell from a uniformly drawn order halves with every other round.
 */
public final class PixelPermutation {
    private static final int ROUNDS = 32;

    private PixelPermutation() {}

    /**
     * The number at a place of a random order of 0 … n − 1.
     *
     * @param index place in the order, from 0 to n − 1
     * @param n how many numbers there are, from 1 to 2⁶²
     * @param key selects the order
     * @return from 0 to n − 1; different for different places
     */
    public static long permute(long index, long n, long key) {
        long hashed = Mixing.mix64(key + Mixing.GOLDEN_GAMMA);
        long x = index;
        for (int round = 0; round < ROUNDS; round++) {
            long word = Mixing.absorb(hashed, round);
            long partner = Math.multiplyHigh(word >>> 1, n << 1) - x;
            partner += partner < 0 ? n : 0;
            if ((Mixing.absorb(word, Math.max(x, partner)) & 1) != 0) {
                x = partner;
            }
        }
        return x;
    }
}
