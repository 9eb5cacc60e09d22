package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A surface with a material on each side. The back one sees a frame turned over, its normal towards the light. Nothing
 * passes from one side to the other.
 */
public final class TwoSided implements Bsdf {
    private final Bsdf front;
    private final Bsdf back;
    private final TangentFrame tangentFrame;

    /**
     * Creates a two-sided material.
     *
     * @param front material on the normal's side
     * @param back material on the other side; may be the same
     * @throws IllegalArgumentException if one of them lets light through, or if they need frames along different texture
     *     coordinates
     */
    public TwoSided(Bsdf front, Bsdf back) {
        this.front = requireOpaque("front", front);
        this.back = requireOpaque("back", back);
        this.tangentFrame = front.tangentFrame().and(back.tangentFrame());
    }

    private static Bsdf requireOpaque(String side, Bsdf bsdf) {
        if (bsdf.transmissive() || bsdf.maybeTransparent()) {
            throw new IllegalArgumentException("the " + side + " of a two-sided material must not let light through; "
                    + "a mask goes around the two-sided material");
        }
        return bsdf;
    }

    @Override
    public boolean textured() {
        return front.textured() || back.textured();
    }

    @Override
    public boolean choosesLobe() {
        return front.choosesLobe() || back.choosesLobe();
    }

    @Override
    public TangentFrame tangentFrame() {
        return tangentFrame;
    }

    @Override
    public boolean tiltsNormal() {
        return front.tiltsNormal() || back.tiltsNormal();
    }

    @Override
    public boolean connectable() {
        return front.connectable() || back.connectable();
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
        if (woZ > 0) {
            return front.evaluate(point, woX, woY, woZ, wiX, wiY, wiZ, mode, value);
        }
        return back.evaluate(point, woX, woY, -woZ, wiX, wiY, -wiZ, mode, value);
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
        if (woZ > 0) {
            return front.density(point, woX, woY, woZ, wiX, wiY, wiZ, mode);
        }
        return back.density(point, woX, woY, -woZ, wiX, wiY, -wiZ, mode);
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
        if (woZ > 0) {
            return front.sample(point, woX, woY, woZ, u, v, w, mode, out);
        }
        boolean sampled = back.sample(point, woX, woY, -woZ, u, v, w, mode, out);
        out.wiZ = -out.wiZ;
        return sampled;
    }

    /** The larger number of both sides: a side's lobes stay on it. */
    @Override
    public int deltaLobes() {
        return Math.max(front.deltaLobes(), back.deltaLobes());
    }

    @Override
    public boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        if (woZ > 0) {
            return front.deltaLobe(point, woX, woY, woZ, lobe, mode, out);
        }
        boolean followed = back.deltaLobe(point, woX, woY, -woZ, lobe, mode, out);
        out.wiZ = -out.wiZ;
        return followed;
    }

    /** The front's. */
    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        front.albedo(point, out);
    }
}
