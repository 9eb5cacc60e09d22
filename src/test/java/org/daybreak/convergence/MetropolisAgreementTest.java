package org.daybreak.convergence;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Metropolis light transport against bidirectional path tracing: each strategy with the bidirectional one alone, each option alone, and
 * everything together.
 *
 * <p>The t-tests of {@link ChainAgreement}, with a false-alarm rate of 1e-4 per row and fixed seeds.
 */
class MetropolisAgreementTest {
    private static final List<String> STRATEGIES =
            List.of("bidirectional", "lensSubpath", "lens", "caustic", "multiChain", "manifold");

    private static final List<String> OPTIONS = List.of(
            "separateDirect=false",
            "sharing=never",
            "sharing=always",
            "importanceMutations=true",
            "importanceMutations=true separateDirect=false",
            "expectedValues=false",
            "expectedValues=false separateDirect=false",
            "twoStage=true reduction=4 sharing=never",
            "twoStage=true reduction=4 sharing=always",
            "twoStage=true reduction=4 separateDirect=false");

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
        rows.add(Arguments.of("gold_ring", "sharing=always", 48, 0.3));
        rows.add(Arguments.of("gold_ring", "sharing=never", 48, 0.3));
        rows.add(Arguments.of("veach_room", "", 48, 0.3));
        rows.add(Arguments.of("door_ajar", "", 64, 0.3));
        rows.add(Arguments.of("lights of every kind", "separateDirect=false", 32, 0.15));
        rows.add(Arguments.of("lights of every kind", "sharing=always", 32, 0.15));
        rows.add(Arguments.of("masks", "separateDirect=false", 32, 0.15));
        rows.add(Arguments.of("masks", "sharing=always", 32, 0.15));
        rows.add(Arguments.of("lamp, glass and metal, thin lens", "separateDirect=false", 32, 0.15));
        rows.add(Arguments.of("lamp, glass and metal, parallel rays", "separateDirect=false", 32, 0.15));
        return rows.stream();
    }

    /** Each scene that ships, with each strategy and each option alone. */
    static Stream<Arguments> shippedScenes() {
        List<Arguments> rows = new ArrayList<>();
        for (String name : ChainAgreement.SHIPPED) {
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
        return BidirectionalScenes.withCrossScenes().keySet().stream()
                .flatMap(name -> Stream.of("sharing=never", "sharing=always", "separateDirect=false")
                        .map(settings -> Arguments.of(name, settings + candidates(name), 200, 0.1)));
    }

    /** More candidates where few of them know little of the brightness: a directional light on mirrors and glass. */
    private static String candidates(String name) {
        return name.equals("directional") ? " bootstrapSamples=400000" : "";
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

    /**
     * Compares b.
     *
     * @param samplesPerPixel of bidirectional path tracing
     * @param detectable relative error that is found out
     * @param knownError whether its standard error is to be right, too
     */
    @ParameterizedTest
    @CsvSource({
        "cornell_spheres, 64, 0.05, true",
        "gold_ring, 256, 1, false",
        "veach_room, 64, 0.05, true",
        "door_ajar, 64, 0.1, true",
        "lights of every kind, 16, 0.05, true"
    })
    void brightnessIsTheMeanLuminance(String name, int samplesPerPixel, double detectable, boolean knownError)
            throws SceneException {
        ChainAgreement.checkBrightness(name, samplesPerPixel, detectable, knownError);
    }

    private static void check(String name, String settings, int mutations, int samplesPerPixel, double detectable)
            throws SceneException {
        String all = settings + " directSamples=" + Math.max(4, mutations / 8);
        ChainAgreement.check(name, "metropolis", all, "", mutations, samplesPerPixel, detectable);
    }
}
