package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.convergence.BidirectionalScenes;
import org.daybreak.convergence.ShippedScenes;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.tracing.EmissionGuide;
import org.daybreak.tracing.RaySample;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * For any full path, the weights of all techniques that a configuration can sample add up to 1.
 *
 * <p>Full paths are those that the renderer finds. For each, {@link PathRebuilder} makes the subpaths of every other technique from
 * the geometry, and the program weights them as if it had traced them: by the four densities that {@link ComplementTracer} fills in
 * at the joint and those that stand in the subpaths. Each weight must be p_s^β/Σp_i^β, with densities by the definitions, and so must the
 * weight that the program gave when it found the path; and what {@link LineTracer} wrote into the subpaths must be what was rebuilt.
 */
class WeightsTest {
    private static final double[] EXPONENTS = {0, 1, 2, 4, 100};
    private static final int[] DEPTHS = {-1, 1, 2, 3, 5};
    private static final double TOLERANCE = 1e-9;

    /** Sum over all shipped scenes: more than 10⁵. */
    private static final int PATHS = 4600;

    private static final int PATHS_OF_OTHER_SCENES = 1000;
    private static final int REFERENCE_FACTOR = 10;

    static List<String> shippedScenes() throws IOException {
        Path folder = ShippedScenes.repository().resolve("scenes");
        try (Stream<Path> files = Files.walk(folder, 3)) {
            return files.filter(file -> file.getFileName().toString().matches("scene.*\\.xml"))
                    .map(file -> folder.relativize(file).toString().replace('\\', '/'))
                    .filter(name -> !name.startsWith("src/"))
                    .sorted()
                    .toList();
        }
    }

    static List<String> otherScenes() {
        return List.copyOf(BidirectionalScenes.withCrossScenes().keySet());
    }

    @ParameterizedTest
    @MethodSource("shippedScenes")
    void weightsAddUp(String name) throws IOException, SceneException {
        assertTrue(shippedScenes().size() * PATHS > 100_000);
        check(name, shipped(name), PATHS, 1);
    }

    /** All kinds of emitters and cameras, shading normals, mirrored instances, masks. */
    @ParameterizedTest
    @MethodSource("otherScenes")
    void weightsAddUpWithAllKindsOfThings(String name) {
        check(name, SceneCompiler.compile(BidirectionalScenes.withCrossScenes().get(name)), PATHS_OF_OTHER_SCENES, 2);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("shippedScenes")
    void weightsOfMorePathsAddUp(String name) throws SceneException {
        check(name, shipped(name), REFERENCE_FACTOR * PATHS, 3);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("otherScenes")
    void weightsOfMorePathsAddUpWithAllKindsOfThings(String name) {
        check(
                name,
                SceneCompiler.compile(BidirectionalScenes.withCrossScenes().get(name)),
                REFERENCE_FACTOR * PATHS_OF_OTHER_SCENES,
                4);
    }

    private static Scene shipped(String name) throws SceneException {
        return ShippedScenes.compile(ShippedScenes.read(name).graph(), 40, 30);
    }

    private static void check(String name, Scene scene, int paths, long seed) {
        new Check(name, scene, false, false, 1, 2, 0.25, paths / 3, seed).run();
        new Check(name, scene, false, true, 3, 1, 0.01, paths / 3, seed + 100).run();
        new Check(name, scene, true, true, 1, 1, 1, paths / 3, seed + 200).run();
    }

    /** The paths of one scene. */
    private static final class Check implements Contribution.Listener {
        private final String name;
        private final Scene scene;
        private final Camera camera;
        private final boolean allLights;
        private final int splitting;
        private final EmissionGuide guide;
        private final LightDensities lights;
        private final boolean lensHits;
        private final double exponent;
        private final double share;
        private final int wanted;
        private final SplittableRandom random;
        private int checked;

        Check(
                String name,
                Scene scene,
                boolean allLights,
                boolean lensHits,
                int splitting,
                double exponent,
                double share,
                int wanted,
                long seed) {
            this.name = name;
            this.scene = scene;
            this.camera = scene.camera();
            this.allLights = allLights;
            this.splitting = splitting;
            guide = new EmissionGuide(scene);
            lights = new LightDensities(scene, guide, allLights);
            this.lensHits = lensHits;
            this.exponent = exponent;
            this.share = share;
            this.wanted = wanted;
            random = new SplittableRandom(seed);
        }

        private BidirectionalSettings settings(
                int maxEyeDepth, int maxLightDepth, int maxDepth, double beta, boolean causticMap, boolean hits) {
            return new BidirectionalSettings(
                    maxEyeDepth,
                    maxLightDepth,
                    maxDepth,
                    beta,
                    BidirectionalSettings.Roulette.THROUGHPUT,
                    3,
                    splitting,
                    allLights,
                    causticMap,
                    share,
                    hits,
                    1);
        }

        void run() {
            BidirectionalSettings settings = settings(-1, -1, -1, exponent, true, lensHits);
            BiDirectionalProcessor processor = new BiDirectionalProcessor(scene, camera, false, settings, this);
            Sampler sampler = new SobolSampling().newSampler(random.nextLong(), 1 << 20);
            RaySample sample = new RaySample();
            SplatBuffer splats = new SplatBuffer();
            long limit = 2000L * wanted;
            for (long i = 0; checked < wanted; i++) {
                assertTrue(i < limit, name + ": hardly a sample finds a path");
                sampler.start(0, i);
                double x = sampler.next() * camera.width();
                double y = sampler.next() * camera.height();
                splats.clear();
                processor.trace(x, y, sampler, sample, splats);
            }
        }

        /** Takes some of the paths of each sample, so that they come from many. */
        @Override
        public void found(Contribution found) {
            if (checked >= wanted || random.nextInt(4) != 0) {
                return;
            }
            checked++;
            FullPath path = new FullPath(scene, camera, found);
            PathRebuilder rebuilder = new PathRebuilder(path, guide, allLights, lensHits, splitting);
            PathRebuilder other = new PathRebuilder(path, guide, allLights, !lensHits, splitting);
            int k = path.edgeCount();
            double[] weights = checkWeights(rebuilder, settings(-1, -1, -1, exponent, true, lensHits), k);
            assertEquals(weights[found.s], found.weight, TOLERANCE, () -> describe(path, found.s) + " as found");
            checkStored(found, path, rebuilder);
            for (double beta : EXPONENTS) {
                checkWeights(rebuilder, settings(-1, -1, -1, beta, true, lensHits), k);
                checkWeights(rebuilder, settings(-1, -1, -1, beta, false, lensHits), k);
                if (camera.hasLensArea()) {
                    checkWeights(other, settings(-1, -1, -1, beta, true, !lensHits), k);
                }
                boolean lens = random.nextBoolean();
                int eyeDepth = DEPTHS[random.nextInt(lens ? 0 : 2, DEPTHS.length)];
                int lightDepth = DEPTHS[random.nextInt(DEPTHS.length)];
                int maxDepth = random.nextBoolean() ? -1 : k + random.nextInt(3);
                checkWeights(rebuilder, settings(eyeDepth, lightDepth, maxDepth, beta, lens, lensHits), k);
            }
        }

        /** Checks the weights of all techniques under some settings, and returns them. */
        private double[] checkWeights(PathRebuilder rebuilder, BidirectionalSettings settings, int k) {
            double beta = settings.heuristicExponent();
            ComplementTracer complement = new ComplementTracer(scene, lights, settings.limits(camera), beta, splitting);
            double[] logs = new double[k + 2];
            double largest = Double.NEGATIVE_INFINITY;
            for (int s = 0; s <= k + 1; s++) {
                boolean seenByEye = rebuilder.isDirectView() && settings.maxEyeDepth() != 1;
                boolean admissible = rebuilder.possible(s, settings.causticMap())
                        && !(s == 1 && seenByEye)
                        && within(k + 1 - s, settings.maxEyeDepth())
                        && within(s, settings.maxLightDepth());
                double count = s == k ? share : 1;
                logs[s] = admissible ? rebuilder.logDensity(s) + Math.log(count) : Double.NEGATIVE_INFINITY;
                largest = Math.max(largest, logs[s]);
            }
            double[] weights = new double[k + 2];
            if (largest == Double.NEGATIVE_INFINITY) {
                return weights;
            }
            double[] expected = new double[k + 2];
            double total = 0;
            for (int s = 0; s <= k + 1; s++) {
                expected[s] = logs[s] == Double.NEGATIVE_INFINITY ? 0 : Math.exp(beta * (logs[s] - largest));
                total += expected[s];
            }
            double sum = 0;
            for (int s = 0; s <= k + 1; s++) {
                if (logs[s] > Double.NEGATIVE_INFINITY) {
                    weights[s] = rebuilder.weight(complement, s, beta, settings.causticMap() ? share : 0);
                    sum += weights[s];
                    int technique = s;
                    assertEquals(
                            expected[s] / total,
                            weights[s],
                            TOLERANCE,
                            () -> describe(rebuilder.path(), technique) + " with " + settings + ", log densities "
                                    + Arrays.toString(logs));
                }
            }
            double all = sum;
            assertEquals(1, all, TOLERANCE, () -> describe(rebuilder.path(), -1) + " with " + settings);
            return weights;
        }

        private static boolean within(int vertices, int depth) {
            return depth < 0 || vertices <= depth;
        }

        /** What was written into the subpaths on the way, as far as a shorter path is known. */
        private void checkStored(Contribution found, FullPath path, PathRebuilder rebuilder) {
            int s = found.s;
            int t = found.t;
            if (t == 0) {
                checkStored(rebuilder.lightPath(s - 1, exponent), found.light, s - 1, s - 1, path);
                return;
            }
            if (s >= 2) {
                PathValues expected = rebuilder.lightPath(s, exponent);
                assertEquals(expected.infinite, found.light.infinite);
                assertEquals(expected.deltaLight, found.light.deltaLight);
                assertClose(expected.nextEventRatio, found.light.nextEventRatio, path, s, "next event");
                checkStored(expected, found.light, s, s, path);
            }
            if (t >= 2) {
                checkStored(rebuilder.eyePath(t, exponent, share), found.eye, t, s == 0 ? t - 1 : t, path);
            }
        }

        /** Compares two subpaths, of which so many vertices are such that scatter. */
        private void checkStored(PathValues expected, PathValues actual, int length, int scattering, FullPath path) {
            for (int i = 0; i < length; i++) {
                assertClose(expected.forward[i], actual.forward[i], path, i, "forward");
                if (i > 0 && i < scattering) {
                    assertEquals(expected.connectable[i], actual.connectable[i]);
                    assertClose(expected.toPrevious[i], actual.toPrevious[i], path, i, "toPrevious");
                }
                if (i < length - 2) {
                    assertClose(expected.reverse[i], actual.reverse[i], path, i, "reverse");
                }
                if (i < length - 1) {
                    assertEquals(expected.delta[i], actual.delta[i]);
                    assertClose(expected.tail[i], actual.tail[i], path, i, "tail");
                }
            }
        }

        private void assertClose(double expected, double actual, FullPath path, int vertex, String what) {
            assertEquals(expected, actual, TOLERANCE * Math.abs(expected), () -> describe(path, vertex) + ": " + what);
        }

        private String describe(FullPath path, int s) {
            StringBuilder text =
                    new StringBuilder(name).append(", path ").append(checked).append(", ");
            for (int i = 0; i <= path.edgeCount(); i++) {
                text.append(path.delta[i] ? 'S' : i == 0 ? 'L' : i == path.edgeCount() ? 'E' : 'D');
            }
            return text + (s < 0 ? "" : ", number " + s);
        }
    }
}
