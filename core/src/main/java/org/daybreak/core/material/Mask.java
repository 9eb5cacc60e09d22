package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** A material with holes: a fraction of the light, 1 − opacity, passes as if there were no surface. */
public final class Mask implements Bsdf {
    private final Texture opacity;
    private final Bsdf nested;

    /**
     * Creates a mask.
     *
     * @param opacity fraction of the surface that is there, in [0,1]; of colours the luminance counts
     * @param nested material of that fraction
     * @throws IllegalArgumentException if the opacity exceeds 1
     */
    public Mask(Texture opacity, Bsdf nested) {
        if (!(opacity.maximum() <= 1)) {
            throw new IllegalArgumentException("opacity must be between 0 and 1 but reaches " + opacity.maximum());
        }
        this.opacity = opacity;
        this.nested = nested;
    }

    @Override
    public boolean textured() {
        return !opacity.isConstant() || nested.textured();
    }

    @Override
    public TangentFrame tangentFrame() {
        return nested.tangentFrame();
    }

    @Override
    public boolean tiltsNormal() {
        return nested.tiltsNormal();
    }

    @Override
    public boolean connectable() {
        return nested.connectable();
    }

    @Override
    public boolean transmissive() {
        return nested.transmissive();
    }

    @Override
    public double evaluate(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode,
            Spectrum value) {
        double there = opacityAt(point);
        double density = nested.evaluate(point, woX, woY, woZ, wiX, wiY, wiZ, mode, value);
        value.scale(there);
        return there * density;
    }

    @Override
    public double density(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode) {
        return opacityAt(point) * nested.density(point, woX, woY, woZ, wiX, wiY, wiZ, mode);
    }

    @Override
    public boolean sample(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double u,
            double v,
            double w,
            TransportMode mode,
            BsdfSample out) {
        double there = opacityAt(point);
        if (w < there) {
            // What is left of w within the chosen fraction is uniform again; the weight f·cos/density keeps.
            boolean sampled = nested.sample(point, woX, woY, woZ, u, v, w / there, mode, out);
            out.density *= there;
            return sampled;
        }
        out.setPassThrough(woX, woY, woZ, 1 - there);
        return true;
    }

    @Override
    public int deltaLobes() {
        return nested.deltaLobes();
    }

    @Override
    public boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        double there = opacityAt(point);
        if (there == 0 || !nested.deltaLobe(point, woX, woY, woZ, lobe, mode, out)) {
            return false;
        }
        out.weight.scale(there);
        out.density *= there;
        return true;
    }

    @Override
    public double transparency(SurfacePoint point) {
        double there = opacityAt(point);
        return 1 - there + there * nested.transparency(point);
    }

    @Override
    public boolean maybeTransparent() {
        return true;
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double there = opacityAt(point);
        nested.albedo(point, out);
        out.set(there * out.r + 1 - there, there * out.g + 1 - there, there * out.b + 1 - there);
    }

    private double opacityAt(SurfacePoint point) {
        // The luminance of white exceeds 1 by rounding.
        return Math.min(1, opacity.evaluateScalar(point));
    }
}
