package org.daybreak.scenes.mesh;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.daybreak.core.color.ColorSpaces;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.scenes.mesh.PlyHeader.Element;
import org.daybreak.scenes.mesh.PlyHeader.Encoding;
import org.daybreak.scenes.mesh.PlyHeader.Property;
import org.jspecify.annotations.Nullable;

/**
 * Reads PLY files, ASCII and binary of both byte orders: positions, normals ({@code nx ny nz}), texture coordinates
 * ({@code u v}, {@code s t} or {@code texture_u texture_v}), second ones ({@code u1 v1}, {@code s1 t1} and others) and
 * colours ({@code red green blue}; whole numbers in sRGB, others linear) of the vertices and the list {@code vertex_indices} (or
 * {@code vertex_index}) of the faces. Polygons are cut into fans. Triangle strips are the
 * element {@code tristrips}. Other elements and properties are passed over.
 */
public final class PlyReader {
    /**
     * Where a vertex property goes: 0–2 position, 3–5 normal, 6–7 texture coordinates, 8–10 colour, 11–12 second texture
     * coordinates.
     */
    private static final List<List<String>> TARGETS = List.of(
            List.of("x"),
            List.of("y"),
            List.of("z"),
            List.of("nx"),
            List.of("ny"),
            List.of("nz"),
            List.of("u", "s", "texture_u", "texture_s"),
            List.of("v", "t", "texture_v", "texture_t"),
            List.of("red", "r", "diffuse_red", "vertex_color_r", "color_r", "color_0"),
            List.of("green", "g", "diffuse_green", "vertex_color_g", "color_g", "color_1"),
            List.of("blue", "b", "diffuse_blue", "vertex_color_b", "color_b", "color_2"),
            List.of("u1", "s1", "texture_u1", "texture_s1", "uv1_0", "uv1_x"),
            List.of("v1", "t1", "texture_v1", "texture_t1", "uv1_1", "uv1_y"));

    /** The attributes: the first of their properties, and how many they have. */
    private static final int NORMAL = 3;

    private static final int UV = 6;
    private static final int COLOR = 8;
    private static final int SECOND_UV = 11;
    private static final int[] WIDTHS = {3, 3, 3, 3, 3, 3, 2, 2, 3, 3, 3, 2, 2};

    private static final List<String> NAMES =
            List.of("x", "y", "z", "nx", "ny", "nz", "u", "v", "red", "green", "blue", "u1", "v1");
    private static final List<String> VERTEX_LISTS = List.of("vertex_indices", "vertex_index");
    private static final List<String> LABELS =
            NAMES.stream().map(name -> name + " of vertex ").toList();

    private final ByteSource source;
    private final long fileSize;
    private final boolean flipTexCoords;
    private final IntList triangles = new IntList();
    private boolean ascii;
    private boolean bigEndian;
    private float @Nullable [] positions;
    private float @Nullable [] normals;
    private float @Nullable [] texCoords;
    private float @Nullable [] secondTexCoords;
    private float @Nullable [] colors;
    private boolean hasFaces;

    private PlyReader(ByteSource source, long fileSize, boolean flipTexCoords) {
        this.source = source;
        this.fileSize = fileSize;
        this.flipTexCoords = flipTexCoords;
    }

    /**
     * Reads a file.
     *
     * @param flipTexCoords whether v becomes 1 − v
     * @return the mesh; without normals if the file has none
     * @throws MeshFormatException with the line where there is one, if the file breaks the format's rules or has no faces
     * @throws IOException if the file cannot be read
     */
    public static TriangleMesh read(Path file, boolean flipTexCoords) throws IOException {
        try (ByteSource source = new ByteSource(Files.newInputStream(file))) {
            return new PlyReader(source, Files.size(file), flipTexCoords).read();
        }
    }

    private TriangleMesh read() throws IOException {
        PlyHeader header = PlyHeader.read(source);
        ascii = header.encoding == Encoding.ASCII;
        bigEndian = header.encoding == Encoding.BIG_ENDIAN;
        for (Element element : header.elements) {
            checkSize(element, header.encoding);
            switch (element.name()) {
                case "vertex" -> readVertices(element);
                case "face" -> readFaces(element);
                case "tristrips" -> readStrips(element);
                default -> skip(element);
            }
        }
        float[] p = positions;
        if (p == null) {
            throw new MeshFormatException(0, "the file has no element 'vertex'");
        }
        if (!hasFaces || triangles.size() == 0) {
            throw new MeshFormatException(0, "the file has no faces");
        }
        int[] t = triangles.toArray();
        checkIndices(t, p.length / 3);
        return new TriangleMesh(p, t, normals, texCoords, secondTexCoords, colors);
    }

    /** Refuses counts that the file is too short for before anything is allocated for them. */
    private void checkSize(Element element, Encoding encoding) throws MeshFormatException {
        // The last ASCII number needs no blank after it.
        long available = encoding == Encoding.ASCII ? fileSize + 1 : fileSize;
        long size = element.smallestSize(encoding);
        if (size > 0 && element.count() > available / size) {
            throw new MeshFormatException(
                    element.line(),
                    "the header promises " + element.count() + " elements '" + element.name()
                            + "' but the file has only " + fileSize + " bytes");
        }
    }

    private void readVertices(Element element) throws IOException {
        if (positions != null) {
            throw new MeshFormatException(element.line(), "a second element 'vertex'");
        }
        if (element.count() > Integer.MAX_VALUE / 3 - 8) {
            throw new MeshFormatException(element.line(), "more vertices than an array can hold");
        }
        List<Property> properties = element.properties();
        int[] targets = new int[properties.size()];
        boolean[] present = new boolean[NAMES.size()];
        for (int i = 0; i < targets.length; i++) {
            targets[i] =
                    properties.get(i).isList() ? -1 : target(properties.get(i).name());
            if (targets[i] >= 0) {
                if (present[targets[i]]) {
                    throw new MeshFormatException(
                            element.line(), "the vertices have '" + NAMES.get(targets[i]) + "' twice");
                }
                present[targets[i]] = true;
            }
        }
        for (int k = 0; k < 3; k++) {
            if (!present[k]) {
                throw new MeshFormatException(element.line(), "the vertices have no property '" + NAMES.get(k) + "'");
            }
        }
        int count = (int) element.count();
        float[] p = new float[3 * count];
        float[] n = attribute(NORMAL, present, count);
        float[] uv = attribute(UV, present, count);
        float[] rgb = attribute(COLOR, present, count);
        float[] second = attribute(SECOND_UV, present, count);
        float[][] arrays = {p, p, p, n, n, n, uv, uv, rgb, rgb, rgb, second, second};
        for (int vertex = 0; vertex < count; vertex++) {
            for (int i = 0; i < targets.length; i++) {
                int target = targets[i];
                if (target < 0) {
                    skip(properties.get(i));
                    continue;
                }
                float value = real(properties.get(i).type(), target, vertex);
                float[] array = arrays[target];
                if (array != null) {
                    array[WIDTHS[target] * vertex + component(target)] =
                            converted(target, properties.get(i).type(), value);
                }
            }
        }
        positions = p;
        normals = n;
        texCoords = uv;
        secondTexCoords = second;
        colors = rgb;
    }

    /** Room for an attribute; null unless all of its properties are there. */
    private static float @Nullable [] attribute(int first, boolean[] present, int count) {
        for (int i = 0; i < WIDTHS[first]; i++) {
            if (!present[first + i]) {
                return null;
            }
        }
        return new float[WIDTHS[first] * count];
    }

    private static int component(int target) {
        return target >= SECOND_UV ? target - SECOND_UV : target >= COLOR ? target - COLOR : target % 3;
    }

    private float converted(int target, PlyType type, float value) {
        if (target >= COLOR && target < SECOND_UV) {
            return linear(type, value);
        }
        boolean isV = target == UV + 1 || target == SECOND_UV + 1;
        return isV && flipTexCoords ? 1 - value : value;
    }

    /** Linear value of a colour: whole numbers are encoded by the sRGB curve, of which the largest is 1; others are linear. */
    private static float linear(PlyType type, float value) {
        double largest = switch (type) {
            case UINT8, INT8 -> 255;
            case UINT16, INT16 -> 65_535;
            case UINT32, INT32 -> 255;
            case FLOAT32, FLOAT64 -> 0;
        };
        double inside = Math.max(0, Math.min(1, largest == 0 ? value : value / largest));
        return (float) (largest == 0 ? inside : ColorSpaces.srgbToLinear(inside));
    }

    private static int target(String name) {
        for (int i = 0; i < TARGETS.size(); i++) {
            if (TARGETS.get(i).contains(name)) {
                return i;
            }
        }
        return -1;
    }

    private float real(PlyType type, int target, int vertex) throws IOException {
        if (ascii) {
            source.skipSpace();
            return source.single(LABELS.get(target), vertex);
        }
        float value =
                (float) (type == PlyType.FLOAT32 || type == PlyType.FLOAT64 ? binaryReal(type) : binaryWhole(type));
        if (!Float.isFinite(value)) {
            throw new MeshFormatException(0, LABELS.get(target) + vertex + " is not a finite number");
        }
        return value;
    }

    private void readFaces(Element element) throws IOException {
        hasFaces = true;
        List<Property> properties = element.properties();
        int indices = -1;
        for (int i = 0; i < properties.size(); i++) {
            Property p = properties.get(i);
            if (p.isList() && VERTEX_LISTS.contains(p.name())) {
                indices = i;
            }
        }
        if (indices < 0) {
            throw new MeshFormatException(element.line(), "the faces have no list 'vertex_indices'");
        }
        Property list = properties.get(indices);
        if (!list.type().isInteger()) {
            throw new MeshFormatException(element.line(), "the list 'vertex_indices' must be of an integer type");
        }
        for (long face = 0; face < element.count(); face++) {
            for (int i = 0; i < properties.size(); i++) {
                if (i == indices) {
                    readPolygon(list, face);
                } else {
                    skip(properties.get(i));
                }
            }
        }
    }

    private void readPolygon(Property list, long face) throws IOException {
        long corners = whole(list.countType(), "the number of vertices of a face");
        if (corners < 3) {
            throw new MeshFormatException(
                    ascii ? source.line() : 0, "face " + face + " has " + corners + " vertices but needs at least 3");
        }
        int fan = index(list, face);
        int previous = index(list, face);
        for (long i = 2; i < corners; i++) {
            int vertex = index(list, face);
            triangles.add(fan);
            triangles.add(previous);
            triangles.add(vertex);
            previous = vertex;
        }
    }

    /** Reads triangle strips: one list of vertices, in which −1 ends a strip; every other triangle is turned. */
    private void readStrips(Element element) throws IOException {
        hasFaces = true;
        if (element.properties().isEmpty()) {
            // They take no bytes, so the file does not bound their number.
            return;
        }
        for (long i = 0; i < element.count(); i++) {
            for (Property p : element.properties()) {
                if (p.isList() && p.type().isInteger() && VERTEX_LISTS.contains(p.name())) {
                    readStrip(p, i);
                } else {
                    skip(p);
                }
            }
        }
    }

    private void readStrip(Property list, long number) throws IOException {
        long count = whole(list.countType(), "the length of a strip");
        int first = -1;
        int second = -1;
        boolean turned = false;
        for (long i = 0; i < count; i++) {
            long value = whole(list.type(), "a vertex index");
            if (value == -1) {
                first = -1;
                second = -1;
                turned = false;
                continue;
            }
            int vertex = checked(value, number);
            if (first >= 0) {
                triangles.add(turned ? second : first);
                triangles.add(turned ? first : second);
                triangles.add(vertex);
                turned = !turned;
            }
            first = second;
            second = vertex;
        }
    }

    private int index(Property list, long face) throws IOException {
        return checked(whole(list.type(), "a vertex index"), face);
    }

    private int checked(long index, long face) throws MeshFormatException {
        float[] p = positions;
        // Faces may come before the vertices; then the check follows at the end.
        if (index < 0 || index > Integer.MAX_VALUE || (p != null && index >= p.length / 3)) {
            throw new MeshFormatException(
                    ascii ? source.line() : 0,
                    "face " + face + " refers to vertex " + index
                            + (p == null ? "" : " but there are " + p.length / 3));
        }
        return (int) index;
    }

    private static void checkIndices(int[] indices, int vertices) throws MeshFormatException {
        for (int i = 0; i < indices.length; i++) {
            if (indices[i] >= vertices) {
                throw new MeshFormatException(
                        0, "triangle " + i / 3 + " refers to vertex " + indices[i] + " but there are " + vertices);
            }
        }
    }

    private void skip(Element element) throws IOException {
        if (element.properties().isEmpty()) {
            return;
        }
        for (long i = 0; i < element.count(); i++) {
            for (Property p : element.properties()) {
                skip(p);
            }
        }
    }

    private void skip(Property property) throws IOException {
        long values = 1;
        if (property.isList()) {
            values = whole(property.countType(), "the length of a list");
            if (values < 0) {
                throw new MeshFormatException(ascii ? source.line() : 0, "a list has a negative length");
            }
        }
        if (!ascii) {
            source.skip(values * property.type().bytes);
            return;
        }
        for (long i = 0; i < values; i++) {
            int next = source.skipSpace();
            // Without a word nothing is consumed, and a list may claim any length.
            if (source.word().isEmpty()) {
                throw new MeshFormatException(
                        source.line(),
                        next == -1
                                ? "the file ends in the middle of its data"
                                : "the character with the code " + next + " stands where a value must follow");
            }
        }
    }

    private long whole(PlyType type, String what) throws IOException {
        if (!ascii) {
            return binaryWhole(type);
        }
        source.skipSpace();
        return source.wholeNumber(what, -1);
    }

    private double binaryReal(PlyType type) throws IOException {
        return type == PlyType.FLOAT32
                ? Float.intBitsToFloat(source.int32(bigEndian))
                : Double.longBitsToDouble(source.int64(bigEndian));
    }

    private long binaryWhole(PlyType type) throws IOException {
        return switch (type) {
            case INT8 -> (byte) source.uint8();
            case UINT8 -> source.uint8();
            case INT16 -> (short) source.uint16(bigEndian);
            case UINT16 -> source.uint16(bigEndian);
            case INT32 -> source.int32(bigEndian);
            case UINT32 -> source.int32(bigEndian) & 0xffffffffL;
            case FLOAT32, FLOAT64 -> throw new IllegalArgumentException(type + " is no integer type");
        };
    }
}
