package org.daybreak.scenes.gltf;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/**
 * An array of scalars, vectors or matrices in a buffer (glTF 2.0 specification, 3.6.2), sparse ones included. All that it
 * refers to has been checked to exist, and elements are decoded when asked for, so that its size costs nothing.
 */
final class Accessor {
    private static final VarHandle SHORT = MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle FLOAT = MethodHandles.byteArrayViewVarHandle(float[].class, ByteOrder.LITTLE_ENDIAN);

    private static final Map<String, Integer> WIDTHS =
            Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4, "MAT2", 4, "MAT3", 9, "MAT4", 16);

    /** Kinds of numbers that accessors hold. */
    enum Component {
        BYTE(5120, 1),
        UNSIGNED_BYTE(5121, 1),
        SHORT(5122, 2),
        UNSIGNED_SHORT(5123, 2),
        UNSIGNED_INT(5125, 4),
        FLOAT(5126, 4);

        private final int code;
        private final int size;

        Component(int code, int size) {
            this.code = code;
            this.size = size;
        }

        private static Component of(JsonValue code) throws GltfException {
            int given = code.integer(0, Integer.MAX_VALUE);
            for (Component c : values()) {
                if (c.code == given) {
                    return c;
                }
            }
            throw code.error("must be one of 5120, 5121, 5122, 5123, 5125, 5126 but is " + given);
        }
    }

    private final JsonValue json;
    private final Component component;
    private final String type;
    private final int width;
    private final int count;
    private final boolean normalized;
    private final byte @Nullable [] bytes;
    private final int offset;
    private final int stride;
    /** Elements that are replaced, ascending. */
    private final int[] replaced;

    private final byte[] replacements;
    private final int replacementOffset;

    private Accessor(JsonValue json, Buffers buffers) throws GltfException {
        this.json = json;
        this.component = Component.of(json.get("componentType"));
        this.type = json.get("type").text();
        Integer known = WIDTHS.get(type);
        if (known == null) {
            json.choice("type", "", new TreeSet<>(WIDTHS.keySet()));
        }
        this.width = known == null ? 1 : known;
        this.count = json.get("count").integer(1, Integer.MAX_VALUE);
        this.normalized = json.truth("normalized", false);
        if (normalized && (component == Component.FLOAT || component == Component.UNSIGNED_INT)) {
            throw json.error("is normalized, but floats and 32-bit integers cannot be");
        }
        int size = width * component.size;
        JsonValue viewReference = json.find("bufferView");
        if (viewReference == null) {
            this.bytes = null;
            this.offset = 0;
            this.stride = size;
        } else {
            Buffers.Slice view = buffers.view(viewReference);
            this.stride = view.stride() == 0 ? size : view.stride();
            if (stride < size) {
                throw json.error("has elements of " + size + " bytes but the stride of its buffer view is " + stride);
            }
            int start = json.integer("byteOffset", 0, 0, Integer.MAX_VALUE);
            requireRoom(json, start, count, stride, size, view.length());
            this.bytes = view.bytes();
            this.offset = view.offset() + start;
        }
        JsonValue sparse = json.find("sparse");
        if (sparse == null) {
            this.replaced = new int[0];
            this.replacements = new byte[0];
            this.replacementOffset = 0;
        } else {
            int replacedCount = sparse.get("count").integer(1, count);
            this.replaced = sparseIndices(sparse.get("indices"), replacedCount, buffers);
            JsonValue values = sparse.get("values");
            Buffers.Slice view = buffers.view(values.get("bufferView"));
            int start = values.integer("byteOffset", 0, 0, Integer.MAX_VALUE);
            requireRoom(values, start, replacedCount, size, size, view.length());
            this.replacements = view.bytes();
            this.replacementOffset = view.offset() + start;
        }
    }

    /** The accessor that a value refers to. */
    static Accessor of(JsonValue reference, Container container, Buffers buffers) throws GltfException {
        return new Accessor(container.resolve(reference, "accessors"), buffers);
    }

    private static void requireRoom(JsonValue what, int start, int count, int stride, int size, int available)
            throws GltfException {
        long end = start + (count - 1L) * stride + size;
        if (end > available) {
            throw what.error("needs " + end + " bytes of a buffer view of " + available + " bytes");
        }
    }

    private int[] sparseIndices(JsonValue indices, int length, Buffers buffers) throws GltfException {
        Component kind = Component.of(indices.get("componentType"));
        if (kind != Component.UNSIGNED_BYTE && kind != Component.UNSIGNED_SHORT && kind != Component.UNSIGNED_INT) {
            throw indices.get("componentType").error("must be 5121, 5123 or 5125");
        }
        Buffers.Slice view = buffers.view(indices.get("bufferView"));
        int start = indices.integer("byteOffset", 0, 0, Integer.MAX_VALUE);
        requireRoom(indices, start, length, kind.size, kind.size, view.length());
        int[] out = new int[length];
        long previous = -1;
        for (int i = 0; i < length; i++) {
            long index = unsigned(view.bytes(), view.offset() + start + i * kind.size, kind);
            if (index <= previous || index >= count) {
                throw indices.error("has " + index + " at position " + i
                        + "; indices must rise and be less than the accessor's count, " + count);
            }
            out[i] = (int) index;
            previous = index;
        }
        return out;
    }

    /** Number of elements, at least 1. */
    int count() {
        return count;
    }

    /** Numbers per element. */
    int width() {
        return width;
    }

    /** The accessor's value in the document. */
    JsonValue json() {
        return json;
    }

    /** An exception if the elements are not of one of these types. */
    Accessor requireType(JsonValue use, String... types) throws GltfException {
        if (!Arrays.asList(types).contains(type)) {
            throw use.error(
                    "must be of type " + String.join(" or ", types) + " but " + json.path() + " is of type " + type);
        }
        return this;
    }

    /** An exception if the numbers are not of one of these kinds. */
    Accessor requireComponent(JsonValue use, Set<Component> components) throws GltfException {
        if (!components.contains(component)) {
            throw use.error("cannot have components of type " + component + ", as " + json.path() + " has");
        }
        return this;
    }

    /** An exception if the numbers are integers that are not normalized. */
    Accessor requireFloatOrNormalized(JsonValue use) throws GltfException {
        if (component != Component.FLOAT && !normalized) {
            throw use.error("must be float or normalized but " + json.path() + " is neither");
        }
        return this;
    }

    private int position(int element) {
        return bytes == null ? -1 : offset + element * stride;
    }

    /**
     * A number of an element, normalised if the accessor says so (glTF 2.0 specification, 3.6.2.2).
     *
     * @throws GltfException if it is not finite
     */
    float value(int element, int column) throws GltfException {
        int sparse = replaced.length == 0 ? -1 : Arrays.binarySearch(replaced, element);
        byte[] source = sparse >= 0 ? replacements : bytes;
        if (source == null) {
            return 0;
        }
        int at = (sparse >= 0 ? replacementOffset + sparse * width * component.size : position(element))
                + column * component.size;
        switch (component) {
            case FLOAT -> {
                float value = (float) FLOAT.get(source, at);
                if (!Float.isFinite(value)) {
                    throw json.error("has an element that is not finite, number " + element);
                }
                return value;
            }
            case BYTE -> {
                return normalized ? Math.max(source[at] / 127f, -1) : source[at];
            }
            case SHORT -> {
                short value = (short) SHORT.get(source, at);
                return normalized ? Math.max(value / 32767f, -1) : value;
            }
            case UNSIGNED_BYTE -> {
                return normalized ? (source[at] & 0xff) / 255f : source[at] & 0xff;
            }
            case UNSIGNED_SHORT -> {
                int value = (short) SHORT.get(source, at) & 0xffff;
                return normalized ? value / 65535f : value;
            }
            case UNSIGNED_INT -> {
                return (int) INT.get(source, at) & 0xffffffffL;
            }
        }
        throw new IllegalStateException("no decoder for " + component);
    }

    /** An element of unsigned integers as it is stored. */
    long unsigned(int element, int column) {
        int sparse = replaced.length == 0 ? -1 : Arrays.binarySearch(replaced, element);
        byte[] source = sparse >= 0 ? replacements : bytes;
        if (source == null) {
            return 0;
        }
        int at = (sparse >= 0 ? replacementOffset + sparse * width * component.size : position(element))
                + column * component.size;
        return unsigned(source, at, component);
    }

    private static long unsigned(byte[] bytes, int at, Component component) {
        return switch (component) {
            case UNSIGNED_BYTE -> bytes[at] & 0xff;
            case UNSIGNED_SHORT -> (short) SHORT.get(bytes, at) & 0xffff;
            case UNSIGNED_INT -> (int) INT.get(bytes, at) & 0xffffffffL;
            default -> throw new IllegalStateException("not unsigned: " + component);
        };
    }
}
