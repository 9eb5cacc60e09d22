package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** 1 where the scalar value of another texture reaches a cutoff, 0 elsewhere: cut-out shapes. */
public final class ThresholdTexture implements Texture {
    private final Texture value;
    private final double cutoff;

    /**
     * Creates a texture.
     *
     * @param cutoff smallest value that gives 1
     */
    public ThresholdTexture(Texture value, double cutoff) {
        this.value = value;
        this.cutoff = cutoff;
    }

    @Override
    public void evaluate(SurfacePoint point, Spectrum out) {
        out.set(evaluateScalar(point));
    }

    @Override
    public double evaluateScalar(SurfacePoint point) {
        return value.evaluateScalar(point) >= cutoff ? 1 : 0;
    }

    @Override
    public double component(SurfacePoint point, int index) {
        return evaluateScalar(point);
    }

    @Override
    public boolean usesSecondUvs() {
        return value.usesSecondUvs();
    }

    /** The mean of the other texture, at most 1: how often it reaches the cutoff is not known, this is of the same order. */
    @Override
    public void mean(Spectrum out) {
        value.mean(out);
        out.set(Math.min(1, Spectrum.luminance(out.r, out.g, out.b)));
    }

    @Override
    public double maximum() {
        return cutoff <= value.maximum() ? 1 : 0;
    }

    @Override
    public boolean isConstant() {
        return value.isConstant();
    }
}
