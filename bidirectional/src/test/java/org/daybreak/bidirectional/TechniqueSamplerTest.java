package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.RaySample;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A technique sampled alone brings what it brings to a whole sample of the same numbers; short paths can be left out. */
class TechniqueSamplerTest {
    private static final int SIZE = 12;
    private static final int SAMPLES = 600;
    private static final int EDGES = 5;

    private final Map<String, double[]> found = new HashMap<>();

    static Stream<Arguments> subjects() {
        return Stream.of(
                subject("room", TestScenes::room, -1, -1, true),
                subject("room", TestScenes::room, 3, 2, true),
                subject("room", TestScenes::room, 1, -1, true),
                subject("room", TestScenes::room, -1, -1, false),
                subject("room through a lens", TestScenes::roomThroughLens, -1, -1, true),
                subject("room of parallel rays", TestScenes::roomOfParallelRays, -1, -1, true),
                subject("rough glass", TestScenes::roughGlass, -1, -1, true),
                subject("outdoors", TestScenes::outdoors, -1, -1, true),
                subject("outdoors", TestScenes::outdoors, 1, -1, true),
                subject("point and spot", TestScenes::pointAndSpot, -1, -1, true),
                subject("everything", size -> TestScenes.everything(size, size), -1, -1, true));
    }

    private static Arguments subject(
            String name, IntFunction<Scene> maker, int maxEyeDepth, int maxLightDepth, boolean causticMap) {
        return Arguments.of(
                name,
                maker,
                new BidirectionalSettings(
                        maxEyeDepth,
                        maxLightDepth,
                        EDGES,
                        2,
                        BidirectionalSettings.Roulette.NONE,
                        3,
                        1,
                        false,
                        causticMap));
    }

    @ParameterizedTest
    @MethodSource("subjects")
    void techniqueAloneIsThatOfTheSample(String name, IntFunction<Scene> maker, BidirectionalSettings settings) {
        Scene scene = maker.apply(SIZE);
        BiDirectionalProcessor processor =
                new BiDirectionalProcessor(scene, scene.camera(), false, settings, this::record);
        TechniqueSampler techniques = new TechniqueSampler(scene, scene.camera(), settings);
        Sampler sampler = new SobolSampling().newSampler(1, SAMPLES);
        RaySample sample = new RaySample();
        SplatBuffer splats = new SplatBuffer();
        int positive = 0;
        for (int i = 0; i < SAMPLES; i++) {
            found.clear();
            sampler.start(0, i);
            double filmX = SIZE * sampler.next();
            double filmY = SIZE * sampler.next();
            splats.clear();
            processor.trace(filmX, filmY, sampler, sample, splats);
            int matched = 0;
            for (int edges = 1; edges <= EDGES; edges++) {
                for (int number = 0; number < techniques.techniques(edges); number++) {
                    int s = techniques.lightVertices(edges, number);
                    assertEquals(number, techniques.number(edges, s));
                    splats.clear();
                    assertTrue(techniques.trace(edges, s, filmX, filmY, sampler, sample, splats));
                    double[] expected = found.get(s + "," + (edges + 1 - s));
                    double[] actual = s == edges
                            ? splats.size() == 0
                                    ? new double[3]
                                    : new double[] {splats.value(0, 0), splats.value(0, 1), splats.value(0, 2)}
                            : new double[] {sample.radiance.r, sample.radiance.g, sample.radiance.b};
                    for (int c = 0; c < 3; c++) {
                        double value = expected == null ? 0 : expected[c];
                        assertEquals(value, actual[c], 1e-12 * value, name + ", s = " + s + ", edges " + edges);
                    }
                    if (expected != null) {
                        matched++;
                        positive += expected[1] > 0 ? 1 : 0;
                    }
                    assertTrue(s < edges || sample.radiance.isBlack());
                    assertTrue(s == edges || splats.size() == 0);
                }
            }
            assertEquals(found.size(), matched, "a technique of the sample is not in the list of those of its length");
        }
        assertTrue(positive > SAMPLES / 50, () -> name + ": hardly anything was found");
    }

    private void record(Contribution c) {
        double[] sum = found.computeIfAbsent(c.s + "," + c.t, key -> new double[3]);
        sum[0] += c.weight * c.r;
        sum[1] += c.weight * c.g;
        sum[2] += c.weight * c.b;
    }

    /** Paths of fewer edges add nothing, and the others what they added before. */
    @Test
    void shortPathsCanBeLeftOut() {
        Scene scene = TestScenes.everything(SIZE, SIZE);
        for (int edges = 1; edges <= EDGES; edges++) {
            int shortest = edges;
            BidirectionalSettings all = new BidirectionalSettings(
                    -1, -1, -1, 2, BidirectionalSettings.Roulette.THROUGHPUT, 3, 2, false, true);
            double[] expected = new double[2];
            double[] actual = new double[2];
            sum(scene, all, shortest, expected);
            sum(scene, all.withMinDepth(edges), 1, actual);
            assertTrue(expected[0] > 0 && expected[1] > 0);
            assertEquals(expected[0], actual[0], 1e-12 * expected[0], "eye side");
            assertEquals(expected[1], actual[1], 1e-12 * expected[1], "splats");
        }
    }

    /** Adds up the weighted contributions of paths of so many edges or more: of the eye side, and splats. */
    private static void sum(Scene scene, BidirectionalSettings settings, int shortest, double[] sums) {
        BiDirectionalProcessor processor = new BiDirectionalProcessor(scene, scene.camera(), false, settings, c -> {
            if (c.s + c.t > shortest) {
                sums[c.t == 1 ? 1 : 0] += c.weight * c.g;
            }
        });
        Sampler sampler = new SobolSampling().newSampler(1, SAMPLES);
        RaySample sample = new RaySample();
        SplatBuffer splats = new SplatBuffer();
        double radiance = 0;
        double splatted = 0;
        for (int i = 0; i < SAMPLES; i++) {
            sampler.start(0, i);
            splats.clear();
            processor.trace(SIZE * sampler.next(), SIZE * sampler.next(), sampler, sample, splats);
            radiance += sample.radiance.g;
            for (int j = 0; j < splats.size(); j++) {
                splatted += splats.value(j, 1);
            }
        }
        if (shortest == 1) {
            assertEquals(sums[0], radiance, 1e-12 * radiance);
            assertEquals(sums[1], splatted, 1e-12 * splatted);
        }
    }
}
