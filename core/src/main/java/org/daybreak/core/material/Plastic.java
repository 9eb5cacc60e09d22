package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A diffuse base under a smooth dielectric coating: delta reflection off the coating, and diffuse light from below with
 * internal reflections. One-sided: black from behind.
 */
public final class Plastic implements Bsdf {
    private static final double INV_PI = 1 / Math.PI;

    private final double eta;
    private final CoatedDiffuse base;
    private final Reflectance specularReflectance;
    private final double externalTransmittance;
    private final LobeChoice choice;

    /**
     * Creates a coated diffuse material.
     *
     * @param intIor refractive index of the coating
     * @param extIor refractive index of the outside
     * @param diffuseReflectance albedo of the base, in [0,1]
     * @param specularReflectance factor on the reflection off the coating, in [0,1]; 1 is physical
     * @param nonlinear whether the colour of the base shifts with internal reflections
     * @throws IllegalArgumentException if an index is not positive and finite or a reflectance exceeds 1
     */
    public Plastic(
            double intIor, double extIor, Texture diffuseReflectance, Texture specularReflectance, boolean nonlinear) {
        this.eta = Checks.requireIor("interior", intIor) / Checks.requireIor("exterior", extIor);
        Reflectance diffuse = new Reflectance("diffuse reflectance", diffuseReflectance);
        this.specularReflectance = new Reflectance("specular reflectance", specularReflectance);
        this.base = new CoatedDiffuse(diffuse, eta, Fresnel.diffuse(1 / eta), nonlinear);
        this.externalTransmittance = 1 - Fresnel.diffuse(eta);
        this.choice = new LobeChoice(this.specularReflectance, diffuse);
    }

    @Override
    public boolean textured() {
        return base.varies() || specularReflectance.varies();
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
        double transmittanceOut = 1 - Fresnel.dielectric(Math.min(1, woZ), eta);
        double transmittanceIn = 1 - Fresnel.dielectric(Math.min(1, wiZ), eta);
        double cosineDensity = wiZ * INV_PI;
        base.evaluate(point, transmittanceOut * transmittanceIn * cosineDensity, value);
        return choice.diffuseProbability(transmittanceOut) * cosineDensity;
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
        if (woZ <= 0 || wiZ <= 0) {
            return 0;
        }
        double transmittance = 1 - Fresnel.dielectric(Math.min(1, woZ), eta);
        return choice.diffuseProbability(transmittance) * wiZ * INV_PI;
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
        double transmittanceOut = 1 - Fresnel.dielectric(Math.min(1, woZ), eta);
        double diffuse = choice.diffuseProbability(transmittanceOut);
        if (w < diffuse) {
            out.setCosineDistributed(u, v);
            out.setContinuous(diffuse * out.wiZ * INV_PI);
            double transmittanceIn = 1 - Fresnel.dielectric(Math.min(1, out.wiZ), eta);
            base.evaluate(point, transmittanceOut * transmittanceIn / diffuse, out.weight);
            return true;
        }
        if (!choice.anyLobe()) {
            return false;
        }
        setReflected(point, woX, woY, woZ, transmittanceOut, 1 - diffuse, out);
        return true;
    }

    @Override
    public int deltaLobes() {
        return 1;
    }

    @Override
    public boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        if (lobe > 0 || woZ <= 0) {
            return false;
        }
        double transmittance = 1 - Fresnel.dielectric(Math.min(1, woZ), eta);
        setReflected(point, woX, woY, woZ, transmittance, 1 - choice.diffuseProbability(transmittance), out);
        return out.undoChoice();
    }

    /** Sets a sample of the reflection off the coating. */
    private void setReflected(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double transmittance,
            double probability,
            BsdfSample out) {
        out.setMirrored(woX, woY, woZ);
        out.setDelta(0, probability, 1);
        specularReflectance.evaluateScaled(point, (1 - transmittance) / probability, out.weight);
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double transmittance = 1 - Fresnel.dielectric(1, eta);
        specularReflectance.evaluateScaled(point, 1 - transmittance, out);
        double r = out.r;
        double g = out.g;
        double b = out.b;
        base.evaluate(point, transmittance * externalTransmittance, out);
        out.set(out.r + r, out.g + g, out.b + b);
    }
}
