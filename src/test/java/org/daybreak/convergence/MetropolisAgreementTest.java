package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
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
 * Metropolis light transport against bidirectional path tracing: each strategy with the bidirectional one alone, each option alone, and
 * everything together.
 *
 * <p>Welch's t-test of tile means over independent runs, each with a start of its own; all tiles, channels and the means of the image with
 * a false-alarm rate of 1e-4 per row by Šidák's correction. Seeds are fixed. That the tests can fail is shown on the same runs, one
 * image made brighter and darker by as much as each row says.
 *
 * <p>Chains need more steps than samples are needed until the mean of a tile is near normal; so films are small and tiles are large.
 */
class MetropolisAgreementTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int RUNS = 16;
    private static final List<String> STRATEGIES =
            List.of("bidirectional", "lensSubpath", "lens", "caustic", "multiChain", "manifold");
    private static final List<String> SHIPPED = List.of("cornell_spheres", "gold_ring", "veach_room", "door_ajar");

    private static final List<String> OPTIONS = List.of(
            "separateDirect=false",
            "importanceMutations=true",
            "importanceMutations=true separateDirect=false",
            "expectedValues=false",
            "expectedValues=false separateDirect=false",
            "twoStage=true reduction=4",
            "twoStage=true reduction=4 separateDirect=false");

    private static Map<String, SceneGraph> scenes() {
        Map<String, SceneGraph> scenes = new LinkedHashMap<>(CrossScenes.all());
        scenes.putAll(BidirectionalScenes.all());
        return scenes;
    }

    private static Scene scene(String name) throws SceneException {
        if (!SHIPPED.contains(name)) {
            return SceneCompiler.compile(scenes().get(name));
        }
        SceneGraph graph = ShippedScenes.read(name + "/scene.xml").graph();
        return switch (name) {
            case "cornell_spheres" -> ShippedScenes.compile(graph, 24, 24);
            case "door_ajar" -> ShippedScenes.compile(graph, 27, 15);
            default -> ShippedScenes.compile(graph, 24, 16);
        };
    }

    /** Settings that leave the bidirectional strategy and one more. */
    private static String only(String strategy) {
        StringBuilder settings = new StringBuilder();
        for (String other : STRATEGIES) {
            if (!other.equals("bidirectional") && !other.equals(strategy)) {
                settings.append(other).append("=0 ");
            }
        }
        return settings.toString().trim();
    }

    static Stream<Arguments> fewRows() {
        List<Arguments> rows = new ArrayList<>();
        for (String strategy : STRATEGIES) {
            rows.add(Arguments.of("cornell_spheres", only(strategy) + " separateDirect=false", 96, 0.2));
        }
        for (String option : OPTIONS) {
            rows.add(Arguments.of("cornell_spheres", option, 96, 0.2));
        }
        rows.add(Arguments.of("gold_ring", "", 48, 0.3));
        rows.add(Arguments.of("veach_room", "", 48, 0.3));
        rows.add(Arguments.of("door_ajar", "", 64, 0.3));
        rows.add(Arguments.of("lights of every kind", "separateDirect=false", 32, 0.15));
        rows.add(Arguments.of("masks", "separateDirect=false", 32, 0.15));
        rows.add(Arguments.of("lamp, glass and metal, thin lens", "separateDirect=false", 32, 0.15));
        rows.add(Arguments.of("lamp, glass and metal, parallel rays", "separateDirect=false", 32, 0.15));
        return rows.stream();
    }

    /** Each scene that ships, with each strategy and each option alone. */
    static Stream<Arguments> shippedScenes() {
        List<Arguments> rows = new ArrayList<>();
        for (String name : SHIPPED) {
            for (String strategy : STRATEGIES) {
                rows.add(Arguments.of(name, only(strategy) + " separateDirect=false", 400, 0.15));
            }
            rows.add(Arguments.of(name, "", 400, 0.15));
            for (String option : OPTIONS) {
                rows.add(Arguments.of(name, option, 400, 0.15));
            }
        }
        return rows.stream();
    }

    static Stream<Arguments> allOtherScenes() {
        return scenes().keySet().stream()
                .flatMap(name ->
                        Stream.of("", "separateDirect=false").map(settings -> Arguments.of(name, settings, 200, 0.1)));
    }

    /**
     * Compares.
     *
     * @param settings besides those of the start
     * @param mutations per pixel
     * @param detectable relative error of the brightness that is found out
     */
    @ParameterizedTest
    @MethodSource("fewRows")
    void agreesWithBidirectional(String name, String settings, int mutations, double detectable) throws SceneException {
        check(name, "seedPaths=100 bootstrapSamples=20000 " + settings, mutations, 32, detectable);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource({"shippedScenes", "allOtherScenes"})
    void agreesCloselyWithBidirectional(String name, String settings, int mutations, double detectable)
            throws SceneException {
        check(name, "seedPaths=200 bootstrapSamples=20000 " + settings, mutations, 128, detectable);
    }

    private static void check(String name, String settings, int mutations, int samplesPerPixel, double detectable)
            throws SceneException {
        Scene scene = scene(name);
        Map<String, String> parameters = parse(settings);
        parameters.put("mutationsPerPixel", Integer.toString(mutations));
        parameters.put("directSamples", Integer.toString(Math.max(4, mutations / 8)));
        Runs chains = Runs.of(Rendering.renderer("metropolis", parameters), scene, 5000, RUNS, mutations);
        Runs samples = Runs.of(Rendering.renderer("bidirectional"), scene, 6000, RUNS, samplesPerPixel);
        String row = name + ", " + settings;
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
