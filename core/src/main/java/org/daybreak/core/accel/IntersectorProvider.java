package org.daybreak.core.accel;

import java.util.Optional;

/**
 * A way to build an {@link Intersector}; found by {@link java.util.ServiceLoader}. The provider class itself must load
 * on every JVM the program supports: whatever may be missing is touched by {@link #build} only.
 */
public interface IntersectorProvider {
    /** Unique short name by which a user can ask for it: {@code scalar}, {@code vector256}, {@code vector512}. */
    String id();

    /** One line for people. */
    String description();

    /** The available provider of highest priority is tried first. */
    int priority();

    /** Why it cannot, or should not, be used on this JVM and processor; empty where it can. */
    Optional<String> unavailability();

    /**
     * Builds the index. The result, and every answer it gives, is the same for every number of threads, at any time.
     *
     * @param primitives what to index; its arrays must not change afterwards
     * @param threads number of threads to build with, at least 1
     * @throws IllegalArgumentException if a coordinate is not finite, a vertex index is out of range, or the set is
     *     too large for the index
     */
    Intersector build(PrimitiveSet primitives, int threads);

    /**
     * Starts, in the background, whatever makes the intersectors of this provider fast. {@link #build} does so too; who
     * knows early that there will be something to build gains the time until then.
     */
    default void warmUp() {}

    /**
     * Waits until the intersectors of this provider run at full speed. They work from the start; only measurements need
     * this. The clock starts with {@link #warmUp} or the first {@link #build}.
     *
     * @param milliseconds how long to wait at most
     * @return false if they are still warming up, or turned out slow here and use a slower way for good
     * @throws InterruptedException if the thread is interrupted
     */
    default boolean awaitFullSpeed(long milliseconds) throws InterruptedException {
        return true;
    }
}
