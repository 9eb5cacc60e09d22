package org.daybreak.metropolis.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SmallStepTest {
    /** Steps up and down, of sizes spread evenly on a logarithmic scale. False-alarm rate 1e-4 for each pair of bounds. */
    @ParameterizedTest
    @CsvSource({"0.0009765625, 0.015625", "0.001, 0.5", "0.1, 0.1000001"})
    void sizesAreEvenOnALogarithmicScale(double smallest, double largest) {
        SmallStep step = new SmallStep(smallest, largest);
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        int bins = 8;
        int samples = 40_000;
        long[] counts = new long[2 * bins];
        for (int i = 0; i < samples; i++) {
            double change = step.move(0.5, random.nextDouble()) - 0.5;
            double size = Math.log(Math.abs(change) / smallest) / Math.log(largest / smallest);
            // Rounding of 0.5 ± size can leave the range by a hair.
            int bin = Math.min(bins - 1, Math.max(0, (int) (size * bins)));
            counts[change > 0 ? bin : bins + bin]++;
        }
        double[] expected = new double[counts.length];
        Arrays.fill(expected, samples / (double) counts.length);
        ZTest.assertNotRejected(
                "sizes", ChiSquareTest.compare("sizes", counts, expected).pValue(), 1e-4);
    }

    @Test
    void numbersStayInTheUnitInterval() {
        for (double largest : new double[] {1e-9, 1.0 / 64, 0.5}) {
            SmallStep step = new SmallStep(1e-9, largest);
            for (double value : new double[] {0, Double.MIN_VALUE, 1e-10, 0.3, 1 - 1e-10, Math.nextDown(1.0)}) {
                for (double u : new double[] {0, 0.25, Math.nextDown(0.5), 0.5, 0.75, Math.nextDown(1.0)}) {
                    double moved = step.move(value, u);
                    assertTrue(moved >= 0 && moved < 1, () -> value + " moved by " + u + " is " + moved);
                    double distance = Math.abs(moved - value);
                    double around = Math.min(distance, 1 - distance);
                    assertTrue(around <= largest * (1 + 1e-6) && around >= 0.99e-9, () -> "moved by " + around);
                }
            }
        }
    }

    @Test
    void boundsInTheWrongOrderAreAnError() {
        ParameterException e = assertThrows(ParameterException.class, () -> new SmallStep(0.25, 0.125));
        assertEquals(
                "parameter 'smallestStep' is '0.25' but must be at most 'largestStep', which is '0.125'",
                e.getMessage());
    }
}
