package org.daybreak.scenes.mesh;

import java.util.Arrays;
import org.daybreak.core.geometry.TriangleMesh;

/** Removes triangles that have no area and therefore no normal. */
public final class ZeroAreaTriangles {
    /** Sine below which the angle between two sides counts as zero: far below what single-precision vertices can resolve. */
    private static final double SMALLEST_SINE = 1e-14;

    private ZeroAreaTriangles() {}

    /** The mesh without its triangles of zero area; the same mesh if there are none. May be left without any triangle. */
    public static TriangleMesh removedFrom(TriangleMesh mesh) {
        int[] all = mesh.triangles();
        int[] kept = all;
        int size = 0;
        for (int t = 0; t < all.length; t += 3) {
            if (hasArea(mesh.positions(), 3 * all[t], 3 * all[t + 1], 3 * all[t + 2])) {
                if (kept != all) {
                    System.arraycopy(all, t, kept, size, 3);
                }
                size += 3;
            } else if (kept == all) {
                kept = all.clone();
            }
        }
        return kept == all ? mesh : mesh.withTriangles(Arrays.copyOf(kept, size));
    }

    private static boolean hasArea(float[] p, int a, int b, int c) {
        double abX = (double) p[b] - p[a];
        double abY = (double) p[b + 1] - p[a + 1];
        double abZ = (double) p[b + 2] - p[a + 2];
        double acX = (double) p[c] - p[a];
        double acY = (double) p[c + 1] - p[a + 1];
        double acZ = (double) p[c + 2] - p[a + 2];
        double nx = abY * acZ - abZ * acY;
        double ny = abZ * acX - abX * acZ;
        double nz = abX * acY - abY * acX;
        double ab = abX * abX + abY * abY + abZ * abZ;
        double ac = acX * acX + acY * acY + acZ * acZ;
        return nx * nx + ny * ny + nz * nz > SMALLEST_SINE * SMALLEST_SINE * ab * ac;
    }
}
