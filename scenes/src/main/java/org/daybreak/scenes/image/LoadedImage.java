package org.daybreak.scenes.image;

/**
 * The pixels of an image file, row by row from the top, channels interleaved: 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and
 * alpha. The arrays belong to the image and must not be changed.
 */
public sealed interface LoadedImage {
    /** Width in pixels. */
    int width();

    /** Height in pixels. */
    int height();

    /** Number of interleaved channels, 1 to 4. */
    int channels();

    /**
     * An image with 8 bits per channel, as stored: values are encoded by the sRGB transfer function unless the user of the
     * file knows better ("raw").
     */
    record Bytes(int width, int height, int channels, byte[] samples) implements LoadedImage {
        /** Checks the sizes. */
        public Bytes {
            check(width, height, channels, samples.length);
        }
    }

    /**
     * An image of floats.
     *
     * @param encoded true if values lie in [0, 1] and are encoded by the sRGB transfer function, false if they are linear
     */
    record Floats(int width, int height, int channels, float[] samples, boolean encoded) implements LoadedImage {
        /** Checks the sizes. */
        public Floats {
            check(width, height, channels, samples.length);
        }
    }

    private static void check(int width, int height, int channels, int samples) {
        if (width < 1 || height < 1 || channels < 1 || channels > 4 || (long) width * height * channels != samples) {
            throw new IllegalArgumentException("an image of " + width + "x" + height + " pixels with " + channels
                    + " channels does not have " + samples + " samples");
        }
    }
}
