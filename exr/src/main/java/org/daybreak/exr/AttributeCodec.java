package org.daybreak.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jspecify.annotations.Nullable;

/** The bytes of attribute values, little endian as in the file. */
final class AttributeCodec {
    private AttributeCodec() {}

    /**
     * Reads a value.
     *
     * @return the value; {@link ExrAttribute.Opaque} if the type is unknown, or a string is not UTF-8; null if the type
     *     is known and the number of bytes is wrong
     */
    static @Nullable ExrAttribute decode(String typeName, byte[] bytes) {
        int expected = sizeOf(typeName);
        if (expected >= 0 && expected != bytes.length) {
            return null;
        }
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        return switch (typeName) {
            case "int" -> new ExrAttribute.IntValue(in.getInt());
            case "float" -> new ExrAttribute.FloatValue(in.getFloat());
            case "double" -> new ExrAttribute.DoubleValue(in.getDouble());
            case "v2i" -> new ExrAttribute.V2iValue(new V2i(in.getInt(), in.getInt()));
            case "v2f" -> new ExrAttribute.V2fValue(getV2f(in));
            case "box2i" -> new ExrAttribute.Box2iValue(new Box2i(in.getInt(), in.getInt(), in.getInt(), in.getInt()));
            case "box2f" ->
                new ExrAttribute.Box2fValue(new Box2f(in.getFloat(), in.getFloat(), in.getFloat(), in.getFloat()));
            case "chromaticities" ->
                new ExrAttribute.ChromaticitiesValue(
                        new Chromaticities(getV2f(in), getV2f(in), getV2f(in), getV2f(in)));
            case "string" -> {
                String text = Utf8.decodeOrNull(bytes);
                yield text != null ? new ExrAttribute.StringValue(text) : new ExrAttribute.Opaque(typeName, bytes);
            }
            default -> new ExrAttribute.Opaque(typeName, bytes);
        };
    }

    /** Writes a value. */
    static byte[] encode(ExrAttribute attribute) {
        if (attribute instanceof ExrAttribute.StringValue text) {
            return Utf8.encode(text.value());
        }
        if (attribute instanceof ExrAttribute.Opaque opaque) {
            return opaque.bytes();
        }
        ByteBuffer out = ByteBuffer.allocate(sizeOf(attribute.typeName())).order(ByteOrder.LITTLE_ENDIAN);
        if (attribute instanceof ExrAttribute.IntValue number) {
            out.putInt(number.value());
        } else if (attribute instanceof ExrAttribute.FloatValue number) {
            out.putFloat(number.value());
        } else if (attribute instanceof ExrAttribute.DoubleValue number) {
            out.putDouble(number.value());
        } else if (attribute instanceof ExrAttribute.V2iValue pair) {
            out.putInt(pair.value().x()).putInt(pair.value().y());
        } else if (attribute instanceof ExrAttribute.V2fValue pair) {
            putV2f(out, pair.value());
        } else if (attribute instanceof ExrAttribute.Box2iValue rectangle) {
            Box2i box = rectangle.value();
            out.putInt(box.xMin()).putInt(box.yMin()).putInt(box.xMax()).putInt(box.yMax());
        } else if (attribute instanceof ExrAttribute.Box2fValue rectangle) {
            Box2f box = rectangle.value();
            out.putFloat(box.xMin()).putFloat(box.yMin()).putFloat(box.xMax()).putFloat(box.yMax());
        } else if (attribute instanceof ExrAttribute.ChromaticitiesValue colours) {
            Chromaticities xy = colours.value();
            putV2f(out, xy.red());
            putV2f(out, xy.green());
            putV2f(out, xy.blue());
            putV2f(out, xy.white());
        }
        return out.array();
    }

    /** Bytes of a value of the type, or −1 if the type has no fixed size or is unknown. */
    private static int sizeOf(String typeName) {
        return switch (typeName) {
            case "int", "float" -> 4;
            case "double", "v2i", "v2f" -> 8;
            case "box2i", "box2f" -> 16;
            case "chromaticities" -> 32;
            default -> -1;
        };
    }

    private static V2f getV2f(ByteBuffer in) {
        return new V2f(in.getFloat(), in.getFloat());
    }

    private static void putV2f(ByteBuffer out, V2f pair) {
        out.putFloat(pair.x()).putFloat(pair.y());
    }
}
