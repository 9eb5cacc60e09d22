package org.daybreak.scenes.gltf;

import org.daybreak.core.geometry.TriangleMesh;
import org.jspecify.annotations.Nullable;

/**
 * The triangles of a primitive with all vertex attributes that are read. Values per vertex are interleaved.
 *
 * @param positions x, y, z per vertex
 * @param triangles three vertex indices per triangle
 * @param normals x, y, z per vertex, or null for flat triangles
 * @param tangents x, y, z and the sign of the bitangent per vertex, or null
 * @param uv0 first texture coordinates, u and v per vertex, v down from the top of the image, or null
 * @param uv1 second texture coordinates, or null
 * @param colors linear r, g, b and opacity in [0, 1] per vertex, or null
 */
record Geometry(
        float[] positions,
        int[] triangles,
        float @Nullable [] normals,
        float @Nullable [] tangents,
        float @Nullable [] uv0,
        float @Nullable [] uv1,
        float @Nullable [] colors) {
    /** The mesh of the engine. */
    TriangleMesh toMesh() {
        return new TriangleMesh(positions, triangles, normals, uv0, uv1, triples(colors))
                .withTangents(triples(tangents));
    }

    /** The first three numbers of each four. */
    private static float @Nullable [] triples(float @Nullable [] fours) {
        if (fours == null) {
            return null;
        }
        float[] out = new float[fours.length / 4 * 3];
        for (int i = 0; i < out.length; i++) {
            out[i] = fours[i / 3 * 4 + i % 3];
        }
        return out;
    }

    /** True if a vertex is not opaque. */
    boolean hasVertexOpacity() {
        if (colors != null) {
            for (int i = 3; i < colors.length; i += 4) {
                if (colors[i] < 1) {
                    return true;
                }
            }
        }
        return false;
    }
}
