package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** Two materials side by side, too fine to be told apart: f = (1 − weight)·first + weight·second. */
public final class Blend implements Bsdf {
    private static final double BELOW_ONE = Math.nextDown(1.0);

    private final UnitScalar weight;
    private final Bsdf first;
    private final Bsdf second;
    private final TangentFrame tangentFrame;
    /** Number of the second material's first delta lobe. */
    private final int secondLobe;

    /**
     * Creates a blend.
     *
     * @param weight share of the second material, in [0,1]; of colours the luminance counts
     * @throws IllegalArgumentException if the weight exceeds 1, or if the materials need frames along different texture
     *     coordinates
     */
    public Blend(Texture weight, Bsdf first, Bsdf second) {
        this.weight = new UnitScalar("weight", weight);
        this.first = first;
        this.second = second;
        this.tangentFrame = first.tangentFrame().and(second.tangentFrame());
        this.secondLobe = first.deltaLobes();
    }

    @Override
    public boolean textured() {
        return weight.varies() || first.textured() || second.textured();
    }

    @Override
    public TangentFrame tangentFrame() {
        return tangentFrame;
    }

    @Override
    public boolean tiltsNormal() {
        return first.tiltsNormal() || second.tiltsNormal();
    }

    @Override
    public boolean connectable() {
        return first.connectable() || second.connectable();
    }

    @Override
    public boolean transmissive() {
        return first.transmissive() || second.transmissive();
    }

    @Override
    public double transparency(SurfacePoint point) {
        double t = weight.at(point);
        return (1 - t) * first.transparency(point) + t * second.transparency(point);
    }

    @Override
    public boolean maybeTransparent() {
        return first.maybeTransparent() || second.maybeTransparent();
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
        double t = weight.at(point);
        double density = (1 - t) * first.evaluate(point, woX, woY, woZ, wiX, wiY, wiZ, mode, value);
        double r = (1 - t) * value.r;
        double g = (1 - t) * value.g;
        double b = (1 - t) * value.b;
        density += t * second.evaluate(point, woX, woY, woZ, wiX, wiY, wiZ, mode, value);
        value.set(t * value.r + r, t * value.g + g, t * value.b + b);
        return density;
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
        double t = weight.at(point);
        return (1 - t) * first.density(point, woX, woY, woZ, wiX, wiY, wiZ, mode)
                + t * second.density(point, woX, woY, woZ, wiX, wiY, wiZ, mode);
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
        double t = weight.at(point);
        boolean chosen = w < t;
        // What is left of w within the chosen share is uniform again.
        boolean sampled = chosen
                ? second.sample(point, woX, woY, woZ, u, v, w / t, mode, out)
                : first.sample(point, woX, woY, woZ, u, v, Math.min((w - t) / (1 - t), BELOW_ONE), mode, out);
        if (!sampled) {
            return false;
        }
        if (out.delta) {
            out.density *= chosen ? t : 1 - t;
            if (chosen && !out.passThrough) {
                out.lobe += secondLobe;
            }
            return true;
        }
        double density = evaluate(point, woX, woY, woZ, out.wiX, out.wiY, out.wiZ, mode, out.weight);
        return out.complete(density, out.eta);
    }

    /** The first material's, then the second's. */
    @Override
    public int deltaLobes() {
        return secondLobe + second.deltaLobes();
    }

    @Override
    public boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        double t = weight.at(point);
        boolean chosen = lobe >= secondLobe;
        double share = chosen ? t : 1 - t;
        boolean followed = chosen
                ? second.deltaLobe(point, woX, woY, woZ, lobe - secondLobe, mode, out)
                : first.deltaLobe(point, woX, woY, woZ, lobe, mode, out);
        if (share == 0 || !followed) {
            return false;
        }
        out.weight.scale(share);
        out.density *= share;
        out.lobe = lobe;
        return true;
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double t = weight.at(point);
        first.albedo(point, out);
        double r = (1 - t) * out.r;
        double g = (1 - t) * out.g;
        double b = (1 - t) * out.b;
        second.albedo(point, out);
        out.set(t * out.r + r, t * out.g + g, t * out.b + b);
    }
}
