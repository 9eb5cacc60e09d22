package org.daybreak.core.geometry;

/** Brightness of an emitting surface over its texture coordinates, for drawing points from where it emits. */
public interface SurfaceBrightness {
    /** Luminance of the radiance at texture coordinates; finite and not negative. */
    double at(double u, double v);

    /** Number of steps along each side of the unit square of texture coordinates that resolves its pattern; positive. */
    int detail();
}
