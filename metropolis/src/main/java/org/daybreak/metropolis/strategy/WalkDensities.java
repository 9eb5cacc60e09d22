package org.daybreak.metropolis.strategy;

import org.daybreak.core.math.Densities;

/**
 * Densities with which random walks make pieces of a {@link LightPath}, in its measures: the factors of T
 * (Veach 1997, §11.4.1). Pure functions.
 */
final class WalkDensities {
    private WalkDensities() {}

    /**
     * Density with which a walk from vertex {@code from} (a vertex that stays, or -1 for the start of a light subpath)
     * towards the lens makes the vertices up to {@code to}, choices of delta lobes and what alpha masks decide
     * included.
     */
    static double fromLight(LightPath y, int from, int to) {
        double density = 1;
        for (int i = from + 1; i <= to; i++) {
            density *= y.fromLight[i];
            if (i > 0) {
                density *= y.lobeFromLight[i - 1] * y.clear[i - 1];
            }
        }
        return to == from ? 1 : density * y.opacity[to] / (from < 0 ? 1 : y.opacity[from]);
    }

    /**
     * The same from the lens side: the vertices from {@code to} up to {@code from} − 1; {@code from} may be k + 1 for
     * the start on the lens.
     */
    static double fromEye(LightPath y, int from, int to) {
        double density = 1;
        for (int i = from - 1; i >= to; i--) {
            density *= y.fromEye[i];
            if (i < y.length - 1) {
                density *= y.lobeFromEye[i + 1] * y.clear[i];
            }
        }
        return to == from ? 1 : density * y.opacity[to] / (from > y.length - 1 ? 1 : y.opacity[from]);
    }

    /** Factor from solid angle at x_{i+1} to the measure of x_i. */
    static double towardsLight(LightPath y, int i) {
        if (i == 0 && y.infinite) {
            return 1;
        }
        return Densities.solidAngleToArea(1, y.squared[i], y.points[i].geometricCosine(y.dx[i], y.dy[i], y.dz[i]));
    }
}
