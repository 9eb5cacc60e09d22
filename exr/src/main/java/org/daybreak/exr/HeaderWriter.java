package org.daybreak.exr;

import java.io.ByteArrayOutputStream;
import java.util.Map;

/** Writes magic number, version field and attributes. */
final class HeaderWriter {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    private HeaderWriter() {}

    /**
     * Writes the header of a scanline file with rows in increasing order.
     *
     * @param header what to write, except compression and line order
     * @param compression how the chunks will be packed
     */
    static byte[] write(ExrHeader header, Compression compression) {
        HeaderWriter writer = new HeaderWriter();
        writer.putInt(HeaderParser.MAGIC);
        writer.putInt(HeaderParser.VERSION | (needsLongNames(header) ? HeaderParser.FLAG_LONG_NAMES : 0));
        writer.put("channels", "chlist", channelList(header));
        writer.put("compression", "compression", new byte[] {(byte) compression.code()});
        writer.put("dataWindow", new ExrAttribute.Box2iValue(header.dataWindow()));
        writer.put("displayWindow", new ExrAttribute.Box2iValue(header.displayWindow()));
        writer.put("lineOrder", "lineOrder", new byte[] {(byte) LineOrder.INCREASING_Y.code()});
        writer.put("pixelAspectRatio", new ExrAttribute.FloatValue(header.pixelAspectRatio()));
        writer.put("screenWindowCenter", new ExrAttribute.V2fValue(header.screenWindowCenter()));
        writer.put("screenWindowWidth", new ExrAttribute.FloatValue(header.screenWindowWidth()));
        for (Map.Entry<String, ExrAttribute> entry : header.attributes().entrySet()) {
            writer.put(entry.getKey(), entry.getValue());
        }
        writer.out.write(0);
        return writer.out.toByteArray();
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
