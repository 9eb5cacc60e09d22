package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** A value that varies over a surface: a colour or a number. Immutable and thread-safe. */
public interface Texture {
    /** Writes the linear RGB value at a point. */
    void evaluate(SurfacePoint point, Spectrum out);

    /** The scalar value at a point: for colour textures their luminance. */
    double evaluateScalar(SurfacePoint point);

    /**
     * One component of the linear RGB value at a point. Textures that normal maps use implement it without allocation.
     *
     * @param index 0 for red, 1 for green, 2 for blue
     */
    default double component(SurfacePoint point, int index) {
        Spectrum value = new Spectrum();
        evaluate(point, value);
        return index == 0 ? value.r : index == 1 ? value.g : value.b;
    }

    /** True if {@link #derivativeU} and {@link #derivativeV} are those of the scalar value wherever it is smooth. */
    default boolean differentiable() {
        return false;
    }

    /** True if the texture lies on the second texture coordinates; its derivatives are by those then. */
    default boolean usesSecondUvs() {
        return false;
    }

    /** Derivative of the scalar value by the texture coordinate u; 0 where pieces are constant. */
    default double derivativeU(SurfacePoint point) {
        return 0;
    }

    /** Derivative of the scalar value by the texture coordinate v; 0 where pieces are constant. */
    default double derivativeV(SurfacePoint point) {
        return 0;
    }

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
