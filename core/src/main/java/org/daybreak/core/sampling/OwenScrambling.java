package org.daybreak.core.sampling;

/**
 * Nested uniform scrambling (Owen 1995) by hashing: each bit of a number is flipped, or not, by a hash of the seed and
 * all bits above it. A scrambled (t, m, s)-net is a (t, m, s)-net again, and each of its points is uniform over seeds.
 *
 * <p>Burley, “Practical Hash-based Owen Scrambling”, JCGT 9(4), 2020.
 */
public final class OwenScrambling {
    private OwenScrambling() {}

    /**
     * Scrambles a binary fraction.
     *
     * @param bits an unsigned fraction of 2³²
     * @param seed well-mixed random bits; seeds that differ little give scramblings that differ little
     */
    public static int scramble(int bits, int seed) {
        return Integer.reverse(permuteReversed(Integer.reverse(bits), seed));
    }

    /**
     * The scrambling on numbers whose bits are in reversed order: a permutation in which each bit depends on the bits
     * below it. Laine and Karras, “Stratified Sampling for Stochastic Transparency” (2011), with the constants of
     * Vegdahl (2021), who searched for those that come nearest to independent flips.
     */
    static int permuteReversed(int reversedBits, int seed) {
        int x = reversedBits;
        x ^= x * 0x3D20ADEA;
        x += seed;
        x *= (seed >>> 16) | 1;
        x ^= x * 0x05526C56;
        x ^= x * 0x53A22864;
        return x;
    }
}
