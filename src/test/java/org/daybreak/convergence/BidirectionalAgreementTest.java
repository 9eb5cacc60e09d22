package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.testing.Grids;
import org.daybreak.core.testing.ZTest;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Bidirectional path tracing against path tracing, with all exponents of the heuristic, and its settings among themselves. Scenes have each
 * emitter kind, mirrored shapes and instances, shading normals, all materials, masks, lenses and parallel rays; some are nothing but a
 * sky.
 *
 * <p>Welch's t-test of tile means over independent runs, all tiles, channels and the means of the image with a false-alarm rate
 * of 1e-4 per scene and setting by Šidák's correction. Seeds are fixed.
 */
class BidirectionalAgreementTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int RUNS = 16;
    private static final int REFERENCE_FACTOR = 8;
    private static final List<String> EXPONENTS = List.of("2", "1", "0");

    /** Each scene with the default exponent, every other one with one of the others, too. */
    static Stream<Arguments> scenesAndExponents() {
        List<Arguments> list = new ArrayList<>();
        int number = 0;
        for (String name : BidirectionalScenes.withCrossScenes().keySet()) {
            list.add(Arguments.of(name, "2"));
            if (number % 2 == 0) {
                list.add(Arguments.of(name, number % 4 == 0 ? "1" : "0"));
            }
            number++;
        }
        return list.stream();
    }

    static Stream<Arguments> scenesAndAllExponents() {
        return BidirectionalScenes.withCrossScenes().keySet().stream()
                .flatMap(name -> EXPONENTS.stream().map(exponent -> Arguments.of(name, exponent)));
    }

    @ParameterizedTest
    @MethodSource("scenesAndExponents")
    void agreesWithPathTracing(String name, String exponent) {
        checkAgainstPath(name, exponent, 1, 8, 0.1);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("scenesAndAllExponents")
    void agreesCloselyWithPathTracing(String name, String exponent) {
        checkAgainstPath(name, exponent, REFERENCE_FACTOR, 6, 0.05);
    }

    private static void checkAgainstPath(String name, String exponent, int factor, int tile, double detectable) {
        Scene scene =
                SceneCompiler.compile(BidirectionalScenes.withCrossScenes().get(name));
        Runs path = Runs.of(Rendering.renderer("path"), scene, 3000, RUNS, 6L * factor);
        Map<String, String> parameters = new HashMap<>(Map.of("heuristicExponent", exponent));
        if (name.equals("lights of every kind")) {
            // Only light subpaths find what points and directions send through ideal glass or over mirrors.
            parameters.put("maxLightDepth", "1");
        }
        // Equal weights scatter more.
        int samples = exponent.equals("0") ? 2 * factor : factor;
        Runs both = runs(scene, 6000, parameters, 3L * samples);
        // Equal weights let the variance of the worst technique in.
        double found = (exponent.equals("0") || name.equals("within glass") ? 3 : 1) * detectable;
        path.assertAgreement(name + ", β = " + exponent, both, tile, found, SIGNIFICANCE);
    }

    /** Settings that must not change the mean, each against another one. */
    static Stream<Arguments> settings() {
        return Stream.of(
                Arguments.of("all kinds", "", "lightsPerPath=all"),
                Arguments.of("lights of every kind", "", "lightsPerPath=all heuristicExponent=1"),
                Arguments.of("instances", "", "lightsPerPath=all"),
                Arguments.of("lamp, glass and metal, thin lens", "", "causticMap=false"),
                Arguments.of("shading normals", "", "causticMap=false"),
                Arguments.of("masks", "", "causticMap=false"),
                Arguments.of("veils", "maxDepth=6", "maxDepth=6 russianRoulette=none"),
                Arguments.of(
                        "materials 1",
                        "maxDepth=6 russianRoulette=none",
                        "maxDepth=6 russianRoulette=throughput rrDepth=1"),
                Arguments.of(
                        "materials 3",
                        "maxDepth=6 russianRoulette=none",
                        "maxDepth=6 russianRoulette=efficiency rrDepth=1"),
                Arguments.of("sphere", "russianRoulette=throughput", "russianRoulette=efficiency"),
                Arguments.of("materials 4", "", "splitting=4"),
                Arguments.of("glass and metal under a panorama", "", "splitting=3 heuristicExponent=1"),
                Arguments.of("masks", "splitting=5 rrDepth=1", "maxLightDepth=1 splitting=2"),
                Arguments.of("rough materials", "", "maxEyeDepth=2"),
                Arguments.of("rough materials", "", "maxEyeDepth=1"),
                Arguments.of("image environment", "", "maxEyeDepth=1"),
                Arguments.of("empty scene under a panorama", "", "maxEyeDepth=1"),
                Arguments.of("empty scene under a panorama, thin lens", "", "maxEyeDepth=1"),
                Arguments.of("empty scene under a sky, parallel rays", "", "maxEyeDepth=1"),
                Arguments.of("rough materials", "", "maxLightDepth=1"),
                Arguments.of("rough materials", "", "maxLightDepth=2 heuristicExponent=1"),
                Arguments.of("veils", "maxDepth=5", "maxEyeDepth=5 maxLightDepth=3 maxDepth=5"),
                Arguments.of("image environment", "", "maxEyeDepth=3 heuristicExponent=0"));
    }

    @ParameterizedTest
    @MethodSource("settings")
    void settingsDoNotChangeTheMean(String name, String first, String second) {
        checkSettings(name, first, second, 1, 8, 0.1);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("settings")
    void settingsHardlyChangeTheMean(String name, String first, String second) {
        checkSettings(name, first, second, REFERENCE_FACTOR, 6, 0.05);
    }

    private static void checkSettings(
            String name, String first, String second, int factor, int tile, double detectable) {
        Scene scene =
                SceneCompiler.compile(BidirectionalScenes.withCrossScenes().get(name));
        Runs runs1 = runs(scene, 7000, Rendering.parameters(first), 4L * factor);
        Runs runs2 = runs(scene, 8000, Rendering.parameters(second), 4L * factor);
        // Few light paths that start at the sky come to the lens.
        double found = (second.contains("maxEyeDepth=1") ? 3 : 1) * detectable;
        runs1.assertAgreement(name + ", " + first + " and " + second, runs2, tile, found, SIGNIFICANCE);
    }

    /** Light subpaths of the samples of a crop are as many as those, and find the pixels of the crop as often as others. */
    @Test
    void cropHasTheMeansOfThatPartOfTheImage() throws SceneException {
        Renderer renderer = Rendering.renderer("bidirectional");
        SceneGraph graph = ShippedScenes.read("cornell_spheres/scene.xml").graph();
        Runs whole = Runs.of(renderer, ShippedScenes.compile(graph, 48, 32), 9000, RUNS, 4);
        FilmSettings.Crop crop = new FilmSettings.Crop(12, 8, 24, 16);
        graph.setFilm(new FilmSettings(48, 32, crop, ReconstructionFilter.BOX));
        Scene scene = SceneCompiler.compile(graph);
        double[][] expected = new double[RUNS][];
        double[][] actual = new double[RUNS][];
        for (int i = 0; i < RUNS; i++) {
            double[] part = new double[crop.width() * crop.height()];
            FilmImage image = whole.images().get(i);
            for (int j = 0; j < part.length; j++) {
                part[j] = image.get("G", crop.x() + j % crop.width(), crop.y() + Math.floorDiv(j, crop.width()));
            }
            expected[i] = Grids.tileMeans(part, crop.width(), 8);
            float[] values = Rendering.render(renderer, scene, 9500 + i, 8).channel("G");
            assertEquals(part.length, values.length);
            actual[i] = Grids.tileMeans(Runs.toDoubles(values), crop.width(), 8);
        }
        ZTest.assertNoneRejected("crop", ZTest.tilesOfRuns(expected, actual), SIGNIFICANCE);
    }

    private static Runs runs(Scene scene, long seed, Map<String, String> parameters, long samplesPerPixel) {
        return Runs.of(Rendering.renderer("bidirectional", parameters), scene, seed, RUNS, samplesPerPixel);
    }
}
