package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Texture;

/** A constant, or a pattern that varies smoothly over texture space and has a black corner. */
record TestTexture(double r, double g, double b, boolean pattern) implements Texture {
    @Override
    public void evaluate(SurfacePoint point, Spectrum out) {
        double factor = pattern ? Math.max(0, 0.2 + point.u - 0.4 * point.v) : 1;
        out.set(factor * r, factor * g, factor * b);
    }

    @Override
    public double evaluateScalar(SurfacePoint point) {
        Spectrum value = new Spectrum();
        evaluate(point, value);
        return value.luminance();
    }

    @Override
    public void mean(Spectrum out) {
        throw new UnsupportedOperationException("lights average over the surface");
    }

    @Override
    public double maximum() {
        return (pattern ? 1.2 : 1) * Math.max(r, Math.max(g, b));
    }

    @Override
    public boolean isConstant() {
        return !pattern;
    }
}
