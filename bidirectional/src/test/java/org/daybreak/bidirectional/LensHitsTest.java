package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.SampleAddress;
import org.daybreak.core.render.SampleRecord;
import org.daybreak.core.render.SampleRequest;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Light paths that hit a lens with an area, technique t = 0. Seeds are fixed. */
class LensHitsTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int SIZE = 12;
    private static final int TILE = 4;
    private static final int RUNS = 24;

    private static FilmImage render(Scene scene, long seed, int samplesPerPixel, String... texts) {
        Map<String, String> values = new HashMap<>();
        for (int i = 0; i < texts.length; i += 2) {
            values.put(texts[i], texts[i + 1]);
        }
        BidirectionalRendererFactory factory = new BidirectionalRendererFactory();
        Film film = new Film(scene.film());
        RenderContext context = new RenderContext(
                seed,
                1,
                RenderBudget.samples(samplesPerPixel),
                new SobolSampling(),
                new CancellationToken(),
                RenderListener.NONE);
        factory.create(ParameterValues.parse(factory.parameters(), values, factory.id()))
                .render(scene, scene.camera(), film, context);
        return film.develop();
    }

    /**
     * With and without the technique the mean is the same: Welch's t-tests of tiles and of the whole image over independent runs, false
     * alarms with 1e-4 by Šidák's correction. An image that is brighter by a stated part is found out.
     */
    @ParameterizedTest
    @CsvSource({
        "russianRoulette, efficiency, splitting, 2, 0.08",
        "heuristicExponent, 0, splitting, 3, 0.2",
        "causticMap, false, splitting, 2, 0.08",
        "lightsPerPath, all, heuristicExponent, 1, 0.08",
        "maxDepth, 3, heuristicExponent, 1, 0.08",
        "maxLightDepth, 3, splitting, 1, 0.08"
    })
    void theMeanIsTheSame(String name, String value, String other, String otherValue, double detectable) {
        Scene scene = TestScenes.glassThroughWideLens(SIZE, SIZE);
        double[][] with = new double[RUNS][];
        double[][] without = new double[RUNS][];
        for (int i = 0; i < RUNS; i++) {
            with[i] = tiles(render(scene, i, 32, name, value, other, otherValue, "lensHits", "true"));
            without[i] = tiles(render(scene, 1000 + i, 32, name, value, other, otherValue));
        }
        double level = Significance.sidak(SIGNIFICANCE, with[0].length);
        double[] pValues = ZTest.tilesOfRuns(without, with);
        assertTrue(Arrays.stream(pValues).allMatch(p -> p >= level), () -> Arrays.toString(pValues));
        double[][] brighter = Arrays.stream(with)
                .map(run -> Arrays.stream(run).map(v -> (1 + detectable) * v).toArray())
                .toArray(double[][]::new);
        double[] wrong = ZTest.tilesOfRuns(without, brighter);
        assertTrue(Arrays.stream(wrong).anyMatch(p -> p < level), () -> Arrays.toString(wrong));
    }

    /** Means of the green channel in tiles and, last, in the image. */
    private static double[] tiles(FilmImage image) {
        int perSide = SIZE / TILE;
        double[] means = new double[perSide * perSide + 1];
        for (int y = 0; y < SIZE; y++) {
            for (int x = 0; x < SIZE; x++) {
                double value = image.get("G", x, y);
                means[y / TILE * perSide + x / TILE] += value / (TILE * TILE);
                means[means.length - 1] += value / (SIZE * SIZE);
            }
        }
        return means;
    }

    /**
     * A point light is seen as the disc that the lens makes of it, which no other technique finds: ∫ We·I·cos θ/r² over the lens is I
     * times the mean of the importance of lens points. A z-test over independent runs, false alarms with 1e-4.
     */
    @Test
    void aPointLightIsADisc() {
        Scene scene = TestScenes.pointBeforeWideLens(SIZE);
        Camera camera = scene.camera();
        LensSample lens = new LensSample();
        int n = 64;
        double[] expected = new double[SIZE * SIZE];
        double sum = 0;
        for (int i = 0; i < n * n; i++) {
            int row = i / n;
            assertTrue(camera.sampleLens(0.1, -0.05, -0.9, (i % n + 0.5) / n, (row + 0.5) / n, lens));
            expected[((int) lens.filmY) * SIZE + (int) lens.filmX] += 0.5 * lens.weight / (n * n);
            sum += 0.5 * lens.weight / (n * n);
        }
        Moments total = new Moments();
        double[] mean = new double[SIZE * SIZE];
        for (int run = 0; run < RUNS; run++) {
            FilmImage image = render(scene, run, 1024, "lensHits", "true");
            double all = 0;
            for (int p = 0; p < mean.length; p++) {
                all += image.channel("G")[p];
                mean[p] += image.channel("G")[p] / RUNS;
            }
            total.add(all);
        }
        ZTest.assertNotRejected("light in the disc", ZTest.oneSample(total, sum), SIGNIFICANCE);
        int lit = 0;
        for (int p = 0; p < mean.length; p++) {
            assertTrue(expected[p] > 0 || mean[p] < 0.01 * sum, "pixel " + p);
            lit += expected[p] > 0.01 * sum && mean[p] > 0 ? 1 : 0;
        }
        assertTrue(lit >= 4, lit + " pixels are lit");
        FilmImage without = render(scene, 0, 16);
        assertEquals(0, without.get("G", SIZE / 2, SIZE / 2));
    }

    @Test
    void replayTellsOfHits() {
        Scene scene = TestScenes.glassThroughWideLens(SIZE, SIZE);
        BidirectionalRendererFactory factory = new BidirectionalRendererFactory();
        Renderer renderer =
                factory.create(ParameterValues.parse(factory.parameters(), Map.of("lensHits", "true"), factory.id()));
        int hits = 0;
        for (int i = 0; i < 1000; i++) {
            SampleAddress address = new SampleAddress(3, i % SIZE, i / SIZE % SIZE, 0);
            SampleRequest request = new SampleRequest(address, scene.film(), new SobolSampling(), 1);
            SampleRecord record =
                    renderer.replay(scene, scene.camera(), request).orElseThrow();
            for (SampleRecord.Contribution c : record.contributions()) {
                if (c.t() == 0) {
                    assertTrue(c.s() >= 2 && c.eyePath() == -1, c.toString());
                    boolean hit = c.outcome() == SampleRecord.Outcome.SPLATTED;
                    assertTrue(hit || c.outcome() == SampleRecord.Outcome.ZERO, c.toString());
                    hits += hit ? 1 : 0;
                }
            }
        }
        assertTrue(hits > 0, "no hits");
    }

    /** A lens that is a point cannot be hit: the option changes nothing. */
    @Test
    void pinholesAreNotHit() {
        Scene scene = TestScenes.everything(24, 18);
        FilmImage with = render(scene, 1, 4, "lensHits", "true", "maxDepth", "5");
        FilmImage without = render(scene, 1, 4, "maxDepth", "5");
        assertArrayEquals(without.channel("R"), with.channel("R"));
    }
}
