package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A rough interface between two transparent media: reflection and refraction off microfacets (Walter et al. 2007, eq. 20
 * and 21). The normal points to the exterior. Two-sided by nature. Light scattered more than once between facets is lost.
 *
 * <p>Sampling draws a visible facet and then reflects with the probability of its Fresnel reflectance, so that the weight
 * is the masking function alone, times η² of the crossing where radiance is carried.
 */
public final class RoughDielectric implements Bsdf {
    private final Microfacet.Kind kind;
    private final Roughness roughness;
    /** Interior over exterior. */
    private final double eta;

    private final Reflectance specularReflectance;
    private final Reflectance specularTransmittance;

    /**
     * Creates an interface.
     *
     * @param kind distribution of facets
     * @param intIor refractive index on the side away from the normal
     * @param extIor refractive index on the normal's side
     * @param specularReflectance factor on reflection, in [0,1]; 1 is physical
     * @param specularTransmittance factor on refraction, in [0,1]; 1 is physical
     * @throws IllegalArgumentException if an index is not positive and finite, both are equal (light would pass straight
     *     through, without a density), or a factor exceeds 1
     */
    public RoughDielectric(
            Microfacet.Kind kind,
            Roughness roughness,
            double intIor,
            double extIor,
            Texture specularReflectance,
            Texture specularTransmittance) {
        this.kind = kind;
        this.roughness = roughness;
        this.eta = Checks.requireIor("interior", intIor) / Checks.requireIor("exterior", extIor);
        if (eta == 1) {
            throw new IllegalArgumentException(
                    "the indices of refraction of a rough interface must differ but both are " + intIor + "; use null");
        }
        this.specularReflectance = new Reflectance("specular reflectance", specularReflectance);
        this.specularTransmittance = new Reflectance("specular transmittance", specularTransmittance);
    }

    @Override
    public boolean textured() {
        return roughness.varies() || specularReflectance.varies() || specularTransmittance.varies();
    }

    @Override
    public TangentFrame tangentFrame() {
        return roughness.tangentFrame();
    }

    @Override
    public boolean transmissive() {
        return true;
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
        double density = density(point, woX, woY, woZ, wiX, wiY, wiZ, mode);
        if (density == 0) {
            value.setZero();
            return 0;
        }
        boolean reflected = woZ > 0 == wiZ > 0;
        double masking = maskingIn(point, wiX, wiY, Math.abs(wiZ));
        if (reflected) {
            specularReflectance.evaluateScaled(point, density * masking, value);
        } else {
            double scale = crossing(woZ > 0 ? eta : 1 / eta, mode);
            specularTransmittance.evaluateScaled(point, density * masking * scale, value);
        }
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
        double alphaU = roughness.alongU(point);
        double alphaV = roughness.alongV(point, alphaU);
        // Seen from below, facets look the same: mirror both directions at the surface.
        double relative = woZ > 0 ? eta : 1 / eta;
        double inZ = woZ > 0 ? wiZ : -wiZ;
        return inZ > 0
                ? DielectricFacets.reflectionDensity(
                        kind, alphaU, alphaV, relative, woX, woY, Math.abs(woZ), wiX, wiY, inZ)
                : DielectricFacets.refractionDensity(
                        kind, alphaU, alphaV, relative, woX, woY, Math.abs(woZ), wiX, wiY, inZ);
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
        if (woZ == 0) {
            return false;
        }
        double alphaU = roughness.alongU(point);
        double alphaV = roughness.alongV(point, alphaU);
        boolean outside = woZ > 0;
        double relative = outside ? eta : 1 / eta;
        if (!DielectricFacets.sample(kind, alphaU, alphaV, relative, woX, woY, Math.abs(woZ), u, v, w, out)) {
            return false;
        }
        boolean reflected = out.wiZ > 0;
        out.wiZ = outside ? out.wiZ : -out.wiZ;
        double density = density(point, woX, woY, woZ, out.wiX, out.wiY, out.wiZ, mode);
        if (density == 0) {
            return false;
        }
        out.setContinuous(density);
        double masking = maskingIn(point, out.wiX, out.wiY, Math.abs(out.wiZ));
        if (reflected) {
            specularReflectance.evaluateScaled(point, masking, out.weight);
        } else {
            out.eta = 1 / relative;
            specularTransmittance.evaluateScaled(point, masking * crossing(relative, mode), out.weight);
        }
        return true;
    }

    /** Radiance per solid angle changes with the square of the index where rays converge; flux does not. */
    private static double crossing(double relative, TransportMode mode) {
        return mode == TransportMode.RADIANCE ? 1 / (relative * relative) : 1;
    }

    private double maskingIn(SurfacePoint point, double x, double y, double cosine) {
        double alphaU = roughness.alongU(point);
        double alphaV = roughness.alongV(point, alphaU);
        return Microfacet.maskingOverCosine(kind, alphaU, alphaV, x, y, cosine) * cosine;
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double reflectance = Fresnel.dielectric(1, eta);
        specularReflectance.evaluateSum(point, reflectance, specularTransmittance, 1 - reflectance, out);
    }
}
