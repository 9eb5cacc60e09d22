package org.daybreak.tracing;

import java.util.Map;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Path and light tracing share no estimator but must show the same picture. Welch's t-tests on block means of independent
 * runs; false-alarm rate 1e-5 per assertion, Šidák-corrected over the blocks.
 */
final class AgreementTest {
    private static void assertAgree(Scene scene, Map<String, String> path, Map<String, String> light, String channel) {
        double[][] first = Rendering.blocks(Rendering.renderer("path", path), scene, channel, 16, 32, 8);
        double[][] second = Rendering.blocks(Rendering.renderer("light", light), scene, channel, 24, 64, 8);
        ZTest.assertNoneRejected("path and light tracing", ZTest.tilesOfRuns(first, second), 1e-5);
    }

    @ParameterizedTest
    @ValueSource(strings = {"2", "3", "-1"})
    void diffuseRoom(String maxDepth) {
        Scene scene = TestScenes.diffuseRoom(40, 24, ReconstructionFilter.BOX);
        assertAgree(scene, Map.of("maxDepth", maxDepth), Map.of("maxDepth", maxDepth, "rrDepth", "2"), "G");
    }

    /** Near the edges of the film the two normalise differently, but estimate the same. */
    @ParameterizedTest
    @ValueSource(strings = {"GAUSSIAN", "MITCHELL"})
    void filtersMeanTheSame(String filter) {
        ReconstructionFilter f =
                filter.equals("GAUSSIAN") ? ReconstructionFilter.GAUSSIAN : ReconstructionFilter.MITCHELL;
        Scene scene = TestScenes.diffuseRoom(16, 8, f);
        double[][] first =
                Rendering.blocks(Rendering.renderer("path", Map.of("maxDepth", "2")), scene, "R", 16, 256, 1);
        double[][] second =
                Rendering.blocks(Rendering.renderer("light", Map.of("maxDepth", "2")), scene, "R", 24, 512, 1);
        // Adjacent pixels share samples; Šidák's level is then too strict, never too lax.
        ZTest.assertNoneRejected("filtered pixels", ZTest.tilesOfRuns(first, second), 1e-5);
    }

    /** Alpha masks on the way of eye, light and shadow rays; area, sphere and point lights and an environment. */
    @Test
    void veiledRoom() {
        assertAgree(TestScenes.veiledRoom(40, 24), Map.of(), Map.of(), "B");
    }

    /** The number from which Russian roulette acts changes the noise, not the mean. */
    @Test
    void russianRouletteIsUnbiased() {
        Scene scene = TestScenes.cornell(40, 24);
        double[][] early = Rendering.blocks(Rendering.renderer("path", Map.of("rrDepth", "1")), scene, "R", 16, 64, 8);
        double[][] late = Rendering.blocks(Rendering.renderer("path", Map.of("rrDepth", "20")), scene, "R", 16, 64, 8);
        ZTest.assertNoneRejected("roulette", ZTest.tilesOfRuns(early, late), 1e-5);
    }
}
