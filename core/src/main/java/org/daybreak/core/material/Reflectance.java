package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/** A texture checked to lie in [0,1], with a short cut for constants: reading those costs three loads. */
final class Reflectance {
    /** Null if constant. */
    private final @Nullable Texture varying;

    private final double r;
    private final double g;
    private final double b;
    private final double samplingWeight;

    /**
     * Checks and wraps a texture.
     *
     * @param name for the message, such as “diffuse reflectance”
     * @throws IllegalArgumentException if the texture exceeds 1
     */
    Reflectance(String name, Texture texture) {
        if (!(texture.maximum() <= 1)) {
            throw new IllegalArgumentException(name + " must be between 0 and 1 but reaches " + texture.maximum());
        }
        Spectrum mean = new Spectrum();
        texture.mean(mean);
        this.varying = texture.isConstant() ? null : texture;
        this.r = mean.r;
        this.g = mean.g;
        this.b = mean.b;
        double average = (mean.r + mean.g + mean.b) / 3;
        this.samplingWeight = average > 0 ? average : texture.maximum();
    }

    /** Writes the value at a point. */
    void evaluate(SurfacePoint point, Spectrum out) {
        Texture texture = varying;
        if (texture == null) {
            out.set(r, g, b);
        } else {
            texture.evaluate(point, out);
        }
    }

    /** Writes the value at a point times a factor. */
    void evaluateScaled(SurfacePoint point, double factor, Spectrum out) {
        Texture texture = varying;
        if (texture == null) {
            out.set(factor * r, factor * g, factor * b);
        } else {
            texture.evaluate(point, out);
            out.scale(factor);
        }
    }

    /** Writes the value at a point times a factor plus that of another times another factor. */
    void evaluateSum(SurfacePoint point, double factor, Reflectance other, double otherFactor, Spectrum out) {
        evaluateScaled(point, factor, out);
        double sumR = out.r;
        double sumG = out.g;
        double sumB = out.b;
        other.evaluateScaled(point, otherFactor, out);
        out.set(out.r + sumR, out.g + sumG, out.b + sumB);
    }

    /** Luminance at a point, positive unless the value is black. */
    double luminance(SurfacePoint point) {
        Texture texture = varying;
        return texture == null ? Spectrum.luminance(r, g, b) : texture.evaluateScalar(point);
    }

    /** True unless the texture is constant. */
    boolean varies() {
        return varying != null;
    }

    /** Mean over channels and texture, for choosing between lobes; zero only if the reflectance is zero everywhere. */
    double samplingWeight() {
        return samplingWeight;
    }
}
