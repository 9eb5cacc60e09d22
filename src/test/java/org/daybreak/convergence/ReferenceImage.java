package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.daybreak.core.testing.Grids;
import org.daybreak.core.testing.Moments;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.ImageFileException;

/**
 * An image with the variance of each pixel: one that other programs rendered, in {@code src/test/resources/reference}, whose
 * README says how it may be used; or the means of independent runs of a renderer of ours.
 */
final class ReferenceImage {
    /** Edge of the window over which variances are averaged: that of a pixel rests on 6 to 7 degrees of freedom. */
    private static final int SMOOTHING = 7;

    private final boolean correlated;
    private final int width;
    private final int height;
    private final Map<String, double[]> means;
    private final Map<String, double[]> variances;

    private ReferenceImage(
            boolean correlated, int width, int height, Map<String, double[]> means, Map<String, double[]> variances) {
        this.correlated = correlated;
        this.width = width;
        this.height = height;
        this.means = means;
        this.variances = variances;
    }

    static ReferenceImage of(String scene) throws ImageFileException {
        Path folder = ShippedScenes.repository()
                .resolve("src/test/resources/reference")
                .resolve(scene);
        ExrImage mean = ExrReader.read(folder.resolve("reference.exr"));
        ExrImage error = ExrReader.read(folder.resolve("standard_error.exr"));
        Map<String, double[]> means = new HashMap<>();
        Map<String, double[]> variances = new HashMap<>();
        for (String channel : Runs.CHANNELS) {
            means.put(channel, Runs.toDoubles(mean.samples(channel)));
            double[] squares = Arrays.stream(Runs.toDoubles(error.samples(channel)))
                    .map(e -> e * e)
                    .toArray();
            variances.put(channel, boxMean(squares, mean.width(), SMOOTHING));
        }
        // Part of this image comes from Markov chains, whose errors neighbouring pixels share.
        boolean correlated = scene.equals("door_ajar");
        return new ReferenceImage(correlated, mean.width(), mean.height(), means, variances);
    }

    /** The means of the tiles of independent runs, a pixel for each. */
    static ReferenceImage of(Runs runs, int tile) {
        Map<String, double[]> means = new HashMap<>();
        Map<String, double[]> variances = new HashMap<>();
        int tiles = Grids.tiles(runs.width(), tile) * Grids.tiles(runs.height(), tile);
        for (String channel : Runs.CHANNELS) {
            double[][] values = runs.tiles(channel, tile);
            double[] mean = new double[tiles];
            double[] variance = new double[tiles];
            for (int i = 0; i < tiles; i++) {
                Moments moments = Runs.moments(values, i);
                mean[i] = moments.mean();
                variance[i] = moments.varianceOfMean();
            }
            means.put(channel, mean);
            variances.put(channel, variance);
        }
        return new ReferenceImage(
                false, Grids.tiles(runs.width(), tile), Grids.tiles(runs.height(), tile), means, variances);
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** Values of a channel, pixel by pixel. */
    double[] values(String channel) {
        return value(means, channel);
    }

    /** Variances of these values. */
    double[] variances(String channel) {
        return value(variances, channel);
    }

    private static double[] value(Map<String, double[]> channels, String channel) {
        double[] values = channels.get(channel);
        assertNotNull(values);
        return values;
    }

    /**
     * What the variance of the mean of a block of pixels is, as a part of the mean variance of its pixels: 1/n if pixels
     * are independent.
     *
     * @param pixels n
     */
    double varianceOfMean(int pixels) {
        return correlated ? 1 : 1.0 / pixels;
    }

    /** The mean over a square window around each value; at the edges over what there is of it. */
    static double[] boxMean(double[] values, int width, int window) {
        int height = values.length / width;
        int reach = window / 2;
        double[] result = new double[values.length];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                double sum = 0;
                int count = 0;
                for (int v = Math.max(0, y - reach); v <= Math.min(height - 1, y + reach); v++) {
                    for (int u = Math.max(0, x - reach); u <= Math.min(width - 1, x + reach); u++) {
                        sum += values[v * width + u];
                        count++;
                    }
                }
                result[y * width + x] = sum / count;
            }
        }
        return result;
    }
}
