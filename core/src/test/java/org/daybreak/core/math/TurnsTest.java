package org.daybreak.core.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class TurnsTest {
    private static final double ERROR = 2.3e-16;

    @Test
    void agreesWithTheFunctionsOfTheJdk() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 200_000; i++) {
            double turns = random.nextDouble();
            double x = 2 * turns - 1;
            assertEquals(Math.sin(Math.PI / 4 * x), Turns.sinEighth(x), ERROR);
            assertEquals(Math.cos(Math.PI / 4 * x), Turns.cosEighth(x), ERROR);
            // The argument 2π·turns that the JDK's functions get is off by two roundings itself.
            assertEquals(Math.sin(2 * Math.PI * turns), Turns.sin(turns), ERROR + 2 * Math.PI * 0x1p-52);
            assertEquals(Math.cos(2 * Math.PI * turns), Turns.cos(turns), ERROR + 2 * Math.PI * 0x1p-52);
        }
    }

    @Test
    void quartersAreExact() {
        double[] sine = {0, 1, 0, -1};
        for (int quarter = -9; quarter <= 9; quarter++) {
            assertEquals(sine[quarter & 3], Turns.sin(quarter / 4.0), 0.0);
            assertEquals(sine[quarter + 1 & 3], Turns.cos(quarter / 4.0), 0.0);
        }
    }

    @Test
    void endsOfTheOctantAgree() {
        assertEquals(Math.sqrt(0.5), Turns.sinEighth(1), ERROR);
        assertEquals(Math.sqrt(0.5), Turns.cosEighth(-1), ERROR);
        assertEquals(1, Turns.sin(0.25), 0);
        assertEquals(Math.sqrt(0.5), Turns.cos(-0.125), ERROR);
    }
}
