package org.daybreak.scenes.mesh;

/** Vertex normals of meshes that come without. */
public final class VertexNormals {
    private VertexNormals() {}

    /**
     * Unit vertex normals as means of the unit normals of the triangles around, weighted by the triangle's angle at the
     * vertex (Thürmer and Wüthrich 1998). Vertices of no triangle of positive area get (1, 0, 0).
     *
     * @param positions x, y, z per vertex
     * @param triangles three vertex indices per triangle
     * @return x, y, z per vertex
     */
    public static float[] angleWeighted(float[] positions, int[] triangles) {
        double[] sums = new double[positions.length];
        for (int t = 0; t + 2 < triangles.length; t += 3) {
            addTriangle(positions, 3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2], sums);
        }
        float[] normals = new float[positions.length];
        for (int i = 0; i + 2 < sums.length; i += 3) {
            double length = Math.sqrt(sums[i] * sums[i] + sums[i + 1] * sums[i + 1] + sums[i + 2] * sums[i + 2]);
            if (length > 0) {
                normals[i] = (float) (sums[i] / length);
                normals[i + 1] = (float) (sums[i + 1] / length);
                normals[i + 2] = (float) (sums[i + 2] / length);
            } else {
                normals[i] = 1;
            }
        }
        return normals;
    }

    private static void addTriangle(float[] p, int a, int b, int c, double[] sums) {
        double abX = (double) p[b] - p[a];
        double abY = (double) p[b + 1] - p[a + 1];
        double abZ = (double) p[b + 2] - p[a + 2];
        double acX = (double) p[c] - p[a];
        double acY = (double) p[c + 1] - p[a + 1];
        double acZ = (double) p[c + 2] - p[a + 2];
        double nx = abY * acZ - abZ * acY;
        double ny = abZ * acX - abX * acZ;
        double nz = abX * acY - abY * acX;
        double doubleArea = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (!(doubleArea > 0)) {
            return;
        }
        double dotA = abX * acX + abY * acY + abZ * acZ;
        double dotB = abX * abX + abY * abY + abZ * abZ - dotA;
        // The sine of a corner's angle times its two edges is twice the area, whichever the corner.
        double angleA = Math.atan2(doubleArea, dotA);
        double angleB = Math.atan2(doubleArea, dotB);
        add(sums, a, angleA / doubleArea, nx, ny, nz);
        add(sums, b, angleB / doubleArea, nx, ny, nz);
        add(sums, c, (Math.PI - angleA - angleB) / doubleArea, nx, ny, nz);
    }

    private static void add(double[] sums, int i, double weight, double nx, double ny, double nz) {
        sums[i] += weight * nx;
        sums[i + 1] += weight * ny;
        sums[i + 2] += weight * nz;
    }
}
