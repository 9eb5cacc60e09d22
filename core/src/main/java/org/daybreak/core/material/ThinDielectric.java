package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A thin pane of a transparent medium: delta reflection, and transmission that does not bend. Light reflected any number of
 * times between its two faces is counted, without absorption: with Fresnel's reflectance F of one face the pane reflects
 * 2F/(1 + F). Two-sided by nature.
 */
public final class ThinDielectric extends DeltaBsdf {
    private static final int REFLECTION = 0;
    private static final int TRANSMISSION = 1;

    private final double eta;
    private final Reflectance specularReflectance;
    private final Reflectance specularTransmittance;

    /**
     * Creates a pane.
     *
     * @param intIor refractive index of the pane
     * @param extIor refractive index around it
     * @param specularReflectance factor on reflection, in [0,1]; 1 is physical
     * @param specularTransmittance factor on transmission, in [0,1]; 1 is physical
     * @throws IllegalArgumentException if an index is not positive and finite or a factor exceeds 1
     */
    public ThinDielectric(double intIor, double extIor, Texture specularReflectance, Texture specularTransmittance) {
        this.eta = Checks.requireIor("interior", intIor) / Checks.requireIor("exterior", extIor);
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
        return follow(point, woX, woY, woZ, w, CHOOSE, out);
    }

    @Override
    public int deltaLobes() {
        return 2;
    }

    @Override
    public boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        return lobe <= TRANSMISSION && follow(point, woX, woY, woZ, 0, lobe, out) && out.undoChoice();
    }

    /** Sets a sample of a given lobe, or of the one that {@code w} chooses. */
    private boolean follow(SurfacePoint point, double woX, double woY, double woZ, double w, int lobe, BsdfSample out) {
        if (woZ == 0) {
            return false;
        }
        double reflectance = reflectance(Math.min(1, Math.abs(woZ)));
        if (lobe == CHOOSE ? w < reflectance : lobe == REFLECTION) {
            out.setMirrored(woX, woY, woZ);
            out.setDelta(REFLECTION, reflectance, 1);
            specularReflectance.evaluate(point, out.weight);
        } else {
            out.setStraight(woX, woY, woZ);
            out.setDelta(TRANSMISSION, 1 - reflectance, 1);
            specularTransmittance.evaluate(point, out.weight);
        }
        return true;
    }

    private double reflectance(double cosine) {
        double face = Fresnel.dielectric(cosine, eta);
        return 2 * face / (1 + face);
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double reflectance = reflectance(1);
        specularReflectance.evaluateSum(point, reflectance, specularTransmittance, 1 - reflectance, out);
    }
}
