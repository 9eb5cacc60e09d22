package org.daybreak.exr;

/**
 * A PFM image.
 *
 * @param width columns, at least 1
 * @param height rows, at least 1
 * @param components 1 (grey) or 3 (red, green, blue)
 * @param samples index {@code (y * width + x) * components + c}, rows from top to bottom; not copied
 * @param scale the positive scale factor of the file; by convention the unit of the samples. It is kept, the samples are
 *     not multiplied by it
 */
public record PfmImage(int width, int height, int components, float[] samples, float scale) {
    /**
     * Checks the sizes.
     *
     * @throws IllegalArgumentException if a size is below 1, there are not 1 or 3 components, the array has another
     *     length, or the scale is not positive and finite
     */
    public PfmImage {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("an image needs at least one pixel, not " + width + " x " + height);
        }
        if (components != 1 && components != 3) {
            throw new IllegalArgumentException("PFM holds 1 or 3 components, not " + components);
        }
        // Divided, as the product of three ints may not fit a long.
        if (samples.length % components != 0 || samples.length / components != (long) width * height) {
            throw new IllegalArgumentException(
                    samples.length + " samples for " + width + " x " + height + " x " + components);
        }
        if (!(scale > 0 && scale <= Float.MAX_VALUE)) {
            throw new IllegalArgumentException("the scale must be positive and finite, not " + scale);
        }
    }

    /**
     * Creates an image with scale 1.
     *
     * @param width columns
     * @param height rows
     * @param components 1 or 3
     * @param samples rows from top to bottom; not copied
     * @throws IllegalArgumentException as the canonical constructor
     */
    public PfmImage(int width, int height, int components, float[] samples) {
        this(width, height, components, samples, 1);
    }
}
