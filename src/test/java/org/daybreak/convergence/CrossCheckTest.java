package org.daybreak.convergence;

import java.util.Set;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Path tracing against light tracing, which have nothing in common but scene and materials: one walks from the camera and
 * weights two techniques for direct light, the other walks from the lights with adjoint scattering functions. Each emitter
 * kind, mirrored shapes, shading normals, media and lenses must come out the same.
 *
 * <p>Welch's t-test of tile means over independent runs, all tiles, channels and the means of the image with a false-alarm
 * rate of 1e-4 per scene by Šidák's correction. Seeds are fixed.
 */
class CrossCheckTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int RUNS = 24;
    private static final int REFERENCE_FACTOR = 32;

    /** Where one of the two has a large variance and takes more samples. */
    private static final Set<String> DIFFICULT = Set.of(
            "light in glass",
            "inside of a glass sphere",
            "image environment",
            "directional",
            "orthographic camera",
            "environment camera");

    static Set<String> scenes() {
        return CrossScenes.all().keySet();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void pathAndLightTracingAgree(String name) {
        check(name, 1, 8, 0.05);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("scenes")
    void pathAndLightTracingAgreeClosely(String name) {
        check(name, REFERENCE_FACTOR, 4, 0.01);
    }

    private static void check(String name, int factor, int tile, double detectable) {
        Scene scene = SceneCompiler.compile(CrossScenes.all().get(name));
        int samples = factor * (DIFFICULT.contains(name) ? 4 : 1);
        Runs path = Runs.of(Rendering.renderer("path"), scene, 3000, RUNS, 4L * samples);
        Runs light = Runs.of(Rendering.renderer("light"), scene, 4000, RUNS, 8L * samples);
        path.assertAgreement(name, light, tile, detectable, SIGNIFICANCE);
    }
}
