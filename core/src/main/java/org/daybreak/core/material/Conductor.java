package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** A smooth metal, or an ideal mirror: one delta lobe of reflection. One-sided: black from behind. */
public final class Conductor extends DeltaBsdf {
    private final ConductorFresnel fresnel;
    private final Reflectance specularReflectance;

    /**
     * Creates a metal.
     *
     * @param eta real part of the refractive index, relative to vacuum
     * @param k imaginary part (absorption)
     * @param specularReflectance factor on the lobe, in [0,1]; 1 is physical
     * @throws IllegalArgumentException if a part of the index is negative, not finite, or both are zero, or the
     *     reflectance exceeds 1
     */
    public Conductor(Spectrum eta, Spectrum k, Texture specularReflectance) {
        this(new ConductorFresnel(eta, k), specularReflectance);
    }

    private Conductor(ConductorFresnel fresnel, Texture specularReflectance) {
        this.fresnel = fresnel;
        this.specularReflectance = new Reflectance("specular reflectance", specularReflectance);
    }

    /**
     * Creates a mirror that reflects the same at every angle.
     *
     * @param specularReflectance reflectance, in [0,1]
     * @throws IllegalArgumentException if the reflectance exceeds 1
     */
    public static Conductor mirror(Texture specularReflectance) {
        return new Conductor(new ConductorFresnel(null, null), specularReflectance);
    }

    @Override
    public boolean textured() {
        return specularReflectance.varies();
    }

    @Override
    public boolean choosesLobe() {
        return false;
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
        out.setMirrored(woX, woY, woZ);
        out.setDelta(0, 1, 1);
        specularReflectance.evaluate(point, out.weight);
        fresnel.multiply(woZ, out.weight);
        return true;
    }

    @Override
    public int deltaLobes() {
        return 1;
    }

    @Override
    public boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        return lobe == 0 && sample(point, woX, woY, woZ, 0, 0, 0, mode, out) && out.undoChoice();
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        specularReflectance.evaluate(point, out);
        fresnel.multiply(1, out);
    }
}
