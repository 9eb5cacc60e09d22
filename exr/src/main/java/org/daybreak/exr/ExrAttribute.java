package org.daybreak.exr;

import java.util.Arrays;
import java.util.Objects;

/**
 * A typed value in the header of an OpenEXR file. Types without a record of their own are kept as {@link Opaque} bytes
 * and written back unchanged.
 */
public sealed interface ExrAttribute {
    /**
     * Returns the name of the type in the file format, such as {@code string} or {@code box2i}.
     *
     * @return the type name
     */
    String typeName();

    /**
     * A signed 32-bit integer.
     *
     * @param value the value
     */
    record IntValue(int value) implements ExrAttribute {
        @Override
        public String typeName() {
            return "int";
        }
    }

    /**
     * A 32-bit float.
     *
     * @param value the value
     */
    record FloatValue(float value) implements ExrAttribute {
        @Override
        public String typeName() {
            return "float";
        }
    }

    /**
     * A 64-bit float.
     *
     * @param value the value
     */
    record DoubleValue(double value) implements ExrAttribute {
        @Override
        public String typeName() {
            return "double";
        }
    }

    /**
     * A text, stored as UTF-8.
     *
     * @param value the text
     */
    record StringValue(String value) implements ExrAttribute {
        /**
         * Creates the value.
         *
         * @throws NullPointerException if the text is null
         */
        public StringValue {
            Objects.requireNonNull(value, "value");
        }

        @Override
        public String typeName() {
            return "string";
        }
    }

    /**
     * Two integers.
     *
     * @param value the value
     */
    record V2iValue(V2i value) implements ExrAttribute {
        @Override
        public String typeName() {
            return "v2i";
        }
    }

    /**
     * Two floats.
     *
     * @param value the value
     */
    record V2fValue(V2f value) implements ExrAttribute {
        @Override
        public String typeName() {
            return "v2f";
        }
    }

    /**
     * An integer rectangle.
     *
     * @param value the value
     */
    record Box2iValue(Box2i value) implements ExrAttribute {
        @Override
        public String typeName() {
            return "box2i";
        }
    }

    /**
     * A float rectangle.
     *
     * @param value the value
     */
    record Box2fValue(Box2f value) implements ExrAttribute {
        @Override
        public String typeName() {
            return "box2f";
        }
    }

    /**
     * Primaries and white point.
     *
     * @param value the value
     */
    record ChromaticitiesValue(Chromaticities value) implements ExrAttribute {
        @Override
        public String typeName() {
            return "chromaticities";
        }
    }

    /** A value of a type that this library does not take apart. Immutable; equal by type name and bytes. */
    final class Opaque implements ExrAttribute {
        private final String typeName;
        private final byte[] bytes;

        /**
         * Creates the value; the bytes are copied.
         *
         * @param typeName type name in the file format, 1 to 255 bytes of UTF-8
         * @param bytes the value as it stands in the file (little endian)
         */
        public Opaque(String typeName, byte[] bytes) {
            this.typeName = Objects.requireNonNull(typeName, "typeName");
            this.bytes = bytes.clone();
        }

        @Override
        public String typeName() {
            return typeName;
        }

        /**
         * Returns a copy of the value as it stands in the file.
         *
         * @return the bytes
         */
        public byte[] bytes() {
            return bytes.clone();
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof Opaque that && typeName.equals(that.typeName) && Arrays.equals(bytes, that.bytes);
        }

        @Override
        public int hashCode() {
            return 31 * typeName.hashCode() + Arrays.hashCode(bytes);
        }

        @Override
        public String toString() {
            return "Opaque[" + typeName + ", " + bytes.length + " bytes]";
        }
    }
}
