package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A checkerboard of 2×2 fields per unit square of texture space: {@code color0} where ⌊2u⌋ + ⌊2v⌋ is even, also for
 * negative coordinates.
 */
public final class CheckerboardTexture implements Texture {
    private final Texture color0;
    private final Texture color1;
    private final double[] uvTransform;

    /**
     * Creates a checkerboard.
     *
     * @param color0 the field at the origin; sees the original texture coordinates
     * @param color1 the other fields
     * @param uvTransform 2×3 affine matrix as for {@link BitmapTexture}
     * @throws IllegalArgumentException if the matrix has not 6 finite elements
     */
    public CheckerboardTexture(Texture color0, Texture color1, double[] uvTransform) {
        this.color0 = color0;
        this.color1 = color1;
        this.uvTransform = Checks.requireAffine(uvTransform);
    }

    @Override
    public void evaluate(SurfacePoint point, Spectrum out) {
        (isFirst(point) ? color0 : color1).evaluate(point, out);
    }

    @Override
    public double evaluateScalar(SurfacePoint point) {
        return (isFirst(point) ? color0 : color1).evaluateScalar(point);
    }

    @Override
    public double component(SurfacePoint point, int index) {
        return (isFirst(point) ? color0 : color1).component(point, index);
    }

    @Override
    public boolean differentiable() {
        return color0.differentiable() && color1.differentiable();
    }

    @Override
    public double derivativeU(SurfacePoint point) {
        return (isFirst(point) ? color0 : color1).derivativeU(point);
    }

    @Override
    public double derivativeV(SurfacePoint point) {
        return (isFirst(point) ? color0 : color1).derivativeV(point);
    }

    @Override
    public void mean(Spectrum out) {
        Spectrum other = new Spectrum();
        color1.mean(other);
        color0.mean(out);
        out.add(other);
        out.scale(0.5);
    }

    @Override
    public double maximum() {
        return Math.max(color0.maximum(), color1.maximum());
    }

    private boolean isFirst(SurfacePoint point) {
        double[] m = uvTransform;
        double u = m[0] * point.u + m[1] * point.v + m[2];
        double v = m[3] * point.u + m[4] * point.v + m[5];
        return isOdd(Math.floor(2 * u)) == isOdd(Math.floor(2 * v));
    }

    private static boolean isOdd(double integer) {
        return integer - 2 * Math.floor(integer / 2) != 0;
    }
}
