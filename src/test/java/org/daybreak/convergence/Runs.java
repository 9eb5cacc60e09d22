package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Grids;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;

/**
 * Independent renders of one scene with different seeds. Mean and variance over them need nothing to be independent
 * within a render: not the samples of a pixel, which low-discrepancy points and shared light subpaths are not, nor
 * neighbouring pixels.
 *
 * <p>What the t-tests take for granted is that a tile's mean in one run is near normal. So tiles and runs are made large
 * enough that each such mean rests on hundreds of samples.
 */
final class Runs {
    /** Names of the colour channels. */
    static final List<String> CHANNELS = List.of("R", "G", "B");

    private final int width;
    private final int height;
    private final List<FilmImage> images;

    private Runs(int width, int height, List<FilmImage> images) {
        this.width = width;
        this.height = height;
        this.images = images;
    }

    /**
     * Renders.
     *
     * @param firstSeed seed of the first run; the others have the seeds after it
     * @param runs number of runs
     * @param samplesPerPixel samples per pixel of each run
     */
    static Runs of(Renderer renderer, Scene scene, long firstSeed, int runs, long samplesPerPixel) {
        List<FilmImage> images = new ArrayList<>();
        for (int i = 0; i < runs; i++) {
            images.add(Rendering.render(renderer, scene, firstSeed + i, samplesPerPixel));
        }
        return new Runs(scene.film().width(), scene.film().height(), images);
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    List<FilmImage> images() {
        return images;
    }

    /** A value per pixel for each run, as double. */
    double[][] pixels(String channel) {
        return images.stream().map(image -> toDoubles(image.channel(channel))).toArray(double[][]::new);
    }

    /** The mean over the runs of each pixel. */
    double[] mean(String channel) {
        double[] mean = new double[width * height];
        for (double[] run : pixels(channel)) {
            for (int i = 0; i < mean.length; i++) {
                mean[i] += run[i] / images.size();
            }
        }
        return mean;
    }

    /** Tile means of each run. */
    double[][] tiles(String channel, int tile) {
        return Arrays.stream(pixels(channel))
                .map(run -> Grids.tileMeans(run, width, tile))
                .toArray(double[][]::new);
    }

    /** The moments over runs of one column of an array of runs. */
    static Moments moments(double[][] runs, int column) {
        Moments moments = new Moments();
        for (double[] run : runs) {
            moments.add(run[column]);
        }
        return moments;
    }

    /**
     * p-values of one-sample t-tests of the means of runs.
     *
     * @param runs values of each run
     * @param expected their expectation
     * @param allowance by how much the expectation may be off for reasons other than noise, such as rounding, relative
     */
    static double[] pValues(double[][] runs, double[] expected, double allowance) {
        double[] pValues = new double[expected.length];
        for (int i = 0; i < pValues.length; i++) {
            Moments moments = moments(runs, i);
            double excess = Math.abs(moments.mean() - expected[i]) - allowance * Math.abs(expected[i]);
            double error = Math.sqrt(moments.varianceOfMean());
            if (excess <= 0) {
                pValues[i] = 1;
            } else {
                pValues[i] = Significance.student(excess / error, moments.count() - 1.0);
            }
        }
        return pValues;
    }

    /**
     * p-values of Welch's t-tests against other runs: of tiles of all channels, and of the means of the image.
     *
     * @param factor by which the others are made brighter
     */
    double[] pValues(Runs other, int tile, double factor) {
        List<double[]> parts = new ArrayList<>();
        for (String channel : CHANNELS) {
            for (int size : new int[] {tile, width}) {
                double[][] scaled = Arrays.stream(other.tiles(channel, size))
                        .map(run -> Arrays.stream(run).map(v -> factor * v).toArray())
                        .toArray(double[][]::new);
                parts.add(ZTest.tilesOfRuns(tiles(channel, size), scaled));
            }
        }
        return parts.stream().flatMapToDouble(Arrays::stream).toArray();
    }

    /**
     * Fails if other runs have other means, by the t-tests above, or if the tests would pass them by were they brighter or darker.
     *
     * @param what what is compared, for messages
     * @param detectable relative error of the brightness that must be found
     * @param significance the false-alarm rate
     */
    void assertAgreement(String what, Runs other, int tile, double detectable, double significance) {
        ZTest.assertNoneRejected(what, pValues(other, tile, 1), significance);
        for (double wrong : new double[] {1 - detectable, 1 + detectable}) {
            double[] pValues = pValues(other, tile, wrong);
            assertThrows(
                    AssertionError.class,
                    () -> ZTest.assertNoneRejected(what, pValues, significance),
                    () -> what + ": an image " + wrong + " times as bright is not found out");
        }
    }

    static double[] toDoubles(float[] values) {
        double[] result = new double[values.length];
        for (int i = 0; i < result.length; i++) {
            result[i] = values[i];
        }
        return result;
    }
}
