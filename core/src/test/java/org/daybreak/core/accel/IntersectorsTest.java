package org.daybreak.core.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
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
        assertEquals("", SelfCheck.run(new ScalarProvider()));
        assertNotEquals("", SelfCheck.run(new FaultyProvider(false)));
        assertNotEquals("", SelfCheck.run(new FaultyProvider(true)));
    }

    /** Loses every tenth hit, or reports every tenth distance a little wrong. */
    private record FaultyProvider(boolean wrongDistance) implements IntersectorProvider {
        @Override
        public String id() {
            return "faulty";
        }

        @Override
        public String description() {
            return "wrong now and then";
        }

        @Override
        public int priority() {
            return -1;
        }

        @Override
        public Optional<String> unavailability() {
            return Optional.empty();
        }

        @Override
        public Intersector build(PrimitiveSet primitives, int threads) {
            return new FaultyIntersector(ScalarIntersector.build(primitives, threads), wrongDistance);
        }
    }

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
