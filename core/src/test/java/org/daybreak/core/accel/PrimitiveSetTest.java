package org.daybreak.core.accel;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the builder refuses, and with which words. */
class PrimitiveSetTest {
    private static final double[] IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    private static String refusal(float[] positions, int[] triangles, int threads) {
        return assertThrows(
                        IllegalArgumentException.class,
                        () -> new ScalarProvider().build(PrimitiveSet.ofTriangles(positions, triangles), threads))
                .getMessage();
    }

    @ParameterizedTest
    @ValueSource(floats = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY})
    void vertexThatIsNotFinite(float bad) {
        String message = refusal(new float[] {0, 0, 0, 1, bad, 0, 0, 1, 0}, new int[] {0, 1, 2}, 1);
        assertEquals("vertex 1 has the coordinate y = " + bad, message);
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 3, Integer.MAX_VALUE, Integer.MIN_VALUE})
    void vertexThatDoesNotExist(int bad) {
        String message = refusal(new float[9], new int[] {0, 1, 2, 0, bad, 2}, 1);
        assertEquals("triangle 1 refers to vertex " + bad + " but there are 3 vertices", message);
    }

    @Test
    void messagesSurviveThePool() {
        int[] triangles = new int[300_000];
        triangles[299_999] = 7;
        assertEquals("triangle 99999 refers to vertex 7 but there are 3 vertices", refusal(new float[9], triangles, 3));
    }

    @Test
    void incompleteVerticesAndTriangles() {
        assertThrows(IllegalArgumentException.class, () -> PrimitiveSet.ofTriangles(new float[4], new int[0]));
        assertThrows(IllegalArgumentException.class, () -> PrimitiveSet.ofTriangles(new float[9], new int[4]));
    }

    @Test
    void singularAndWrongTransforms() {
        double[] flat = {1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0};
        String message = assertThrows(IllegalArgumentException.class, () -> new Quadric(Quadric.Kind.SPHERE, flat))
                .getMessage();
        assertTrue(message.contains("singular"), message);
        double[] shifted = IDENTITY.clone();
        shifted[3] = 1;
        assertThrows(IllegalArgumentException.class, () -> new Quadric(Quadric.Kind.SPHERE, IDENTITY, shifted));
        double[] notFinite = IDENTITY.clone();
        notFinite[5] = Double.NaN;
        assertThrows(IllegalArgumentException.class, () -> new Quadric(Quadric.Kind.DISK, notFinite));
    }

    @Test
    void quadricBeyondSinglePrecision() {
        double[] huge = {1e39, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        Quadric[] quadrics = {new Quadric(Quadric.Kind.SPHERE, huge)};
        PrimitiveSet set = new PrimitiveSet(new float[0], new int[0], quadrics, new Instance[0]);
        String message = assertThrows(IllegalArgumentException.class, () -> new ScalarProvider().build(set, 1))
                .getMessage();
        assertTrue(message.startsWith("quadric 0 exceeds the range of single precision"), message);
    }

    @Test
    void boundsHoldAllKinds() {
        Quadric[] quadrics = {
            new Quadric(Quadric.Kind.CYLINDER, new double[] {1, 0, 0, 5, 0, 2, 0, 0, 0, 0, -3, 0}),
            new Quadric(Quadric.Kind.DISK, new double[] {0, 0, 1, 0, 0, 4, 0, 0, 1, 0, 0, 0})
        };
        float[] triangle = {0, 0, 0, 1, 0, 0, 0, 0, 7};
        Intersector level = new ScalarProvider().build(PrimitiveSet.ofTriangles(triangle, new int[] {0, 1, 2}), 1);
        Instance[] instances = {new Instance(new double[] {-2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, level)};
        PrimitiveSet set = new PrimitiveSet(new float[0], new int[0], quadrics, instances);
        float[] box = new float[6];
        new ScalarProvider().build(set, 1).bounds(box);
        assertArrayEquals(new float[] {-2, -4, -3, 6, 4, 7}, box, 1e-5f);
    }
}
