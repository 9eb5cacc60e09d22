package org.daybreak.core.geometry;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class CubeMeshTest {
    /** Vertices of Mitsuba 3.9.1's cube, four for each face, with texture coordinates (0, 1), (1, 1), (1, 0) and (0, 0). */
    private static final int[][][] MITSUBA = {
        {{1, -1, -1}, {1, -1, 1}, {-1, -1, 1}, {-1, -1, -1}},
        {{1, 1, -1}, {-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}},
        {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}},
        {{1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}},
        {{-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}, {-1, -1, -1}},
        {{1, 1, -1}, {1, -1, -1}, {-1, -1, -1}, {-1, 1, -1}},
    };

    private static final int[][] COORDINATES = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};

    @Test
    void facesHaveTheTextureCoordinatesOfMitsuba() {
        List<String> expected = new ArrayList<>();
        for (int[][] face : MITSUBA) {
            IntStream.range(0, 4)
                    .forEach(i -> expected.add(vertex(face, face[i], COORDINATES[i][0], COORDINATES[i][1])));
        }
        float[] positions = CubeMesh.MESH.positions();
        float[] uvs = CubeMesh.MESH.uvs();
        assertNotNull(uvs);
        List<String> actual = new ArrayList<>();
        for (int face = 0; face < 6; face++) {
            int[][] corners = new int[4][];
            for (int i = 0; i < 4; i++) {
                int p = 3 * (4 * face + i);
                corners[i] = new int[] {(int) positions[p], (int) positions[p + 1], (int) positions[p + 2]};
            }
            for (int i = 0; i < 4; i++) {
                int t = 2 * (4 * face + i);
                actual.add(vertex(corners, corners[i], (int) uvs[t], (int) uvs[t + 1]));
            }
        }
        assertEquals(24, actual.size());
        assertArrayEquals(
                expected.stream().sorted().toArray(), actual.stream().sorted().toArray());
    }

    /** The face, by the sum of its corners, with one of them and its texture coordinates. */
    private static String vertex(int[][] face, int[] corner, int u, int v) {
        int x = face[0][0] + face[1][0] + face[2][0] + face[3][0];
        int y = face[0][1] + face[1][1] + face[2][1] + face[3][1];
        int z = face[0][2] + face[1][2] + face[2][2] + face[3][2];
        return x + " " + y + " " + z + ": " + corner[0] + " " + corner[1] + " " + corner[2] + " at " + u + " " + v;
    }
}
