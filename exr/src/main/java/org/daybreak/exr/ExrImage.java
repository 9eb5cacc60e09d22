package org.daybreak.exr;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * An OpenEXR image (one part of a file): its header and, for each channel, one array of samples in rows from top to
 * bottom. HALF and FLOAT channels are held as {@code float[]}, UINT channels as {@code int[]}. A tiled image may hold
 * reduced copies of itself, its levels; the samples of the image are those of level (0, 0).
 *
 * <p>The description is immutable. The sample arrays are handed in and out without copying, as images are large: who
 * changes an array changes the image.
 */
public final class ExrImage {
    private final ExrHeader header;
    private final List<ExrLevel> levels;

    /** The levels come in the order of the file, and each has the size that the header says. */
    ExrImage(ExrHeader header, List<ExrLevel> levels) {
        this.header = header;
        this.levels = List.copyOf(levels);
    }

    /**
     * Starts an image whose data window and display window are both (0, 0) to (width − 1, height − 1).
     *
     * @param width columns, at least 1
     * @param height rows, at least 1
     * @return a builder without channels
     * @throws IllegalArgumentException if a size is below 1, or width × height does not fit an array
     */
    public static Builder builder(int width, int height) {
        return new Builder(width, height);
    }

    /**
     * Returns what the file says, or will say, about the image.
     *
     * @return the header
     */
    public ExrHeader header() {
        return header;
    }

    /**
     * Returns the number of columns of the data window.
     *
     * @return the width in pixels
     */
    public int width() {
        return (int) header.width();
    }

    /**
     * Returns the number of rows of the data window.
     *
     * @return the height in pixels
     */
    public int height() {
        return (int) header.height();
    }

    /**
     * Returns the samples of a HALF or FLOAT channel.
     *
     * @param channel full name, layer included
     * @return width × height samples, index {@code y * width + x} from the top left of the data window; not a copy
     * @throws IllegalArgumentException if there is no such channel, or it is a UINT channel
     */
    public float[] samples(String channel) {
        return levels.get(0).samples(channel);
    }

    /**
     * Returns the samples of a UINT channel.
     *
     * @param channel full name, layer included
     * @return width × height unsigned integers, index {@code y * width + x} from the top left of the data window; not a
     *     copy
     * @throws IllegalArgumentException if there is no such channel, or it is a HALF or FLOAT channel
     */
    public int[] uintSamples(String channel) {
        return levels.get(0).uintSamples(channel);
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
        return levels.get(0).interleaved(layer, components);
    }

    /**
     * Returns how many sizes the levels have horizontally.
     *
     * @return 1 unless the image is tiled with several levels
     */
    public int xLevels() {
        TileDescription tiles = header.tiles();
        return tiles == null ? 1 : tiles.xLevels(width(), height());
    }

    /**
     * Returns how many sizes the levels have vertically.
     *
     * @return 1 unless the image is tiled with several levels
     */
    public int yLevels() {
        TileDescription tiles = header.tiles();
        return tiles == null ? 1 : tiles.yLevels(width(), height());
    }

    /**
     * Returns the image at one resolution.
     *
     * @param xLevel binary logarithm of the horizontal reduction
     * @param yLevel binary logarithm of the vertical reduction
     * @return the samples
     * @throws IllegalArgumentException if there is no such level; a mip map has only those with two equal numbers
     */
    public ExrLevel level(int xLevel, int yLevel) {
        TileDescription tiles = header.tiles();
        boolean mipmap = tiles != null && tiles.mode() == TileDescription.LevelMode.MIPMAP;
        if (xLevel < 0 || yLevel < 0 || xLevel >= xLevels() || yLevel >= yLevels() || (mipmap && xLevel != yLevel)) {
            throw new IllegalArgumentException("there is no level (" + xLevel + ", " + yLevel + ")");
        }
        return levels.get(mipmap ? xLevel : yLevel * xLevels() + xLevel);
    }

    /** All levels in the order of the file. */
    List<ExrLevel> levels() {
        return levels;
    }

    /**
     * Starts an image with everything that this one has, sharing its arrays; levels are made anew.
     *
     * @return a builder
     */
    public Builder toBuilder() {
        Builder builder = new Builder(width(), height())
                .dataWindowOrigin(
                        header.dataWindow().xMin(), header.dataWindow().yMin())
                .displayWindow(header.displayWindow())
                .pixelAspectRatio(header.pixelAspectRatio())
                .screenWindow(header.screenWindowCenter(), header.screenWindowWidth())
                .tiles(header.tiles())
                .attributes(header.attributes());
        for (ExrChannel channel : header.channels()) {
            builder.channels.put(channel.name(), channel);
        }
        builder.samples.putAll(levels.get(0).samples());
        builder.uintSamples.putAll(levels.get(0).uintSamples());
        return builder;
    }

    static int checkedLength(long length) {
        if (length > Integer.MAX_VALUE - 8) {
            throw new IllegalArgumentException(length + " samples do not fit one array");
        }
        return (int) length;
    }

    /** Collects channels and attributes of a new image; not for use by several threads. */
    public static final class Builder {
        private final int width;
        private final int height;
        private final int pixels;
        private final Map<String, ExrChannel> channels = new TreeMap<>(Utf8.BYTE_ORDER);
        private final Map<String, float[]> samples = new HashMap<>();
        private final Map<String, int[]> uintSamples = new HashMap<>();
        private final Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        private Box2i dataWindow;
        private Box2i displayWindow;
        private float pixelAspectRatio = 1;
        private V2f screenWindowCenter = new V2f(0, 0);
        private float screenWindowWidth = 1;
        private @Nullable TileDescription tiles;

        private Builder(int width, int height) {
            this.width = width;
            this.height = height;
            dataWindow = Box2i.ofSize(width, height);
            displayWindow = dataWindow;
            pixels = checkedLength((long) width * height);
        }

        /**
         * Moves the data window; its size stays. Pixels of a crop keep their place in the picture this way.
         *
         * @param x left column, may be negative
         * @param y top row, may be negative
         * @return this
         * @throws ArithmeticException if a corner leaves the range of an int
         */
        public Builder dataWindowOrigin(int x, int y) {
            dataWindow = new Box2i(x, y, Math.addExact(x, width - 1), Math.addExact(y, height - 1));
            return this;
        }

        /**
         * Sets the pixels that are to be shown.
         *
         * @param window a window that is not empty
         * @return this
         */
        public Builder displayWindow(Box2i window) {
            displayWindow = window;
            return this;
        }

        /**
         * Sets the shape of the pixels; 1 at first.
         *
         * @param ratio width of a pixel over its height
         * @return this
         */
        public Builder pixelAspectRatio(float ratio) {
            pixelAspectRatio = ratio;
            return this;
        }

        /**
         * Sets the screen window of a perspective camera; centre (0, 0) and width 1 at first.
         *
         * @param center centre at distance 1
         * @param windowWidth width at distance 1
         * @return this
         */
        public Builder screenWindow(V2f center, float windowWidth) {
            screenWindowCenter = center;
            screenWindowWidth = windowWidth;
            return this;
        }

        /**
         * Makes the image a tiled one, or again one of scan lines. Reduced levels are made by {@link #build()}: a sample
         * of a HALF or FLOAT channel is the mean over the area that it covers, of a UINT channel the one in its middle.
         *
         * @param description how to cut the image, or null for scan lines
         * @return this
         */
        public Builder tiles(@Nullable TileDescription description) {
            tiles = description;
            return this;
        }

        /**
         * Names the image as a part of a file, see {@link ExrWriter#writeParts}.
         *
         * @param name name, unique in the file
         * @return this
         */
        public Builder name(String name) {
            return attribute(ExrHeader.NAME, name);
        }

        /**
         * Adds a channel of floating-point samples.
         *
         * @param name full name, layer included, such as {@code R} or {@code albedo.R}
         * @param type HALF (rounded to nearest when written, see {@link Half}) or FLOAT
         * @param plane width × height samples in rows from the top; kept, not copied
         * @return this
         * @throws IllegalArgumentException if the name is taken or not valid, the type is UINT, or the array has
         *     another length
         */
        public Builder channel(String name, PixelType type, float[] plane) {
            if (type == PixelType.UINT) {
                throw new IllegalArgumentException("channel '" + name + "' of type UINT needs integers");
            }
            add(new ExrChannel(name, type, false), plane.length);
            samples.put(name, plane);
            return this;
        }

        /**
         * Adds several channels of one type.
         *
         * @param planes samples by channel name, as {@link #channel(String, PixelType, float[])} takes them
         */
        public Builder channels(Map<String, float[]> planes, PixelType type) {
            planes.forEach((name, plane) -> channel(name, type, plane));
            return this;
        }

        /**
         * Adds a channel of unsigned integers.
         *
         * @param name full name, layer included
         * @param plane width × height samples in rows from the top; kept, not copied
         * @return this
         * @throws IllegalArgumentException if the name is taken or not valid, or the array has another length
         */
        public Builder uintChannel(String name, int[] plane) {
            add(new ExrChannel(name, PixelType.UINT, false), plane.length);
            uintSamples.put(name, plane);
            return this;
        }

        /**
         * Adds the channels of a layer from one array that holds them pixel by pixel.
         *
         * @param layer layer, or {@code ""} for channels without a layer
         * @param type HALF or FLOAT
         * @param pixelSamples index {@code (y * width + x) * components.length + c}; copied
         * @param components names within the layer in the order of the array, such as R, G, B
         * @return this
         * @throws IllegalArgumentException as {@link #channel}
         */
        public Builder interleavedLayer(String layer, PixelType type, float[] pixelSamples, String... components) {
            int stride = components.length;
            if (pixelSamples.length != (long) pixels * stride) {
                throw new IllegalArgumentException("layer '" + layer + "' has " + pixelSamples.length
                        + " samples instead of " + width + " x " + height + " x " + stride);
            }
            for (int c = 0; c < stride; c++) {
                float[] plane = new float[pixels];
                for (int i = 0; i < pixels; i++) {
                    plane[i] = pixelSamples[i * stride + c];
                }
                channel(ExrChannel.name(layer, components[c]), type, plane);
            }
            return this;
        }

        /**
         * Sets an attribute. A value set before under the same name is replaced.
         *
         * @param name name, 1 to 255 bytes; none that the format sets itself, such as {@code compression},
         *     {@code version} or {@code type}
         * @param value value
         * @return this
         * @throws IllegalArgumentException if the name is not valid
         */
        public Builder attribute(String name, ExrAttribute value) {
            ExrHeader.checkAttribute(name, value);
            attributes.put(name, value);
            return this;
        }

        /**
         * Sets a text attribute, see {@link #attribute(String, ExrAttribute)}.
         *
         * @param name name
         * @param value text
         * @return this
         */
        public Builder attribute(String name, String value) {
            return attribute(name, new ExrAttribute.StringValue(value));
        }

        /**
         * Sets an integer attribute, see {@link #attribute(String, ExrAttribute)}.
         *
         * @param name name
         * @param value number
         * @return this
         */
        public Builder attribute(String name, int value) {
            return attribute(name, new ExrAttribute.IntValue(value));
        }

        /**
         * Sets a float attribute, see {@link #attribute(String, ExrAttribute)}.
         *
         * @param name name
         * @param value number
         * @return this
         */
        public Builder attribute(String name, float value) {
            return attribute(name, new ExrAttribute.FloatValue(value));
        }

        /**
         * Sets a double attribute, see {@link #attribute(String, ExrAttribute)}.
         *
         * @param name name
         * @param value number
         * @return this
         */
        public Builder attribute(String name, double value) {
            return attribute(name, new ExrAttribute.DoubleValue(value));
        }

        /**
         * Sets all attributes of a map, see {@link #attribute(String, ExrAttribute)}.
         *
         * @param values values by name, in the order in which they are to be written
         * @return this
         */
        public Builder attributes(Map<String, ? extends ExrAttribute> values) {
            values.forEach(this::attribute);
            return this;
        }

        /**
         * Finishes the image.
         *
         * @return the image; it shares the sample arrays that were handed in
         * @throws IllegalArgumentException if there is no channel or the display window is empty
         */
        public ExrImage build() {
            List<ExrChannel> sorted = new ArrayList<>(channels.values());
            ExrHeader header = new ExrHeader(
                    dataWindow,
                    displayWindow,
                    Compression.ZIP,
                    LineOrder.INCREASING_Y,
                    pixelAspectRatio,
                    screenWindowCenter,
                    screenWindowWidth,
                    sorted,
                    tiles,
                    attributes);
            ExrLevel full = new ExrLevel(width, height, new HashMap<>(samples), new HashMap<>(uintSamples));
            return new ExrImage(header, tiles == null ? List.of(full) : LevelReduction.levels(tiles, full));
        }

        private void add(ExrChannel channel, int length) {
            ExrHeader.checkName("channel", channel.name());
            if (length != pixels) {
                throw new IllegalArgumentException("channel '" + channel.name() + "' has " + length
                        + " samples instead of " + width + " x " + height);
            }
            if (channels.putIfAbsent(channel.name(), channel) != null) {
                throw new IllegalArgumentException("channel '" + channel.name() + "' appears twice");
            }
        }
    }
}
