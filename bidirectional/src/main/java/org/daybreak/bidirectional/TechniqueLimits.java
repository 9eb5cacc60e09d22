package org.daybreak.bidirectional;

/**
 * Which techniques (s, t) a configuration samples.
 *
 * @param maxEyeVertices largest t, at least 1
 * @param maxLightVertices largest s, at least 0
 * @param lens whether t = 1 is among them
 * @param parallelFilm whether the camera sees along a single direction, so that what is at infinity is sampled by film position
 * @param lensHits whether t = 0 is among them: light subpaths that hit the lens
 * @param lensShare as how many samples one of t = 1 counts in the weights, in (0, 1]
 */
record TechniqueLimits(
        int maxEyeVertices,
        int maxLightVertices,
        boolean lens,
        boolean parallelFilm,
        boolean lensHits,
        double lensShare) {
    /** True if no technique of a path with so many vertices is beyond the limits of depth. */
    boolean leaveAll(int vertices) {
        return vertices <= maxEyeVertices && vertices - (lensHits ? 0 : 1) <= maxLightVertices;
    }

    /**
     * Whether lights that are seen directly are joined to the lens (s = t = 1): only if eye subpaths cannot meet them. These do
     * better than a comparison of densities can know, as each pixel has samples of its own.
     */
    boolean emitterAtLens() {
        return lens && maxEyeVertices == 1;
    }

    /** As how many samples one of technique s counts, which its density is multiplied by. */
    double share(CombinedPathValues path, int s) {
        return path.length() - s == 1 ? lensShare : 1;
    }

    /** What technique t = 1 counts as in sums of weights: n^β, or 0 if it is none. */
    double lensTerm(double exponent) {
        return lens ? MisWeight.power(lensShare, exponent) : 0;
    }

    /** True if technique s can make the path. */
    boolean admits(CombinedPathValues path, int s) {
        int t = path.length() - s;
        if (t < 0 || t > maxEyeVertices || s > maxLightVertices || (t == 1 && !(s == 1 ? emitterAtLens() : lens))) {
            return false;
        }
        if (t == 0) {
            return lensHits;
        }
        return s == 0 ? path.hittable : !path.delta[s - 1] && !path.delta[s];
    }
}
