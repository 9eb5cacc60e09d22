package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** The product of two textures, component by component. */
public final class ProductTexture implements Texture {
    private final Texture first;
    private final Texture second;

    /** Creates the product of two textures. */
    public ProductTexture(Texture first, Texture second) {
        this.first = first;
        this.second = second;
    }

    @Override
    public void evaluate(SurfacePoint point, Spectrum out) {
        first.evaluate(point, out);
        double r = out.r;
        double g = out.g;
        double b = out.b;
        second.evaluate(point, out);
        out.set(r * out.r, g * out.g, b * out.b);
    }

    /** Luminance of the product. */
    @Override
    public double evaluateScalar(SurfacePoint point) {
        return Spectrum.luminance(component(point, 0), component(point, 1), component(point, 2));
    }

    @Override
    public double component(SurfacePoint point, int index) {
        return first.component(point, index) * second.component(point, index);
    }

    @Override
    public boolean usesSecondUvs() {
        return first.usesSecondUvs() || second.usesSecondUvs();
    }

    /** The product of the means, which is the mean of the product if the textures are independent or one is constant. */
    @Override
    public void mean(Spectrum out) {
        first.mean(out);
        double r = out.r;
        double g = out.g;
        double b = out.b;
        second.mean(out);
        out.set(r * out.r, g * out.g, b * out.b);
    }

    /** The product of the maxima, a bound. */
    @Override
    public double maximum() {
        return first.maximum() * second.maximum();
    }

    @Override
    public boolean isConstant() {
        return first.isConstant() && second.isConstant();
    }
}
