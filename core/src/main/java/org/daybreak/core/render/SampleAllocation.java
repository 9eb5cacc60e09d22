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
     * What the passes so far say of the luminance of the pixels, row by row. Immutable as long as the arrays are not written to.
     *
     * @param width columns
     * @param height rows
     * @param means means
     * @param deviations standard deviation that a single sample would have were samples independent, estimated from the difference
     *     between the last pass and those before it: the mean of its square over pixels is unbiased, each by itself is
     *     hardly more than a guess. Not the scatter of the samples within a pixel, of which stratification removes a part. NaN
     *     where it is unknown.
     */
    record Statistics(int width, int height, double[] means, double[] deviations) {}

    /**
     * Chooses the numbers of samples of a pass that is not the first.
     *
     * @param statistics what the passes before it have shown
     * @param average the average number of samples per pixel to aim at
     * @param counts receives the number of samples of each pixel, at least 1
     */
    void allocate(Statistics statistics, long average, int[] counts);
}
