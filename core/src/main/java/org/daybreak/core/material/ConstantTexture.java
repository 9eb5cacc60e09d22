package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** The same colour everywhere. */
public final class ConstantTexture implements Texture {
    private final double r;
    private final double g;
    private final double b;

    /**
     * Creates a texture of a linear RGB colour.
     *
     * @throws IllegalArgumentException if a component is negative or not finite
     */
    public ConstantTexture(double r, double g, double b) {
        this.r = requireValue(r);
        this.g = requireValue(g);
        this.b = requireValue(b);
    }

    /** Creates a texture with three equal components, checked as by the constructor. */
    public static ConstantTexture grey(double value) {
        return new ConstantTexture(value, value, value);
    }

    @Override
    public void evaluate(SurfacePoint point, Spectrum out) {
        out.set(r, g, b);
    }

    @Override
    public double evaluateScalar(SurfacePoint point) {
        return scalar();
    }

    @Override
    public double component(SurfacePoint point, int index) {
        return index == 0 ? r : index == 1 ? g : b;
    }

    @Override
    public boolean differentiable() {
        return true;
    }

    @Override
    public void mean(Spectrum out) {
        out.set(r, g, b);
    }

    @Override
    public double maximum() {
        return Math.max(r, Math.max(g, b));
    }

    @Override
    public boolean isConstant() {
        return true;
    }

    @Override
    public String toString() {
        return "ConstantTexture[" + r + ", " + g + ", " + b + "]";
    }

    private double scalar() {
        // The luminance weights add up to 1 only to rounding: a grey must come back as it was given.
        return r == g && g == b ? r : Spectrum.luminance(r, g, b);
    }

    private static double requireValue(double value) {
        if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a texture's value must be finite and not negative but is " + value);
        }
        return value;
    }
}
