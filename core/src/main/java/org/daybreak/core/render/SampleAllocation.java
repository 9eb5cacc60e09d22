package org.daybreak.core.render;

/**
 * Divides samples among the pixels by what earlier passes have shown.
 *
 * <p>A render works in passes. The numbers of a pass are fixed before its first sample is taken, its random numbers are
 * independent of those of earlier passes, and the weight of a pass in the image is fixed from the start. So each pass is an
 * unbiased image of its own, and so is their weighted mean, although the numbers depend on the values.
 */
public interface SampleAllocation {
    /**
     * The average number of samples per pixel of each pass, in order. The first pass has this number in every pixel.
     *
     * @param samplesPerPixel average number of samples per pixel in all
     */
    long[] passes(long samplesPerPixel);

    /**
     * Chooses the numbers of samples of a pass that is not the first.
     *
     * @param width columns
     * @param height rows
     * @param means mean luminance of each pixel, row by row
     * @param deviations standard deviation of a single sample's luminance, NaN where it is unknown
     * @param average the average number of samples per pixel to aim at
     * @param counts receives the number of samples of each pixel, at least 1
     */
    void allocate(int width, int height, double[] means, double[] deviations, long average, int[] counts);
}
