package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** A texture times a colour. */
public final class ScaledTexture implements Texture {
    private final Texture nested;
    private final double r;
    private final double g;
    private final double b;
    private final boolean grey;

    /**
     * Creates a texture times a linear RGB colour.
     *
     * @throws IllegalArgumentException if a component is negative or not finite
     */
    public ScaledTexture(Texture nested, double r, double g, double b) {
        this.nested = nested;
        // Checks the components.
        Spectrum factor = new Spectrum();
        new ConstantTexture(r, g, b).mean(factor);
        this.r = factor.r;
        this.g = factor.g;
        this.b = factor.b;
        this.grey = r == g && g == b;
    }

    @Override
    public void evaluate(SurfacePoint point, Spectrum out) {
        nested.evaluate(point, out);
        out.set(r * out.r, g * out.g, b * out.b);
    }

    @Override
    public double evaluateScalar(SurfacePoint point) {
        return grey
                ? r * nested.evaluateScalar(point)
                : Spectrum.luminance(
                        r * nested.component(point, 0), g * nested.component(point, 1), b * nested.component(point, 2));
    }

    @Override
    public double component(SurfacePoint point, int index) {
        return (index == 0 ? r : index == 1 ? g : b) * nested.component(point, index);
    }

    /** Only a grey factor commutes with the luminance. */
    @Override
    public boolean differentiable() {
        return grey && nested.differentiable();
    }

    @Override
    public boolean usesSecondUvs() {
        return nested.usesSecondUvs();
    }

    @Override
    public double derivativeU(SurfacePoint point) {
        return r * nested.derivativeU(point);
    }

    @Override
    public double derivativeV(SurfacePoint point) {
        return r * nested.derivativeV(point);
    }

    @Override
    public void mean(Spectrum out) {
        nested.mean(out);
        out.set(r * out.r, g * out.g, b * out.b);
    }

    /** A bound: the largest of the factor times the largest of the texture, for grey factors exact. */
    @Override
    public double maximum() {
        return Math.max(r, Math.max(g, b)) * nested.maximum();
    }

    @Override
    public boolean isConstant() {
        return nested.isConstant();
    }
}
