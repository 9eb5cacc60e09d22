package org.daybreak.exr;

import java.util.Map;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/**
 * The samples of an image at one resolution. The arrays are handed out without copying.
 *
 * @see ExrImage#level(int, int)
 */
public final class ExrLevel {
    private final int width;
    private final int height;
    private final Map<String, float[]> samples;
    private final Map<String, int[]> uintSamples;

    /** Takes the maps over; each channel is in one of them and has width × height samples. */
    ExrLevel(int width, int height, Map<String, float[]> samples, Map<String, int[]> uintSamples) {
        this.width = width;
        this.height = height;
        this.samples = samples;
        this.uintSamples = uintSamples;
    }

    /**
     * Returns the number of columns.
     *
     * @return the width in pixels
     */
    public int width() {
        return width;
    }

    /**
     * Returns the number of rows.
     *
     * @return the height in pixels
     */
    public int height() {
        return height;
    }

    /**
     * Returns the samples of a HALF or FLOAT channel.
     *
     * @param channel full name, layer included
     * @return width × height samples, index {@code y * width + x} from the top left; not a copy
     * @throws IllegalArgumentException if there is no such channel, or it is a UINT channel
     */
    public float[] samples(String channel) {
        float[] found = samples.get(channel);
        if (found == null) {
            throw missing(channel, uintSamples.containsKey(channel), "holds unsigned integers");
        }
        return found;
    }

    /**
     * Returns the samples of a UINT channel.
     *
     * @param channel full name, layer included
     * @return width × height unsigned integers, index {@code y * width + x} from the top left; not a copy
     * @throws IllegalArgumentException if there is no such channel, or it is a HALF or FLOAT channel
     */
    public int[] uintSamples(String channel) {
        int[] found = uintSamples.get(channel);
        if (found == null) {
            throw missing(channel, samples.containsKey(channel), "holds floating-point numbers");
        }
        return found;
    }

    /**
     * Copies HALF or FLOAT channels of a layer into one array, pixel by pixel.
     *
     * @param layer layer, or {@code ""}
     * @param components names within the layer in the wanted order, such as R, G, B
     * @return width × height × components samples, index {@code (y * width + x) * components.length + c}
     * @throws IllegalArgumentException if a channel is missing or of type UINT, or the samples do not fit an array
     */
    public float[] interleaved(String layer, String... components) {
        int pixels = width * height;
        int stride = components.length;
        float[] target = new float[ExrImage.checkedLength((long) pixels * stride)];
        for (int c = 0; c < stride; c++) {
            float[] plane = samples(ExrChannel.name(layer, components[c]));
            for (int i = 0; i < pixels; i++) {
                target[i * stride + c] = plane[i];
            }
        }
        return target;
    }

    /** All HALF and FLOAT channels. */
    Map<String, float[]> samples() {
        return samples;
    }

    /** All UINT channels. */
    Map<String, int[]> uintSamples() {
        return uintSamples;
    }

    /** The {@code float[]} or {@code int[]} of a channel. */
    @Nullable
    Object plane(String channel) {
        float[] plane = samples.get(channel);
        return plane != null ? plane : uintSamples.get(channel);
    }

    private IllegalArgumentException missing(String channel, boolean otherType, String otherContent) {
        if (otherType) {
            return new IllegalArgumentException("channel '" + channel + "' " + otherContent);
        }
        TreeSet<String> names = new TreeSet<>(Utf8.BYTE_ORDER);
        names.addAll(samples.keySet());
        names.addAll(uintSamples.keySet());
        return new IllegalArgumentException("no channel '" + channel + "'; the image has " + String.join(", ", names));
    }
}
