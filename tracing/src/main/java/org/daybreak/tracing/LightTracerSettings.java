package org.daybreak.tracing;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;

/**
 * Settings of the light tracer.
 *
 * @param maxDepth largest number of edges of a path from a light to the camera: 1 shows emitters only; -1 for no limit
 * @param rrDepth Russian roulette may end a light subpath from this number of edges on
 */
public record LightTracerSettings(int maxDepth, int rrDepth) {
    /** The parameters from which the settings are made: those of the path tracer, which mean the same here. */
    static final List<Parameter> PARAMETERS = PathTracerSettings.PARAMETERS;

    /** Settings from parameter values. */
    static LightTracerSettings of(ParameterValues values) {
        return new LightTracerSettings(values.integer("maxDepth"), values.integer("rrDepth"));
    }

    /** The depth limit as a number that can be compared. */
    int edgeLimit() {
        return maxDepth < 0 ? Integer.MAX_VALUE : maxDepth;
    }
}
