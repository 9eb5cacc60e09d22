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
}
