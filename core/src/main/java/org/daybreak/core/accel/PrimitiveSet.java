package org.daybreak.core.accel;

/**
 * What one {@link Intersector} indexes: triangles, quadrics and instances of other levels. Primitives are numbered one
 * after the other: triangles first, then quadrics, then instances.
 *
 * <p>The vertex and index arrays are shared, not copied; they must not change while an intersector built from them is
 * in use.
 */
public final class PrimitiveSet {
    private static final Quadric[] NO_QUADRICS = {};
    private static final Instance[] NO_INSTANCES = {};

    private final float[] positions;
    private final int[] triangles;
    private final Quadric[] quadrics;
    private final Instance[] instances;

    /**
     * Creates a set.
     *
     * @param positions vertices as x, y, z one after the other
     * @param triangles three vertex numbers for each triangle
     * @param quadrics analytic surfaces
     * @param instances placed copies of other levels; those levels must be free of instances
     * @throws IllegalArgumentException if a length is no multiple of three
     */
    public PrimitiveSet(float[] positions, int[] triangles, Quadric[] quadrics, Instance[] instances) {
        if (positions.length % 3 != 0) {
            throw new IllegalArgumentException("number of vertex coordinates is no multiple of 3: " + positions.length);
        }
        if (triangles.length % 3 != 0) {
            throw new IllegalArgumentException("number of triangle corners is no multiple of 3: " + triangles.length);
        }
        this.positions = positions;
        this.triangles = triangles;
        this.quadrics = quadrics.clone();
        this.instances = instances.clone();
    }

    /** A set of triangles only; see the constructor. */
    public static PrimitiveSet ofTriangles(float[] positions, int[] triangles) {
        return new PrimitiveSet(positions, triangles, NO_QUADRICS, NO_INSTANCES);
    }

    /** Number of triangles; they have the numbers 0 to this − 1. */
    public int triangleCount() {
        return triangles.length / 3;
    }

    /** Number of quadrics. */
    public int quadricCount() {
        return quadrics.length;
    }

    /** Number of instances. */
    public int instanceCount() {
        return instances.length;
    }

    /** Number of all primitives. */
    public int size() {
        return Math.addExact(Math.addExact(triangleCount(), quadrics.length), instances.length);
    }

    /** The vertex coordinates themselves, not a copy. */
    public float[] positions() {
        return positions;
    }

    /** The vertex numbers themselves, not a copy. */
    public int[] triangles() {
        return triangles;
    }

    /** Quadric by its own number; as a primitive it has the number {@link #triangleCount()} + index. */
    public Quadric quadric(int index) {
        return quadrics[index];
    }

    /** Instance by its own number, which {@link Ray#instance} reports. */
    public Instance instance(int index) {
        return instances[index];
    }
}
