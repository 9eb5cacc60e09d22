package org.daybreak.exr;

/**
 * One channel of an OpenEXR image. The part of the name before the last dot is its layer: {@code albedo.R} is the
 * component {@code R} of the layer {@code albedo}; a name without a dot belongs to the unnamed layer {@code ""}.
 *
 * @param name full name, layer included
 * @param type stored type
 * @param perceptuallyLinear a hint to lossy compressions that the samples are close to perceptually uniform; false for
 *     light
 */
public record ExrChannel(String name, PixelType type, boolean perceptuallyLinear) {
    /**
     * Returns the layer of this channel.
     *
     * @return the name before the last dot, or the empty string
     */
    public String layer() {
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(0, dot);
    }

    /**
     * Returns the name within the layer.
     *
     * @return the name after the last dot
     */
    public String component() {
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /**
     * Puts layer and component together.
     *
     * @param layer layer, or the empty string
     * @param component name within the layer
     * @return the name of the channel
     */
    public static String name(String layer, String component) {
        return layer.isEmpty() ? component : layer + "." + component;
    }
}
