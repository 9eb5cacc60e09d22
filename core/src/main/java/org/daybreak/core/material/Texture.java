package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** A value that varies over a surface: a colour or a number. Immutable and thread-safe. */
public interface Texture {
    /** Writes the linear RGB value at a point. */
    void evaluate(SurfacePoint point, Spectrum out);

    /** The scalar value at a point: for colour textures their luminance. */
    double evaluateScalar(SurfacePoint point);

    /** Writes the mean over the unit square of texture space: weights for lights and lobes. */
    void mean(Spectrum out);

    /** Largest component anywhere: for checks such as reflectance ≤ 1. */
    double maximum();

    /** True if the value is the same everywhere. */
    default boolean isConstant() {
        return false;
    }

    /** Number of steps along each side of the unit square of texture space that resolves the pattern; positive. */
    default int detail() {
        return 64;
    }
}
