package org.daybreak.core.accel;

import org.jspecify.annotations.Nullable;

/**
 * A ray query, its answer, and the scratch space of the traversal. Mutable; owned by one worker and reused for all its
 * rays, so that a query allocates nothing.
 */
public final class Ray {
    /** Origin in the space of the {@link PrimitiveSet}. */
    public double ox, oy, oz;

    /** Direction; need not have unit length, t counts in multiples of it. */
    public double dx, dy, dz;

    /** Hits at or beyond this parameter are ignored; may be +∞. */
    public double tMax = Double.POSITIVE_INFINITY;

    /**
     * Answer: parameter of the hit. For triangles good to a few units in the last place of single precision; refine
     * with {@link HitRefinement}.
     */
    public double t;

    /** Answer: number of the primitive in the set, or in the set of the instance if there is one; -1 for no hit. */
    public int primitive = -1;

    /** Answer: number of the instance among {@link PrimitiveSet#instance}, or -1 for primitives of the set itself. */
    public int instance = -1;

    /** The ray as {@link #prepare} leaves it for the traversal. For implementations of {@link Intersector} only. */
    public final PreparedRay prepared = new PreparedRay();

    /** Room for one vector of distances as int bits. For implementations of {@link Intersector} only. */
    public final int[] lanes = new int[16];

    private long[] stack = new long[256];

    private @Nullable Ray nested;

    /** Sets origin and direction. */
    public void set(double ox, double oy, double oz, double dx, double dy, double dz, double tMax) {
        this.ox = ox;
        this.oy = oy;
        this.oz = oz;
        this.dx = dx;
        this.dy = dy;
        this.dz = dz;
        this.tMax = tMax;
    }

    /**
     * Returns a traversal stack of at least the given size. For implementations of {@link Intersector} only.
     *
     * @param size number of entries needed
     */
    public long[] stack(int size) {
        long[] current = stack;
        return current.length >= size ? current : growStack(size);
    }

    /**
     * Brings the ray into the form that traversal needs. For implementations of {@link Intersector} only.
     *
     * @param scale factor by which the index multiplied coordinates
     */
    public PreparedRay prepare(double scale) {
        prepared.set(this, scale);
        return prepared;
    }

    private long[] growStack(int size) {
        stack = new long[Math.max(size, 2 * stack.length)];
        return stack;
    }

    /** The ray with which an instance's own level is traversed; made when first needed. */
    Ray nested() {
        Ray child = nested;
        if (child == null) {
            child = new Ray();
            nested = child;
        }
        return child;
    }
}
