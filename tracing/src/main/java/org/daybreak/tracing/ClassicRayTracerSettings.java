package org.daybreak.tracing;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;

/**
 * Settings of the classic ray tracer.
 *
 * @param maxDepth largest number of edges of a path from the camera to a light; -1 for no limit
 */
public record ClassicRayTracerSettings(int maxDepth) {
    /** The parameters from which the settings are made. */
    static final List<Parameter> PARAMETERS = List.of(Parameter.integer(
            "maxDepth",
            "Recursion depth",
            10,
            -1,
            Integer.MAX_VALUE,
            "Largest number of edges from the camera to a light: 1 shows emitters only, 2 adds direct light, each further"
                    + " one a reflection or refraction; -1 for no limit."));

    /** Settings from parameter values. */
    static ClassicRayTracerSettings of(ParameterValues values) {
        return new ClassicRayTracerSettings(values.integer("maxDepth"));
    }

    /** The depth limit as a number that can be compared. */
    int edgeLimit() {
        return maxDepth < 0 ? Integer.MAX_VALUE : maxDepth;
    }
}
