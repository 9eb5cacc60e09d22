package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;

class PiecewiseConstant2DTest {
    /** False-alarm rate of each statistical assertion. */
    private static final double SIGNIFICANCE = 1e-4;

    private static double weight(int column, int row) {
        return row == 2 || column == 5 ? 0 : 1 + (column * 7 + row * 3) % 11;
    }

    @Test
    void pointsFollowTheDensity() {
        PiecewiseConstant2D distribution = new PiecewiseConstant2D(13, 6, PiecewiseConstant2DTest::weight);
        ChiSquareTest.ofPoints(
                        "piecewise constant",
                        (u, v, w, dest) -> {
                            double density = distribution.sample(u, v, dest);
                            assertTrue(density > 0);
                            assertEquals(density, distribution.density(dest[0], dest[1]));
                            return true;
                        },
                        distribution::density,
                        0,
                        1,
                        0,
                        1)
                .cells(13 * 5, 6 * 7)
                .assertAgrees(SIGNIFICANCE);
    }

    @Test
    void densityIsTheWeightByItsAverage() {
        PiecewiseConstant2D distribution = new PiecewiseConstant2D(13, 6, PiecewiseConstant2DTest::weight);
        double sum = 0;
        for (int row = 0; row < 6; row++) {
            for (int column = 0; column < 13; column++) {
                sum += weight(column, row);
            }
        }
        assertEquals(sum / 78, distribution.average(), 1e-14);
        for (int row = 0; row < 6; row++) {
            for (int column = 0; column < 13; column++) {
                double density = distribution.density((column + 0.5) / 13, (row + 0.5) / 6);
                assertEquals(weight(column, row) / distribution.average(), density, 1e-12);
            }
        }
    }

    @Test
    void aSunDoesNotTakeTheSkyOutOfItsRow() {
        // One pixel a million times brighter than the rest; still the estimate of the mean is unbiased.
        PiecewiseConstant2D distribution =
                new PiecewiseConstant2D(512, 256, (column, row) -> column == 77 && row == 40 ? 1e6 : 1);
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        double[] p = new double[2];
        Moments sky = new Moments();
        for (int i = 0; i < 200_000; i++) {
            double density = distribution.sample(random.nextDouble(), random.nextDouble(), p);
            boolean sun = (int) (p[0] * 512) == 77 && (int) (p[1] * 256) == 40;
            sky.add(sun ? 0 : 1 / density);
        }
        ZTest.assertNotRejected("area of the sky", ZTest.oneSample(sky, 1 - 1.0 / (512 * 256)), SIGNIFICANCE);
    }

    @Test
    void cornersOfTheSquareStayInsideAndHaveDensity() {
        double[] ends = {0, Math.nextDown(1.0)};
        PiecewiseConstant2D distribution =
                new PiecewiseConstant2D(3, 7, (column, row) -> column == 1 && row == 3 ? 2 : 0);
        double[] p = new double[2];
        for (double u : ends) {
            for (double v : ends) {
                assertEquals(21, distribution.sample(u, v, p), 1e-12);
                assertEquals(21, distribution.density(p[0], p[1]), 1e-12);
                assertTrue(p[0] >= 1.0 / 3 && p[0] < 2.0 / 3 && p[1] >= 3.0 / 7 && p[1] < 4.0 / 7);
            }
        }
    }

    @Test
    void zeroWeightsAreUniform() {
        PiecewiseConstant2D distribution = new PiecewiseConstant2D(4, 2, (column, row) -> 0);
        assertEquals(0, distribution.average());
        double[] p = new double[2];
        assertEquals(1, distribution.sample(0.3, 0.8, p), 1e-15);
        assertEquals(0.3, p[0], 1e-15);
        assertEquals(0.8, p[1], 1e-15);
    }

    @Test
    void badWeightsAndSizesAreRefused() {
        String message = assertThrows(
                        IllegalArgumentException.class,
                        () -> new PiecewiseConstant2D(4, 2, (column, row) -> column + row == 4 ? Double.NaN : 1))
                .getMessage();
        assertEquals("row 1: weight 3 of a distribution is NaN", message);
        assertThrows(IllegalArgumentException.class, () -> new PiecewiseConstant2D(0, 2, (column, row) -> 1));
        assertThrows(
                IllegalArgumentException.class, () -> new PiecewiseConstant2D(1 << 20, 1 << 20, (column, row) -> 1));
    }
}
