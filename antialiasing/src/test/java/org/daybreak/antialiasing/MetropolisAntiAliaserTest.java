package org.daybreak.antialiasing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Arrays;
import java.util.BitSet;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;

class MetropolisAntiAliaserTest {
    private static final int WIDTH = 37;
    private static final int HEIGHT = 23;
    private static final int PIXELS = WIDTH * HEIGHT;

    private static MetropolisAntiAliaser aliaser(long key) {
        return new MetropolisAntiAliaser(WIDTH, HEIGHT, key);
    }

    @Test
    void visitsEachPixelOnceInEachRound() {
        MetropolisAntiAliaser aliaser = aliaser(5);
        for (int round = 0; round < 3; round++) {
            BitSet seen = new BitSet();
            for (int i = 0; i < PIXELS; i++) {
                long pixel = aliaser.pixel((long) round * PIXELS + i);
                assertFalse(seen.get((int) pixel));
                seen.set((int) pixel);
            }
            assertEquals(PIXELS, seen.cardinality());
        }
    }

    @Test
    void roundsAndKeysHaveOrdersOfTheirOwn() {
        assertNotEquals(
                aliaser(5).pixel(0) + PIXELS * aliaser(5).pixel(1),
                aliaser(5).pixel(PIXELS) + PIXELS * aliaser(5).pixel(PIXELS + 1L));
        assertNotEquals(
                aliaser(5).pixel(0) + PIXELS * aliaser(5).pixel(1),
                aliaser(6).pixel(0) + PIXELS * aliaser(6).pixel(1));
    }

    /** Rings of equal width on the logarithmic scale get equal shares; false-alarm rate 1e-5. */
    @Test
    void distancesAreEvenOnALogarithmicScale() {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        int rings = 20;
        long[] counts = new long[rings];
        double[] expected = new double[rings];
        Arrays.fill(expected, 1000);
        for (int i = 0; i < 1000 * rings; i++) {
            double r = MetropolisAntiAliaser.distance(0.1, 8, random.nextDouble());
            counts[(int) (rings * Math.log(r / 0.1) / Math.log(8 / 0.1) * (1 - 1e-12))]++;
        }
        ZTest.assertNotRejected(
                "distances",
                ChiSquareTest.compare("distances", counts, expected).pValue(),
                1e-5);
        assertEquals(8, MetropolisAntiAliaser.distance(0.1, 8, 0), 1e-12);
        assertEquals(0.1, MetropolisAntiAliaser.distance(0.1, 8, 1), 1e-12);
    }
}
