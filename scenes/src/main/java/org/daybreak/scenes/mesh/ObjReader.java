package org.daybreak.scenes.mesh;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.render.NearestName;
import org.jspecify.annotations.Nullable;

/**
 * Reads Wavefront OBJ files: {@code v}, {@code vt}, {@code vn} and {@code f} in all forms, negative indices, lines joined by
 * a backslash. All groups become one mesh; polygons are cut into fans. Vertices are shared where position, texture
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
            "usemtl",
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
    private final IntList triangles = new IntList();

    /** Position, texture coordinate and normal of each vertex of the mesh, the last two -1 if there is none. */
    private final TripleTable vertices = new TripleTable();

    private boolean hasTexCoords;
    private boolean hasNormals;
    private boolean lacksNormals;

    private ObjReader(ByteSource source, boolean flipTexCoords) {
        this.source = source;
        this.flipTexCoords = flipTexCoords;
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
            return new ObjReader(source, flipTexCoords).read();
        }
    }

    private TriangleMesh read() throws IOException {
        while (source.peek() != -1) {
            int first = source.skipBlanks();
            if (first != '\n' && first != '#' && first != -1) {
                readStatement();
            }
            source.skipLine();
        }
        if (triangles.size() == 0) {
            throw new MeshFormatException(0, "the file has no faces");
        }
        return mesh();
    }

    private void readStatement() throws IOException {
        String keyword = source.word();
        switch (keyword) {
            case "v" -> {
                positions.add(coordinate("x of a vertex"));
                positions.add(coordinate("y of a vertex"));
                positions.add(coordinate("z of a vertex"));
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
                triangles.add(fan);
                triangles.add(previous);
                triangles.add(vertex);
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
        hasTexCoords |= texCoord >= 0;
        hasNormals |= normal >= 0;
        lacksNormals |= normal < 0;
        return vertices.number(position, texCoord, normal);
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

    private TriangleMesh mesh() {
        int count = vertices.size();
        float[] p = new float[3 * count];
        float @Nullable [] uv = hasTexCoords ? new float[2 * count] : null;
        float @Nullable [] n = hasNormals ? new float[3 * count] : null;
        for (int i = 0; i < count; i++) {
            copy(positions, vertices.get(i, 0), 3, p, i);
            if (uv != null) {
                copy(texCoords, vertices.get(i, 1), 2, uv, i);
            }
            if (n != null) {
                copy(normals, vertices.get(i, 2), 3, n, i);
            }
        }
        int[] t = triangles.toArray();
        if (n != null && lacksNormals) {
            float[] computed = VertexNormals.angleWeighted(p, t);
            for (int i = 0; i < count; i++) {
                if (vertices.get(i, 2) < 0) {
                    System.arraycopy(computed, 3 * i, n, 3 * i, 3);
                }
            }
        }
        return new TriangleMesh(p, t, n, uv);
    }

    private static void copy(FloatList from, int element, int stride, float[] to, int index) {
        if (element >= 0) {
            for (int k = 0; k < stride; k++) {
                to[stride * index + k] = from.get(stride * element + k);
            }
        }
    }
}
