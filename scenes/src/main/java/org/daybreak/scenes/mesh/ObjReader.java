package org.daybreak.scenes.mesh;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.daybreak.core.color.ColorSpaces;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.render.NearestName;
import org.jspecify.annotations.Nullable;

/**
 * Reads Wavefront OBJ files: {@code v}, {@code vt}, {@code vn} and {@code f} in all forms, negative indices, lines joined by
 * a backslash. All groups become one mesh, or those of each material one; polygons are cut into fans. Vertices are shared where position, texture
 * coordinate and normal are. Materials, smoothing groups, points and lines are passed over.
 *
 * <p>If only some corners have a normal, the others get the angle-weighted mean of their triangles; corners without texture
 * coordinates get (0, 0).
 */
public final class ObjReader {
    private static final Set<String> PASSED_OVER = Set.of(
            "g",
            "o",
            "s",
            "mg",
            "mtllib",
            "usemap",
            "maplib",
            "l",
            "p",
            "lod",
            "bevel",
            "c_interp",
            "d_interp",
            "shadow_obj",
            "trace_obj");
    private static final Set<String> FREE_FORM = Set.of(
            "vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end",
            "con", "ctech", "stech");
    private static final Set<String> KNOWN = Set.of("v", "vt", "vn", "f", "g", "o", "s", "usemtl", "mtllib", "l", "p");

    private final ByteSource source;
    private final boolean flipTexCoords;
    private final FloatList positions = new FloatList();
    private final FloatList texCoords = new FloatList();
    private final FloatList normals = new FloatList();
    /** Linear colours of the positions; empty unless some position has one. */
    private final FloatList colors = new FloatList();

    private final float[] extra = new float[4];
    /** The faces by material; a single entry with the name "" unless they are to be told apart. */
    private final Map<String, Part> parts = new LinkedHashMap<>();

    private final boolean split;
    private Part part = new Part();

    private ObjReader(ByteSource source, boolean flipTexCoords, boolean split) {
        this.source = source;
        this.flipTexCoords = flipTexCoords;
        this.split = split;
        parts.put("", part);
    }

    /** Faces that become one mesh. */
    private static final class Part {
        final IntList triangles = new IntList();

        /** Position, texture coordinate and normal of each vertex of the mesh, the last two -1 if there is none. */
        final TripleTable vertices = new TripleTable();

        boolean hasTexCoords;
        boolean hasNormals;
        boolean lacksNormals;
    }

    /**
     * Reads a file.
     *
     * @param flipTexCoords whether v becomes 1 − v, as OBJ counts texture rows from the bottom and images from the top
     * @return the mesh; without normals if the file has none
     * @throws MeshFormatException with the line, if the file breaks the format's rules or has no faces
     * @throws IOException if the file cannot be read
     */
    public static TriangleMesh read(Path file, boolean flipTexCoords) throws IOException {
        try (ByteSource source = new ByteSource(Files.newInputStream(file))) {
            Map<String, TriangleMesh> meshes = new ObjReader(source, flipTexCoords, false).read();
            return meshes.values().iterator().next();
        }
    }

    /**
     * Reads a file into one mesh for each material.
     *
     * @param flipTexCoords as for {@link #read}
     * @return the meshes by the names that {@code usemtl} gives, in their order; under "" what comes before the first
     * @throws MeshFormatException with the line, if the file breaks the format's rules or has no faces
     * @throws IOException if the file cannot be read
     */
    public static Map<String, TriangleMesh> readByMaterial(Path file, boolean flipTexCoords) throws IOException {
        try (ByteSource source = new ByteSource(Files.newInputStream(file))) {
            return new ObjReader(source, flipTexCoords, true).read();
        }
    }

    private Map<String, TriangleMesh> read() throws IOException {
        while (source.peek() != -1) {
            int first = source.skipBlanks();
            if (first != '\n' && first != '#' && first != -1) {
                readStatement();
            }
            source.skipLine();
        }
        Map<String, TriangleMesh> meshes = new LinkedHashMap<>();
        for (Map.Entry<String, Part> entry : parts.entrySet()) {
            if (entry.getValue().triangles.size() > 0) {
                meshes.put(entry.getKey(), mesh(entry.getValue()));
            }
        }
        if (meshes.isEmpty()) {
            throw new MeshFormatException(0, "the file has no faces");
        }
        return meshes;
    }

    private void readStatement() throws IOException {
        String keyword = source.word();
        switch (keyword) {
            case "v" -> {
                positions.add(coordinate("x of a vertex"));
                positions.add(coordinate("y of a vertex"));
                positions.add(coordinate("z of a vertex"));
                readColor();
            }
            case "vt" -> {
                texCoords.add(coordinate("u of a texture coordinate"));
                int next = source.skipBlanks();
                float v = next == '\n' || next == -1 ? 0 : coordinate("v of a texture coordinate");
                texCoords.add(flipTexCoords ? 1 - v : v);
            }
            case "vn" -> {
                normals.add(coordinate("x of a normal"));
                normals.add(coordinate("y of a normal"));
                normals.add(coordinate("z of a normal"));
            }
            case "f" -> readFace();
            case "usemtl" -> {
                if (split) {
                    source.skipBlanks();
                    part = parts.computeIfAbsent(source.restOfLine(), name -> new Part());
                }
            }
            default -> {
                if (FREE_FORM.contains(keyword)) {
                    throw new MeshFormatException(
                            source.line(), "'" + keyword + "': free-form curves and surfaces are not supported");
                }
                if (!PASSED_OVER.contains(keyword)) {
                    throw new MeshFormatException(
                            source.line(), "unknown statement '" + keyword + "'" + NearestName.hint(keyword, KNOWN));
                }
            }
        }
    }

    /**
     * Reads what may follow a position: its weight, which only matters to free forms, or a colour, which programs write as sRGB.
     * Vertices without are white.
     */
    private void readColor() throws IOException {
        int count = 0;
        int next = source.skipBlanks();
        while (count < 4 && next != '\n' && next != -1 && next != '#') {
            extra[count++] = source.single("a number after a vertex", -1);
            next = source.skipBlanks();
        }
        if (count != 3 && colors.size() == 0) {
            return;
        }
        while (colors.size() < positions.size() - 3) {
            colors.add(1);
        }
        for (int i = 0; i < 3; i++) {
            double value = count == 3 ? Math.max(0, Math.min(1, extra[i])) : 1;
            colors.add((float) ColorSpaces.srgbToLinear(value));
        }
    }

    private float coordinate(String what) throws IOException {
        source.skipBlanks();
        return source.single(what, -1);
    }

    private void readFace() throws IOException {
        int corners = 0;
        int fan = 0;
        int previous = 0;
        int next = source.skipBlanks();
        while (next != '\n' && next != -1 && next != '#') {
            int vertex = readCorner();
            if (corners == 0) {
                fan = vertex;
            } else if (corners >= 2) {
                part.triangles.add(fan);
                part.triangles.add(previous);
                part.triangles.add(vertex);
            }
            previous = vertex;
            corners++;
            next = source.skipBlanks();
        }
        if (corners < 3) {
            throw new MeshFormatException(source.line(), "a face needs at least 3 vertices but has " + corners);
        }
    }

    private int readCorner() throws IOException {
        int position = index("vertex", positions.size() / 3);
        int texCoord = -1;
        int normal = -1;
        if (source.peek() == '/') {
            source.next();
            if (source.peek() != '/') {
                texCoord = index("texture coordinate", texCoords.size() / 2);
            }
            if (source.peek() == '/') {
                source.next();
                normal = index("normal", normals.size() / 3);
            }
        }
        part.hasTexCoords |= texCoord >= 0;
        part.hasNormals |= normal >= 0;
        part.lacksNormals |= normal < 0;
        return part.vertices.number(position, texCoord, normal);
    }

    /** Reads an index, which counts from 1, or backwards from the last element if it is negative. */
    private int index(String what, int count) throws IOException {
        long i = source.wholeNumber("the index of a " + what, '/');
        long index = i < 0 ? count + i : i - 1;
        if (index < 0 || index >= count) {
            throw new MeshFormatException(
                    source.line(), "a face refers to " + what + " " + i + " but " + count + " are defined before it");
        }
        return (int) index;
    }

    private TriangleMesh mesh(Part faces) {
        TripleTable vertices = faces.vertices;
        int count = vertices.size();
        float[] p = new float[3 * count];
        float @Nullable [] uv = faces.hasTexCoords ? new float[2 * count] : null;
        float @Nullable [] n = faces.hasNormals ? new float[3 * count] : null;
        for (int i = 0; i < count; i++) {
            copy(positions, vertices.get(i, 0), 3, p, i);
            if (uv != null) {
                copy(texCoords, vertices.get(i, 1), 2, uv, i);
            }
            if (n != null) {
                copy(normals, vertices.get(i, 2), 3, n, i);
            }
        }
        float @Nullable [] c = colors.size() == 0 ? null : new float[3 * count];
        for (int i = 0; c != null && i < count; i++) {
            copy(colors, vertices.get(i, 0), 3, c, i);
        }
        int[] t = faces.triangles.toArray();
        if (n != null && faces.lacksNormals) {
            float[] computed = VertexNormals.angleWeighted(p, t);
            for (int i = 0; i < count; i++) {
                if (vertices.get(i, 2) < 0) {
                    System.arraycopy(computed, 3 * i, n, 3 * i, 3);
                }
            }
        }
        return new TriangleMesh(p, t, n, uv, null, c);
    }

    private static void copy(FloatList from, int element, int stride, float[] to, int index) {
        if (element >= 0) {
            for (int k = 0; k < stride; k++) {
                to[stride * index + k] = from.get(stride * element + k);
            }
        }
    }
}
