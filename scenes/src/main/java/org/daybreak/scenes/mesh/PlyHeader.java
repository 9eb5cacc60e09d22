package org.daybreak.scenes.mesh;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.daybreak.core.render.NearestName;

/** Header of a PLY file. */
final class PlyHeader {
    private static final Map<String, PlyType> TYPES = Map.ofEntries(
            Map.entry("char", PlyType.INT8),
            Map.entry("int8", PlyType.INT8),
            Map.entry("uchar", PlyType.UINT8),
            Map.entry("uint8", PlyType.UINT8),
            Map.entry("short", PlyType.INT16),
            Map.entry("int16", PlyType.INT16),
            Map.entry("ushort", PlyType.UINT16),
            Map.entry("uint16", PlyType.UINT16),
            Map.entry("int", PlyType.INT32),
            Map.entry("int32", PlyType.INT32),
            Map.entry("uint", PlyType.UINT32),
            Map.entry("uint32", PlyType.UINT32),
            Map.entry("float", PlyType.FLOAT32),
            Map.entry("float32", PlyType.FLOAT32),
            Map.entry("double", PlyType.FLOAT64),
            Map.entry("float64", PlyType.FLOAT64));
    private static final List<String> STATEMENTS =
            List.of("format", "comment", "obj_info", "element", "property", "end_header");

    /** Bounds the memory that a header alone can ask for. */
    private static final int MOST_PROPERTIES = 1 << 12;

    /** How the data after the header is written. */
    enum Encoding {
        ASCII,
        LITTLE_ENDIAN,
        BIG_ENDIAN
    }

    /**
     * A property of an element.
     *
     * @param countType type of the length of a list; the property's own type if it is no list
     */
    record Property(String name, boolean isList, PlyType countType, PlyType type) {}

    /** A kind of element, with the line it is declared on. */
    record Element(String name, long count, List<Property> properties, int line) {
        /** Fewest bytes that one such element takes in the file. */
        long smallestSize(Encoding encoding) {
            long size = 0;
            for (Property p : properties) {
                size += encoding == Encoding.ASCII ? 2 : p.countType.bytes;
            }
            return size;
        }
    }

    final Encoding encoding;
    final List<Element> elements;

    private PlyHeader(Encoding encoding, List<Element> elements) {
        this.encoding = encoding;
        this.elements = elements;
    }

    /** Reads a header up to the end of its last line. */
    static PlyHeader read(ByteSource source) throws IOException {
        if (source.next() != 'p' || source.next() != 'l' || source.next() != 'y' || source.peek() > ' ') {
            throw new MeshFormatException(1, "the file does not start with 'ply'");
        }
        source.skipLine();
        Encoding encoding = null;
        List<Element> elements = new ArrayList<>();
        int properties = 0;
        while (true) {
            if (source.skipSpace() == -1) {
                throw new MeshFormatException(source.line(), "the header has no 'end_header'");
            }
            int line = source.line();
            String statement = source.word();
            switch (statement) {
                case "format" -> encoding = readFormat(source);
                case "element" -> elements.add(readElement(source));
                case "property" -> {
                    if (elements.isEmpty()) {
                        throw new MeshFormatException(line, "'property' before the first 'element'");
                    }
                    if (++properties > MOST_PROPERTIES) {
                        throw new MeshFormatException(
                                line, "the header has more than " + MOST_PROPERTIES + " properties");
                    }
                    elements.get(elements.size() - 1).properties().add(readProperty(source));
                }
                case "end_header" -> {
                    source.skipLine();
                    if (encoding == null) {
                        throw new MeshFormatException(line, "the header has no 'format'");
                    }
                    return new PlyHeader(encoding, elements);
                }
                case "comment", "obj_info" -> {}
                default ->
                    throw new MeshFormatException(
                            line,
                            "unknown header statement '" + statement + "'" + NearestName.hint(statement, STATEMENTS));
            }
            source.skipLine();
        }
    }

    private static Encoding readFormat(ByteSource source) throws IOException {
        source.skipBlanks();
        String name = source.word();
        source.skipBlanks();
        String version = source.word();
        if (!version.equals("1.0")) {
            throw new MeshFormatException(source.line(), "the format version is '" + version + "' but must be 1.0");
        }
        return switch (name) {
            case "ascii" -> Encoding.ASCII;
            case "binary_little_endian" -> Encoding.LITTLE_ENDIAN;
            case "binary_big_endian" -> Encoding.BIG_ENDIAN;
            default ->
                throw new MeshFormatException(
                        source.line(),
                        "unknown format '" + name + "'"
                                + NearestName.hint(
                                        name, List.of("ascii", "binary_little_endian", "binary_big_endian")));
        };
    }

    private static Element readElement(ByteSource source) throws IOException {
        source.skipBlanks();
        String name = source.word();
        source.skipBlanks();
        long count = source.wholeNumber("the number of elements", -1);
        if (name.isEmpty() || count < 0) {
            throw new MeshFormatException(source.line(), "an element needs a name and a number that is not negative");
        }
        return new Element(name, count, new ArrayList<>(), source.line());
    }

    private static Property readProperty(ByteSource source) throws IOException {
        source.skipBlanks();
        String first = source.word();
        if (!first.equals("list")) {
            PlyType type = type(first, source.line());
            source.skipBlanks();
            return new Property(source.word(), false, type, type);
        }
        source.skipBlanks();
        PlyType countType = type(source.word(), source.line());
        if (!countType.isInteger()) {
            throw new MeshFormatException(source.line(), "the length of a list must be of an integer type");
        }
        source.skipBlanks();
        PlyType type = type(source.word(), source.line());
        source.skipBlanks();
        return new Property(source.word(), true, countType, type);
    }

    private static PlyType type(String name, int line) throws MeshFormatException {
        PlyType type = TYPES.get(name);
        if (type == null) {
            throw new MeshFormatException(line, "unknown type '" + name + "'" + NearestName.hint(name, TYPES.keySet()));
        }
        return type;
    }
}
