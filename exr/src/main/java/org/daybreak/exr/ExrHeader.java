package org.daybreak.exr;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * What an OpenEXR file says about its image, without the pixels. Immutable.
 *
 * @param dataWindow the pixels that are stored; any origin, also negative
 * @param displayWindow the pixels that are to be shown
 * @param compression how the file is packed; a writer is told by {@link ExrWriteOptions} instead
 * @param lineOrder how the chunks are ordered in the file; the writer always writes increasing
 * @param pixelAspectRatio width of a pixel over its height
 * @param screenWindowCenter centre of the screen window of a perspective camera at distance 1
 * @param screenWindowWidth width of the screen window of a perspective camera at distance 1
 * @param channels all channels, sorted by name (bytes of UTF-8)
 * @param tiles how a tiled image is cut, or null for an image of scan lines
 * @param attributes all further attributes in file order; {@code name} is the name of a part
 */
public record ExrHeader(
        Box2i dataWindow,
        Box2i displayWindow,
        Compression compression,
        LineOrder lineOrder,
        float pixelAspectRatio,
        V2f screenWindowCenter,
        float screenWindowWidth,
        List<ExrChannel> channels,
        @Nullable TileDescription tiles,
        Map<String, ExrAttribute> attributes) {

    /** Names that the format itself needs; they are fields of this record or follow from it. */
    private static final Set<String> RESERVED_NAMES = Set.of(
            "channels",
            "compression",
            "dataWindow",
            "displayWindow",
            "lineOrder",
            "pixelAspectRatio",
            "screenWindowCenter",
            "screenWindowWidth",
            "type",
            "chunkCount",
            "version",
            "tiles");

    /** The attribute that holds the name of a part. */
    static final String NAME = "name";

    /** Names and type names longer than this need the long-name flag. */
    static final int SHORT_NAME_BYTES = 31;

    static final int MAX_NAME_BYTES = 255;

    /**
     * Creates a header; the list and the map are copied.
     *
     * @throws IllegalArgumentException if a window is empty, there is no channel, channels are not sorted or not unique,
     *     or a name is empty, longer than 255 bytes, holds a NUL, or is one that the format reserves
     */
    public ExrHeader {
        checkWindow("data window", dataWindow);
        checkWindow("display window", displayWindow);
        channels = List.copyOf(channels);
        attributes = Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
        checkChannels(channels);
        for (Map.Entry<String, ExrAttribute> entry : attributes.entrySet()) {
            checkAttribute(entry.getKey(), entry.getValue());
        }
    }

    /**
     * Returns the number of columns of the data window.
     *
     * @return the width, at least 1; a long as a header may claim more than fits an array
     */
    public long width() {
        return dataWindow.width();
    }

    /**
     * Returns the number of rows of the data window.
     *
     * @return the height, at least 1
     */
    public long height() {
        return dataWindow.height();
    }

    /**
     * Returns the name of this part; a file with several parts has one for each.
     *
     * @return the attribute {@code name}, or the empty string
     */
    public String name() {
        return attributes.get(NAME) instanceof ExrAttribute.StringValue text ? text.value() : "";
    }

    /**
     * Looks a channel up.
     *
     * @param name full name, layer included
     * @return the channel, or null if there is none of this name
     */
    public @Nullable ExrChannel channel(String name) {
        for (ExrChannel channel : channels) {
            if (channel.name().equals(name)) {
                return channel;
            }
        }
        return null;
    }

    /**
     * Returns the names of the channels.
     *
     * @return full names in file order
     */
    public List<String> channelNames() {
        List<String> names = new ArrayList<>();
        for (ExrChannel channel : channels) {
            names.add(channel.name());
        }
        return Collections.unmodifiableList(names);
    }

    /**
     * Returns the layers, see {@link ExrChannel#layer()}.
     *
     * @return each layer once, in file order; {@code ""} stands for channels without a layer
     */
    public List<String> layers() {
        Set<String> layers = new LinkedHashSet<>();
        for (ExrChannel channel : channels) {
            layers.add(channel.layer());
        }
        return List.copyOf(layers);
    }

    private static void checkWindow(String name, Box2i window) {
        if (window.isEmpty()) {
            throw new IllegalArgumentException("the " + name + " is empty");
        }
    }

    private static void checkChannels(List<ExrChannel> channels) {
        if (channels.isEmpty()) {
            throw new IllegalArgumentException("there is no channel");
        }
        for (int i = 0; i < channels.size(); i++) {
            String name = channels.get(i).name();
            checkName("channel", name);
            int order =
                    i == 0 ? -1 : Utf8.BYTE_ORDER.compare(channels.get(i - 1).name(), name);
            if (order == 0) {
                throw new IllegalArgumentException("channel '" + name + "' appears twice");
            }
            if (order > 0) {
                throw new IllegalArgumentException("channel '" + name + "' is out of order");
            }
        }
    }

    /** Checks name and type of a further attribute. */
    static void checkAttribute(String name, ExrAttribute value) {
        checkName("attribute", name);
        checkName("attribute type", value.typeName());
        if (RESERVED_NAMES.contains(name)) {
            throw new IllegalArgumentException("attribute '" + name + "' is set by the file format itself");
        }
        // The official library refuses the whole file otherwise: it is the name of the part.
        if (name.equals(NAME) && !value.typeName().equals("string")) {
            throw new IllegalArgumentException("attribute 'name' must be a string");
        }
    }

    /** Checks a name of a channel, attribute or type. */
    static void checkName(String what, String name) {
        int length = Utf8.encode(name).length;
        if (length < 1 || length > MAX_NAME_BYTES || name.indexOf('\0') >= 0) {
            throw new IllegalArgumentException(
                    "name of " + what + " '" + name + "' must have 1 to " + MAX_NAME_BYTES + " bytes, none of them 0");
        }
    }
}
