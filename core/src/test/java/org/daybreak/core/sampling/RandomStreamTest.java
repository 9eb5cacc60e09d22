package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RandomStreamTest {
    /** False-alarm rate of each statistical assertion; the seeds are fixed, so a pass is a pass for good. */
    private static final double SIGNIFICANCE = 1e-4;

    /** How two addresses differ that must nevertheless be independent. */
    enum Neighbours {
        SEED,
        DOMAIN,
        INDEX,
        SUB_INDEX,
        POSITION,
        INDEX_AND_SUB_INDEX,
        HIGH_BITS;

        void seat(RandomStream stream, long i, int side) {
            switch (this) {
                case SEED -> stream.seat(2 * i + side, StreamDomain.PIXEL, 5, 7);
                case DOMAIN -> stream.seat(1, side == 0 ? StreamDomain.PIXEL : StreamDomain.LENS, i, 7);
                case INDEX -> stream.seat(1, StreamDomain.PIXEL, i + side, 7);
                case SUB_INDEX -> stream.seat(1, StreamDomain.PIXEL, 5, i + side);
                case POSITION -> {
                    stream.seat(1, StreamDomain.PIXEL, 5, 7);
                    stream.skipTo(i + side);
                }
                case INDEX_AND_SUB_INDEX -> stream.seat(1, StreamDomain.PIXEL, i + side, i + 1 - side);
                case HIGH_BITS -> stream.seat(1, StreamDomain.PIXEL, i | (long) side << 63, 7);
                default -> throw new AssertionError(this);
            }
        }
    }

    @Test
    void mixerGivesThePublishedSplitMix64Sequences() {
        RandomStream stream = new RandomStream();
        // First outputs of the public-domain reference splitmix64.c for state 0 and 1234567.
        long[] ofZero = {0xE220A8397B1DCDAFL, 0x6E789E6AA1B965F4L, 0x06C45D188009454FL, 0xF88BB8A8724C81ECL};
        stream.seat(0, Mixing.GOLDEN_GAMMA);
        for (long expected : ofZero) {
            assertEquals(expected, stream.nextLong());
        }
        String[] of1234567 = {
            "6457827717110365317",
            "3203168211198807973",
            "9817491932198370423",
            "4593380528125082431",
            "16408922859458223821"
        };
        stream.seat(1234567, Mixing.GOLDEN_GAMMA);
        for (String expected : of1234567) {
            assertEquals(expected, Long.toUnsignedString(stream.nextLong()));
        }
    }

    @Test
    void addressesGiveThePinnedNumbers() {
        // From an independent implementation of the definition (Python integers). A change here changes every picture.
        assertSequence(
                new RandomStream(0, StreamDomain.PIXEL, 0, 0),
                0x9BB8DC1A5D5508E7L,
                0xCEC0B27045FD3C7DL,
                0x92BEDB16F21E47F6L,
                0xB6674F075214007DL);
        assertSequence(
                new RandomStream(42, StreamDomain.LIGHT_PATH, 7, 11),
                0xFD9A4309147959D3L,
                0xA28A3B194C516FB6L,
                0x5776F43A9B7F116CL,
                0x9D775768C03BE7BAL);
        assertSequence(
                new RandomStream(-1, StreamDomain.CHAIN, 1L << 40, -5),
                0x7FCF121D3CB2F7C8L,
                0xDA4C1F45BD7D36C1L,
                0xDD81231895E344AFL,
                0x0497328F560D0BA8L);
    }

    @Test
    void anyPositionIsReplayed() {
        RandomStream stream = new RandomStream(3, StreamDomain.CHAIN, 4, 5);
        double[] numbers = new double[100];
        for (int i = 0; i < numbers.length; i++) {
            assertEquals(i, stream.position());
            numbers[i] = stream.nextDouble();
        }
        for (int i = numbers.length - 1; i >= 0; i--) {
            stream.skipTo(i);
            assertEquals(i, stream.position());
            assertEquals(numbers[i], stream.nextDouble());
        }
        stream.seat(9, StreamDomain.CHAIN, 4, 5);
        assertNotEquals(numbers[0], stream.nextDouble());
        stream.seat(3, StreamDomain.CHAIN, 4, 5);
        assertEquals(numbers[0], stream.nextDouble());
    }

    @Test
    void domainsHaveDistinctNumbers() {
        Set<Integer> ids = new HashSet<>();
        for (StreamDomain domain : StreamDomain.values()) {
            assertTrue(ids.add(domain.id()), domain.name());
        }
    }

    @Test
    void doublesLieBelowOne() {
        // The largest output of the mixer, 2^64 − 1, is that of the state whose mix it is; reach it by its inverse.
        RandomStream stream = new RandomStream();
        stream.seat(inverseMix64(-1L) - Mixing.GOLDEN_GAMMA, Mixing.GOLDEN_GAMMA);
        assertEquals(Math.nextDown(1.0), stream.nextDouble());
        stream.seat(-Mixing.GOLDEN_GAMMA, Mixing.GOLDEN_GAMMA);
        assertEquals(0.0, stream.nextDouble());
    }

    @Test
    void doublesAreUniformInEveryBit() {
        RandomStream stream = new RandomStream(1, StreamDomain.PIXEL, 2, 3);
        int n = 1 << 18;
        int[] ones = new int[53];
        for (int i = 0; i < n; i++) {
            long bits = (long) (stream.nextDouble() * 0x1p53);
            for (int b = 0; b < 53; b++) {
                ones[b] += (int) (bits >>> b & 1);
            }
        }
        double[] pValues = new double[53];
        for (int b = 0; b < 53; b++) {
            pValues[b] = ZTest.known(ones[b], Math.sqrt(n / 4.0), n / 2.0);
        }
        ZTest.assertNoneRejected("ones among the bits", pValues, SIGNIFICANCE);
    }

    @ParameterizedTest
    @EnumSource(Neighbours.class)
    void neighbouringAddressesAreIndependent(Neighbours neighbours) {
        RandomStream stream = new RandomStream();
        // χ² of pairs on a grid of the leading bits, and on one of the trailing bits.
        long[] leading = new long[4096];
        long[] trailing = new long[4096];
        Moments product = new Moments();
        int n = 1 << 18;
        for (int i = 0; i < n; i++) {
            neighbours.seat(stream, i, 0);
            double a = stream.nextDouble();
            neighbours.seat(stream, i, 1);
            double b = stream.nextDouble();
            leading[cell((int) (a * 64), (int) (b * 64))]++;
            trailing[cell((int) (long) (a * 0x1p53), (int) (long) (b * 0x1p53))]++;
            product.add((a - 0.5) * (b - 0.5) * 12);
        }
        double[] expected = new double[4096];
        Arrays.fill(expected, n / 4096.0);
        double[] pValues = {
            ChiSquareTest.compare("leading bits", leading, expected).pValue(),
            ChiSquareTest.compare("trailing bits", trailing, expected).pValue(),
            ZTest.known(product.mean(), 1 / Math.sqrt(n), 0)
        };
        ZTest.assertNoneRejected(
                neighbours + ": grids of leading and trailing bits, correlation", pValues, SIGNIFICANCE);
    }

    @Test
    void everyInputBitChangesEveryOutputBitHalfTheTime() {
        int trials = 2048;
        RandomStream base = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        double[] pValues = new double[3 * 64 * 64];
        for (int word = 0; word < 3; word++) {
            for (int in = 0; in < 64; in++) {
                int[] flips = new int[64];
                for (int trial = 0; trial < trials; trial++) {
                    base.skipTo(3L * trial);
                    long seed = base.nextLong();
                    // Indices as they occur: small numbers.
                    long index = base.nextLong() >>> 40;
                    long subIndex = base.nextLong() >>> 50;
                    long flip = 1L << in;
                    long change = Mixing.hash(seed, StreamDomain.PIXEL, index, subIndex)
                            ^ Mixing.hash(
                                    word == 0 ? seed ^ flip : seed,
                                    StreamDomain.PIXEL,
                                    word == 1 ? index ^ flip : index,
                                    word == 2 ? subIndex ^ flip : subIndex);
                    for (int out = 0; out < 64; out++) {
                        flips[out] += (int) (change >>> out & 1);
                    }
                }
                for (int out = 0; out < 64; out++) {
                    pValues[(word * 64 + in) * 64 + out] =
                            ZTest.known(flips[out], Math.sqrt(trials / 4.0), trials / 2.0);
                }
            }
        }
        ZTest.assertNoneRejected("avalanche", pValues, SIGNIFICANCE);
    }

    @Test
    void integersAreUniform() {
        for (int bound : new int[] {1, 2, 3, 7, 64, 1000}) {
            RandomStream stream = new RandomStream(1, StreamDomain.PIXEL, bound, 0);
            long[] counts = new long[bound];
            int n = 200_000;
            for (int i = 0; i < n; i++) {
                counts[stream.nextInt(bound)]++;
            }
            if (bound > 1) {
                double[] expected = new double[bound];
                Arrays.fill(expected, (double) n / bound);
                double p = ChiSquareTest.compare("integers", counts, expected).pValue();
                ZTest.assertNotRejected("integers below " + bound, p, SIGNIFICANCE);
            }
        }
    }

    @Test
    void integersFollowTheHighBitsAndReachBothEnds() {
        RandomStream stream = new RandomStream();
        stream.seat(inverseMix64(-1L) - Mixing.GOLDEN_GAMMA, Mixing.GOLDEN_GAMMA);
        assertEquals(Integer.MAX_VALUE - 1, stream.nextInt(Integer.MAX_VALUE));
        stream.seat(-Mixing.GOLDEN_GAMMA, Mixing.GOLDEN_GAMMA);
        assertEquals(0, stream.nextInt(1 << 30));
        assertEquals(1, stream.position());
        // u = 0 is one of the 2^63 mod 3 = 2 inputs too many, so it is drawn again.
        stream.seat(-Mixing.GOLDEN_GAMMA, Mixing.GOLDEN_GAMMA);
        assertTrue(stream.nextInt(3) < 3);
        assertEquals(2, stream.position());
        assertThrows(IllegalArgumentException.class, () -> stream.nextInt(0));
    }

    /** The cell of a 64 × 64 grid from the trailing bits of two numbers. */
    private static int cell(int a, int b) {
        return (a & 63) << 6 | (b & 63);
    }

    private static void assertSequence(RandomStream stream, long... expected) {
        for (long value : expected) {
            assertEquals(value, stream.nextLong());
        }
    }

    private static long inverseMix64(long y) {
        y = y ^ (y >>> 31) ^ (y >>> 62);
        y *= inverseOdd(0x94D049BB133111EBL);
        y = y ^ (y >>> 27) ^ (y >>> 54);
        y *= inverseOdd(0xBF58476D1CE4E5B9L);
        return y ^ (y >>> 30) ^ (y >>> 60);
    }

    /** Inverse of an odd number modulo 2^64 by Newton's iteration. */
    private static long inverseOdd(long a) {
        long x = a;
        for (int i = 0; i < 6; i++) {
            x *= 2 - a * x;
        }
        return x;
    }
}
