package org.daybreak.core.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class IntersectorsTest {
    @Test
    void scalarIsAlwaysThere() {
        assertEquals("scalar", Intersectors.select("scalar").id());
        assertTrue(Intersectors.providers().stream().anyMatch(p -> p.id().equals("scalar")));
        assertSame(Intersectors.select(), Intersectors.select());
    }

    @Test
    void unknownIdNamesTheKnownOnes() {
        String message = assertThrows(IllegalArgumentException.class, () -> Intersectors.select("vektor"))
                .getMessage();
        assertTrue(message.contains("\"vektor\"") && message.contains("scalar"), message);
    }

    @Test
    void selfCheckPassesARightIntersectorAndCatchesAWrongOne() {
        PrimitiveSet set = SelfCheck.scene(200);
        Intersector right = ScalarIntersector.build(set, 1);
        assertEquals("", SelfCheck.compare(right, ScalarIntersector.build(set, 1)));
        assertNotEquals("", SelfCheck.compare(right, new FaultyIntersector(right, false)));
        assertNotEquals("", SelfCheck.compare(right, new FaultyIntersector(right, true)));
    }

    /** Loses every tenth hit, or reports every tenth distance a little wrong. */
    private static final class FaultyIntersector implements Intersector {
        private final Intersector right;
        private final boolean wrongDistance;
        private int queries;

        FaultyIntersector(Intersector right, boolean wrongDistance) {
            this.right = right;
            this.wrongDistance = wrongDistance;
        }

        @Override
        public boolean intersect(Ray ray) {
            boolean hit = right.intersect(ray);
            if (hit && ++queries % 10 == 0) {
                if (wrongDistance) {
                    ray.t *= 1.001;
                } else {
                    ray.primitive = -1;
                    return false;
                }
            }
            return hit;
        }

        @Override
        public boolean occluded(Ray ray) {
            return right.occluded(ray);
        }

        @Override
        public void bounds(float[] target) {
            right.bounds(target);
        }

        @Override
        public String describe() {
            return "faulty";
        }

        @Override
        public long memoryBytes() {
            return 0;
        }
    }
}
