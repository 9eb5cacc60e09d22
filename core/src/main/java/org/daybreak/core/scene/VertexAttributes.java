package org.daybreak.core.scene;

import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * The vertex attributes that few scenes have, of all vertices of a level. The arrays are taken over.
 *
 * @param secondUvs second texture coordinates, or null if no mesh has any
 * @param colors linear RGB, or null if no mesh has any
 * @param tangents directions that shading frames lie along, zero vectors where a mesh has none; null if no mesh has any
 */
@SuppressWarnings("ArrayRecordComponent") // Never compared.
record VertexAttributes(float @Nullable [] secondUvs, float @Nullable [] colors, float @Nullable [] tangents) {
    /** Interpolates between the vertices a, b, c with the weights u, v, w. The point's first coordinates are set. */
    void set(int a, int b, int c, double u, double v, double w, SurfacePoint hit) {
        hit.setNoAttributes();
        float[] st = secondUvs;
        if (st != null) {
            hit.u2 = u * st[2 * a] + v * st[2 * b] + w * st[2 * c];
            hit.v2 = u * st[2 * a + 1] + v * st[2 * b + 1] + w * st[2 * c + 1];
        }
        float[] rgb = colors;
        if (rgb != null) {
            hit.colorR = u * rgb[3 * a] + v * rgb[3 * b] + w * rgb[3 * c];
            hit.colorG = u * rgb[3 * a + 1] + v * rgb[3 * b + 1] + w * rgb[3 * c + 1];
            hit.colorB = u * rgb[3 * a + 2] + v * rgb[3 * b + 2] + w * rgb[3 * c + 2];
        }
    }
}
