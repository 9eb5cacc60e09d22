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
     * One channel as a grey image.
     *
     * @param index 0 red, 1 green, 2 blue, 3 opacity; red, green and blue of a grey image are its grey, and where there is
     *     no opacity it is 1
     */
    default LoadedImage channel(int index) {
        int count = channels();
        int pixels = width() * height();
        boolean alpha = index == 3;
        int offset = alpha ? (count % 2 == 0 ? count - 1 : -1) : count < 3 ? 0 : index;
        if (this instanceof Bytes b) {
            byte[] out = new byte[pixels];
            for (int i = 0; i < pixels; i++) {
                out[i] = offset < 0 ? (byte) 255 : b.samples[count * i + offset];
            }
            return new Bytes(width(), height(), 1, out);
        }
        Floats f = (Floats) this;
        float[] out = new float[pixels];
        for (int i = 0; i < pixels; i++) {
            out[i] = offset < 0 ? 1 : f.samples[count * i + offset];
        }
        return new Floats(width(), height(), 1, out, f.encoded && !alpha);
    }

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
