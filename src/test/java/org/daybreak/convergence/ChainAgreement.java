package org.daybreak.convergence;

import java.util.List;
import java.util.Map;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
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
