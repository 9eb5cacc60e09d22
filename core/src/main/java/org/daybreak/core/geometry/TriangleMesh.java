package org.daybreak.core.geometry;

import org.jspecify.annotations.Nullable;

/**
 * An indexed triangle mesh. Positions, normals and texture coordinates are shared per vertex; a triangle's front is the side
 * from which its vertices run counter-clockwise. Immutable: the arrays are taken over, not copied, and must not be
 * changed afterwards.
 */
public final class TriangleMesh implements Shape {
    private final float[] positions;
    private final int[] triangles;
    private final float @Nullable [] normals;
    private final float @Nullable [] uvs;

    /**
     * Creates a mesh.
     *
     * @param positions x, y, z per vertex; finite
     * @param triangles three vertex indices per triangle
     * @param normals x, y, z per vertex, need not be unit, or null for flat shading
     * @param uvs u, v per vertex, or null
     * @throws IllegalArgumentException naming the first bad index or number
     */
    public TriangleMesh(float[] positions, int[] triangles, float @Nullable [] normals, float @Nullable [] uvs) {
        if (positions.length % 3 != 0 || triangles.length % 3 != 0) {
            throw new IllegalArgumentException("positions and triangles must come in threes but there are "
                    + positions.length + " and " + triangles.length);
        }
        int vertices = positions.length / 3;
        checkLength("normals", normals, 3L * vertices);
        checkLength("texture coordinates", uvs, 2L * vertices);
        checkFinite("position", positions, 3);
        if (normals != null) {
            checkFinite("normal", normals, 3);
        }
        if (uvs != null) {
            checkFinite("texture coordinate", uvs, 2);
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
        return turned == null ? this : new TriangleMesh(positions, turned, n, uvs);
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
}
