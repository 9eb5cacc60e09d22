package org.daybreak.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Reads magic number, version field and attributes; afterwards the source stands at the chunk offset table. */
final class HeaderParser {
    static final int MAGIC = 20000630;
    static final int VERSION = 2;
    static final int FLAG_TILED = 0x200;
    static final int FLAG_LONG_NAMES = 0x400;
    static final int FLAG_DEEP = 0x800;
    static final int FLAG_MULTIPART = 0x1000;

    private static final int KNOWN_FLAGS = FLAG_TILED | FLAG_LONG_NAMES | FLAG_DEEP | FLAG_MULTIPART;
    /** NUL behind the name, type, flag, three reserved bytes and two sampling rates. */
    private static final int CHANNEL_TAIL_BYTES = 17;

    private final FileSource source;

    private @Nullable Box2i dataWindow;
    private @Nullable Box2i displayWindow;
    private @Nullable Compression compression;
    private @Nullable LineOrder lineOrder;
    private @Nullable Float pixelAspectRatio;
    private @Nullable V2f screenWindowCenter;
    private @Nullable Float screenWindowWidth;
    private @Nullable List<ExrChannel> channels;
    private final Map<String, ExrAttribute> attributes = new LinkedHashMap<>();

    private HeaderParser(FileSource source) {
        this.source = source;
    }

    /** Parses the header that starts at the current place of the source. */
    static ExrHeader parse(FileSource source) throws ImageFileException {
        HeaderParser parser = new HeaderParser(source);
        int maxNameBytes = parser.parseVersion();
        parser.parseAttributes(maxNameBytes);
        return parser.header();
    }

    /** Returns the longest allowed name. */
    private int parseVersion() throws ImageFileException {
        if (source.readInt("the magic number") != MAGIC) {
            throw source.error("is not an OpenEXR file (wrong magic number)");
        }
        int field = source.readInt("the version field");
        int version = field & 0xff;
        if (version != VERSION) {
            throw source.error("OpenEXR version " + version + " is not supported");
        }
        if ((field & FLAG_MULTIPART) != 0) {
            throw source.error("multi-part files are not supported");
        }
        if ((field & FLAG_DEEP) != 0) {
            throw source.error("deep images are not supported");
        }
        if ((field & FLAG_TILED) != 0) {
            throw source.error("tiled images are not supported");
        }
        if ((field & ~(0xff | KNOWN_FLAGS)) != 0) {
            throw source.error(
                    "the version field has unknown flags 0x" + Integer.toHexString(field & ~(0xff | KNOWN_FLAGS)));
        }
        return (field & FLAG_LONG_NAMES) != 0 ? ExrHeader.MAX_NAME_BYTES : ExrHeader.SHORT_NAME_BYTES;
    }

    private void parseAttributes(int maxNameBytes) throws ImageFileException {
        while (true) {
            String name = text(source.readNulTerminated(maxNameBytes, "an attribute name"), "an attribute name");
            if (name.isEmpty()) {
                return;
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
                    throw source.error("line order " + code + " is not valid for a scanline image");
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
            case "type" -> checkPartType(type, bytes);
            case "chunkCount", "version", "tiles" -> {
                // Follow from the image when it is written again; of no use for reading a single scanline part.
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
                    throw new ImageFileException(source.path(), "the header is damaged: " + e.getMessage(), e);
                }
                if (attributes.putIfAbsent(name, attribute) != null) {
                    throw twice(name);
                }
            }
        }
    }

    private void checkPartType(String type, byte[] bytes) throws ImageFileException {
        String part = type.equals("string") ? text(bytes, "attribute 'type'") : "";
        switch (part) {
            case "scanlineimage" -> {
                // What this reader reads.
            }
            case "tiledimage" -> throw source.error("tiled images are not supported");
            case "deepscanline", "deeptile" -> throw source.error("deep images are not supported");
            default -> throw source.error("the header is damaged: attribute 'type' is not a known kind of image");
        }
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

    private ExrHeader header() throws ImageFileException {
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
                    attributes);
        } catch (IllegalArgumentException e) {
            throw new ImageFileException(source.path(), "the header is damaged: " + e.getMessage(), e);
        }
    }
}
