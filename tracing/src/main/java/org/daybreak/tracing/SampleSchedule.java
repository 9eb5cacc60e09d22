package org.daybreak.tracing;

import java.util.Map;
import org.daybreak.core.render.RenderState;

/** The order in which a pixelwise render takes its samples. Guarded by the render. */
interface SampleSchedule {
    /** True if nothing remains to be described. */
    boolean isDone();

    /** True if the next unit depends on what was committed. */
    boolean needsCommits();

    /** Describes the next unit, if it is not {@linkplain #isDone() done}. */
    void next(TileUnit unit);

    /** Goes on from a state. */
    void restore(RenderState state);

    /** Where a unit stands in the schedule: a render that goes on from there begins with it. */
    Map<String, long[]> position(TileUnit unit);

    /** Where the unit to come stands. */
    Map<String, long[]> position();
}
