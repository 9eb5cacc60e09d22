package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.testing.ZTest;
import org.daybreak.scenes.description.SceneException;

/**
 * Chains against bidirectional path tracing.
 *
 * <p>Welch's t-test of tile means over independent runs, each with a start of its own; all tiles, channels and the means of the image with
 * a false-alarm rate of 1e-4 per comparison by Šidák's correction. Seeds are fixed. That the test can fail is shown on the same runs, one
 * image made brighter and darker.
 *
 * <p>Chains need more steps than samples are needed until the mean of a tile is near normal; so films are small and tiles are large.
 */
final class ChainAgreement {
    /** Scenes that ship, for which there is a small size. */
    static final List<String> SHIPPED = List.of("cornell_spheres", "gold_ring", "veach_room", "door_ajar");

    private static final double SIGNIFICANCE = 1e-4;
    private static final int RUNS = 16;
    private static final int BRIGHTNESS_RUNS = 32;

    /** Quantiles 5e-5 and 1 − 5e-5 of χ² over its 31 degrees of freedom. */
    private static final double LEAST_RATIO = 0.297;

    private static final double LARGEST_RATIO = 2.303;

    private ChainAgreement() {}

    /**
     * Compares.
     *
     * @param name of a scene that ships or of {@link BidirectionalScenes#withCrossScenes}
     * @param renderer of the chains
     * @param settings of the chains, as {@code name=value} with spaces between them
     * @param common settings of both
     * @param mutations per pixel
     * @param samplesPerPixel of bidirectional path tracing
     * @param detectable relative error of the brightness that is found out
     */
    static void check(
            String name,
            String renderer,
            String settings,
            String common,
            int mutations,
            int samplesPerPixel,
            double detectable)
            throws SceneException {
        Scene scene = scene(name);
        Map<String, String> parameters = Rendering.parameters(settings + " " + common);
        parameters.put("mutationsPerPixel", Integer.toString(mutations));
        Runs chains = Runs.of(Rendering.renderer(renderer, parameters), scene, 5000, RUNS, mutations);
        Renderer paths = Rendering.renderer("bidirectional", Rendering.parameters(common));
        Runs samples = Runs.of(paths, scene, 6000, RUNS, samplesPerPixel);
        String row = name + ", " + renderer + ", " + settings + " " + common;
        int tile = Math.min(scene.film().width(), scene.film().height()) / 2;
        samples.assertAgreement(row, chains, tile, detectable, SIGNIFICANCE);
    }

    /**
     * The brightness b that chains report, from candidates of their own in each run, against the mean luminance of bidirectional path tracing;
     * and its reported standard error against how it scatters.
     *
     * @param detectable relative error of b that is found out
     * @param knownError whether so few candidates tell their own error: where light is found by chance, most runs know nothing of it
     */
    static void checkBrightness(String name, int samplesPerPixel, double detectable, boolean knownError)
            throws SceneException {
        Scene scene = scene(name);
        Renderer chains = Rendering.renderer(
                "metropolis",
                Rendering.parameters("seedPaths=1 mutationsPerPixel=1 bootstrapSamples=20000 separateDirect=false"));
        Renderer paths = Rendering.renderer("bidirectional");
        double[][] reported = new double[BRIGHTNESS_RUNS][1];
        double[][] brighter = new double[BRIGHTNESS_RUNS][1];
        double[][] rendered = new double[BRIGHTNESS_RUNS][1];
        double squares = 0;
        for (int i = 0; i < BRIGHTNESS_RUNS; i++) {
            Map<String, Double> figures = Rendering.render(
                            chains, scene, new Film(scene.film()), 7000L + i, 1, 1, new SobolSampling())
                    .figures();
            reported[i][0] = figures.getOrDefault("b", Double.NaN);
            brighter[i][0] = (1 + detectable) * reported[i][0];
            double error = figures.getOrDefault("bStandardError", Double.NaN);
            squares += error * error;
            rendered[i][0] = luminance(Rendering.render(paths, scene, 8000L + i, samplesPerPixel));
        }
        double p = ZTest.tilesOfRuns(rendered, reported)[0];
        assertTrue(p > SIGNIFICANCE, () -> name + ": b is not the mean luminance, p = " + p);
        double changed = ZTest.tilesOfRuns(rendered, brighter)[0];
        assertTrue(changed < SIGNIFICANCE, () -> name + ": a wrong b is not found out, p = " + changed);
        if (knownError) {
            double ratio = Runs.moments(reported, 0).variance() * BRIGHTNESS_RUNS / squares;
            assertTrue(
                    ratio > LEAST_RATIO && ratio < LARGEST_RATIO,
                    () -> name + ": variance of b over what its standard error says: " + ratio);
        }
    }

    private static double luminance(FilmImage image) {
        double sum = 0;
        for (int i = 0; i < image.channel("R").length; i++) {
            sum += Spectrum.luminance(image.channel("R")[i], image.channel("G")[i], image.channel("B")[i]);
        }
        return sum / image.channel("R").length;
    }

    private static Scene scene(String name) throws SceneException {
        if (!SHIPPED.contains(name)) {
            return SceneCompiler.compile(BidirectionalScenes.withCrossScenes().get(name));
        }
        SceneGraph graph = ShippedScenes.read(name + "/scene.xml").graph();
        return switch (name) {
            case "cornell_spheres" -> ShippedScenes.compile(graph, 24, 24);
            case "door_ajar" -> ShippedScenes.compile(graph, 27, 15);
            default -> ShippedScenes.compile(graph, 24, 16);
        };
    }
}
