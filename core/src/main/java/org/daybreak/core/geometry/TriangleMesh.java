package org.daybreak.core.geometry;

import org.jspecify.annotations.Nullable;

/**
 * An indexed triangle mesh. Positions, normals, tangents, texture coordinates and colours are shared per vertex; a
 * triangle's front is the side from which its vertices run counter-clockwise. Immutable: the arrays are taken over, not
 * copied, and must not be changed afterwards.
 */
public final class TriangleMesh implements Shape {
    private final float[] positions;
    private final int[] triangles;
    private final float @Nullable [] normals;
    private final float @Nullable [] uvs;
    private final float @Nullable [] secondUvs;
    private final float @Nullable [] colors;
    private final float @Nullable [] tangents;

    /**
     * Creates a mesh without tangents, second texture coordinates and colours.
     *
     * @param positions x, y, z per vertex; finite
     * @param triangles three vertex indices per triangle
     * @param normals x, y, z per vertex, need not be unit, or null for flat shading
     * @param uvs u, v per vertex, or null
     * @throws IllegalArgumentException naming the first bad index or number
     */
    public TriangleMesh(float[] positions, int[] triangles, float @Nullable [] normals, float @Nullable [] uvs) {
        this(positions, triangles, normals, uvs, null, null, null);
    }

    /**
     * Creates a mesh without tangents.
     *
     * @param positions x, y, z per vertex; finite
     * @param triangles three vertex indices per triangle
     * @param normals x, y, z per vertex, need not be unit, or null for flat shading
     * @param uvs u, v per vertex, or null
     * @param secondUvs another u, v per vertex for textures that ask for the second set, or null
     * @param colors linear red, green, blue per vertex in [0,1], or null for white
     * @throws IllegalArgumentException naming the first bad index or number
     */
    public TriangleMesh(
            float[] positions,
            int[] triangles,
            float @Nullable [] normals,
            float @Nullable [] uvs,
            float @Nullable [] secondUvs,
            float @Nullable [] colors) {
        this(positions, triangles, normals, uvs, secondUvs, colors, null);
    }

    private TriangleMesh(
            float[] positions,
            int[] triangles,
            float @Nullable [] normals,
            float @Nullable [] uvs,
            float @Nullable [] secondUvs,
            float @Nullable [] colors,
            float @Nullable [] tangents) {
        if (positions.length % 3 != 0 || triangles.length % 3 != 0) {
            throw new IllegalArgumentException("positions and triangles must come in threes but there are "
                    + positions.length + " and " + triangles.length);
        }
        int vertices = positions.length / 3;
        checkLength("normals", normals, 3L * vertices);
        checkLength("texture coordinates", uvs, 2L * vertices);
        checkLength("second texture coordinates", secondUvs, 2L * vertices);
        checkLength("colors", colors, 3L * vertices);
        checkLength("tangents", tangents, 3L * vertices);
        checkFinite("position", positions, 3);
        if (normals != null) {
            checkFinite("normal", normals, 3);
        }
        if (uvs != null) {
            checkFinite("texture coordinate", uvs, 2);
        }
        if (secondUvs != null) {
            checkFinite("second texture coordinate", secondUvs, 2);
        }
        if (colors != null) {
            checkColors(colors);
        }
        if (tangents != null) {
            checkFinite("tangent", tangents, 3);
        }
        for (int i = 0; i < triangles.length; i++) {
            if (triangles[i] < 0 || triangles[i] >= vertices) {
                throw new IllegalArgumentException("triangle " + i / 3 + " refers to vertex " + triangles[i]
                        + " but the mesh has " + vertices + " vertices");
            }
        }
        this.positions = positions;
        this.triangles = triangles;
        this.normals = normals;
        this.uvs = uvs;
        this.secondUvs = secondUvs;
        this.colors = colors;
        this.tangents = tangents;
    }

    /**
     * This mesh with other optional attributes; everything else is shared.
     *
     * @param newSecondUvs as for the constructor
     * @param newColors as for the constructor
     * @throws IllegalArgumentException naming the first bad number
     */
    public TriangleMesh withAttributes(float @Nullable [] newSecondUvs, float @Nullable [] newColors) {
        return new TriangleMesh(positions, triangles, normals, uvs, newSecondUvs, newColors, tangents);
    }

    /**
     * This mesh with other normals or none; everything else is shared.
     *
     * @param newNormals as for the constructor
     * @throws IllegalArgumentException naming the first bad number
     */
    public TriangleMesh withNormals(float @Nullable [] newNormals) {
        return new TriangleMesh(positions, triangles, newNormals, uvs, secondUvs, colors, tangents);
    }

    /**
     * This mesh with tangents: directions that the shading frames of materials with normal maps, bump maps or anisotropic
     * roughness lie along, instead of those along which texture coordinates change in each triangle. Maps that were baked for
     * a mesh with tangents need them. Everything else is shared.
     *
     * @param newTangents x, y, z per vertex, need not be unit or orthogonal to the normals, or null
     * @throws IllegalArgumentException naming the first bad number
     */
    public TriangleMesh withTangents(float @Nullable [] newTangents) {
        return new TriangleMesh(positions, triangles, normals, uvs, secondUvs, colors, newTangents);
    }

    /**
     * This mesh with other triangles over the same vertices.
     *
     * @param newTriangles as for the constructor
     * @throws IllegalArgumentException naming the first bad index
     */
    public TriangleMesh withTriangles(int[] newTriangles) {
        return new TriangleMesh(positions, newTriangles, normals, uvs, secondUvs, colors, tangents);
    }

    /** Number of triangles. */
    public int triangleCount() {
        return triangles.length / 3;
    }

    /** Number of vertices. */
    public int vertexCount() {
        return positions.length / 3;
    }

    /** The positions; not a copy, do not change. */
    public float[] positions() {
        return positions;
    }

    /** The vertex indices; not a copy, do not change. */
    public int[] triangles() {
        return triangles;
    }

    /** The normals or null; not a copy, do not change. */
    public float @Nullable [] normals() {
        return normals;
    }

    /** The texture coordinates or null; not a copy, do not change. */
    public float @Nullable [] uvs() {
        return uvs;
    }

    /** The second texture coordinates or null; not a copy, do not change. */
    public float @Nullable [] secondUvs() {
        return secondUvs;
    }

    /** The tangents or null; not a copy, do not change. */
    public float @Nullable [] tangents() {
        return tangents;
    }

    /** The vertex colours or null; not a copy, do not change. */
    public float @Nullable [] colors() {
        return colors;
    }

    /**
     * A mesh whose triangles are wound so that their front is the side the vertex normals point to: the normals say which side
     * is out, whatever the winding. Returns this mesh if it is so already or has no normals.
     */
    public TriangleMesh windAlongNormals() {
        float[] n = normals;
        if (n == null) {
            return this;
        }
        int[] turned = null;
        for (int i = 0; i < triangles.length; i += 3) {
            if (windsAgainst(n, 3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2])) {
                if (turned == null) {
                    turned = triangles.clone();
                }
                turned[i + 1] = triangles[i + 2];
                turned[i + 2] = triangles[i + 1];
            }
        }
        return turned == null ? this : withTriangles(turned);
    }

    private boolean windsAgainst(float[] n, int a, int b, int c) {
        float[] p = positions;
        double e1x = (double) p[b] - p[a];
        double e1y = (double) p[b + 1] - p[a + 1];
        double e1z = (double) p[b + 2] - p[a + 2];
        double e2x = (double) p[c] - p[a];
        double e2y = (double) p[c + 1] - p[a + 1];
        double e2z = (double) p[c + 2] - p[a + 2];
        double gx = e1y * e2z - e1z * e2y;
        double gy = e1z * e2x - e1x * e2z;
        double gz = e1x * e2y - e1y * e2x;
        return gx * ((double) n[a] + n[b] + n[c])
                        + gy * ((double) n[a + 1] + n[b + 1] + n[c + 1])
                        + gz * ((double) n[a + 2] + n[b + 2] + n[c + 2])
                < 0;
    }

    private static void checkLength(String what, float @Nullable [] values, long expected) {
        if (values != null && values.length != expected) {
            throw new IllegalArgumentException(
                    "a mesh must have " + expected + " numbers of " + what + " but has " + values.length);
        }
    }

    private static void checkFinite(String what, float[] values, int stride) {
        for (int i = 0; i < values.length; i++) {
            if (!Float.isFinite(values[i])) {
                throw new IllegalArgumentException(what + " of vertex " + i / stride + " is not finite");
            }
        }
    }

    private static void checkColors(float[] colors) {
        for (int i = 0; i < colors.length; i++) {
            if (!(colors[i] >= 0 && colors[i] <= 1)) {
                throw new IllegalArgumentException(
                        "color of vertex " + i / 3 + " must be from 0 to 1 but contains " + colors[i]);
            }
        }
    }
}
