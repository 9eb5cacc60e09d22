package org.daybreak.bidirectional;

import java.util.Arrays;

/**
 * A full path x₀…x_k put together from a light and an eye subpath (the thesis' class of that name), with the densities of each
 * vertex from both ends. Index 0 is the vertex on the light; {@link #fromEnd} counts from the lens. Filled by
 * {@link ComplementTracer}, owned by one worker.
 */
public final class CombinedPathValues {
    private int length;

    /**
     * Density of each vertex as sampled from the light: per area, per solid angle at infinity. That of the lens counts only where
     * hits of it do.
     */
    double[] fromLight = new double[16];

    /** Density of each vertex as sampled from the lens. That of the lens itself may be 1 if it is the same in all techniques. */
    double[] fromEye = new double[16];

    /** True if the path scatters at the vertex by a delta lobe, so that none of its edges can be connected there. */
    boolean[] delta = new boolean[16];

    /** Density of x₀ when next-event estimation samples it from x₁; with two vertices that of the light subpath. */
    double nextEvent;

    /** True if eye paths can hit x₀. */
    boolean hittable;

    /** Creates an empty path. */
    public CombinedPathValues() {}

    /** Number of vertices, k + 1. */
    public int length() {
        return length;
    }

    /** Index from the light of the vertex with an index from the lens, and the other way round. */
    public int fromEnd(int index) {
        return length - 1 - index;
    }

    /** Density of a vertex as sampled from the light. */
    public double fromLight(int vertex) {
        return fromLight[vertex];
    }

    /** Density of a vertex as sampled from the lens. */
    public double fromEye(int vertex) {
        return fromEye[vertex];
    }

    /** True if the path scatters at a vertex by a delta lobe. */
    public boolean isDelta(int vertex) {
        return delta[vertex];
    }

    void setLength(int length) {
        this.length = length;
        if (length > fromLight.length) {
            int capacity = Math.max(length, 2 * fromLight.length);
            fromLight = Arrays.copyOf(fromLight, capacity);
            fromEye = Arrays.copyOf(fromEye, capacity);
            delta = Arrays.copyOf(delta, capacity);
        }
    }
}
