package org.daybreak.core.color;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** The expected colours are those of Mitsuba 3.9.1, which sums 1000 values; hence the tolerance. */
class SpectralColorsTest {
    private static final double[] FOUR = {400, 500, 600, 700};

    @Test
    void reflectancesAsInMitsuba() {
        assertArrayEquals(
                new double[] {0.995342, 0.999756, 0.994909},
                SpectralColors.reflectance(FOUR, new double[] {1, 1, 1, 1}),
                1.5e-3);
        assertArrayEquals(
                new double[] {0.262351, 0.382156, 0.31049},
                SpectralColors.reflectance(FOUR, new double[] {0.1, 0.5, 0.2, 0.9}),
                1e-3);
        assertArrayEquals(
                new double[] {1, 1, 1}, SpectralColors.reflectance(new double[] {300, 900}, new double[] {1, 1}), 5e-4);
    }

    @Test
    void emissionAsInMitsuba() {
        assertArrayEquals(
                new double[] {1.19969, 0.94952, 0.903443},
                SpectralColors.emission(FOUR, new double[] {1, 1, 1, 1}),
                1.5e-3);
        assertArrayEquals(
                new double[] {0.340989, 0.358583, 0.276004},
                SpectralColors.emission(FOUR, new double[] {0.1, 0.5, 0.2, 0.9}),
                1e-3);
    }

    /** At 6504 K the colour is near that of daylight; the luminance is that of a sum over Planck's law. */
    @Test
    void blackbodies() {
        double[] day = SpectralColors.blackbody(6504);
        assertEquals(1.05, day[2] / day[1], 0.05);
        assertEquals(1.05, day[0] / day[1], 0.05);
        double[] warm = SpectralColors.blackbody(2000);
        assertEquals(0, warm[2], 0.02 * warm[0]);
        // Wien's approximation holds to 1e-3 in the visible at 2000 K: c1/l^5 exp(-c2/lT) at 555 nm is 5.3 W/(m2 sr
        // nm).
        double green = 2
                * 6.62607015e-34
                * 299_792_458.0
                * 299_792_458.0
                * 1e36
                / Math.pow(555, 5)
                * Math.exp(-0.01438776877e9 / (555 * 2000));
        double luminance = 0.212671 * warm[0] + 0.715160 * warm[1] + 0.072169 * warm[2];
        assertEquals(1.3, luminance / green, 0.3);
    }
}
