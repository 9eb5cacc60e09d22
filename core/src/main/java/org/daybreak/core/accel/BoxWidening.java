package org.daybreak.core.accel;

/**
 * Widening of boxes that makes up for the rounding of the triangle test.
 *
 * <p>The test subtracts the origin, and shears; each vertex moves by at most 2⁻²⁴ (2 |V − O| along its own axis and
 * along the axis of the ray). Where the ray meets the triangle, that is at most a few 2⁻²⁴ times the extent of the
 * triangle, plus a part that is relative to T and covered by {@link PreparedRay#ULPS}. So each box grows on all sides by
 * 2⁻²¹ of its largest extent. The rule is monotone: the widened box of a node holds those of its children.
 */
final class BoxWidening {
    private static final float RELATIVE = 0x1p-21f;

    private BoxWidening() {}

    /** By how much to move each side of a box with these extents. */
    static float margin(float extentX, float extentY, float extentZ) {
        return RELATIVE * Math.max(extentX, Math.max(extentY, extentZ));
    }

    static float down(float bound, float margin) {
        return Math.nextDown(bound - margin);
    }

    static float up(float bound, float margin) {
        return Math.nextUp(bound + margin);
    }
}
