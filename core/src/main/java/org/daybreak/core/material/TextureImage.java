package org.daybreak.core.material;

import org.daybreak.core.color.ColorSpaces;
import org.jspecify.annotations.Nullable;

/**
 * Pixels of a texture, in linear values: one channel (grey) or three (RGB). Bytes stay bytes and are decoded by a table
 * as they are read; everything else is kept as floats. Immutable.
 *
 * <p>Row 0 is the first row of the file, the top of the picture.
 */
public final class TextureImage {
    private static final float[] SRGB = decodeTable(true);
    private static final float[] RAW = decodeTable(false);

    private final int width;
    private final int height;
    private final int channels;
    /** Exactly one of {@code bytes} and {@code floats} is there. */
    private final byte @Nullable [] bytes;

    private final float @Nullable [] floats;
    private final float[] decode;

    private TextureImage(
            int width, int height, int channels, byte @Nullable [] bytes, float @Nullable [] floats, float[] decode) {
        this.width = width;
        this.height = height;
        this.channels = channels;
        this.bytes = bytes;
        this.floats = floats;
        this.decode = decode;
    }

    /**
     * Creates an image from 8-bit values encoded by the sRGB transfer function.
     *
     * @param channels interleaved channels of {@code data}: 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha; alpha is
     *     dropped
     * @param data values row by row; copied
     * @throws IllegalArgumentException if the size is not positive or does not fit the data
     */
    public static TextureImage fromSrgbBytes(int width, int height, int channels, byte[] data) {
        return fromBytes(width, height, channels, data, SRGB);
    }

    /**
     * Creates an image from 8-bit values where 0 … 255 stand for 0 … 1 linearly; otherwise as {@link #fromSrgbBytes}.
     */
    public static TextureImage fromRawBytes(int width, int height, int channels, byte[] data) {
        return fromBytes(width, height, channels, data, RAW);
    }

    /**
     * Creates an image from linear values.
     *
     * @param channels as for {@link #fromSrgbBytes}
     * @param data values row by row; copied
     * @throws IllegalArgumentException if the size is not positive or does not fit the data, or a value is negative or
     *     not finite
     */
    public static TextureImage fromFloats(int width, int height, int channels, float[] data) {
        int kept = requireLayout(width, height, channels, data.length);
        float[] floats = new float[width * height * kept];
        for (int i = 0; i < width * height; i++) {
            for (int c = 0; c < kept; c++) {
                float value = data[i * channels + c];
                if (!(value >= 0 && value < Float.POSITIVE_INFINITY)) {
                    throw new IllegalArgumentException("pixel (" + i % width + ", " + i / width
                            + ") of a texture must be finite and not negative but is " + value);
                }
                floats[i * kept + c] = value;
            }
        }
        return new TextureImage(width, height, kept, null, floats, RAW);
    }

    private static TextureImage fromBytes(int width, int height, int channels, byte[] data, float[] decode) {
        int kept = requireLayout(width, height, channels, data.length);
        byte[] bytes = new byte[width * height * kept];
        for (int i = 0; i < width * height; i++) {
            System.arraycopy(data, i * channels, bytes, i * kept, kept);
        }
        return new TextureImage(width, height, kept, bytes, null, decode);
    }

    /** Returns the number of channels without alpha. */
    private static int requireLayout(int width, int height, int channels, int length) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("a texture needs at least one pixel but is " + width + "x" + height);
        }
        if (channels < 1 || channels > 4) {
            throw new IllegalArgumentException("a texture has 1 to 4 channels but got " + channels);
        }
        if ((long) width * height * channels != length) {
            throw new IllegalArgumentException("a texture of " + width + "x" + height + " pixels with " + channels
                    + " channels has " + (long) width * height * channels + " values but got " + length);
        }
        return channels < 3 ? 1 : 3;
    }

    /** Width in pixels. */
    public int width() {
        return width;
    }

    /** Height in pixels. */
    public int height() {
        return height;
    }

    /** Number of channels without alpha: 1 or 3. */
    public int channels() {
        return channels;
    }

    /** Linear value of a channel of the pixel in column {@code x} of row {@code y}; unchecked but for the array's end. */
    public double value(int x, int y, int channel) {
        return value((y * width + x) * channels + channel);
    }

    /** Linear value at an index into the interleaved channels, row by row. */
    double value(int index) {
        byte[] stored = bytes;
        if (stored != null) {
            return decode[stored[index] & 0xFF];
        }
        float[] linear = floats;
        return linear == null ? 0 : linear[index];
    }

    private static float[] decodeTable(boolean srgb) {
        float[] table = new float[256];
        for (int i = 0; i < table.length; i++) {
            table[i] = (float) (srgb ? ColorSpaces.srgbByteToLinear(i) : i / 255.0);
        }
        return table;
    }
}
