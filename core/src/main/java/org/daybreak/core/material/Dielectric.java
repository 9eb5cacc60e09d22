package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A smooth interface between two transparent media: delta reflection and delta refraction. The normal points to the
 * exterior. Two-sided by nature.
 */
public final class Dielectric extends DeltaBsdf {
    private static final int REFLECTION = 0;
    private static final int REFRACTION = 1;

    private final double intIor;
    private final double extIor;
    private final Reflectance specularReflectance;
    private final Reflectance specularTransmittance;

    /**
     * Creates an interface.
     *
     * @param intIor refractive index on the side away from the normal
     * @param extIor refractive index on the normal's side
     * @param specularReflectance factor on reflection, in [0,1]; 1 is physical
     * @param specularTransmittance factor on refraction, in [0,1]; 1 is physical
     * @throws IllegalArgumentException if an index is not positive and finite or a factor exceeds 1
     */
    public Dielectric(double intIor, double extIor, Texture specularReflectance, Texture specularTransmittance) {
        this.intIor = Checks.requireIor("interior", intIor);
        this.extIor = Checks.requireIor("exterior", extIor);
        this.specularReflectance = new Reflectance("specular reflectance", specularReflectance);
        this.specularTransmittance = new Reflectance("specular transmittance", specularTransmittance);
    }

    @Override
    public boolean textured() {
        return specularReflectance.varies() || specularTransmittance.varies();
    }

    @Override
    public boolean transmissive() {
        return true;
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
        return follow(point, woX, woY, woZ, w, CHOOSE, mode, out);
    }

    @Override
    public int deltaLobes() {
        return 2;
    }

    @Override
    public boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        return lobe <= REFRACTION && follow(point, woX, woY, woZ, 0, lobe, mode, out) && out.undoChoice();
    }

    /** Sets a sample of a given lobe, or of the one that {@code w} chooses. */
    private boolean follow(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double w,
            int lobe,
            TransportMode mode,
            BsdfSample out) {
        if (woZ == 0) {
            return false;
        }
        boolean outside = woZ > 0;
        double etaRatio = outside ? extIor / intIor : intIor / extIor;
        double cosine = Math.min(1, Math.abs(woZ));
        double refracted = Fresnel.refractedCosine(cosine, etaRatio);
        double reflectance = refracted < 0 ? 1 : Fresnel.dielectric(cosine, refracted, 1 / etaRatio);
        if (lobe == CHOOSE ? w < reflectance : lobe == REFLECTION) {
            out.setMirrored(woX, woY, woZ);
            out.setDelta(REFLECTION, reflectance, 1);
            specularReflectance.evaluate(point, out.weight);
            return true;
        }
        out.wiX = -etaRatio * woX;
        out.wiY = -etaRatio * woY;
        out.wiZ = outside ? -refracted : refracted;
        out.setDelta(REFRACTION, 1 - reflectance, etaRatio);
        // Radiance per solid angle changes with the square of the index where rays converge; flux does not.
        double scale = mode == TransportMode.RADIANCE ? etaRatio * etaRatio : 1;
        specularTransmittance.evaluateScaled(point, scale, out.weight);
        return true;
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double reflectance = Fresnel.dielectric(1, intIor / extIor);
        specularReflectance.evaluateSum(point, reflectance, specularTransmittance, 1 - reflectance, out);
    }
}
