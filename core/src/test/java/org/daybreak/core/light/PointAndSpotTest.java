package org.daybreak.core.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.math.Transform;
import org.junit.jupiter.api.Test;

class PointAndSpotTest {
    private final LightSample sample = new LightSample();

    @Test
    void pointLightFallsWithTheSquareOfTheDistance() {
        Light light = new PointLight(0, 3, 4, new Spectrum(1, 2, 3));
        assertTrue(light.sampleIncident(0, 0, 0, 0.5, 0.5, sample));
        assertEquals(5, sample.distance, 1e-15);
        assertEquals(2.0 / 25, sample.weight.g, 1e-15);
        assertEquals(0.6, sample.wiY, 1e-15);
        double luminance = new Spectrum(1, 2, 3).luminance();
        assertEquals(luminance / 25 * 0.8, light.importance(0, 0, 0, 0, 0, 1), 1e-12);
        assertEquals(luminance / 25, light.importance(0, 0, 0, 0, 0, 0), 1e-12);
        assertEquals(0, light.importance(0, 0, 0, 0, 0, -1));
        assertFalse(light.sampleIncident(0, 3, 4, 0.5, 0.5, sample), "at the light itself");
    }

    /** Values from Mitsuba 3.9.1 ({@code spot.sample_direction}, scalar_rgb): intensity 2, cutoff 40°, beam 15°, distance 2. */
    @Test
    void spotFallsOffAsInMitsuba() {
        Light light = new SpotLight(Transform.identity(), new Spectrum(2, 3, 5), 40, 15);
        double[][] table = {{0, 0.5}, {10, 0.5}, {14.9, 0.5}, {15.1, 0.498}, {20, 0.4}, {30, 0.2}, {39.9, 0.00199995}};
        for (double[] row : table) {
            double angle = Math.toRadians(row[0]);
            assertTrue(light.sampleIncident(2 * Math.sin(angle), 0, 2 * Math.cos(angle), 0.5, 0.5, sample));
            assertEquals(row[1], sample.weight.r, 1e-6);
            assertEquals(2.5 * row[1], sample.weight.b, 1e-6);
        }
        double outside = Math.toRadians(40.1);
        assertFalse(light.sampleIncident(2 * Math.sin(outside), 0, 2 * Math.cos(outside), 0.5, 0.5, sample));
        assertEquals(0, light.importance(2 * Math.sin(outside), 0, 2 * Math.cos(outside), 0, 0, 0));
    }

    @Test
    void spotShinesAlongItsAxisInTheWorld() {
        Transform place = Transform.lookAt(1, 2, 3, 4, 5, 1, 0, 1, 0).multiply(Transform.scale(3, 3, 3));
        Light light = new SpotLight(place, new Spectrum(1, 1, 1), 5, 4);
        assertTrue(light.sampleIncident(4, 5, 1, 0.5, 0.5, sample));
        assertEquals(1.0 / 22, sample.weight.g, 1e-12);
        assertEquals(Math.sqrt(22), sample.distance, 1e-12);
        assertFalse(light.sampleIncident(1, 2, 4, 0.5, 0.5, sample));
    }

    @Test
    void powerInClosedForm() {
        Spectrum one = new Spectrum(1, 1, 1);
        assertEquals(4 * Math.PI, new PointLight(0, 0, 0, one).power(), 1e-12);
        assertEquals(4 * Math.PI, new SpotLight(Transform.identity(), one, 180, 180).power(), 1e-12);
        assertEquals(
                2 * Math.PI * (1 - Math.cos(Math.toRadians(30))),
                new SpotLight(Transform.identity(), one, 30, 30).power(),
                1e-12);
    }

    @Test
    void badAnglesAreRefused() {
        assertRefused(0, 0, "cutoff");
        assertRefused(181, 20, "cutoff");
        assertRefused(Double.NaN, 20, "cutoff");
        assertRefused(20, 21, "beam");
        assertRefused(20, -1, "beam");
    }

    private static void assertRefused(double cutoff, double beam, String part) {
        IllegalArgumentException e = assertThrows(
                IllegalArgumentException.class,
                () -> new SpotLight(Transform.identity(), new Spectrum(1, 1, 1), cutoff, beam));
        assertTrue(e.getMessage().contains(part), e.getMessage());
    }
}
