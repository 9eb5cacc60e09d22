package org.daybreak.core.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;

class EnvironmentTest {
    /** Direction and radiance, from Mitsuba 3.9.1 ({@code envmap.eval}, scalar_rgb) for the 8×5 panorama at scale 2. */
    private static final double[][] MITSUBA = {
        {0.363537, 0.864299, 0.347603, 2.859689, 2.470921, 1.054073},
        {-0.790571, 0.549242, 0.270797, 3.177278, 1.375589, 0.469487},
        {-0.616362, 0.667058, 0.418488, 3.447135, 1.234344, 0.846890},
        {0.473290, 0.045734, 0.879719, 2.188434, 2.768078, 0.736187},
        {-0.822690, -0.181986, -0.538574, 0.970083, 2.796793, 0.851603},
        {0.896977, 0.059497, -0.438054, 2.987673, 4.166982, 0.441163},
    };

    private final Spectrum radiance = new Spectrum();
    private final SurfacePoint unused = new SurfacePoint();

    @Test
    void panoramaLooksAsInMitsuba() {
        Transform turn = Transform.rotate(1, 2, 3, 70).multiply(Transform.scale(-1, 1, 1));
        Light light = LightCases.environment(LightCases.panorama(8, 5), turn);
        for (double[] row : MITSUBA) {
            light.radiance(unused, -row[0], -row[1], -row[2], radiance);
            // Six decimals of the direction and single precision on the other side.
            assertEquals(row[3], radiance.r, 3e-5);
            assertEquals(row[4], radiance.g, 3e-5);
            assertEquals(row[5], radiance.b, 3e-5);
        }
    }

    @Test
    void pixelsLieWhereTheConventionSays() {
        Light light = LightCases.environment(LightCases.spots(8, 5, 2, 1), Transform.identity());
        double theta = Math.PI / 4;
        double phi = 2 * Math.PI * 2.5 / 8;
        double x = Math.sin(phi) * Math.sin(theta);
        double z = -Math.cos(phi) * Math.sin(theta);
        light.radiance(unused, -x, -Math.cos(theta), -z, radiance);
        assertEquals(10, radiance.r, 1e-12);
        light.radiance(unused, x, -Math.cos(theta), -z, radiance);
        assertTrue(radiance.isBlack());
    }

    @Test
    void polesAreFiniteAndSampled() {
        for (double y : new double[] {1, -1}) {
            Light light = LightCases.environment(LightCases.panorama(8, 5), Transform.identity());
            light.radiance(unused, 0, -y, 0, radiance);
            assertTrue(radiance.isFinite() && radiance.max() > 0);
            double density = light.incidentDensity(0, 0, 0, unused, 0, y, 0);
            assertTrue(density > 1 && Double.isFinite(density));
        }
    }

    /** Where a pixel is black but its neighbour is not, there is still radiance, and so there must be density. */
    @Test
    void densityIsPositiveWhereRadianceIs() {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        for (LightCases.Case c : LightCases.infinite()) {
            int bright = 0;
            for (int i = 0; i < 20_000; i++) {
                double y = 2 * random.nextDouble() - 1;
                double phi = 2 * Math.PI * random.nextDouble();
                double x = Math.sqrt(1 - y * y) * Math.cos(phi);
                double z = Math.sqrt(1 - y * y) * Math.sin(phi);
                c.light().radiance(unused, -x, -y, -z, radiance);
                double density = c.light().incidentDensity(0, 0, 0, unused, x, y, z);
                assertEquals(radiance.max() > 0, density > 0, c.name());
                bright += radiance.max() > 0 ? 1 : 0;
            }
            assertTrue(bright > 20, c.name());
        }
    }

    /** Luminance over density is constant within a cell but for sin θ, so the weights of a smooth map vary little. */
    @Test
    void weightsVaryLittle() {
        Light light = LightCases.environment(LightCases.spots(64, 33, 20, 15), Transform.identity());
        LightSample sample = new LightSample();
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        Moments weights = new Moments();
        for (int i = 0; i < 20_000; i++) {
            light.sampleIncident(0, 0, 0, random.nextDouble(), random.nextDouble(), sample);
            weights.add(sample.weight.luminance());
        }
        assertTrue(Math.sqrt(weights.variance()) < 0.03 * weights.mean());
        // Its irradiance is the tent's solid angle times the peak: (2π/64)·(π/32)·sin θ times 10, 8, 6, integrated over
        // rows.
        assertEquals(light.importance(0, 0, 0, 0, 0, 0), weights.mean(), 1e-3 * weights.mean());
    }

    @Test
    void irradianceOfAConstantSkyIsPi() {
        Light light = new ConstantEnvironment(new Spectrum(1, 1, 1), 0, 0, 0, 1);
        RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
        LightSample sample = new LightSample();
        Moments moments = new Moments();
        for (int i = 0; i < 100_000; i++) {
            light.sampleIncident(1, 2, 3, random.nextDouble(), random.nextDouble(), sample);
            moments.add(sample.weight.g * Math.max(0, sample.wiY));
        }
        // False-alarm rate 1e-4.
        ZTest.assertNotRejected("sky", ZTest.oneSample(moments, Math.PI), 1e-4);
        assertEquals(Math.PI, light.importance(1, 2, 3, 0, 1, 0), 1e-9);
        // A constant panorama is the same light.
        float[] white = new float[3 * 16 * 8];
        java.util.Arrays.fill(white, 1);
        Light image = new ImageEnvironment(new RadianceMap(16, 8, white), 1, LightCases.TURN, 0, 0, 0, 1);
        assertEquals(light.power(), image.power(), 1e-9 * light.power());
        assertEquals(Math.PI, image.importance(1, 2, 3, 0, 1, 0), 0.02);
    }

    /** An empty scene under a sky still shows the sky: only emission into the scene has no power. */
    @Test
    void emptyScenesHaveASky() {
        Light[] lights = {
            new ConstantEnvironment(new Spectrum(3, 2, 1), 0, 0, 0, 0),
            new ImageEnvironment(LightCases.panorama(8, 5), 1, LightCases.TURN, 0, 0, 0, 0)
        };
        EmissionDensity density = new EmissionDensity();
        for (Light light : lights) {
            assertEquals(0, light.power());
            assertFalse(light.sampleEmission(0.5, 0.5, 0.5, 0.5, new EmissionSample()));
            light.emissionDensity(unused, 0, 1, 0, density);
            assertEquals(0, density.position);
            assertTrue(light.sampleIncident(0, 0, 0, 0.3, 0.7, new LightSample()));
            assertTrue(light.incidentDensity(0, 0, 0, unused, 0, 0.6, 0.8) > 0);
            light.radiance(unused, 0, -0.6, -0.8, radiance);
            assertTrue(radiance.max() > 0);
            assertTrue(LightSelections.forLights(java.util.List.of(light))
                    .choose(0, 0, 0, 0, 1, 0, 0.5, new LightChoice()));
        }
    }

    @Test
    void blackPanoramasAreHarmless() {
        Light light = new ImageEnvironment(new RadianceMap(4, 3, new float[36]), 1, Transform.identity(), 0, 0, 0, 1);
        assertEquals(0, light.power());
        assertFalse(light.sampleIncident(0, 0, 0, 0.5, 0.5, new LightSample()));
        assertFalse(light.sampleEmission(0.5, 0.5, 0.5, 0.5, new EmissionSample()));
        assertEquals(0, light.importance(0, 0, 0, 0, 1, 0));
        assertEquals(0, new ConstantEnvironment(new Spectrum(), 0, 0, 0, 1).importance(0, 0, 0, 0, 1, 0));
    }

    @Test
    void badScalesAreRefused() {
        RadianceMap map = LightCases.panorama(2, 2);
        for (double scale : new double[] {-1, Double.NaN, Double.POSITIVE_INFINITY}) {
            IllegalArgumentException e = assertThrows(
                    IllegalArgumentException.class,
                    () -> new ImageEnvironment(map, scale, Transform.identity(), 0, 0, 0, 1));
            assertTrue(e.getMessage().contains(Double.toString(scale)));
        }
    }
}
