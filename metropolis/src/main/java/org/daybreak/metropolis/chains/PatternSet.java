package org.daybreak.metropolis.chains;

import java.util.Arrays;

/** A set of kinds of paths, which are numbers here. Immutable. */
public final class PatternSet {
    /** No kind. */
    public static final PatternSet NONE = new PatternSet(new long[0]);

    private final long[] patterns;

    /** Creates a set of the numbers in an array, in any order. */
    public PatternSet(long... patterns) {
        this.patterns = patterns.clone();
        Arrays.sort(this.patterns);
    }

    /** Whether a kind is among them. */
    public boolean contains(long pattern) {
        return Arrays.binarySearch(patterns, pattern) >= 0;
    }

    /** True if there is no kind in it. */
    public boolean isEmpty() {
        return patterns.length == 0;
    }

    /** Number of kinds. */
    public int size() {
        return patterns.length;
    }
}
