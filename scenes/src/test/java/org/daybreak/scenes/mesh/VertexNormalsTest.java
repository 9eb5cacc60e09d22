package org.daybreak.scenes.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.daybreak.core.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;

class VertexNormalsTest {
    private static final float[] BENT_SQUARE = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1};

    @Test
    void agreeWithMitsuba() {
        // Read from vertex_normals of a ply and an obj shape in Mitsuba 3.9.1.
        float[] expected = {
            0.37048277f,
            -0.37048277f,
            0.85175407f,
            0,
            0,
            1,
            0.37048277f,
            -0.37048277f,
            0.85175407f,
            0.57735026f,
            -0.57735026f,
            0.57735026f
        };
        assertArrayEquals(expected, VertexNormals.angleWeighted(BENT_SQUARE, new int[] {0, 1, 2, 0, 2, 3}), 2e-7f);
    }

    @Test
    void ignoreTrianglesWithoutArea() {
        float[] positions = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 1};
        float h = (float) Math.sqrt(0.5);
        // Mitsuba 3.9.1 gives the same, also for the vertex that only the flat triangle has.
        float[] expected = {0, -h, h, 0, -h, h, 1, 0, 0, 0, -h, h};
        assertArrayEquals(expected, VertexNormals.angleWeighted(positions, new int[] {0, 1, 2, 0, 1, 3}), 2e-7f);
    }

    @Test
    void doNotDependOnHowAFanIsCut() {
        float[] pyramid = {1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1};
        float[] normals =
                VertexNormals.angleWeighted(pyramid, new int[] {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2, 1, 0, 3, 2});
        float[] other =
                VertexNormals.angleWeighted(pyramid, new int[] {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 3, 1, 3, 2});
        assertArrayEquals(normals, other, 1e-6f);
    }

    @Test
    void zeroAreaTrianglesGoAndOthersStay() {
        TriangleMesh bad = new TriangleMesh(
                BENT_SQUARE, new int[] {0, 0, 1, 0, 1, 2, 1, 2, 1, 3, 3, 3, 0, 2, 3, 2, 3, 2}, null, null);
        TriangleMesh good = ZeroAreaTriangles.removedFrom(bad);
        assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3}, good.triangles());
        assertSame(good, ZeroAreaTriangles.removedFrom(good));
        // Small is not zero: the same shape a billion times smaller, and a needle.
        float[] small = {0, 0, 0, 1e-9f, 0, 0, 1e-9f, 1e-9f, 0, 1e-9f, 1e-18f, 0};
        assertEquals(
                2,
                ZeroAreaTriangles.removedFrom(new TriangleMesh(small, new int[] {0, 1, 2, 0, 1, 3}, null, null))
                        .triangleCount());
    }
}
