package org.daybreak.metropolis.strategy;

import org.daybreak.metropolis.chains.PatternSet;

/**
 * Which paths count: those that some technique of bidirectional path tracing with the same limits can make.
 *
 * @param shortest smallest number of edges
 * @param maxVertices largest number of vertices
 * @param maxEyeVertices largest number of vertices from the lens, at least 1
 * @param maxLightVertices largest number of vertices from the light, at least 0
 * @param leftOut kinds of paths that do not count: numbers of {@link PathPattern}
 */
public record PathLimits(int shortest, long maxVertices, int maxEyeVertices, int maxLightVertices, PatternSet leftOut) {
    /** Limits with which all kinds of paths count. */
    public PathLimits(int shortest, long maxVertices, int maxEyeVertices, int maxLightVertices) {
        this(shortest, maxVertices, maxEyeVertices, maxLightVertices, PatternSet.NONE);
    }

    /** True if a path counts. */
    boolean admit(LightPath path) {
        int vertices = path.length;
        if (vertices - 1 < shortest
                || vertices > maxVertices
                || (!leftOut.isEmpty() && leftOut.contains(PathPattern.of(path)))) {
            return false;
        }
        if (vertices <= maxEyeVertices && !path.deltaLight) {
            return true;
        }
        // An emitter that is seen directly is met, not joined to the lens.
        int first = Math.max(1, (int) Math.min(Integer.MAX_VALUE, (long) vertices - maxEyeVertices));
        for (int s = first; s < vertices && s <= maxLightVertices && vertices > 2; s++) {
            if (path.joins(s - 1) && path.joins(s)) {
                return true;
            }
        }
        return false;
    }
}
