package org.daybreak.tracing;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Map;
import org.daybreak.antialiasing.AdaptiveSampling;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Numbers of samples that depend on the samples do not change the mean, and make the error smaller where it pays. */
class AdaptiveTest {
    private static Antialiasing adaptive(Map<String, String> parameters) {
        AdaptiveSampling method = new AdaptiveSampling();
        return method.create(ParameterValues.parse(method.parameters(), parameters, method.id()));
    }

    private static double[][] blocks(
            Scene scene,
            ReconstructionFilter filter,
            Antialiasing method,
            long firstSeed,
            int runs,
            int spp,
            int block) {
        double[][] means = new double[runs][];
        for (int i = 0; i < runs; i++) {
            Film film =
                    new Film(new FilmSettings(scene.film().width(), scene.film().height(), filter));
            RenderContext context = new RenderContext(
                    firstSeed + i, 2, RenderBudget.samples(spp), method, new CancellationToken(), RenderListener.NONE);
            Rendering.renderer("path", Map.of()).render(scene, scene.camera(), film, context);
            means[i] = Rendering.blocks(film.develop(), "G", block);
        }
        return means;
    }

    /**
     * A first pass of two samples errs in most pixels of this scene, so a dependence of the mean on the numbers would show.
     * Welch's t-tests on blocks; false-alarm rate 1e-5 per assertion, Šidák-corrected over the blocks.
     */
    @ParameterizedTest
    @EnumSource(
            value = ReconstructionFilter.Kind.class,
            names = {"BOX", "GAUSSIAN"})
    void meanIsThatOfUniformSampling(ReconstructionFilter.Kind kind) {
        Scene scene = TestScenes.cornell(24, 16);
        ReconstructionFilter filter =
                kind == ReconstructionFilter.Kind.BOX ? ReconstructionFilter.BOX : ReconstructionFilter.GAUSSIAN;
        double[][] uniform = blocks(scene, filter, new SobolSampling(), 1, 32, 64, 4);
        double[][] adaptive =
                blocks(scene, filter, adaptive(Map.of("firstPass", "2", "uniformShare", "0.05")), 1000, 96, 16, 4);
        ZTest.assertNoneRejected("adaptive", ZTest.tilesOfRuns(uniform, adaptive), 1e-5);
    }

    /**
     * Three quarters of the image are black and need no samples. At the same number of samples the squared error, from the
     * differences of independent pairs of runs, must be less: Welch's t-test on their logarithms. Were both errors distributed alike,
     * this test would pass with a probability below 1e-4. Measured: a tenth.
     */
    @ParameterizedTest
    @ValueSource(strings = {"relative", "absolute"})
    void errorIsSmallerWhereNoiseIsUneven(String error) {
        Scene scene = TestScenes.distantRoom(80, 60);
        double[][] uniform = blocks(scene, ReconstructionFilter.BOX, new SobolSampling(), 1, 16, 64, 1);
        double[][] adaptive = blocks(scene, ReconstructionFilter.BOX, adaptive(Map.of("error", error)), 500, 16, 64, 1);
        double[] means = mean(uniform);
        if (error.equals("absolute")) {
            Arrays.fill(means, 1);
        }
        Moments before = logarithmsOfErrors(uniform, means);
        Moments after = logarithmsOfErrors(adaptive, means);
        String what = "adaptive " + Math.exp(after.mean()) + ", uniform " + Math.exp(before.mean());
        assertTrue(after.mean() < before.mean(), what);
        double pValue = ZTest.twoSample(before, after);
        assertTrue(pValue < 1e-4, () -> what + ", p = " + pValue);
    }

    private static double[] mean(double[][] runs) {
        double[] means = new double[runs[0].length];
        for (double[] run : runs) {
            for (int p = 0; p < means.length; p++) {
                means[p] += run[p] / runs.length;
            }
        }
        return means;
    }

    /** Of the squared errors over the squares of the means and a little. */
    private static Moments logarithmsOfErrors(double[][] runs, double[] means) {
        Moments errors = new Moments();
        for (int i = 0; i < runs.length; i += 2) {
            double sum = 0;
            for (int p = 0; p < means.length; p++) {
                double difference = runs[i][p] - runs[i + 1][p];
                sum += difference * difference / (means[p] * means[p] + 0.01);
            }
            errors.add(Math.log(sum / means.length));
        }
        return errors;
    }
}
