package org.daybreak.core.film;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

final class ReconstructionFilterTest {
    static Stream<ReconstructionFilter> filters() {
        return Stream.of(
                ReconstructionFilter.BOX,
                ReconstructionFilter.TENT,
                ReconstructionFilter.GAUSSIAN,
                ReconstructionFilter.MITCHELL,
                ReconstructionFilter.CATMULL_ROM,
                ReconstructionFilter.BLACKMAN_HARRIS,
                ReconstructionFilter.LANCZOS,
                new ReconstructionFilter(ReconstructionFilter.Kind.BOX, 1.25, 0),
                new ReconstructionFilter(ReconstructionFilter.Kind.GAUSSIAN, 1.5, 0.9),
                new ReconstructionFilter(ReconstructionFilter.Kind.MITCHELL, 3, 0.2));
    }

    @ParameterizedTest
    @MethodSource("filters")
    void tableFollowsTheFormula(ReconstructionFilter filter) {
        FilterKernel kernel = new FilterKernel(filter);
        double integral = 0;
        int n = 400_000;
        double step = 2 * filter.radius() / n;
        for (int i = 0; i < n; i++) {
            integral += filter.evaluate(-filter.radius() + (i + 0.5) * step) * step;
        }
        double peak = filter.evaluate(0) / integral;
        for (double d = -filter.radius(); d < filter.radius(); d += 0.00137) {
            assertEquals(filter.evaluate(d) / integral, kernel.weight(d), 2e-5 * peak);
        }
        assertEquals(0, kernel.weight(filter.radius() + 1e-9));
    }

    @ParameterizedTest
    @MethodSource("filters")
    void integralsAreThoseOfTheTable(ReconstructionFilter filter) {
        FilterKernel kernel = new FilterKernel(filter);
        assertEquals(1, kernel.integral(-filter.radius(), filter.radius()), 1e-14);
        assertEquals(1, kernel.integral(-100, 100), 1e-14);
        double from = -0.37;
        double to = 0.41;
        double sum = 0;
        int n = 1_000_000;
        for (int i = 0; i < n; i++) {
            sum += kernel.weight(from + (i + 0.5) * (to - from) / n) * (to - from) / n;
        }
        assertEquals(sum, kernel.integral(from, to), 1e-9);
    }

    @Test
    void mitchellHasTheValuesOfThePaper() {
        // Mitchell and Netravali 1988, eq. 8 with B = C = 1/3: k(0) = 8/9, k(1) = 1/18, and a negative lobe beyond 1.
        assertEquals(8.0 / 9, ReconstructionFilter.MITCHELL.evaluate(0), 1e-15);
        assertEquals(1.0 / 18, ReconstructionFilter.MITCHELL.evaluate(-1), 1e-15);
        assertTrue(ReconstructionFilter.MITCHELL.evaluate(1.5) < 0);
        assertEquals(0, ReconstructionFilter.MITCHELL.evaluate(2), 1e-15);
    }

    @Test
    void refusesImpossibleNumbers() {
        assertThrows(
                IllegalArgumentException.class, () -> new ReconstructionFilter(ReconstructionFilter.Kind.TENT, 0.4, 0));
        assertThrows(
                IllegalArgumentException.class,
                () -> new ReconstructionFilter(ReconstructionFilter.Kind.TENT, Double.NaN, 0));
        assertThrows(
                IllegalArgumentException.class,
                () -> new ReconstructionFilter(ReconstructionFilter.Kind.GAUSSIAN, 2, 0));
    }

    @Test
    void furtherFiltersHaveTheirKnownValues() {
        // Catmull-Rom interpolates: 1 at the centre, 0 at the other pixels, and −1/16 half way to the second.
        assertEquals(1, ReconstructionFilter.CATMULL_ROM.evaluate(0), 1e-15);
        assertEquals(0, ReconstructionFilter.CATMULL_ROM.evaluate(1), 1e-15);
        assertEquals(-1.0 / 16, ReconstructionFilter.CATMULL_ROM.evaluate(1.5), 1e-15);
        // The coefficients of the window add up to 1, and to 0.00006 with alternating signs.
        assertEquals(1, ReconstructionFilter.BLACKMAN_HARRIS.evaluate(0), 1e-15);
        assertEquals(6e-5, ReconstructionFilter.BLACKMAN_HARRIS.evaluate(1.5), 1e-12);
        // sinc(½)·sinc(1/6) = (2/π)(3/π).
        assertEquals(6 / (Math.PI * Math.PI), ReconstructionFilter.LANCZOS.evaluate(0.5), 1e-15);
        assertEquals(0, ReconstructionFilter.LANCZOS.evaluate(2), 1e-15);
        assertTrue(ReconstructionFilter.LANCZOS.evaluate(1.5) < -0.1);
    }

    /** The mean of a function of the film position times the factor is its integral against the filter, at edges too. */
    @ParameterizedTest
    @MethodSource("filters")
    void samplesFollowTheFilter(ReconstructionFilter filter) {
        int width = 7;
        int height = 5;
        FilmSettings settings =
                new FilmSettings(width, height, new FilmSettings.Crop(0, 0, width, height), filter, true);
        FilterKernel kernel = new FilterKernel(filter);
        FilterSampler sampler = new FilterSampler(settings, kernel);
        double[] d = new double[3];
        for (int[] pixel : new int[][] {{3, 2}, {0, 4}, {6, 0}}) {
            // Midpoints in u and v: the means converge fast, so the comparison needs no statistics.
            int n = 200_000;
            double meanX = 0;
            double meanY = 0;
            for (int i = 0; i < n; i++) {
                double factorX = sampler.sampleAxis(pixel[0], width, (i + 0.5) / n, d, 0);
                double factorY = sampler.sampleAxis(pixel[1], height, (i + 0.5) / n, d, 1);
                assertTrue(d[0] >= 0 && d[0] < width && d[1] >= 0 && d[1] < height);
                assertTrue(Math.abs(d[0] - pixel[0] - 0.5) <= filter.radius() + 1e-9);
                meanX += factorX * Math.cos(d[0]) / n;
                meanY += factorY * Math.exp(-0.3 * d[1]) / n;
            }
            assertEquals(filtered(kernel, pixel[0], width, Math::cos), meanX, 2e-5);
            assertEquals(filtered(kernel, pixel[1], height, v -> Math.exp(-0.3 * v)), meanY, 2e-5);
            double factor =
                    sampler.sampleAxis(pixel[0], width, 0.3, d, 0) * sampler.sampleAxis(pixel[1], height, 0.8, d, 1);
            sampler.sample(pixel[0], pixel[1], 0.3, 0.8, d);
            assertEquals(factor, d[2], 1e-15);
        }
    }

    private static double filtered(
            FilterKernel kernel, int pixel, int size, java.util.function.DoubleUnaryOperator function) {
        int n = 200_000;
        double sum = 0;
        double weight = 0;
        for (int i = 0; i < n; i++) {
            double x = (i + 0.5) * size / n;
            double w = kernel.weight(x - pixel - 0.5);
            sum += w * function.applyAsDouble(x);
            weight += w;
        }
        return sum / weight;
    }
}
