package org.daybreak.core.sampling;

/** Hash functions on 64-bit words. */
public final class Mixing {
    /** The odd integer next to 2⁶⁴ divided by the golden ratio: the increment of SplitMix64. */
    public static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;

    private Mixing() {}

    /**
     * The finaliser of SplitMix64, a bijection that changes each output bit with probability near ½ when an input bit
     * changes. 0 maps to 0.
     *
     * <p>Variant 13 of Stafford's improvements of MurmurHash3; Steele, Lea and Flood, “Fast Splittable Pseudorandom
     * Number Generators”, OOPSLA 2014.
     */
    public static long mix64(long z) {
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    /**
     * Takes one more word into a hash. For a fixed hash it is a bijection of the word, and for a fixed word of the
     * hash. The order of the words matters.
     */
    public static long absorb(long hash, long word) {
        return mix64((hash ^ word) + GOLDEN_GAMMA);
    }

    /** Hash of an address within a domain. */
    public static long hash(long seed, StreamDomain domain, long index, long subIndex) {
        return absorb(absorb(absorb(mix64(seed + GOLDEN_GAMMA), domain.id()), index), subIndex);
    }
}
