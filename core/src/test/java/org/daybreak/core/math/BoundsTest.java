package org.daybreak.core.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class BoundsTest {
    private static final Bounds BOX = new Bounds(-1, 0, 2, 3, 4, 5);

    @Test
    void collectsPointsAndBoxes() {
        Bounds.Builder builder = new Bounds.Builder();
        assertTrue(builder.build().isEmpty());
        builder.include(-1, 4, 5);
        builder.include(3, 0, 2);
        assertEquals(BOX, builder.build());
        builder.include(new Bounds(-2, 1, 1, 0, 9, 3));
        assertEquals(new Bounds(-2, 0, 1, 3, 9, 5), builder.build());
        assertEquals(builder.build(), BOX.union(new Bounds(-2, 1, 1, 0, 9, 3)));
    }

    @Test
    void emptyIsNeutral() {
        assertTrue(Bounds.EMPTY.isEmpty());
        assertEquals(BOX, BOX.union(Bounds.EMPTY));
        assertEquals(0, Bounds.EMPTY.boundingSphereRadius());
        assertTrue(Bounds.EMPTY.transform(Transform.translate(1, 2, 3)).isEmpty());
        assertFalse(new Bounds(1, 1, 1, 1, 1, 1).isEmpty());
    }

    @Test
    void nanMakesTheBoxEmptyForGood() {
        Bounds.Builder builder = new Bounds.Builder();
        builder.include(0, 0, 0);
        builder.include(0, Double.NaN, 0);
        builder.include(1, 1, 1);
        assertTrue(builder.build().isEmpty());
    }

    @Test
    void centreAndRadius() {
        assertEquals(1, BOX.centerX());
        assertEquals(2, BOX.centerY());
        assertEquals(3.5, BOX.centerZ());
        assertEquals(Math.sqrt(4 + 4 + 2.25), BOX.boundingSphereRadius(), 1e-15);
        Bounds huge = new Bounds(-1.5e308, 0, 0, 1.5e308, 0, 0);
        assertEquals(0, huge.centerX());
        assertTrue(BOX.contains(3, 4, 5));
        assertFalse(BOX.contains(3, 4, 5.1));
    }

    @Test
    void transformedBoxHoldsTheTransformedCorners() {
        Transform turn = Transform.rotate(0, 0, 1, 90);
        assertEquals(new Bounds(-4, -1, 2, 0, 3, 5), BOX.transform(turn));
        Bounds tilted = BOX.transform(Transform.rotate(1, 1, 1, 33));
        double[] p = new double[3];
        Transform.rotate(1, 1, 1, 33).applyPoint(3, 0, 5, p);
        assertTrue(tilted.contains(p[0], p[1], p[2]));
    }
}
