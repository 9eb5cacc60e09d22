package org.daybreak.core.geometry;

/** The triangles of a {@link Cube}, for intersection and sampling alike. */
public final class CubeMesh {
    /**
     * Axes along which u runs on the faces at −x, +x, −y, +y, −z and +z: 1 for x, 2 for y, 3 for z, negative against it. With
     * those of v they are Mitsuba's: seen from outside, v runs down where u runs to the right, as in images.
     */
    private static final int[] U_AXES = {2, 2, 3, -1, -2, 2};

    private static final int[] V_AXES = {3, -3, 1, -3, 1, 1};

    /** The cube [−1,1]³: four vertices and two triangles per face, normals outwards, texture coordinates [0,1]² per face. */
    public static final TriangleMesh MESH = create();

    private CubeMesh() {}

    private static TriangleMesh create() {
        float[] positions = new float[6 * 4 * 3];
        float[] uvs = new float[6 * 4 * 2];
        int[] triangles = new int[6 * 2 * 3];
        for (int face = 0; face < 6; face++) {
            int axis = face >> 1;
            float sign = (face & 1) == 0 ? -1 : 1;
            for (int corner = 0; corner < 4; corner++) {
                // Counter-clockwise on the unit square: 00, 10, 11, 01.
                float s = corner == 1 || corner == 2 ? 1 : -1;
                float t = corner >= 2 ? 1 : -1;
                int vertex = 4 * face + corner;
                positions[3 * vertex + axis] = sign;
                // With the axes in cyclic order s × t points along +axis; a mirrored s turns that to the outside of the
                // faces at −1.
                positions[3 * vertex + (axis + 1) % 3] = sign * s;
                positions[3 * vertex + (axis + 2) % 3] = t;
                uvs[2 * vertex] = textureCoordinate(positions, vertex, U_AXES[face]);
                uvs[2 * vertex + 1] = textureCoordinate(positions, vertex, V_AXES[face]);
            }
            int base = 4 * face;
            int[] corners = {base, base + 1, base + 2, base, base + 2, base + 3};
            System.arraycopy(corners, 0, triangles, 6 * face, 6);
        }
        return new TriangleMesh(positions, triangles, null, uvs);
    }

    private static float textureCoordinate(float[] positions, int vertex, int axis) {
        return 0.5F * (1 + Integer.signum(axis) * positions[3 * vertex + Math.abs(axis) - 1]);
    }
}
