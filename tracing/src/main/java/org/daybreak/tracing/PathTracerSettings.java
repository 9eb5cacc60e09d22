package org.daybreak.tracing;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;

/**
 * Settings of the path tracer.
 *
 * @param maxDepth largest number of edges of a path: 1 shows emitters only, 2 adds direct light; -1 for no limit
 * @param rrDepth Russian roulette may end a path from this number of edges on
 * @param splitting number of paths that go on from the first vertex that scatters diffusely
 */
public record PathTracerSettings(int maxDepth, int rrDepth, int splitting) {
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
                            + " contribute. Does not change the mean."),
            Parameter.integer(
                    "splitting",
                    "Paths from the first diffuse surface",
                    4,
                    1,
                    1024,
                    "Number of paths that go on from the first surface that scatters diffusely. More of them help where"
                            + " the noise is in indirect light and caustics; 1 where direct light and edges are noisy."
                            + " Does not change the mean."));

    /** Settings from parameter values. */
    static PathTracerSettings of(ParameterValues values) {
        return new PathTracerSettings(
                values.integer("maxDepth"), values.integer("rrDepth"), values.integer("splitting"));
    }

    /** The depth limit as a number that can be compared. */
    int edgeLimit() {
        return maxDepth < 0 ? Integer.MAX_VALUE : maxDepth;
    }
}
