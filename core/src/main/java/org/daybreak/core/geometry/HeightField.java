package org.daybreak.core.geometry;

/** Heights on a grid as a triangle mesh. */
public final class HeightField {
    private HeightField() {}

    /**
     * A mesh over the square [-1, 1]² in x and y, with heights along +z, two triangles for each cell. The first row is at
     * y = −1 and v = 0, the first column at x = −1 and u = 0. It has no normals.
     *
     * @param heights heights row by row; finite
     * @param width number of columns, at least 2
     * @param height number of rows, at least 2
     * @param scale factor on the heights
     * @throws IllegalArgumentException if the sizes do not fit, the mesh would be too large, or a height is not finite
     */
    public static TriangleMesh mesh(float[] heights, int width, int height, double scale) {
        long cells = (width - 1L) * (height - 1L);
        if (width < 2 || height < 2 || heights.length != (long) width * height) {
            throw new IllegalArgumentException(
                    "a height field of " + width + "x" + height + " does not fit " + heights.length + " heights");
        }
        if (6 * cells > Integer.MAX_VALUE - 8) {
            throw new IllegalArgumentException("a height field of " + width + "x" + height + " is too large");
        }
        float[] positions = new float[3 * heights.length];
        float[] uvs = new float[2 * heights.length];
        for (int i = 0; i < heights.length; i++) {
            int row = i / width;
            double u = (double) (i - row * width) / (width - 1);
            double v = (double) row / (height - 1);
            positions[3 * i] = (float) (2 * u - 1);
            positions[3 * i + 1] = (float) (2 * v - 1);
            positions[3 * i + 2] = (float) (scale * heights[i]);
            uvs[2 * i] = (float) u;
            uvs[2 * i + 1] = (float) v;
        }
        int[] triangles = new int[(int) (6 * cells)];
        int corner = 0;
        for (int row = 0; row + 1 < height; row++) {
            for (int column = 0; column + 1 < width; column++) {
                int a = row * width + column;
                int b = a + width;
                triangles[corner++] = a;
                triangles[corner++] = a + 1;
                triangles[corner++] = b + 1;
                triangles[corner++] = a;
                triangles[corner++] = b + 1;
                triangles[corner++] = b;
            }
        }
        return new TriangleMesh(positions, triangles, null, uvs);
    }
}
