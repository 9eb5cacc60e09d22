package org.daybreak.core.sampling;

/**
 * The Sobol′ sequence in base 2 with the direction numbers of Joe and Kuo, “Constructing Sobol Sequences with Better
 * Two-Dimensional Projections”, SIAM J. Sci. Comput. 30 (2008), set D6.
 *
 * <p>Coordinates are 32-bit binary fractions: the unsigned value divided by 2³².
 */
public final class Sobol {
    /** How many dimensions there are. */
    public static final int DIMENSIONS = 16;

    private static final int BITS = 32;

    /**
     * For each dimension from the second: degree s of the primitive polynomial, its inner coefficients a as bits, and
     * the initial numbers m₁ … m_s.
     */
    private static final int[][] JOE_KUO = {
        {1, 0, 1},
        {2, 1, 1, 3},
        {3, 1, 1, 3, 1},
        {3, 2, 1, 1, 1},
        {4, 1, 1, 1, 3, 3},
        {4, 4, 1, 3, 5, 13},
        {5, 2, 1, 1, 5, 5, 17},
        {5, 4, 1, 1, 5, 5, 5},
        {5, 7, 1, 1, 7, 11, 19},
        {5, 11, 1, 1, 5, 1, 1},
        {5, 13, 1, 1, 1, 3, 11},
        {5, 14, 1, 3, 5, 5, 31},
        {6, 1, 1, 3, 3, 9, 7, 49},
        {6, 13, 1, 1, 1, 15, 21, 21},
        {6, 16, 1, 3, 1, 13, 27, 49},
    };

    /**
     * Bit-reversed coordinates of every index with only one byte that is not 0: dimension, byte and its value make the
     * position. The coordinate of an index is the exclusive or over its four bytes.
     */
    private static final int[] REVERSED = reversedTable();

    private Sobol() {}

    /**
     * The coordinate of a point.
     *
     * @param index index of the point, as an unsigned number
     * @param dimension 0 … {@link #DIMENSIONS} − 1
     * @return the coordinate as an unsigned fraction of 2³²
     */
    public static int sobol(int index, int dimension) {
        return Integer.reverse(reversed(index, dimension));
    }

    /** {@link #sobol} with its bits in reversed order, as {@link OwenScrambling} wants them. */
    static int reversed(int index, int dimension) {
        int base = dimension << 10;
        return REVERSED[base + (index & 0xFF)]
                ^ REVERSED[base + 0x100 + (index >>> 8 & 0xFF)]
                ^ REVERSED[base + 0x200 + (index >>> 16 & 0xFF)]
                ^ REVERSED[base + 0x300 + (index >>> 24)];
    }

    private static int[] reversedTable() {
        int[] table = new int[DIMENSIONS << 10];
        for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
            int[] directions = directions(dimension);
            for (int slice = 0; slice < 4; slice++) {
                for (int value = 0; value < 256; value++) {
                    int bits = 0;
                    for (int bit = 0; bit < 8; bit++) {
                        if ((value >>> bit & 1) != 0) {
                            bits ^= directions[slice * 8 + bit];
                        }
                    }
                    table[(dimension << 10) + (slice << 8) + value] = Integer.reverse(bits);
                }
            }
        }
        return table;
    }

    /** Direction numbers v_k = m_k / 2^k as fractions of 2³². */
    private static int[] directions(int dimension) {
        int[] v = new int[BITS];
        if (dimension == 0) {
            // The van der Corput sequence, which is not in the table of the polynomials.
            for (int k = 0; k < BITS; k++) {
                v[k] = 1 << (BITS - 1 - k);
            }
            return v;
        }
        int[] row = JOE_KUO[dimension - 1];
        int s = row[0];
        int a = row[1];
        for (int k = 0; k < s; k++) {
            v[k] = row[2 + k] << (BITS - 1 - k);
        }
        // Bratley and Fox, ACM Algorithm 659 (1988), eq. 2, for the shifted numbers.
        for (int k = s; k < BITS; k++) {
            v[k] = v[k - s] ^ (v[k - s] >>> s);
            for (int i = 1; i < s; i++) {
                if ((a >>> (s - 1 - i) & 1) != 0) {
                    v[k] ^= v[k - i];
                }
            }
        }
        return v;
    }
}
