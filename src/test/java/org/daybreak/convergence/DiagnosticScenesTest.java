package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Grids;
import org.daybreak.core.testing.ZTest;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Renderers against the closed forms of {@code scenes/diagnostic}.
 *
 * <p>Each subject is rendered in independent runs; t-tests compare the mean of each tile and of the whole image with the
 * expected values, with Šidák's correction: the false-alarm rate is 1e-4 per scene and renderer. Seeds are fixed. That the
 * tests can fail is shown each time on the very same runs, scaled by a few per cent.
 *
 * <p>Variant {@code reference} takes 32 times the samples and tiles a quarter as large.
 */
class DiagnosticScenesTest {
    /** False-alarm rate per scene and renderer. */
    private static final double SIGNIFICANCE = 1e-4;

    /** Rounding of an image to float, of CSV files to nine digits and of the scenes' coordinates to float. */
    private static final double ROUNDING = 1e-6;

    /** Error of the midpoint rule in the CSV files where the picture is smooth, 16×16 points per pixel. */
    private static final double QUADRATURE = 2e-5;

    private static final int RUNS = 32;
    private static final int REFERENCE_FACTOR = 32;

    /** How an image is compared. */
    private enum Comparison {
        /** Its mean is the closed form. */
        MEAN,
        /** Its mean is the closed form in pixels that see nothing but the diffuse floor. */
        MEAN_OF_FLOOR,
        /** Its mean is the light that is seen directly; mirrors are black. */
        MEAN_OF_EMITTER,
        /** The estimator has no variance: each pixel of each run is the closed form. */
        EXACT,
        /** Each pixel is 0. */
        BLACK
    }

    /**
     * A scene and a renderer.
     *
     * @param scene name below {@code scenes/diagnostic}
     * @param renderer identifier
     * @param parameters of the renderer, beside those of the scene file
     * @param tile edge of a tile in pixels
     * @param samplesPerPixel of each run
     * @param detectable relative error of the whole image that the ordinary test must find
     */
    private record Subject(
            String scene,
            String renderer,
            Map<String, String> parameters,
            Comparison comparison,
            int tile,
            int samplesPerPixel,
            double detectable) {
        @Override
        public String toString() {
            return scene.replace("/scene", " ").replace(".xml", "") + " " + renderer + " " + parameters;
        }
    }

    private static final Map<String, String> NO_ROULETTE = Map.of("rrDepth", "1000000");

    private static final List<String> BIDIRECTIONAL_SCENES = List.of(
            "furnace_sphere/scene_mirror.xml",
            "furnace_sphere/scene_glass.xml",
            "furnace_sphere/scene_diffuse1.xml",
            "furnace_sphere/scene_diffuse05.xml",
            "furnace_box/scene_depth1.xml",
            "furnace_box/scene_depth2.xml",
            "furnace_box/scene_depth3.xml",
            "furnace_box/scene_depth4.xml",
            "furnace_box/scene_depthinf.xml",
            "point_plane/scene.xml",
            "disk_light/scene.xml",
            "rect_light/scene.xml",
            "sphere_light/scene.xml",
            "two_squares/scene_direct.xml",
            "concentric_spheres/scene.xml",
            "parallel_planes/scene.xml",
            "glass_slab/scene.xml",
            "mirror_corridor/scene.xml",
            "glass_shell/scene.xml");

    private static final List<Subject> SUBJECTS = Stream.of(single(), bidirectional(), metropolis())
            .flatMap(subjects -> subjects)
            .toList();

    private static Stream<Subject> single() {
        return Stream.of(
                exact("furnace_sphere/scene_mirror.xml", "path", Map.of()),
                exact("furnace_sphere/scene_mirror.xml", "raytracer", Map.of()),
                // Each reflection within the sphere has probability 0.04 or so and weight 1.
                exact("furnace_sphere/scene_glass.xml", "path", NO_ROULETTE),
                exact("furnace_sphere/scene_glass.xml", "raytracer", Map.of()),
                exact("furnace_box/scene_depth1.xml", "path", Map.of()),
                exact("furnace_box/scene_depth1.xml", "raytracer", Map.of()),
                exact("mirror_corridor/scene.xml", "path", NO_ROULETTE),
                exact("mirror_corridor/scene.xml", "raytracer", Map.of()),
                // One path in ten thousand is ended by roulette: only the whole image has enough of them for a t-test.
                mean("furnace_sphere/scene_glass.xml", "path", 32, 64, 0.03),
                mean("furnace_sphere/scene_diffuse1.xml", "path", 8, 8, 0.03),
                mean("furnace_sphere/scene_diffuse1.xml", "raytracer", 8, 8, 0.03),
                mean("furnace_sphere/scene_diffuse1.xml", "light", 8, 64, 0.03),
                mean("furnace_sphere/scene_diffuse05.xml", "path", 8, 8, 0.03),
                mean("furnace_sphere/scene_diffuse05.xml", "raytracer", 8, 8, 0.03),
                mean("furnace_sphere/scene_diffuse05.xml", "light", 8, 64, 0.03),
                mean("furnace_box/scene_depth1.xml", "light", 8, 16, 0.03),
                mean("furnace_box/scene_depth2.xml", "path", 8, 4, 0.03),
                mean("furnace_box/scene_depth2.xml", "raytracer", 8, 8, 0.03),
                mean("furnace_box/scene_depth2.xml", "light", 8, 16, 0.03),
                mean("furnace_box/scene_depth3.xml", "path", 8, 4, 0.03),
                mean("furnace_box/scene_depth3.xml", "light", 8, 16, 0.03),
                mean("furnace_box/scene_depth4.xml", "path", 8, 4, 0.03),
                mean("furnace_box/scene_depth4.xml", "light", 8, 16, 0.03),
                mean("furnace_box/scene_depthinf.xml", "path", 8, 4, 0.03),
                mean("furnace_box/scene_depthinf.xml", "light", 8, 16, 0.03),
                mean("point_plane/scene.xml", "path", 8, 8, 0.03),
                mean("point_plane/scene.xml", "raytracer", 8, 8, 0.03),
                mean("point_plane/scene.xml", "light", 8, 16, 0.03),
                mean("disk_light/scene.xml", "path", 8, 8, 0.03),
                mean("disk_light/scene.xml", "raytracer", 8, 8, 0.03),
                mean("disk_light/scene.xml", "light", 8, 16, 0.03),
                mean("rect_light/scene.xml", "path", 8, 8, 0.03),
                mean("rect_light/scene.xml", "raytracer", 8, 8, 0.03),
                mean("rect_light/scene.xml", "light", 8, 16, 0.03),
                mean("sphere_light/scene.xml", "path", 8, 8, 0.03),
                mean("sphere_light/scene.xml", "raytracer", 8, 8, 0.03),
                mean("sphere_light/scene.xml", "light", 8, 16, 0.03),
                mean("two_squares/scene_direct.xml", "path", 8, 8, 0.03),
                mean("two_squares/scene_direct.xml", "raytracer", 8, 8, 0.03),
                mean("two_squares/scene_direct.xml", "light", 8, 16, 0.03),
                mean("concentric_spheres/scene.xml", "path", 8, 8, 0.03),
                mean("concentric_spheres/scene.xml", "light", 8, 16, 0.03),
                mean("parallel_planes/scene.xml", "path", 8, 8, 0.03),
                new Subject("parallel_planes/scene.xml", "light", Map.of(), Comparison.MEAN_OF_FLOOR, 8, 16, 0.03),
                mean("glass_slab/scene.xml", "path", 8, 8, 0.03),
                new Subject("glass_slab/scene.xml", "light", Map.of(), Comparison.MEAN_OF_FLOOR, 8, 16, 0.03),
                mean("mirror_corridor/scene.xml", "path", 8, 8, 0.03),
                // Mirrors are no place from which a light subpath can be joined to the lens.
                new Subject("mirror_corridor/scene.xml", "light", Map.of(), Comparison.MEAN_OF_EMITTER, 32, 16, 0.05),
                new Subject("glass_shell/scene.xml", "path", Map.of(), Comparison.BLACK, 1, 8, 0),
                new Subject("glass_shell/scene.xml", "raytracer", Map.of(), Comparison.BLACK, 1, 8, 0),
                mean("glass_shell/scene.xml", "light", 8, 32, 0.03));
    }

    /** All scenes, and some with limits of depth that leave all light to be found. */
    private static Stream<Subject> bidirectional() {
        Stream<Subject> limits = Stream.of("furnace_box/scene_depth4.xml", "concentric_spheres/scene.xml")
                .flatMap(scene -> Stream.of(
                        bidirectional(scene, Map.of("maxEyeDepth", "1"), 8),
                        bidirectional(scene, Map.of("maxEyeDepth", "2"), 8),
                        bidirectional(scene, Map.of("maxLightDepth", "1"), 8),
                        bidirectional(scene, Map.of("maxLightDepth", "2", "heuristicExponent", "1"), 8),
                        bidirectional(scene, Map.of("causticMap", "false"), 8),
                        bidirectional(scene, Map.of("lightsPerPath", "all"), 8)));
        return Stream.concat(BIDIRECTIONAL_SCENES.stream().map(scene -> bidirectional(scene, "2")), limits);
    }

    /** All scenes with the other exponents of the heuristic: in the ordinary build one of the two for each scene. */
    private static Stream<Subject> otherExponents(boolean all) {
        List<Subject> subjects = new ArrayList<>();
        for (int i = 0; i < BIDIRECTIONAL_SCENES.size(); i++) {
            for (int exponent = 0; exponent < 2; exponent++) {
                if (all || exponent == i % 2) {
                    subjects.add(bidirectional(BIDIRECTIONAL_SCENES.get(i), Integer.toString(exponent)));
                }
            }
        }
        return subjects.stream();
    }

    private static Subject bidirectional(String scene, String exponent) {
        int samples = scene.startsWith("glass_shell/") ? 32 : scene.startsWith("furnace_sphere/") ? 16 : 4;
        return bidirectional(scene, Map.of("heuristicExponent", exponent), samples);
    }

    private static Subject bidirectional(String scene, Map<String, String> parameters, int samplesPerPixel) {
        return new Subject(scene, "bidirectional", parameters, Comparison.MEAN, 8, samplesPerPixel, 0.03);
    }

    /**
     * All scenes, which have a light path each. A run has few chains and candidates for their starts, so that its mean rests on few
     * independent numbers: errors of some per cent are what it can find.
     */
    private static Stream<Subject> metropolis() {
        Map<String, String> parameters =
                Map.of("separateDirect", "false", "seedPaths", "200", "bootstrapSamples", "4000");
        return BIDIRECTIONAL_SCENES.stream()
                .map(scene -> new Subject(scene, "metropolis", parameters, Comparison.MEAN, 16, 12, 0.12));
    }

    /** Scenes that a renderer cannot form, and why. */
    private static final Map<String, String> NOT_FORMED = Map.of(
            "furnace_sphere/scene_mirror.xml light", "nothing but a mirror and what is seen in it",
            "furnace_sphere/scene_glass.xml light", "nothing but glass and what is seen through it");

    private static Subject mean(String scene, String renderer, int tile, int samplesPerPixel, double detectable) {
        return new Subject(scene, renderer, Map.of(), Comparison.MEAN, tile, samplesPerPixel, detectable);
    }

    private static Subject exact(String scene, String renderer, Map<String, String> parameters) {
        return new Subject(scene, renderer, parameters, Comparison.EXACT, 1, 4, 0);
    }

    static Stream<Subject> subjects() {
        return Stream.concat(SUBJECTS.stream(), otherExponents(false));
    }

    static Stream<Subject> allSubjects() {
        return Stream.concat(SUBJECTS.stream(), otherExponents(true));
    }

    @Test
    void everySceneIsTestedWithEveryRendererThatCanFormIt() throws IOException {
        Path folder = ShippedScenes.repository().resolve("scenes/diagnostic");
        Set<String> wanted = new TreeSet<>();
        try (Stream<Path> files = Files.walk(folder, 2)) {
            files.filter(file -> file.getFileName().toString().endsWith(".xml"))
                    .map(file -> folder.relativize(file).toString().replace('\\', '/'))
                    .forEach(scene -> wanted.addAll(List.of(
                            scene + " path", scene + " light", scene + " bidirectional", scene + " metropolis")));
        }
        Set<String> covered = SUBJECTS.stream()
                .filter(subject -> !subject.renderer.equals("raytracer"))
                .map(subject -> subject.scene + " " + subject.renderer)
                .collect(Collectors.toCollection(TreeSet::new));
        covered.addAll(NOT_FORMED.keySet());
        assertEquals(wanted, covered);
    }

    /** The exact integrals and the files agree up to the points that the files' averages are taken over. */
    @ParameterizedTest
    @ValueSource(
            strings = {"furnace_sphere/scene_diffuse05.xml", "concentric_spheres/scene.xml", "mirror_corridor/scene.xml"
            })
    void edgesAreThoseOfTheFiles(String scene) throws IOException {
        ClosedForm closedForm = ClosedForm.of(scene);
        double[] file = closedForm.file();
        double contrast = Arrays.stream(file).max().orElseThrow()
                - Arrays.stream(file).min().orElseThrow();
        assertArrayEquals(file, closedForm.exact(), ClosedForm.quantisation() * contrast);
        double mean = Arrays.stream(file).average().orElseThrow();
        assertEquals(mean, Arrays.stream(closedForm.exact()).average().orElseThrow(), 2e-3 * mean);
    }

    @ParameterizedTest
    @MethodSource("subjects")
    void meetsItsClosedForm(Subject subject) throws IOException, SceneException {
        check(subject, 1, subject.tile, subject.detectable);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("allSubjects")
    void meetsItsClosedFormClosely(Subject subject) throws IOException, SceneException {
        boolean small = subject.tile <= 8;
        // The error falls at least as the root of the number of samples; what is lost by more tests is little.
        check(subject, REFERENCE_FACTOR, small ? (subject.tile + 1) / 2 : subject.tile, subject.detectable / 5);
    }

    private static void check(Subject subject, int factor, int tile, double detectable)
            throws IOException, SceneException {
        SceneFile file = ShippedScenes.read("diagnostic/" + subject.scene);
        Map<String, String> parameters = new HashMap<>(file.request().parameters());
        parameters.putAll(subject.parameters);
        parameters.put("mutationsPerPixel", Integer.toString(subject.samplesPerPixel * factor));
        // The brightness that chains are scaled by comes from the candidates for their starts.
        parameters.computeIfPresent(
                "bootstrapSamples", (name, samples) -> Integer.toString(Integer.parseInt(samples) * factor));
        Renderer renderer = Rendering.renderer(subject.renderer, parameters);
        Scene scene = ShippedScenes.compile(file.graph());
        ClosedForm closedForm = ClosedForm.of(subject.scene);
        assertEquals(closedForm.width(), scene.film().width());
        if (subject.comparison == Comparison.EXACT || subject.comparison == Comparison.BLACK) {
            FilmImage image = Rendering.render(renderer, scene, 1, (long) subject.samplesPerPixel * factor);
            checkPixels(subject, closedForm, image);
            return;
        }
        Runs runs = Runs.of(renderer, scene, 1000, RUNS, (long) subject.samplesPerPixel * factor);
        for (FilmImage image : runs.images()) {
            assertArrayEquals(image.channel("R"), image.channel("G"), "red and green of a grey scene");
            assertArrayEquals(image.channel("R"), image.channel("B"), "red and blue of a grey scene");
        }
        boolean[] seen = new boolean[closedForm.exact().length];
        Arrays.fill(seen, true);
        double[] expected = closedForm.exact();
        if (subject.comparison == Comparison.MEAN_OF_FLOOR) {
            seen = pixelsOfFloor(scene);
        } else if (subject.comparison == Comparison.MEAN_OF_EMITTER) {
            expected = ClosedForm.corridorWithoutMirrors(closedForm.width());
        }
        checkMeans(subject.toString(), runs, masked(expected, seen), seen, tile, detectable);
    }

    /** The comparison of estimators without variance. */
    private static void checkPixels(Subject subject, ClosedForm closedForm, FilmImage image) {
        int compared = 0;
        for (String channel : Runs.CHANNELS) {
            float[] values = image.channel(channel);
            for (int i = 0; i < values.length; i++) {
                if (subject.comparison == Comparison.BLACK) {
                    assertEquals(0, values[i], subject + ": pixel " + i);
                } else if (closedForm.smooth(i)) {
                    double expected = closedForm.exact()[i];
                    assertEquals(expected, values[i], ROUNDING * expected, subject + ": pixel " + i);
                }
                compared += closedForm.smooth(i) ? 1 : 0;
            }
        }
        assertTrue(compared > 0.6 * 3 * closedForm.exact().length, () -> subject + ": hardly a pixel is compared");
    }

    private static void checkMeans(
            String name, Runs runs, double[] expected, boolean[] seen, int tile, double detectable) {
        double[][] tiles = Arrays.stream(runs.pixels("R"))
                .map(run -> withMean(masked(run, seen), runs.width(), tile))
                .toArray(double[][]::new);
        double[] expectedTiles = withMean(expected, runs.width(), tile);
        double allowance = ROUNDING + QUADRATURE;
        double[] pValues = Runs.pValues(tiles, expectedTiles, allowance);
        ZTest.assertNoneRejected(name, pValues, SIGNIFICANCE);
        for (double factor : new double[] {1 - detectable, 1 + detectable}) {
            double[][] wrong = Arrays.stream(tiles)
                    .map(run -> Arrays.stream(run).map(v -> factor * v).toArray())
                    .toArray(double[][]::new);
            double[] wrongPValues = Runs.pValues(wrong, expectedTiles, allowance);
            assertThrows(
                    AssertionError.class,
                    () -> ZTest.assertNoneRejected(name, wrongPValues, SIGNIFICANCE),
                    () -> String.format(
                            Locale.ROOT, "%s: an image %.3f times as bright is not found out", name, factor));
        }
    }

    /** Tile means and, last, the mean of the whole image. */
    private static double[] withMean(double[] values, int width, int tile) {
        double[] means = Grids.tileMeans(values, width, tile);
        double[] result = Arrays.copyOf(means, means.length + 1);
        result[means.length] = Arrays.stream(values).average().orElseThrow();
        return result;
    }

    private static double[] masked(double[] values, boolean[] seen) {
        double[] result = values.clone();
        for (int i = 0; i < result.length; i++) {
            if (!seen[i]) {
                result[i] = 0;
            }
        }
        return result;
    }

    /** Pixels whose corners all see the floor of [-1, 1]² in y = 0 rather than the mirrors around it. */
    private static boolean[] pixelsOfFloor(Scene scene) {
        Camera camera = scene.camera();
        CameraRay ray = new CameraRay();
        int width = camera.width();
        boolean[] seen = new boolean[width * camera.height()];
        int count = 0;
        for (int i = 0; i < seen.length; i++) {
            seen[i] = true;
            for (int corner = 0; corner < 4; corner++) {
                int x = i % width + corner % 2;
                int y = i / width + corner / 2;
                assertTrue(camera.sampleRay(x, y, 0.5, 0.5, ray));
                double t = -ray.oy / ray.dy;
                seen[i] &= t > 0 && Math.abs(ray.ox + t * ray.dx) < 1 && Math.abs(ray.oz + t * ray.dz) < 1;
            }
            count += seen[i] ? 1 : 0;
        }
        assertTrue(count > seen.length / 2, "most of the image is floor");
        return seen;
    }
}
