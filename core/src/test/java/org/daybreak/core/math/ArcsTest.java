package org.daybreak.core.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ArcsTest {
    @Test
    void atan2AgreesWithTheJdkOverAllMagnitudes() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 1_000_000; i++) {
            double y = random.nextDouble(-1, 1) * Math.scalb(1.0, random.nextInt(-60, 60));
            double x = random.nextDouble(-1, 1) * Math.scalb(1.0, random.nextInt(-60, 60));
            double expected = Math.atan2(y, x);
            assertTrue(
                    Math.abs(Arcs.atan2(y, x) - expected) <= 1.5e-15 * Math.abs(expected),
                    () -> y + ", " + x + ": " + Arcs.atan2(y, x) + " for " + expected);
        }
    }

    @Test
    void atan2OnTheAxesAndDiagonalsIsExact() {
        for (double y : new double[] {-2, 0, 2}) {
            for (double x : new double[] {-2, 0, 2}) {
                assertEquals(Math.atan2(y, x), Arcs.atan2(y, x), 1e-15, y + ", " + x);
            }
        }
    }

    @Test
    void acosAgreesWithTheJdk() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 1_000_000; i++) {
            double x = random.nextDouble(-1, 1);
            assertEquals(Math.acos(x), Arcs.acos(x), 1e-15 * Math.PI);
        }
        assertEquals(0, Arcs.acos(1));
        assertEquals(Math.PI, Arcs.acos(-1));
        assertEquals(0, Arcs.acos(1 + 1e-15));
    }
}
