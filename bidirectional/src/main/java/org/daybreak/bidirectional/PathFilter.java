package org.daybreak.bidirectional;

/**
 * Which paths count, while other means find the others: a property of the full path, the same whichever technique makes it. The weights of the
 * techniques do not change with it.
 */
@FunctionalInterface
public interface PathFilter {
    /** Whether the path of the first s vertices of a light subpath and the first t of an eye subpath counts. */
    boolean counts(PathValues light, int s, PathValues eye, int t);
}
