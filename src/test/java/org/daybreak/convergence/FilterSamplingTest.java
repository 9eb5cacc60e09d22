package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Samples drawn in proportion to the filter against samples that are spread evenly and count for all pixels around: the same
 * image, edges included, by Welch's t-test of 2×2 tiles over independent runs. False-alarm rate 1e-4 for each filter by
 * Šidák's correction; seeds are fixed.
 */
class FilterSamplingTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int SIZE = 16;
    private static final int RUNS = 24;

    @ParameterizedTest
    @ValueSource(strings = {"BOX", "TENT", "GAUSSIAN", "MITCHELL", "CATMULL_ROM", "BLACKMAN_HARRIS", "LANCZOS"})
    void bothWaysGiveTheSameImage(String name) throws ReflectiveOperationException {
        ReconstructionFilter filter =
                (ReconstructionFilter) ReconstructionFilter.class.getField(name).get(null);
        Runs evenly = Runs.of(Rendering.renderer("path"), scene(filter, false), 5000, RUNS, 64);
        Runs byFilter = Runs.of(Rendering.renderer("path"), scene(filter, true), 6000, RUNS, 64);
        ZTest.assertNoneRejected(name, pValues(evenly, byFilter, 1), SIGNIFICANCE);
        double[] wrong = pValues(evenly, byFilter, 1.05);
        assertThrows(AssertionError.class, () -> ZTest.assertNoneRejected(name, wrong, SIGNIFICANCE));
    }

    private static Scene scene(ReconstructionFilter filter, boolean sampling) {
        SceneGraph graph = java.util.Objects.requireNonNull(CrossScenes.all().get("rectangle"));
        graph.setFilm(new FilmSettings(SIZE, SIZE, filter).withFilterSampling(sampling));
        return SceneCompiler.compile(graph);
    }

    private static double[] pValues(Runs a, Runs b, double factor) {
        List<double[]> parts = new ArrayList<>();
        for (String channel : Runs.CHANNELS) {
            for (int size : new int[] {2, SIZE}) {
                double[][] scaled = Arrays.stream(b.tiles(channel, size))
                        .map(run -> Arrays.stream(run).map(v -> factor * v).toArray())
                        .toArray(double[][]::new);
                parts.add(ZTest.tilesOfRuns(a.tiles(channel, size), scaled));
            }
        }
        return parts.stream().flatMapToDouble(Arrays::stream).toArray();
    }
}
