package org.daybreak.core.accel;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.daybreak.core.testing.IntersectorChecks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WideBvhTest {
    private static final SplittableRandom RANDOM = new SplittableRandom(9);

    @ParameterizedTest
    @ValueSource(ints = {4, 8, 16})
    void layoutDoesNotDependOnThreads(int width) {
        PrimitiveSet set = IntersectorChecks.mixed(RANDOM.split(), 200_000, 50, 0.02, 1, new Instance[0]);
        WideBvh one = WideBvh.build(set, width, 1);
        for (int threads : new int[] {2, 3, 8}) {
            WideBvh many = WideBvh.build(set, width, threads);
            assertArrayEquals(one.data(), many.data());
            assertEquals(one.root(), many.root());
            assertEquals(one.stackSize(), many.stackSize());
        }
    }

    /** A Cornell box, twelve triangles and two spheres, is one node with a block and two spheres below it. */
    @Test
    void smallScenesAreShallow() {
        Quadric[] spheres = {
            new Quadric(Quadric.Kind.SPHERE, new double[] {0.3, 0, 0, -0.4, 0, 0.3, 0, -0.7, 0, 0, 0.3, -0.3}),
            new Quadric(Quadric.Kind.SPHERE, new double[] {0.3, 0, 0, 0.4, 0, 0.3, 0, -0.7, 0, 0, 0.3, 0.3})
        };
        PrimitiveSet walls = IntersectorChecks.mixed(RANDOM.split(), 12, 0, 0.5, 1, new Instance[0]);
        PrimitiveSet set = new PrimitiveSet(walls.positions(), walls.triangles(), spheres, new Instance[0]);
        WideBvh bvh = WideBvh.build(set, 16, 1);
        assertEquals(WideBvh.START, bvh.root());
        assertEquals(WideBvh.START + 7 * 16 + 9 * 16, bvh.data().length);
    }

    /** Every triangle is in one lane, every box holds what is below it. */
    @ParameterizedTest
    @ValueSource(ints = {4, 8, 16})
    void boxesHoldWhatIsBelow(int width) {
        int triangles = 5000;
        PrimitiveSet set = IntersectorChecks.mixed(RANDOM.split(), triangles, 20, 0.05, 3, new Instance[0]);
        WideBvh bvh = WideBvh.build(set, width, 1);
        int[] seen = new int[set.size()];
        float[] everything = {-2, -2, -2, 2, 2, 2};
        visit(bvh, set, width, bvh.root(), everything, seen);
        for (int i = 0; i < seen.length; i++) {
            assertEquals(1, seen[i], "primitive " + i);
        }
    }

    private static void visit(WideBvh bvh, PrimitiveSet set, int width, int reference, float[] box, int[] seen) {
        if (reference >= 0) {
            for (int lane = 0; lane < width; lane++) {
                float[] child = new float[6];
                for (int plane = 0; plane < 6; plane++) {
                    child[plane] = bvh.data()[reference + plane * width + lane];
                }
                if (child[0] <= child[3]) {
                    for (int axis = 0; axis < 3; axis++) {
                        assertTrue(child[axis] >= box[axis] && child[axis + 3] <= box[axis + 3]);
                    }
                    int below = Float.floatToRawIntBits(bvh.data()[reference + 6 * width + lane]);
                    visit(bvh, set, width, below, child, seen);
                }
            }
            return;
        }
        int leaf = ~reference;
        if ((leaf & 1) != 0) {
            seen[set.triangleCount() + (leaf >> 1)]++;
            return;
        }
        for (int lane = 0; lane < bvh.laneCount(leaf); lane++) {
            int number = bvh.number(leaf, lane);
            seen[number]++;
            for (int corner = 0; corner < 3; corner++) {
                for (int axis = 0; axis < 3; axis++) {
                    float stored = bvh.data()[leaf + (3 * corner + axis) * width + lane];
                    float given = set.positions()[3 * set.triangles()[3 * number + corner] + axis];
                    assertEquals(given * bvh.scale(), stored);
                    assertTrue(stored >= box[axis] && stored <= box[axis + 3]);
                }
            }
        }
    }
}
