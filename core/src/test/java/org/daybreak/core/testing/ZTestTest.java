package org.daybreak.core.testing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.api.Test;

class ZTestTest {
    /** False-alarm rate of each statistical assertion. */
    private static final double SIGNIFICANCE = 1e-4;

    @Test
    void pValuesAreThoseOfTheTables() {
        assertEquals(0.05, Significance.normal(1.959963984540054), 1e-12);
        assertEquals(1, Significance.normal(0));
        // Student: t = 2.776 at 4 degrees of freedom and 12.706 at 1 leave 5 % on both sides.
        assertEquals(0.05, Significance.student(2.7764451051977987, 4), 1e-10);
        assertEquals(0.05, Significance.student(-12.706204736432095, 1), 1e-10);
        // χ²: 18.307 at 10 degrees of freedom leaves 5 %.
        assertEquals(0.05, Significance.chiSquare(18.307038053275146, 10), 1e-10);
        // Welch: from TTest of Apache Commons Math 3.6.1.
        Moments sample1 = Moments.of(2, 4, 4, 4, 5, 5, 7, 9);
        Moments sample2 = Moments.of(6, 7.5, 9, 8);
        assertEquals(0.024255161733543994, ZTest.twoSample(sample1, sample2), 1e-12);
        assertEquals(0, Significance.normal(Double.NaN));
        assertEquals(0, Significance.student(Double.NaN, 3));
        assertEquals(0, Significance.chiSquare(Double.NaN, 3));
    }

    @Test
    void sidakKeepsTheRateOfTheFamily() {
        assertEquals(1e-4, 1 - Math.pow(1 - Significance.sidak(1e-4, 1000), 1000), 1e-12);
        assertEquals(0.01, Significance.sidak(0.01, 1), 1e-15);
    }

    @Test
    void momentsAreThoseOfTheNumbers() {
        Moments moments = Moments.of(2, 4, 4, 4, 5, 5, 7, 9);
        assertEquals(5, moments.mean());
        assertEquals(32.0 / 7, moments.variance(), 1e-15);
        assertEquals(4.0 / 7, moments.varianceOfMean(), 1e-15);
        assertEquals(8, moments.count());
        Moments shifted = new Moments();
        for (double x : new double[] {4, 7, 13, 16}) {
            shifted.add(1e9 + x);
        }
        assertEquals(30, shifted.variance(), 1e-9);
        assertTrue(Double.isNaN(Moments.of(1).variance()));
    }

    @Test
    void fewRunsDoNotRaiseTheFalseAlarmRate() {
        // Four runs a side; a normal approximation would reject some four times too often at 1 %.
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        int trials = 100_000;
        int one = 0;
        int two = 0;
        for (int i = 0; i < trials; i++) {
            Moments a = new Moments();
            Moments b = new Moments();
            for (int run = 0; run < 4; run++) {
                a.add(normal(random));
                b.add(normal(random));
            }
            one += ZTest.oneSample(a, 0) < 0.01 ? 1 : 0;
            two += ZTest.twoSample(a, b) < 0.01 ? 1 : 0;
        }
        double error = Math.sqrt(trials * 0.01 * 0.99);
        ZTest.assertNotRejected("one-sample rate", ZTest.known(one, error, 0.01 * trials), SIGNIFICANCE);
        // Welch's test is approximate and for so few runs conservative.
        assertTrue(two < 0.01 * trials && two > 0.005 * trials, "two-sample rate " + two);
    }

    @Test
    void differencesAreFound() {
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        double[][] runs1 = new double[10][100];
        double[][] runs2 = new double[10][100];
        for (int run = 0; run < 10; run++) {
            for (int tile = 0; tile < 100; tile++) {
                runs1[run][tile] = 1 + 0.01 * normal(random);
                runs2[run][tile] = 1 + 0.01 * normal(random);
            }
        }
        ZTest.assertNoneRejected("equal", ZTest.tilesOfRuns(runs1, runs2), SIGNIFICANCE);
        for (double[] run : runs2) {
            run[37] += 0.06;
        }
        String message = assertThrows(
                        AssertionError.class,
                        () -> ZTest.assertNoneRejected("tiles", ZTest.tilesOfRuns(runs1, runs2), SIGNIFICANCE))
                .getMessage();
        assertTrue(message.startsWith("tiles: 1 of 100 tests rejected; the worst is number 37 with"), message);
    }

    @Test
    void tilesOfKnownVariance() {
        double[] p = ZTest.tiles(
                new double[] {1, 1, 2, Double.NaN},
                new double[] {0.01, 0, 0, 0.01},
                new double[] {1.2, 1, 1, 1},
                new double[] {0, 0, 0, 0});
        assertArrayEquals(new double[] {Significance.normal(2), 1, 0, 0}, p, 1e-12);
        assertThrows(AssertionError.class, () -> ZTest.assertNoneRejected("NaN", new double[] {Double.NaN}, 0.01));
        assertDoesNotThrow(() -> ZTest.assertNotRejected("at the level", 0.01, 0.01));
    }

    @Test
    void tileMeansAndVariances() {
        // Rows of 5 in tiles of 2: the last column of tiles holds one column of pixels, the last row one row.
        double[] values = new double[15];
        Arrays.setAll(values, i -> i);
        assertEquals(3, Grids.tiles(5, 2));
        assertArrayEquals(new double[] {3, 5, 6.5, 10.5, 12.5, 14}, Grids.tileMeans(values, 5, 2));
        double[] ones = new double[15];
        Arrays.fill(ones, 1);
        assertArrayEquals(new double[] {0.25, 0.25, 0.5, 0.5, 0.5, 1}, Grids.tileVariances(ones, 5, 2));
        assertThrows(IllegalArgumentException.class, () -> Grids.tileMeans(values, 4, 2));
    }

    private static double normal(RandomStream random) {
        return Math.sqrt(-2 * Math.log(1 - random.nextDouble())) * Math.cos(2 * Math.PI * random.nextDouble());
    }
}
