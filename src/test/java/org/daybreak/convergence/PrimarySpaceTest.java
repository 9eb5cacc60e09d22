package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.testing.ZTest;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Chains over random numbers, whole samples ({@code pssmlt}) and single paths ({@code mmlt}), against bidirectional path tracing.
 *
 * <p>Welch's t-test of tile means over independent runs, each with a start of its own; all tiles, channels and the means of the image with a
 * false-alarm rate of 1e-4 per row by Šidák's correction. Seeds are fixed. That the tests can fail is shown on the same runs, one image
 * made brighter.
 */
class PrimarySpaceTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int RUNS = 16;
    private static final String SHORT = "seedPaths=100 bootstrapSamples=4000 ";

    private static SceneGraph graph(String name) throws SceneException {
        Map<String, SceneGraph> scenes = new LinkedHashMap<>(CrossScenes.all());
        scenes.putAll(BidirectionalScenes.all());
        SceneGraph graph = scenes.get(name);
        return graph != null ? graph : ShippedScenes.read(name + "/scene.xml").graph();
    }

    private static Scene scene(String name) throws SceneException {
        SceneGraph graph = graph(name);
        return switch (name) {
            case "cornell_spheres" -> ShippedScenes.compile(graph, 24, 24);
            case "door_ajar" -> ShippedScenes.compile(graph, 27, 15);
            case "gold_ring", "veach_room" -> ShippedScenes.compile(graph, 24, 16);
            default -> SceneCompiler.compile(graph);
        };
    }

    static Stream<Arguments> fewRows() {
        return Stream.of(
                Arguments.of("cornell_spheres", "pssmlt", "separateDirect=false largeStep=1", "", 24, 0.15),
                Arguments.of("cornell_spheres", "pssmlt", "separateDirect=false", "", 24, 0.2),
                Arguments.of("cornell_spheres", "pssmlt", "directSamples=8", "", 24, 0.15),
                Arguments.of("cornell_spheres", "mmlt", "directSamples=8", "", 48, 0.15),
                Arguments.of("cornell_spheres", "mmlt", "separateDirect=false", "", 48, 0.2),
                Arguments.of("lamp, glass and metal, thin lens", "mmlt", "separateDirect=false", "", 48, 0.25),
                Arguments.of("lamp, glass and metal, thin lens", "pssmlt", "separateDirect=false", "", 24, 0.25));
    }

    /** Each scene that ships. */
    static Stream<Arguments> shippedScenes() {
        Stream.Builder<Arguments> rows = Stream.builder();
        for (String renderer : new String[] {"pssmlt", "mmlt"}) {
            for (String scene : new String[] {"cornell_spheres", "gold_ring", "veach_room", "door_ajar"}) {
                rows.add(Arguments.of(scene, renderer, "", "", 200, 0.3));
                rows.add(Arguments.of(scene, renderer, "separateDirect=false", "", 200, 0.3));
            }
        }
        return rows.build();
    }

    /** Each option, each side alone, each kind of camera. */
    static Stream<Arguments> options() {
        Stream.Builder<Arguments> rows = Stream.builder();
        for (String renderer : new String[] {"pssmlt", "mmlt"}) {
            rows.add(Arguments.of("cornell_spheres", renderer, "separateDirect=false largeStep=1", "", 100, 0.15));
            rows.add(Arguments.of("cornell_spheres", renderer, "largeStep=0.05", "", 100, 0.15));
            rows.add(Arguments.of("cornell_spheres", renderer, "expectedValues=false", "", 100, 0.15));
            rows.add(Arguments.of("cornell_spheres", renderer, "twoStage=true reduction=4", "", 100, 0.15));
            rows.add(Arguments.of("cornell_spheres", renderer, "smallestStep=0.01 largestStep=0.3", "", 100, 0.15));
            rows.add(Arguments.of("cornell_spheres", renderer, "heuristicExponent=1", "", 100, 0.15));
            rows.add(Arguments.of("cornell_spheres", renderer, "separateDirect=false", "maxDepth=4", 100, 0.15));
            rows.add(Arguments.of(
                    "cornell_spheres", renderer, "separateDirect=false russianRoulette=none", "maxDepth=5", 100, 0.15));
            rows.add(Arguments.of(
                    "cornell_spheres", renderer, "separateDirect=false", "causticMap=false maxLightDepth=1", 200, 0.3));
            rows.add(Arguments.of("cornell_spheres", renderer, "", "maxLightDepth=3 maxEyeDepth=4", 100, 0.2));
            rows.add(Arguments.of("rough materials", renderer, "separateDirect=false", "maxEyeDepth=1", 100, 0.3));
            rows.add(Arguments.of("rough materials", renderer, "separateDirect=false", "maxLightDepth=1", 100, 0.3));
            rows.add(Arguments.of("lamp, glass and metal, thin lens", renderer, "", "", 100, 0.2));
            rows.add(Arguments.of("image environment", renderer, "separateDirect=false", "", 100, 0.2));
            rows.add(Arguments.of("masks", renderer, "separateDirect=false", "", 100, 0.2));
            rows.add(Arguments.of("point", renderer, "separateDirect=false", "", 100, 0.2));
            rows.add(Arguments.of(
                    "empty scene under a sky, parallel rays",
                    renderer,
                    "separateDirect=false",
                    "maxEyeDepth=1",
                    50,
                    0.2));
        }
        return rows.build();
    }

    /**
     * Compares.
     *
     * @param settings of the chains
     * @param common settings of both
     * @param mutations per pixel
     * @param detectable relative error of the brightness that is found out
     */
    @ParameterizedTest
    @MethodSource("fewRows")
    void agreesWithBidirectional(
            String name, String renderer, String settings, String common, int mutations, double detectable)
            throws SceneException {
        Scene scene = scene(name);
        check(scene, name, renderer, SHORT + settings, common, mutations, 32, detectable);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("shippedScenes")
    void shippedScenesAgree(
            String name, String renderer, String settings, String common, int mutations, double detectable)
            throws SceneException {
        agreesClosely(name, renderer, settings, common, mutations, detectable);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("options")
    void optionsAgree(String name, String renderer, String settings, String common, int mutations, double detectable)
            throws SceneException {
        agreesClosely(name, renderer, settings, common, mutations, detectable);
    }

    private static void agreesClosely(
            String name, String renderer, String settings, String common, int mutations, double detectable)
            throws SceneException {
        Scene scene = scene(name);
        String start = "seedPaths=200 bootstrapSamples=10000 ";
        check(scene, name, renderer, start + settings, common, mutations, 64, detectable);
    }

    private static void check(
            Scene scene,
            String name,
            String renderer,
            String settings,
            String common,
            int mutations,
            int samplesPerPixel,
            double detectable) {
        Map<String, String> parameters = parse(settings + " " + common);
        parameters.put("mutationsPerPixel", Integer.toString(mutations));
        Runs chains = Runs.of(Rendering.renderer(renderer, parameters), scene, 5000, RUNS, mutations);
        Runs samples = Runs.of(Rendering.renderer("bidirectional", parse(common)), scene, 6000, RUNS, samplesPerPixel);
        String row = name + ", " + renderer + ", " + settings + " " + common;
        int tile = Math.min(scene.film().width(), scene.film().height()) / 2;
        ZTest.assertNoneRejected(row, samples.pValues(chains, tile, 1), SIGNIFICANCE);
        for (double wrong : new double[] {1 - detectable, 1 + detectable}) {
            double[] pValues = samples.pValues(chains, tile, wrong);
            assertThrows(
                    AssertionError.class,
                    () -> ZTest.assertNoneRejected(row, pValues, SIGNIFICANCE),
                    () -> row + ": an image " + wrong + " times as bright is not found out");
        }
    }

    private static Map<String, String> parse(String settings) {
        Map<String, String> parameters = new HashMap<>();
        for (String setting : settings.split(" ", -1)) {
            int equals = setting.indexOf('=');
            if (equals > 0) {
                parameters.put(setting.substring(0, equals), setting.substring(equals + 1));
            }
        }
        return parameters;
    }
}
