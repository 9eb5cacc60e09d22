package org.daybreak.convergence;

import java.util.stream.Stream;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Chains over random numbers, whole samples ({@code pssmlt}) and single paths ({@code mmlt}), against bidirectional path tracing.
 *
 * <p>The t-tests of {@link ChainAgreement}, with a false-alarm rate of 1e-4 per row and fixed seeds.
 */
class PrimarySpaceTest {
    private static final String SHORT = "seedPaths=100 bootstrapSamples=4000 ";

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
            for (String scene : ChainAgreement.SHIPPED) {
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
        ChainAgreement.check(name, renderer, SHORT + settings, common, mutations, 32, detectable);
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
        String start = "seedPaths=200 bootstrapSamples=10000 ";
        ChainAgreement.check(name, renderer, start + settings, common, mutations, 64, detectable);
    }
}
