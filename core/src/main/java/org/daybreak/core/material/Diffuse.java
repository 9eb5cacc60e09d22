package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** Ideally diffuse reflection, f = ρ/π (Lambert). One-sided: black from behind. */
public final class Diffuse implements Bsdf {
    private static final double INV_PI = 1 / Math.PI;

    private final Reflectance reflectance;

    /**
     * Creates a diffuse material.
     *
     * @param reflectance albedo ρ, in [0,1]
     * @throws IllegalArgumentException if the reflectance exceeds 1
     */
    public Diffuse(Texture reflectance) {
        this.reflectance = new Reflectance("diffuse reflectance", reflectance);
    }

    @Override
    public boolean textured() {
        return reflectance.varies();
    }

    @Override
    public boolean choosesLobe() {
        return false;
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
        if (woZ <= 0 || wiZ <= 0) {
            value.setZero();
            return 0;
        }
        double density = wiZ * INV_PI;
        reflectance.evaluateScaled(point, density, value);
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
        return woZ <= 0 || wiZ <= 0 ? 0 : wiZ * INV_PI;
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
        if (woZ <= 0) {
            return false;
        }
        out.setCosineDistributed(u, v);
        out.setContinuous(out.wiZ * INV_PI);
        reflectance.evaluate(point, out.weight);
        return true;
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        reflectance.evaluate(point, out);
    }
}
