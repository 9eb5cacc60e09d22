package org.daybreak.exr;

/**
 * The inverse of the Haar-like wavelet transform of {@link Compression#PIZ} on 16-bit words.
 */
final class Wavelet {
    /** Below this many different values the transform keeps signed differences, above it works modulo 2^16. */
    private static final int SIGNED_LIMIT = 1 << 14;

    private Wavelet() {}

    /**
     * Transforms a plane in place.
     *
     * @param words holds the plane
     * @param start index of its first word
     * @param width columns
     * @param xStride distance of neighbours in a row
     * @param height rows
     * @param yStride distance of neighbours in a column
     * @param maxValue largest value in the plane
     */
    static void decode(short[] words, int start, int width, int xStride, int height, int yStride, int maxValue) {
        boolean signed = maxValue < SIGNED_LIMIT;
        int smaller = Math.min(width, height);
        int step = Integer.highestOneBit(smaller);
        for (int half = step >> 1; half >= 1; step = half, half >>= 1) {
            // Pairs need both members inside, so the last start is a whole step before the end.
            int y = 0;
            for (; y + step <= height; y += step) {
                int row = start + y * yStride;
                int x = 0;
                for (; x + step <= width; x += step) {
                    quad(words, row + x * xStride, half * xStride, half * yStride, signed);
                }
                if ((width & half) != 0) {
                    pair(words, row + x * xStride, half * yStride, signed);
                }
            }
            if ((height & half) != 0) {
                int row = start + y * yStride;
                for (int x = 0; x + step <= width; x += step) {
                    pair(words, row + x * xStride, half * xStride, signed);
                }
            }
        }
    }

    private static void quad(short[] words, int at, int right, int down, boolean signed) {
        pair(words, at, down, signed);
        pair(words, at + right, down, signed);
        pair(words, at, right, signed);
        pair(words, at + down, right, signed);
    }

    /** Turns a mean and a difference into the two values. */
    private static void pair(short[] words, int at, int distance, boolean signed) {
        if (signed) {
            int difference = words[at + distance];
            int first = words[at] + (difference & 1) + (difference >> 1);
            words[at] = (short) first;
            words[at + distance] = (short) (first - difference);
        } else {
            int mean = words[at] & 0xffff;
            int difference = words[at + distance] & 0xffff;
            int second = mean - (difference >> 1);
            words[at + distance] = (short) second;
            words[at] = (short) (difference + second - 0x8000);
        }
    }
}
