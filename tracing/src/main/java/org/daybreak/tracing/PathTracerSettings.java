package org.daybreak.tracing;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;

/**
 * Settings of the path tracer.
 *
 * @param maxDepth largest number of edges of a path: 1 shows emitters only, 2 adds direct light; -1 for no limit
 * @param rrDepth Russian roulette may end a path from this number of edges on
 */
public record PathTracerSettings(int maxDepth, int rrDepth) {
    /** The parameters from which the settings are made. */
    static final List<Parameter> PARAMETERS = List.of(
            Parameter.integer(
                    "maxDepth",
                    "Recursion depth",
                    -1,
                    -1,
                    Integer.MAX_VALUE,
                    "Largest number of edges of a path from the camera to a light: 1 shows emitters only, 2 adds direct"
                            + " light, and so on; -1 for no limit."),
            Parameter.integer(
                    "rrDepth",
                    "Russian roulette from depth",
                    3,
                    1,
                    Integer.MAX_VALUE,
                    "Number of edges from which on a path may be ended at random, in proportion to what it can still"
                            + " contribute. Does not change the mean."));

    /** Settings from parameter values. */
    static PathTracerSettings of(ParameterValues values) {
        return new PathTracerSettings(values.integer("maxDepth"), values.integer("rrDepth"));
    }

    /** The depth limit as a number that can be compared. */
    int edgeLimit() {
        return maxDepth < 0 ? Integer.MAX_VALUE : maxDepth;
    }
}
