package org.daybreak.core.light;

import java.util.List;

/** Picks the way to choose among lights. */
public final class LightSelections {
    /** Up to this many lights it pays to look at all of them for each choice. */
    private static final int FEW = 32;

    private LightSelections() {}

    /** The selection for the lights of a scene; its indices are those of the list. */
    public static LightSelection forLights(List<? extends Light> lights) {
        return lights.size() <= FEW ? new ImportanceLightSelection(lights) : new LightTreeSelection(lights);
    }
}
