package org.daybreak.metropolis.strategy;

import org.daybreak.bidirectional.Contribution;
import org.daybreak.bidirectional.PathValues;

/**
 * The kind of a path as a number: how many vertices are between light and lens, and at which of them it goes on by a delta lobe, as a
 * caustic does or what is seen in a mirror. In Heckbert's notation, with D for all that is not S: LDDE, LSDE, LDSE, …
 */
public final class PathPattern {
    /** Largest number of inner vertices that are told apart. */
    private static final int LONGEST = 24;

    /** All longer paths. */
    private static final long LONG = 0;

    private PathPattern() {}

    /** The pattern of a complete path. */
    public static long of(LightPath path) {
        int inner = path.length - 2;
        if (inner > LONGEST) {
            return LONG;
        }
        long bits = 0;
        for (int i = 1; i <= inner; i++) {
            bits |= path.lobe[i] >= 0 ? 1L << (i - 1) : 0;
        }
        return bits | 1L << inner;
    }

    /** The pattern of a path that bidirectional path tracing has found. */
    public static long of(Contribution found) {
        return of(found.light(), found.lightVertices(), found.eye(), found.eyeVertices());
    }

    /** The pattern of the path of the first s vertices of a light subpath and the first t of an eye subpath. */
    public static long of(PathValues light, int s, PathValues eye, int t) {
        int inner = s + t - 2;
        if (inner > LONGEST) {
            return LONG;
        }
        long bits = 0;
        // The ends are joined, or are light and lens: there is no lobe.
        for (int i = 1; i < s - 1; i++) {
            bits |= light.isDelta(i) ? 1L << (i - 1) : 0;
        }
        for (int j = 1; j < t - 1; j++) {
            bits |= eye.isDelta(j) ? 1L << (inner - j) : 0;
        }
        return bits | 1L << inner;
    }

    /**
     * Whether samples of pixels can make such paths other than by chance: by joining a point on a light to a vertex without a delta lobe, or two such
     * vertices next to each other; or as delta lobes lead from the lens to the light, so that the film position alone decides. All others
     * they only find if a subpath meets the light by chance: rarely, and with large contributions, of which a small number of samples may not
     * show a single one.
     */
    public static boolean suitsSamples(long pattern) {
        if (pattern == LONG) {
            return false;
        }
        int inner = Long.SIZE - 1 - Long.numberOfLeadingZeros(pattern);
        if (Long.bitCount(pattern) == inner + 1) {
            return true;
        }
        boolean joinable = true;
        for (int i = 0; i < inner; i++) {
            boolean delta = (pattern >> i & 1) != 0;
            if (!delta && joinable) {
                return true;
            }
            joinable = !delta;
        }
        return false;
    }
}
