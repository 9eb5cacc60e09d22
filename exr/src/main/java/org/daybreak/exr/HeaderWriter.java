package org.daybreak.exr;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.Map;

/** Writes magic number, version field and the attributes of all parts. */
final class HeaderWriter {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    private HeaderWriter() {}

    /**
     * Writes the headers of a file with chunks in increasing order. Several parts must have names.
     *
     * @param parts what to write, except compression and line order
     * @param chunkCounts lengths of the tables of offsets
     * @param compression how the chunks will be packed
     */
    static byte[] write(List<ExrHeader> parts, List<Integer> chunkCounts, Compression compression) {
        HeaderWriter writer = new HeaderWriter();
        boolean multipart = parts.size() > 1;
        int flags = multipart ? HeaderParser.FLAG_MULTIPART : 0;
        if (!multipart && parts.get(0).tiles() != null) {
            flags |= HeaderParser.FLAG_TILED;
        }
        if (parts.stream().anyMatch(HeaderWriter::needsLongNames)) {
            flags |= HeaderParser.FLAG_LONG_NAMES;
        }
        writer.putInt(HeaderParser.MAGIC);
        writer.putInt(HeaderParser.VERSION | flags);
        for (int i = 0; i < parts.size(); i++) {
            writer.putPart(parts.get(i), compression);
            if (multipart) {
                boolean tiled = parts.get(i).tiles() != null;
                writer.put("chunkCount", new ExrAttribute.IntValue(chunkCounts.get(i)));
                writer.put(
                        "type",
                        new ExrAttribute.StringValue(tiled ? HeaderParser.TILED_TYPE : HeaderParser.SCANLINE_TYPE));
            }
            writer.out.write(0);
        }
        if (multipart) {
            // An empty header ends the list.
            writer.out.write(0);
        }
        return writer.out.toByteArray();
    }

    private void putPart(ExrHeader header, Compression compression) {
        put("channels", "chlist", channelList(header));
        put("compression", "compression", new byte[] {(byte) compression.code()});
        put("dataWindow", new ExrAttribute.Box2iValue(header.dataWindow()));
        put("displayWindow", new ExrAttribute.Box2iValue(header.displayWindow()));
        put("lineOrder", "lineOrder", new byte[] {(byte) LineOrder.INCREASING_Y.code()});
        put("pixelAspectRatio", new ExrAttribute.FloatValue(header.pixelAspectRatio()));
        put("screenWindowCenter", new ExrAttribute.V2fValue(header.screenWindowCenter()));
        put("screenWindowWidth", new ExrAttribute.FloatValue(header.screenWindowWidth()));
        TileDescription tiles = header.tiles();
        if (tiles != null) {
            HeaderWriter value = new HeaderWriter();
            value.putInt(tiles.width());
            value.putInt(tiles.height());
            value.out.write(tiles.mode().ordinal() | tiles.rounding().ordinal() << 4);
            put("tiles", "tiledesc", value.out.toByteArray());
        }
        for (Map.Entry<String, ExrAttribute> entry : header.attributes().entrySet()) {
            put(entry.getKey(), entry.getValue());
        }
    }

    private static boolean needsLongNames(ExrHeader header) {
        boolean needed = false;
        for (ExrChannel channel : header.channels()) {
            needed |= isLong(channel.name());
        }
        for (Map.Entry<String, ExrAttribute> entry : header.attributes().entrySet()) {
            needed |= isLong(entry.getKey()) || isLong(entry.getValue().typeName());
        }
        return needed;
    }

    private static boolean isLong(String name) {
        return Utf8.encode(name).length > ExrHeader.SHORT_NAME_BYTES;
    }

    private static byte[] channelList(ExrHeader header) {
        HeaderWriter list = new HeaderWriter();
        for (ExrChannel channel : header.channels()) {
            list.putName(channel.name());
            list.putInt(channel.type().code());
            // One byte of flag and three reserved ones.
            list.putInt(channel.perceptuallyLinear() ? 1 : 0);
            list.putInt(1);
            list.putInt(1);
        }
        list.out.write(0);
        return list.out.toByteArray();
    }

    private void put(String name, ExrAttribute value) {
        put(name, value.typeName(), AttributeCodec.encode(value));
    }

    private void put(String name, String type, byte[] value) {
        putName(name);
        putName(type);
        putInt(value.length);
        out.writeBytes(value);
    }

    private void putName(String name) {
        out.writeBytes(Utf8.encode(name));
        out.write(0);
    }

    private void putInt(int value) {
        for (int shift = 0; shift < 32; shift += 8) {
            out.write(value >>> shift);
        }
    }
}
