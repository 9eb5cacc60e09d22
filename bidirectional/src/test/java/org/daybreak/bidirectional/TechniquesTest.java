package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.daybreak.tracing.RaySample;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each technique alone: the image of the paths of k edges, without weights, is the same whichever technique (s, t) with
 * s + t = k + 1, k ≥ 2, finds them, and as the weighted sum of all. In these scenes nothing scatters in ideal directions, so that each technique
 * finds all paths, but for s = 0 with lights without extent.
 *
 * <p>Welch's t-tests of the means of tiles and of the whole image over independent runs, each technique against next-event estimation; the
 * false-alarm rate is 1e-4 per scene by Šidák's correction. Seeds are fixed. That the tests can fail is shown on the same runs,
 * one technique made brighter.
 */
class TechniquesTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int SIZE = 12;
    private static final int TILE = 6;
    private static final int TILES = SIZE / TILE * (SIZE / TILE);
    private static final int RUNS = 16;
    private static final int EDGES = 4;

    /**
     * A scene.
     *
     * @param hittable whether light is counted that comes from what can be hit; otherwise the rest is counted
     * @param detectable relative error of the weighted sum that is found, for paths of two and of three edges; of a technique alone
     *     an image twice as bright is found
     */
    private record Subject(
            String name,
            IntFunction<Scene> maker,
            boolean hittable,
            boolean allLights,
            int splitting,
            int samplesPerPixel,
            double detectable,
            boolean lensHits) {
        Subject(
                String name,
                IntFunction<Scene> maker,
                boolean hittable,
                boolean allLights,
                int splitting,
                int samplesPerPixel,
                double detectable) {
            this(name, maker, hittable, allLights, splitting, samplesPerPixel, detectable, false);
        }

        @Override
        public String toString() {
            return name + (allLights ? ", all lights" : "") + (splitting > 1 ? ", split" : "");
        }
    }

    static Stream<Subject> subjects() {
        return Stream.of(
                new Subject("room", TestScenes::room, true, false, 1, 40, 0.15),
                new Subject("room through a lens", TestScenes::roomThroughLens, true, false, 1, 40, 0.15),
                new Subject("wide lens", TestScenes::roomThroughWideLens, true, false, 1, 40, 0.15, true),
                new Subject("wide lens", TestScenes::roomThroughWideLens, true, false, 3, 40, 0.15, true),
                new Subject("wide lens", TestScenes::roomThroughWideLens, true, true, 1, 40, 0.15, true),
                new Subject("room of parallel rays", TestScenes::roomOfParallelRays, true, true, 1, 40, 0.15),
                new Subject("rough glass", TestScenes::roughGlass, true, false, 1, 40, 0.15),
                new Subject("rough glass", TestScenes::roughGlass, true, false, 3, 40, 0.15),
                new Subject("mirrored instance", TestScenes::mirroredInstance, true, false, 1, 40, 0.15),
                new Subject("mirrored instance", TestScenes::mirroredInstance, true, true, 1, 40, 0.15),
                new Subject("outdoors", TestScenes::outdoors, true, false, 1, 80, 0.3),
                new Subject("outdoors", TestScenes::outdoors, true, false, 3, 80, 0.3),
                new Subject("outdoors", TestScenes::outdoors, true, true, 1, 80, 0.3),
                new Subject("point and spot", TestScenes::pointAndSpot, false, false, 1, 40, 0.15),
                new Subject("point and spot", TestScenes::pointAndSpot, false, true, 1, 40, 0.15));
    }

    @ParameterizedTest
    @MethodSource("subjects")
    void techniquesAgree(Subject subject) {
        check(subject, 1);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("subjects")
    void techniquesAgreeClosely(Subject subject) {
        check(subject, 16);
    }

    private static void check(Subject subject, int factor) {
        Scene scene = subject.maker.apply(SIZE);
        Run[] runs = new Run[RUNS];
        for (int i = 0; i < RUNS; i++) {
            runs[i] = new Run(scene, subject, 100 + i, factor * subject.samplesPerPixel);
        }
        List<String> names = new ArrayList<>();
        List<double[]> all = new ArrayList<>();
        for (int k = 2; k <= EDGES; k++) {
            int edges = k;
            double[][] expected = tiles(runs, run -> run.techniques[edges][1]);
            for (int s = 0; s <= k + 2; s++) {
                if (s == 1 || (s == 0 && !subject.hittable) || (s == k + 1 && !subject.lensHits)) {
                    continue;
                }
                int technique = s;
                boolean sum = s == k + 2;
                double[][] actual = tiles(runs, run -> sum ? run.weighted[edges] : run.techniques[edges][technique]);
                String name = subject + ", " + k + " edges, " + (sum ? "weighted" : "s = " + s);
                assertTrue(Arrays.stream(actual).anyMatch(run -> run[TILES] > 0), () -> name + ": nothing is found");
                names.add(name);
                all.add(ZTest.tilesOfRuns(expected, actual));
                if (k == 2 || k == 3) {
                    double wrong = 1 + (sum ? subject.detectable : 1) / Math.sqrt(factor);
                    double[] brighter = ZTest.tilesOfRuns(expected, scaled(actual, wrong));
                    assertTrue(
                            Arrays.stream(brighter).anyMatch(p -> p < SIGNIFICANCE / TILES),
                            () -> name + ": too bright an image is not found out: " + Arrays.toString(brighter));
                }
            }
        }
        int tests = all.size() * (TILES + 1);
        double level = Significance.sidak(SIGNIFICANCE, tests);
        List<String> wrong = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            double[] pValues = all.get(i);
            if (Arrays.stream(pValues).anyMatch(p -> !(p >= level))) {
                wrong.add(names.get(i) + ": " + Arrays.toString(pValues));
            }
        }
        assertTrue(wrong.isEmpty(), () -> String.join("\n", wrong));
    }

    /** Tile means and, last, the mean of all of them, of each run. */
    private static double[][] tiles(Run[] runs, Function<Run, double[]> values) {
        double[][] result = new double[runs.length][];
        for (int i = 0; i < runs.length; i++) {
            double[] tiles = values.apply(runs[i]);
            result[i] = Arrays.copyOf(tiles, TILES + 1);
            result[i][TILES] = Arrays.stream(tiles).sum() / TILES;
        }
        return result;
    }

    private static double[][] scaled(double[][] runs, double factor) {
        return Arrays.stream(runs)
                .map(run -> Arrays.stream(run).map(v -> factor * v).toArray())
                .toArray(double[][]::new);
    }

    /** An image for each number of edges and each technique. */
    private static final class Run implements Contribution.Listener {
        final double[][][] techniques = new double[EDGES + 1][EDGES + 2][TILES];
        final double[][] weighted = new double[EDGES + 1][TILES];
        private final Scene scene;
        private final boolean hittable;
        private final int samplesPerPixel;

        Run(Scene scene, Subject subject, long seed, int samplesPerPixel) {
            this.scene = scene;
            hittable = subject.hittable;
            this.samplesPerPixel = samplesPerPixel;
            BidirectionalSettings settings = new BidirectionalSettings(
                    -1,
                    -1,
                    EDGES,
                    2,
                    BidirectionalSettings.Roulette.THROUGHPUT,
                    2,
                    subject.splitting,
                    subject.allLights,
                    true,
                    0.25,
                    subject.lensHits,
                    1);
            Camera camera = scene.camera();
            BiDirectionalProcessor processor = new BiDirectionalProcessor(scene, camera, false, settings, this);
            Sampler sampler = new SobolSampling().newSampler(seed, samplesPerPixel);
            RaySample sample = new RaySample();
            SplatBuffer splats = new SplatBuffer();
            for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
                int row = pixel / SIZE;
                for (int i = 0; i < samplesPerPixel; i++) {
                    sampler.start(pixel, i);
                    double x = pixel % SIZE + sampler.next();
                    double y = row + sampler.next();
                    splats.clear();
                    processor.trace(x, y, sampler, sample, splats);
                }
            }
        }

        @Override
        public void found(Contribution c) {
            if (scene.light(c.lightIndex).isDelta() == hittable) {
                return;
            }
            int k = c.s + c.t - 1;
            int tile = ((int) (c.filmY / TILE)) * (SIZE / TILE) + (int) (c.filmX / TILE);
            // Splats of all samples land in a pixel, and each stands for as many pixels as there are.
            double samples = (c.t <= 1 ? (double) SIZE * SIZE : 1) * samplesPerPixel * TILE * TILE;
            double value = Spectrum.luminance(c.r, c.g, c.b) / samples;
            techniques[k][c.s][tile] += value;
            weighted[k][tile] += c.weight * value;
        }
    }
}
