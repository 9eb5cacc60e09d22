package org.daybreak.convergence;

import java.nio.file.Path;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.ImageFileException;

/**
 * An image that other programs rendered, with the standard error of each pixel: {@code src/test/resources/reference}. Its
 * README says how it may be used.
 */
final class ReferenceImage {
    /** Edge of the window over which variances are averaged: that of a pixel rests on 6 to 7 degrees of freedom. */
    private static final int SMOOTHING = 7;

    private final boolean correlated;
    private final ExrImage mean;
    private final ExrImage error;

    private ReferenceImage(boolean correlated, ExrImage mean, ExrImage error) {
        this.correlated = correlated;
        this.mean = mean;
        this.error = error;
    }

    static ReferenceImage of(String scene) throws ImageFileException {
        Path folder = ShippedScenes.repository()
                .resolve("src/test/resources/reference")
                .resolve(scene);
        return new ReferenceImage(
                // Part of this image comes from Markov chains, whose errors neighbouring pixels share.
                scene.equals("door_ajar"),
                ExrReader.read(folder.resolve("reference.exr")),
                ExrReader.read(folder.resolve("standard_error.exr")));
    }

    int width() {
        return mean.width();
    }

    int height() {
        return mean.height();
    }

    /** Values of a channel, pixel by pixel. */
    double[] values(String channel) {
        return Runs.toDoubles(mean.samples(channel));
    }

    /** Variances of these values, smoothed. */
    double[] variances(String channel) {
        float[] errors = error.samples(channel);
        double[] variances = new double[errors.length];
        for (int i = 0; i < variances.length; i++) {
            variances[i] = (double) errors[i] * errors[i];
        }
        return boxMean(variances, width(), SMOOTHING);
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
