package org.daybreak.core.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javax.vecmath.Point3d;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfaceCase;
import org.daybreak.core.geometry.SurfaceSamplers;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class AreaLightTest {
    /** False-alarm rate of each statistical test. */
    private static final double SIGNIFICANCE = 1e-4;

    private static final TestTexture ONE = new TestTexture(1, 1, 1, false);

    /** A sphere of unit radiance high in the sky causes π (R/d)² cos θ. */
    @Test
    void irradianceOfASphere() {
        Light light = new AreaLight(
                SurfaceSamplers.of(new Sphere(new Point3d(0, 0, 3), 1), Transform.identity(), false), ONE, 0);
        double expected = Math.PI / 9 * 0.8;
        assertIrradiance(light, 0.6, 0, 0.8, expected);
        assertEquals(expected, light.importance(0, 0, 0, 0.6, 0, 0.8), 1e-12);
        // Partly below the horizon, the estimate is exact too.
        for (double[] n : new double[][] {{1, 0, 0}, {0.96, 0, -0.28}, {0.96, 0, 0.28}}) {
            ZTest.assertNotRejected(
                    "clipped sphere",
                    ZTest.oneSample(
                            estimate(light, n[0], n[1], n[2], 100_000), light.importance(0, 0, 0, n[0], n[1], n[2])),
                    Significance.sidak(SIGNIFICANCE, 3));
        }
        assertEquals(0, light.importance(0, 0, 0, 0.936, 0, -0.352));
    }

    /** A disk of unit radiance overhead causes π R²/(R² + h²). */
    @Test
    void irradianceOfADisk() {
        Transform place = Transform.translate(0, 0, 2).multiply(Transform.scale(1.5, 1.5, -1));
        Light light = new AreaLight(SurfaceSamplers.of(new Disk(), place, false), ONE, 0);
        double expected = Math.PI * 2.25 / (2.25 + 4);
        assertIrradiance(light, 0, 0, 1, expected);
        assertEquals(expected, light.importance(0, 0, 0, 0, 0, 1), 0.02 * expected);
    }

    /** A rectangle above a corner: ½ (a/√(1+a²) · atan(b/√(1+a²)) + b/√(1+b²) · atan(a/√(1+b²))) for height 1. */
    @Test
    void irradianceOfARectangle() {
        double a = 1.4;
        double b = 0.6;
        Transform place = Transform.translate(a / 2, b / 2, 1).multiply(Transform.scale(a / 2, b / 2, -1));
        Light light = new AreaLight(SurfaceSamplers.of(new Rectangle(), place, false), ONE, 0);
        double sa = Math.sqrt(1 + a * a);
        double sb = Math.sqrt(1 + b * b);
        double expected = 0.5 * (a / sa * Math.atan(b / sa) + b / sb * Math.atan(a / sb));
        assertIrradiance(light, 0, 0, 1, expected);
        // All of it is above the horizon, so only the arc cosine is approximate.
        assertEquals(expected, light.importance(0, 0, 0, 0, 0, 1), 2e-4 * expected);
    }

    /**
     * The quality of light choice rests on this: for surfaces that are above the horizon and not next door, the estimate is the true
     * irradiance within a factor.
     */
    @ParameterizedTest
    @MethodSource("outwardSurfaces")
    void importanceIsCloseToTheIrradiance(SurfaceCase surface) {
        Light light = new AreaLight(surface.sampler(), ONE, 0);
        RandomStream random = new RandomStream(6, StreamDomain.SELF_CHECK, 0, 0);
        LightSample sample = new LightSample();
        int compared = 0;
        for (int i = 0; i < 300; i++) {
            double z = 2 * random.nextDouble() - 1;
            double phi = 2 * Math.PI * random.nextDouble();
            double distance = 4 + 16 * random.nextDouble();
            double px = distance * Math.sqrt(1 - z * z) * Math.cos(phi);
            double py = distance * Math.sqrt(1 - z * z) * Math.sin(phi);
            double pz = distance * z;
            double sum = 0;
            int samples = 400;
            for (int k = 0; k < samples; k++) {
                if (light.sampleIncident(px, py, pz, random.nextDouble(), random.nextDouble(), sample)) {
                    sum += sample.weight.g
                            * Math.max(0, -(sample.wiX * px + sample.wiY * py + sample.wiZ * pz))
                            / distance;
                }
            }
            double truth = sum / samples;
            double estimate = light.importance(px, py, pz, -px / distance, -py / distance, -pz / distance);
            // Edge-on views are dim, and there only positivity counts.
            if (truth > 0.1 / (distance * distance)) {
                compared++;
                assertTrue(
                        estimate > 0.6 * truth && estimate < 2.2 * truth,
                        surface + " from distance " + distance + ": " + estimate + " for " + truth);
            }
        }
        assertTrue(compared > 80, "compared " + compared);
    }

    static List<SurfaceCase> outwardSurfaces() {
        return SurfaceCase.all().stream()
                .filter(c -> !c.name().contains("flipped"))
                .toList();
    }

    @Test
    void blackLightsEmitNothing() {
        Light light = new AreaLight(
                SurfaceSamplers.of(new Rectangle(), Transform.identity(), false), new TestTexture(0, 0, 0, false), 0);
        assertEquals(0, light.power());
        assertEquals(0, light.importance(0, 0, 1, 0, 0, -1));
        assertTrue(!light.sampleIncident(0, 0, 1, 0.5, 0.5, new LightSample()));
        assertTrue(!light.sampleEmission(0.5, 0.5, 0.5, 0.5, new EmissionSample()));
    }

    @Test
    void radianceFollowsTheTexture() {
        Light light = new AreaLight(
                SurfaceSamplers.of(new Rectangle(), Transform.identity(), false), new TestTexture(1, 2, 3, true), 0);
        LightSample sample = new LightSample();
        assertTrue(light.sampleIncident(0, 0, 500, 0.75, 0.25, sample));
        Spectrum radiance = new Spectrum();
        light.radiance(sample.point, 0, 0, 1, radiance);
        assertEquals(0.2 + 0.75 - 0.1, radiance.r, 1e-9);
        assertEquals(3 * radiance.r, radiance.b, 1e-12);
    }

    private static void assertIrradiance(Light light, double nx, double ny, double nz, double expected) {
        Moments moments = estimate(light, nx, ny, nz, 20_000);
        if (Math.abs(moments.mean() - expected) > 1e-9 * expected) {
            ZTest.assertNotRejected(
                    "irradiance", ZTest.oneSample(moments, expected), Significance.sidak(SIGNIFICANCE, 3));
        }
    }

    private static Moments estimate(Light light, double nx, double ny, double nz, int samples) {
        LightSample sample = new LightSample();
        RandomStream random = new RandomStream(7, StreamDomain.SELF_CHECK, 0, 0);
        Moments moments = new Moments();
        for (int i = 0; i < samples; i++) {
            boolean arrives = light.sampleIncident(0, 0, 0, random.nextDouble(), random.nextDouble(), sample);
            double cosine = sample.wiX * nx + sample.wiY * ny + sample.wiZ * nz;
            moments.add(arrives ? sample.weight.g * Math.max(0, cosine) : 0);
        }
        return moments;
    }
}
