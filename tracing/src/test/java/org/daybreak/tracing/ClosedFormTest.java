package org.daybreak.tracing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.BitmapTexture;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Texture;
import org.daybreak.core.material.TextureImage;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Scenes whose picture is known exactly. Each assertion has a false-alarm rate of 1e-5: t-tests on block means of
 * independent runs, with Šidák's correction over blocks.
 */
final class ClosedFormTest {
    private static final double FALSE_ALARM = 1e-5;
    private static final int RUNS = 16;

    private static void assertBlocks(Renderer renderer, Scene scene, int spp, int block, double[] expected) {
        double[][] runs = Rendering.blocks(renderer, scene, "G", RUNS, spp, block);
        double[] pValues = new double[expected.length];
        for (int i = 0; i < expected.length; i++) {
            Moments moments = new Moments();
            double spread = 0;
            for (double[] run : runs) {
                moments.add(run[i]);
                spread = Math.max(spread, Math.abs(run[i] - runs[0][i]));
            }
            // Pictures that are exact in every sample differ by the rounding of the image to floats only.
            pValues[i] = spread < 1e-6 * Math.abs(expected[i])
                    ? Math.abs(moments.mean() - expected[i]) < 1e-6 * Math.abs(expected[i]) ? 1 : 0
                    : ZTest.oneSample(moments, expected[i]);
        }
        ZTest.assertNoneRejected("blocks", pValues, FALSE_ALARM);
    }

    private static double[] constant(double value, int blocks) {
        double[] expected = new double[blocks];
        java.util.Arrays.fill(expected, value);
        return expected;
    }

    /** Every wall emits 1 and reflects ρ = ½: n edges give Σ_{i<n} ρ^i, without limit 1/(1 − ρ). */
    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1.5", "3, 1.75", "4, 1.875", "-1, 2"})
    void furnaceBox(String maxDepth, double radiance) {
        Scene scene = TestScenes.furnaceBox(16);
        Map<String, String> parameters = Map.of("maxDepth", maxDepth, "rrDepth", "2");
        assertBlocks(Rendering.renderer("path", parameters), scene, 16, 8, constant(radiance, 4));
        assertBlocks(Rendering.renderer("light", parameters), scene, 64, 8, constant(radiance, 4));
    }

    @Test
    void classicRayTracingSeesDirectLightOnly() {
        assertBlocks(Rendering.renderer("raytracer", Map.of()), TestScenes.furnaceBox(16), 16, 8, constant(1.5, 4));
    }

    @Test
    void noEdgesNoLight() {
        for (String id : new String[] {"path", "raytracer", "light"}) {
            FilmImage image =
                    Rendering.image(Rendering.renderer(id, Map.of("maxDepth", "0")), TestScenes.furnaceBox(4), 1, 4);
            assertEquals(0, image.mean("R"));
        }
    }

    /** A white sphere in a white environment cannot be seen. */
    @Test
    void furnaceSphere() {
        Scene scene = TestScenes.furnaceSphere(1, 16);
        for (String id : new String[] {"path", "raytracer", "light"}) {
            assertBlocks(Rendering.renderer(id, Map.of()), scene, 32, 4, constant(1, 16));
        }
    }

    /** An empty scene under a sky shows the sky. */
    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light"})
    void emptySceneShowsTheSky(String id) {
        assertBlocks(Rendering.renderer(id, Map.of()), TestScenes.sky(16, 12), 32, 4, constant(2, 12));
    }

    /** Block means of the radiance ρ/π·I·cos θ/d² = ρ/π·I·h/(h² + r²)^{3/2} under the light of the scene of that name. */
    private static double[] radianceUnderPoint(int size, double factor) {
        int n = 64;
        double half = 6 * Math.tan(Math.toRadians(30));
        int blocks = size / 4;
        double[] expected = new double[blocks * blocks];
        for (int i = 0; i < size * n; i++) {
            for (int j = 0; j < size * n; j++) {
                double x = half * (2 * (i + 0.5) / (size * n) - 1);
                double z = half * (2 * (j + 0.5) / (size * n) - 1);
                double d = Math.sqrt(4 + x * x + z * z);
                expected[j / (4 * n) * blocks + i / (4 * n)] +=
                        factor * 0.5 / Math.PI * 10 * 2 / (d * d * d) / (16.0 * n * n);
            }
        }
        return expected;
    }

    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light"})
    void pointOverPlane(String id) {
        assertBlocks(Rendering.renderer(id, Map.of()), TestScenes.pointOverPlane(16), 32, 4, radianceUnderPoint(16, 1));
    }

    /**
     * Two half transparent sheets, which scatter nothing, let a quarter of the light through on its way to the plane and a
     * quarter on its way to the eye, whether the opacity is constant or a texture. They are no vertices of paths: two edges
     * are enough.
     */
    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light"})
    void halfTransparentSheets(String id) {
        Bsdf black = new Diffuse(ConstantTexture.grey(0));
        TextureImage half = TextureImage.fromFloats(2, 1, 1, new float[] {0.5f, 0.5f});
        Texture image = new BitmapTexture(
                half, BitmapTexture.Filter.BILINEAR, BitmapTexture.Wrap.REPEAT, new double[] {1, 0, 0, 0, 1, 0});
        Scene scene = TestScenes.pointOverPlane(16, new Mask(ConstantTexture.grey(0.5), black), new Mask(image, black));
        assertBlocks(Rendering.renderer(id, Map.of("maxDepth", "2")), scene, 256, 4, radianceUnderPoint(16, 1.0 / 16));
    }

    /** Occlusion queries multiply the transparencies of what is in between; no random number decides. */
    @Test
    void shadowRaysAreAttenuated() {
        Bsdf black = new Diffuse(ConstantTexture.grey(0));
        Mask veil = new Mask(ConstantTexture.grey(0.5), black);
        RayCaster caster = new RayCaster(TestScenes.pointOverPlane(16, veil, veil, black));
        SurfacePoint floor = new SurfacePoint();
        SurfacePoint above = new SurfacePoint();
        floor.x = 0.3;
        floor.y = 0.01;
        for (double[] heightAndFraction : new double[][] {{0.4, 1}, {0.7, 0.5}, {1.2, 0.25}, {1.7, 0}}) {
            above.y = heightAndFraction[0];
            assertEquals(heightAndFraction[1], caster.transmittance(floor, above));
            assertEquals(heightAndFraction[1], caster.transmittance(above, floor));
        }
    }
}
