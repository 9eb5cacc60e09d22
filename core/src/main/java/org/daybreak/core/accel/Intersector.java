package org.daybreak.core.accel;

/**
 * An immutable index of one {@link PrimitiveSet} that answers ray queries. Safe for any number of threads, each with
 * its own {@link Ray}; a query allocates nothing once the ray's scratch space has grown to what the index needs.
 *
 * <p>A hit lies at a parameter t with 0 &lt; t &lt; {@code tMax} on {@code origin + t * direction}. Surfaces are hit
 * from both sides. Origins are taken as they are: who leaves a surface moves the origin off it first
 * ({@link HitRefinement}).
 */
public interface Intersector {
    /**
     * Finds the hit of least t. Fills {@link Ray#t}, {@link Ray#primitive} and {@link Ray#instance}; without a hit
     * sets {@code primitive} to -1 and leaves {@code t} at {@code tMax}.
     *
     * @return whether anything was hit
     */
    boolean intersect(Ray ray);

    /** Tells whether there is any hit. Leaves the result fields of the ray undefined. */
    boolean occluded(Ray ray);

    /**
     * Writes the axis-aligned bounds of all primitives: minimum x, y, z, then maximum x, y, z. An empty set has the
     * minimum +∞ and the maximum −∞.
     */
    void bounds(float[] target);

    /** Kind and size of the index in a few words, such as {@code bvh16-512, 50732 triangles, 3.1 MB}. */
    String describe();

    /** Heap memory that this index holds, in bytes, without the arrays of the {@link PrimitiveSet} and children. */
    long memoryBytes();
}
