package org.daybreak.core.sampling;

/**
 * Random numbers at an address: (seed, domain, index, sub-index) selects a stream, the position selects a number of it.
 *
 * <p>Number n of a stream is {@code mix64(origin + (n + 1) · gamma)}, which is SplitMix64 with an increment of its own
 * per stream (Steele, Lea and Flood, OOPSLA 2014). Origin and gamma are two independent hashes of the address, so two
 * streams are equal, or overlap, only with the probability of a collision of about 127 random bits. Any position is
 * reached at once.
 *
 * <p>Mutable, not safe for threads: each worker has its own and seats it at the address of its work.
 */
public final class RandomStream {
    private long origin;
    private long gamma;
    private long state;
    private long position;

    /** Creates the stream at seed 0, domain {@link StreamDomain#PIXEL}, index 0, sub-index 0. */
    public RandomStream() {
        this(0, StreamDomain.PIXEL, 0, 0);
    }

    /** Creates the stream at an address, positioned at its first number. */
    public RandomStream(long seed, StreamDomain domain, long index, long subIndex) {
        seat(seed, domain, index, subIndex);
    }

    /** Moves to the first number of the stream at an address. */
    public void seat(long seed, StreamDomain domain, long index, long subIndex) {
        seat(Mixing.hash(seed, domain, index, subIndex), Mixing.hash(~seed, domain, index, subIndex));
    }

    /** Moves to the first number of the SplitMix64 sequence of this state and increment. */
    void seat(long splitMixState, long gammaSource) {
        origin = splitMixState;
        gamma = usableGamma(gammaSource);
        state = origin;
        position = 0;
    }

    /** How many numbers of this stream lie before the next one. */
    public long position() {
        return position;
    }

    /**
     * Makes number {@code position} the next one; 0 is the first. Each {@code next} call takes one number, but for the
     * rejections of {@link #nextInt}, each of probability below 2⁻³².
     */
    public void skipTo(long position) {
        this.position = position;
        state = origin + position * gamma;
    }

    /** The next 64 random bits. */
    public long nextLong() {
        position++;
        state += gamma;
        return Mixing.mix64(state);
    }

    /** The next number, a multiple of 2⁻⁵³ uniform in [0, 1). */
    public double nextDouble() {
        return (nextLong() >>> 11) * 0x1.0p-53;
    }

    /**
     * The next integer, uniform in 0 … bound − 1 without bias (Lemire, “Fast Random Integer Generation in an
     * Interval”, ACM TOMACS 29(1), 2019).
     *
     * @throws IllegalArgumentException if the bound is not positive
     */
    public int nextInt(int bound) {
        if (bound <= 0) {
            throw new IllegalArgumentException("bound must be positive: " + bound);
        }
        while (true) {
            // 63 random bits u; the integer is floor(u · bound / 2^63).
            long u = nextLong() >>> 1;
            long low = u * bound;
            long fraction = low & Long.MAX_VALUE;
            if (fraction >= bound || fraction >= excess(bound)) {
                return (int) ((Math.multiplyHigh(u, bound) << 1) | (low >>> 63));
            }
        }
    }

    /** 2⁶³ mod bound: how many of the 2⁶³ inputs are too many for an even share. */
    private static long excess(int bound) {
        return (Long.MAX_VALUE % bound + 1) % bound;
    }

    /** An odd increment with enough changes between neighbouring bits for mix64 (OOPSLA 2014, section 4). */
    private static long usableGamma(long z) {
        long odd = z | 1;
        return Long.bitCount(odd ^ (odd >>> 1)) < 24 ? odd ^ 0xAAAAAAAAAAAAAAAAL : odd;
    }
}
