package org.daybreak.core.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Texture;
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

    /** Texture coordinates from Mitsuba 3.9.1: a slide of u and v, cutoff 40°, at (a, b, 1) before the light. */
    @Test
    void slidesAreProjectedAsInMitsuba() {
        Texture coordinates = new Texture() {
            @Override
            public void evaluate(SurfacePoint point, Spectrum out) {
                out.set(Math.floor(8 * point.u) / 8, Math.floor(8 * point.v) / 8, 0.5);
            }

            @Override
            public double evaluateScalar(SurfacePoint point) {
                return 0;
            }

            @Override
            public void mean(Spectrum out) {
                out.set(0.5, 0.5, 0.5);
            }

            @Override
            public double maximum() {
                return 1;
            }
        };
        Light light = new SpotLight(Transform.identity(), new Spectrum(1, 1, 1), 40, 40, coordinates);
        double[][] table = {{0.1, 0.05, 0.5, 0.5}, {0.5, 0, 0.75, 0.5}, {0, 0.5, 0.5, 0.75}, {-0.3, 0.4, 0.25, 0.625}};
        for (double[] row : table) {
            assertTrue(light.sampleIncident(row[0], row[1], 1, 0.5, 0.5, sample));
            double squared = row[0] * row[0] + row[1] * row[1] + 1;
            assertEquals(row[2], sample.weight.r * squared, 1e-12);
            assertEquals(row[3], sample.weight.g * squared, 1e-12);
        }
        assertThrows(
                IllegalArgumentException.class,
                () -> new SpotLight(Transform.identity(), new Spectrum(1, 1, 1), 90, 40, coordinates));
    }

    @Test
    void profilesAreBilinearAndSymmetric() {
        PhotometricProfile profile =
                new PhotometricProfile(new double[] {0, 90}, new double[] {0, 90}, new double[] {100, 0, 100, 300});
        assertEquals(100, profile.candela(0, 0, 1), 1e-9);
        double half = Math.sqrt(0.5);
        assertEquals(50, profile.candela(half, 0, half), 1e-9);
        assertEquals(200, profile.candela(0, half, half), 1e-9);
        assertEquals(200, profile.candela(0, -half, half), 1e-9);
        assertEquals(125, profile.candela(-0.5, 0.5, half), 1e-9);
        assertEquals(125, profile.candela(-0.5, -0.5, half), 1e-9);
        assertEquals(0, profile.candela(half, 0, -half));
        assertEquals(300, profile.maximum());
        // 1000 cd in all directions are 1000/683 W/sr.
        Light even = new PhotometricLight(
                new PhotometricProfile(new double[] {0, 180}, new double[] {0}, new double[] {1000, 1000}),
                new Spectrum(1, 1, 1),
                Transform.translate(0, 0, 2));
        assertTrue(even.sampleIncident(0, 0, 0, 0.5, 0.5, sample));
        assertEquals(1000 / 683.002 / 4, sample.weight.g, 1e-9);
        assertEquals(4 * Math.PI * 1000 / 683.002, even.power(), 1e-9);
    }
}
