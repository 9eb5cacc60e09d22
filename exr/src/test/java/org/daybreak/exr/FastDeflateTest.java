package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;
import org.junit.jupiter.api.Test;

/** What we deflate, the JDK inflates to the same bytes. */
class FastDeflateTest {
    private final FastDeflate deflate = new FastDeflate();

    /** Returns the packed length, or −1. */
    private int check(byte[] bytes) throws DataFormatException {
        int offset = 5;
        byte[] packed = new byte[offset + bytes.length];
        int length = deflate.deflate(bytes, bytes.length, packed, offset);
        if (length < 0) {
            return length;
        }
        assertTrue(length < bytes.length);
        assertArrayEquals(new byte[offset], Arrays.copyOf(packed, offset));
        Inflater inflater = new Inflater();
        inflater.setInput(packed, offset, length);
        byte[] back = new byte[bytes.length];
        assertEquals(bytes.length, inflater.inflate(back));
        assertEquals(0, inflater.inflate(new byte[1]));
        assertTrue(inflater.finished());
        assertEquals(0, inflater.getRemaining());
        inflater.end();
        assertArrayEquals(bytes, back);
        return length;
    }

    /** Pieces of noise of any width, runs, and copies of what came before, near and far. */
    private static byte[] mixture(SplittableRandom random, int length) {
        byte[] bytes = new byte[length];
        int at = 0;
        while (at < length) {
            int count = Math.min(length - at, 1 + random.nextInt(1 << random.nextInt(1, 14)));
            switch (random.nextInt(4)) {
                case 0 -> {
                    int width = 1 << random.nextInt(9);
                    for (int i = 0; i < count; i++) {
                        bytes[at + i] = (byte) random.nextInt(width);
                    }
                }
                case 1 -> Arrays.fill(bytes, at, at + count, (byte) random.nextInt());
                case 2 -> {
                    // Geometric frequencies make the longest codes.
                    for (int i = 0; i < count; i++) {
                        bytes[at + i] = (byte) Long.numberOfTrailingZeros(random.nextLong());
                    }
                }
                default -> {
                    int distance = 1 + random.nextInt(Math.max(1, Math.min(at, 1 << random.nextInt(1, 17))));
                    for (int i = 0; i < count && at > 0; i++) {
                        bytes[at + i] = bytes[at + i - Math.min(distance, at)];
                    }
                }
            }
            at += count;
        }
        return bytes;
    }

    @Test
    void everyMixtureComesBack() throws DataFormatException {
        SplittableRandom random = new SplittableRandom(11);
        int packed = 0;
        for (int i = 0; i < 1500; i++) {
            packed += check(mixture(random, random.nextInt(1, 1 << random.nextInt(4, 19)))) >= 0 ? 1 : 0;
        }
        assertTrue(packed > 500, packed + " packed");
    }

    /** Fibonacci frequencies ask for codes longer than the 15 bits that there are. */
    @Test
    void codesThatAreTooLongAreLimited() throws DataFormatException {
        byte[] bytes = new byte[28_000];
        int at = 0;
        int a = 1;
        int b = 1;
        for (int symbol = 0; at < bytes.length; symbol++) {
            int end = Math.min(bytes.length, at + a);
            Arrays.fill(bytes, at, end, (byte) symbol);
            at = end;
            int next = a + b;
            a = b;
            b = next;
        }
        SplittableRandom random = new SplittableRandom(3);
        for (int i = bytes.length - 1; i > 0; i--) {
            int j = random.nextInt(i + 1);
            byte swapped = bytes[i];
            bytes[i] = bytes[j];
            bytes[j] = swapped;
        }
        assertTrue(check(bytes) > 0);
    }

    @Test
    void noiseDoesNotShrinkAndRunsShrinkToLittle() throws DataFormatException {
        byte[] noise = new byte[100_000];
        new SplittableRandom(4).nextBytes(noise);
        assertEquals(-1, check(noise));
        assertTrue(check(new byte[1 << 20]) < 6000);
        for (int length = 0; length < 40; length++) {
            check(new byte[length]);
        }
    }

    /** Half of the bytes are noise, half compressible, as those of floats are: within 10 % of the JDK's level 4. */
    @Test
    void sizesAreCloseToThoseOfTheJdk() throws DataFormatException {
        SplittableRandom random = new SplittableRandom(5);
        byte[] bytes = new byte[1 << 19];
        for (int i = 0; i < bytes.length; i++) {
            boolean noise = i < bytes.length / 2;
            bytes[i] = (byte) (noise ? random.nextInt() : 128 + Long.numberOfTrailingZeros(random.nextLong()));
        }
        Deflater deflater = new Deflater(4);
        deflater.setInput(bytes);
        deflater.finish();
        int jdk = deflater.deflate(new byte[bytes.length]);
        deflater.end();
        int ours = check(bytes);
        assertTrue(ours > 0 && ours < 1.1 * jdk, ours + " instead of " + jdk);
    }
}
