package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** The colours of a mesh's vertices, interpolated, times a factor; white on shapes without. */
public final class VertexColorTexture implements Texture {
    private final double scale;

    /**
     * Creates a texture.
     *
     * @param scale factor on the colours, which are in [0,1]
     * @throws IllegalArgumentException if the factor is negative or not finite
     */
    public VertexColorTexture(double scale) {
        if (!(scale >= 0 && scale < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "the scale of vertex colors must be finite and not negative but is " + scale);
        }
        this.scale = scale;
    }

    @Override
    public void evaluate(SurfacePoint point, Spectrum out) {
        out.set(scale * point.colorR, scale * point.colorG, scale * point.colorB);
    }

    @Override
    public double evaluateScalar(SurfacePoint point) {
        return scale * Spectrum.luminance(point.colorR, point.colorG, point.colorB);
    }

    @Override
    public double component(SurfacePoint point, int index) {
        return scale * (index == 0 ? point.colorR : index == 1 ? point.colorG : point.colorB);
    }

    /** Which mesh is not known: grey in the middle of the range. */
    @Override
    public void mean(Spectrum out) {
        out.set(0.5 * scale);
    }

    @Override
    public double maximum() {
        return scale;
    }
}
