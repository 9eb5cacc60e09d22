package org.daybreak.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** Reads magic number, version field and the attributes of all parts; afterwards the source stands at the first table of
 * chunk offsets. */
final class HeaderParser {
    static final int MAGIC = 20000630;
    static final int VERSION = 2;
    static final int FLAG_TILED = 0x200;
    static final int FLAG_LONG_NAMES = 0x400;
    static final int FLAG_DEEP = 0x800;
    static final int FLAG_MULTIPART = 0x1000;

    static final String SCANLINE_TYPE = "scanlineimage";
    static final String TILED_TYPE = "tiledimage";

    private static final String DEEP = "deep images are not supported";
    /** Two sizes and a byte of modes. */
    private static final int TILE_DESCRIPTION_BYTES = 9;

    private static final int KNOWN_FLAGS = FLAG_TILED | FLAG_LONG_NAMES | FLAG_DEEP | FLAG_MULTIPART;
    /** NUL behind the name, type, flag, three reserved bytes and two sampling rates. */
    private static final int CHANNEL_TAIL_BYTES = 17;

    private final ImageSource source;

    private @Nullable Box2i dataWindow;
    private @Nullable Box2i displayWindow;
    private @Nullable Compression compression;
    private @Nullable LineOrder lineOrder;
    private @Nullable Float pixelAspectRatio;
    private @Nullable V2f screenWindowCenter;
    private @Nullable Float screenWindowWidth;
    private @Nullable List<ExrChannel> channels;
    private final Map<String, ExrAttribute> attributes = new LinkedHashMap<>();

    private @Nullable TileDescription tiles;
    private @Nullable String partType;
    private @Nullable Integer chunkCount;

    private HeaderParser(ImageSource source) {
        this.source = source;
    }

    /**
     * The headers of a file.
     *
     * @param parts one for each part, at least one
     * @param chunkCounts for each part, what it says about the length of its table of offsets; −1 where nothing
     * @param multipart true if each chunk names its part
     */
    record Headers(List<ExrHeader> parts, List<Integer> chunkCounts, boolean multipart) {}

    /** Parses the headers; the source stands at the start of the file. */
    static Headers parse(ImageSource source) throws ImageFileException {
        if (source.readInt("the magic number") != MAGIC) {
            throw source.error("is not an OpenEXR file (wrong magic number)");
        }
        int field = source.readInt("the version field");
        int version = field & 0xff;
        if (version != VERSION) {
            throw source.error("OpenEXR version " + version + " is not supported");
        }
        if ((field & FLAG_DEEP) != 0) {
            throw source.error(DEEP);
        }
        if ((field & ~(0xff | KNOWN_FLAGS)) != 0) {
            throw source.error(
                    "the version field has unknown flags 0x" + Integer.toHexString(field & ~(0xff | KNOWN_FLAGS)));
        }
        int maxNameBytes = (field & FLAG_LONG_NAMES) != 0 ? ExrHeader.MAX_NAME_BYTES : ExrHeader.SHORT_NAME_BYTES;
        boolean tiled = (field & FLAG_TILED) != 0;
        if ((field & FLAG_MULTIPART) == 0) {
            HeaderParser parser = new HeaderParser(source);
            parser.parseAttributes(maxNameBytes);
            return new Headers(List.of(parser.header(tiled)), List.of(-1), false);
        }
        if (tiled) {
            throw source.error("the header is damaged: the flags for tiles and for several parts exclude each other");
        }
        return parseParts(source, maxNameBytes);
    }

    private static Headers parseParts(ImageSource source, int maxNameBytes) throws ImageFileException {
        List<ExrHeader> parts = new ArrayList<>();
        List<Integer> chunkCounts = new ArrayList<>();
        Set<String> names = new HashSet<>();
        while (true) {
            HeaderParser parser = new HeaderParser(source);
            if (!parser.parseAttributes(maxNameBytes)) {
                break;
            }
            String type = parser.required(parser.partType, "type");
            ExrHeader header = parser.header(type.equals(TILED_TYPE));
            if (!header.attributes().containsKey(ExrHeader.NAME)) {
                throw source.error("the header has no attribute '" + ExrHeader.NAME + "'");
            }
            if (!names.add(header.name())) {
                throw source.error("the header is damaged: two parts are called '" + header.name() + "'");
            }
            chunkCounts.add(parser.required(parser.chunkCount, "chunkCount"));
            parts.add(header);
        }
        if (parts.isEmpty()) {
            throw source.error("the header is damaged: there is no part");
        }
        return new Headers(parts, chunkCounts, true);
    }

    /** Returns false if there is no attribute. */
    private boolean parseAttributes(int maxNameBytes) throws ImageFileException {
        for (boolean any = false; ; any = true) {
            String name = text(source.readNulTerminated(maxNameBytes, "an attribute name"), "an attribute name");
            if (name.isEmpty()) {
                return any;
            }
            String what = "attribute '" + name + "'";
            String type = text(source.readNulTerminated(maxNameBytes, "the type of " + what), "the type of " + what);
            int size = source.readInt("the size of " + what);
            if (size < 0 || size > source.remaining()) {
                throw source.error(
                        "the header is damaged: " + what + " claims " + Integer.toUnsignedString(size) + " bytes");
            }
            takeAttribute(name, type, source.readBytes(size, what), maxNameBytes);
        }
    }

    private void takeAttribute(String name, String type, byte[] bytes, int maxNameBytes) throws ImageFileException {
        switch (name) {
            case "channels" -> channels = once(name, channels, parseChannels(type, bytes, maxNameBytes));
            case "compression" -> {
                int code = oneByte(name, type, bytes);
                Compression known = Compression.ofCode(code);
                if (known == null) {
                    throw source.error("compression with the unknown code " + code + " is not supported");
                }
                compression = once(name, compression, known);
            }
            case "lineOrder" -> {
                int code = oneByte(name, type, bytes);
                LineOrder known = LineOrder.ofCode(code);
                if (known == null) {
                    throw source.error("the unknown line order " + code + " is not supported");
                }
                lineOrder = once(name, lineOrder, known);
            }
            case "dataWindow" -> dataWindow = once(name, dataWindow, window(name, type, bytes));
            case "displayWindow" -> displayWindow = once(name, displayWindow, window(name, type, bytes));
            case "pixelAspectRatio" -> pixelAspectRatio = once(name, pixelAspectRatio, number(name, type, bytes));
            case "screenWindowWidth" -> screenWindowWidth = once(name, screenWindowWidth, number(name, type, bytes));
            case "screenWindowCenter" -> {
                if (!(value(name, type, "v2f", bytes) instanceof ExrAttribute.V2fValue pair)) {
                    throw wrongType(name, type, "v2f");
                }
                screenWindowCenter = once(name, screenWindowCenter, pair.value());
            }
            case "type" -> partType = once(name, partType, parsePartType(type, bytes));
            case "tiles" -> tiles = once(name, tiles, parseTiles(type, bytes));
            case "chunkCount" -> {
                if (!(value(name, type, "int", bytes) instanceof ExrAttribute.IntValue number)) {
                    throw wrongType(name, type, "int");
                }
                chunkCount = once(name, chunkCount, number.value());
            }
            case "version" -> {
                // Of deep images; says nothing about others.
            }
            default -> {
                ExrAttribute attribute = AttributeCodec.decode(type, bytes);
                if (attribute == null) {
                    throw source.error("the header is damaged: attribute '" + name + "' of type " + type + " has "
                            + bytes.length + " bytes");
                }
                try {
                    ExrHeader.checkAttribute(name, attribute);
                } catch (IllegalArgumentException e) {
                    throw source.error("the header is damaged: " + e.getMessage(), e);
                }
                if (attributes.putIfAbsent(name, attribute) != null) {
                    throw twice(name);
                }
            }
        }
    }

    private String parsePartType(String type, byte[] bytes) throws ImageFileException {
        String part = type.equals("string") ? text(bytes, "attribute 'type'") : "";
        return switch (part) {
            case SCANLINE_TYPE, TILED_TYPE -> part;
            case "deepscanline", "deeptile" -> throw source.error(DEEP);
            default -> throw source.error("the header is damaged: attribute 'type' is not a known kind of image");
        };
    }

    private TileDescription parseTiles(String type, byte[] bytes) throws ImageFileException {
        if (!type.equals("tiledesc") || bytes.length != TILE_DESCRIPTION_BYTES) {
            throw wrongType("tiles", type, "tiledesc");
        }
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        int width = in.getInt();
        int height = in.getInt();
        int modes = in.get() & 0xff;
        TileDescription.LevelMode mode = TileDescription.LevelMode.ofCode(modes & 0xf);
        TileDescription.LevelRounding rounding = TileDescription.LevelRounding.ofCode(modes >> 4);
        if (width < 1 || height < 1 || mode == null || rounding == null) {
            throw source.error("the header is damaged: tiles of " + Integer.toUnsignedString(width) + " x "
                    + Integer.toUnsignedString(height) + " pixels with level mode " + modes + " are not valid");
        }
        return new TileDescription(width, height, mode, rounding);
    }

    private List<ExrChannel> parseChannels(String type, byte[] bytes, int maxNameBytes) throws ImageFileException {
        if (!type.equals("chlist")) {
            throw wrongType("channels", type, "chlist");
        }
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        List<ExrChannel> list = new ArrayList<>();
        while (in.hasRemaining() && in.get(in.position()) != 0) {
            int start = in.position();
            int end = start;
            while (end < bytes.length && bytes[end] != 0) {
                end++;
            }
            if (bytes.length - end < CHANNEL_TAIL_BYTES) {
                throw source.error("the header is damaged: the channel list ends early");
            }
            if (end - start > maxNameBytes) {
                throw source.error("the header is damaged: a channel name is longer than " + maxNameBytes + " bytes");
            }
            byte[] nameBytes = new byte[end - start];
            in.get(nameBytes);
            in.get();
            String name = text(nameBytes, "a channel name");
            int typeCode = in.getInt();
            boolean perceptuallyLinear = in.get() != 0;
            in.get();
            in.getShort();
            int xSampling = in.getInt();
            int ySampling = in.getInt();
            PixelType pixelType = PixelType.ofCode(typeCode);
            if (pixelType == null) {
                throw source.error("channel '" + name + "' has the unknown pixel type " + typeCode);
            }
            if (xSampling != 1 || ySampling != 1) {
                throw source.error("subsampled channels are not supported (channel '" + name + "' is sampled every "
                        + xSampling + " x " + ySampling + " pixels)");
            }
            list.add(new ExrChannel(name, pixelType, perceptuallyLinear));
        }
        if (in.remaining() != 1) {
            throw source.error("the header is damaged: the channel list does not end where it should");
        }
        // The official library lays chunks out by sorted channels whatever the order of the list.
        list.sort(Comparator.comparing(ExrChannel::name, Utf8.BYTE_ORDER));
        return list;
    }

    private int oneByte(String name, String type, byte[] bytes) throws ImageFileException {
        if (!type.equals(name) || bytes.length != 1) {
            throw wrongType(name, type, name);
        }
        return bytes[0] & 0xff;
    }

    private Box2i window(String name, String type, byte[] bytes) throws ImageFileException {
        if (!(value(name, type, "box2i", bytes) instanceof ExrAttribute.Box2iValue box)) {
            throw wrongType(name, type, "box2i");
        }
        return box.value();
    }

    private Float number(String name, String type, byte[] bytes) throws ImageFileException {
        if (!(value(name, type, "float", bytes) instanceof ExrAttribute.FloatValue number)) {
            throw wrongType(name, type, "float");
        }
        return number.value();
    }

    private @Nullable ExrAttribute value(String name, String type, String expected, byte[] bytes)
            throws ImageFileException {
        if (!type.equals(expected)) {
            throw wrongType(name, type, expected);
        }
        return AttributeCodec.decode(type, bytes);
    }

    private ImageFileException wrongType(String name, String type, String expected) {
        return source.error(
                "the header is damaged: attribute '" + name + "' of type '" + type + "' is not a valid " + expected);
    }

    private ImageFileException twice(String name) {
        return source.error("the header is damaged: attribute '" + name + "' appears twice");
    }

    private <T> T once(String name, @Nullable T before, T value) throws ImageFileException {
        if (before != null) {
            throw twice(name);
        }
        return value;
    }

    private String text(byte[] bytes, String what) throws ImageFileException {
        String text = Utf8.decodeOrNull(bytes);
        if (text == null) {
            throw source.error("the header is damaged: " + what + " is not UTF-8");
        }
        return text;
    }

    private <T> T required(@Nullable T value, String name) throws ImageFileException {
        if (value == null) {
            throw source.error("the header has no attribute '" + name + "'");
        }
        return value;
    }

    private ExrHeader header(boolean tiled) throws ImageFileException {
        if (partType != null && partType.equals(TILED_TYPE) != tiled) {
            throw source.error("the header is damaged: attribute 'type' contradicts the version field");
        }
        if (!tiled && lineOrder == LineOrder.RANDOM_Y) {
            throw source.error("line order RANDOM_Y is not valid for a scanline image");
        }
        try {
            return new ExrHeader(
                    required(dataWindow, "dataWindow"),
                    required(displayWindow, "displayWindow"),
                    required(compression, "compression"),
                    required(lineOrder, "lineOrder"),
                    required(pixelAspectRatio, "pixelAspectRatio"),
                    required(screenWindowCenter, "screenWindowCenter"),
                    required(screenWindowWidth, "screenWindowWidth"),
                    required(channels, "channels"),
                    tiled ? required(tiles, "tiles") : null,
                    attributes);
        } catch (IllegalArgumentException e) {
            throw source.error("the header is damaged: " + e.getMessage(), e);
        }
    }
}
