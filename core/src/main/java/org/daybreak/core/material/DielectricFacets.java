package org.daybreak.core.material;

/**
 * Reflection and refraction at the facets of a rough dielectric interface (Walter et al. 2007, §4 and §5): densities of
 * sampled directions, for {@code wo} above the surface. The choice between the two lobes at a facet is part of them.
 *
 * <p>{@code eta} is the refractive index below the surface over that above.
 */
final class DielectricFacets {
    private DielectricFacets() {}

    /** Density per solid angle of a reflected direction: F·D·G₁(wo)/(4 cos θ_o). */
    static double reflectionDensity(
            Microfacet.Kind kind,
            double alphaU,
            double alphaV,
            double eta,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ) {
        double density = Microfacet.reflectionDensity(kind, alphaU, alphaV, woX, woY, woZ, wiX, wiY, wiZ);
        return density == 0
                ? 0
                : density * Fresnel.dielectric(Microfacet.halfAngleCosine(woX, woY, woZ, wiX, wiY, wiZ), eta);
    }

    /**
     * Density per solid angle of a refracted direction:
     * (1 − F)·D·G₁(wo)·(wo·m)/cos θ_o · η²·|wi·m| / (wo·m + η wi·m)², with the facet m along ±(wo + η wi).
     *
     * @param wiZ third component, negative or the density is zero
     */
    static double refractionDensity(
            Microfacet.Kind kind,
            double alphaU,
            double alphaV,
            double eta,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ) {
        if (woZ <= 0 || wiZ >= 0) {
            return 0;
        }
        double x = woX + eta * wiX;
        double y = woY + eta * wiY;
        double z = woZ + eta * wiZ;
        double squaredLength = x * x + y * y + z * z;
        double length = Math.copySign(Math.sqrt(squaredLength), z);
        double cosineOut = (woX * x + woY * y + woZ * z) / length;
        double cosineIn = (wiX * x + wiY * y + wiZ * z) / length;
        if (!(cosineOut > 0 && cosineIn < 0)) {
            return 0;
        }
        double transmittance = 1 - Fresnel.dielectric(Math.min(1, cosineOut), Math.min(1, -cosineIn), eta);
        // The denominator is ±|wo + η wi|, whose projection on the facet's normal it is.
        double jacobian = eta * eta * -cosineIn / squaredLength;
        return transmittance
                * cosineOut
                * jacobian
                * Microfacet.distribution(kind, alphaU, alphaV, x, y, z)
                * Microfacet.maskingOverCosine(kind, alphaU, alphaV, woX, woY, woZ);
    }

    /**
     * Samples a direction off a visible facet.
     *
     * @param w chooses between reflection and refraction
     * @param out receives the unit direction; above the surface if reflected, below if refracted
     * @return false if the direction is on the wrong side
     */
    static boolean sample(
            Microfacet.Kind kind,
            double alphaU,
            double alphaV,
            double eta,
            double woX,
            double woY,
            double woZ,
            double u,
            double v,
            double w,
            BsdfSample out) {
        Microfacet.sampleVisibleNormal(kind, alphaU, alphaV, woX, woY, woZ, u, v, out);
        double cosine = Math.min(1, woX * out.wiX + woY * out.wiY + woZ * out.wiZ);
        if (!(cosine > 0)) {
            return false;
        }
        double refracted = Fresnel.refractedCosine(cosine, 1 / eta);
        double reflectance = refracted < 0 ? 1 : Fresnel.dielectric(cosine, refracted, eta);
        if (refracted < 0 || w < reflectance) {
            double twice = 2 * cosine;
            out.wiX = twice * out.wiX - woX;
            out.wiY = twice * out.wiY - woY;
            out.wiZ = twice * out.wiZ - woZ;
            return out.wiZ > 0;
        }
        double along = cosine / eta - refracted;
        double x = along * out.wiX - woX / eta;
        double y = along * out.wiY - woY / eta;
        double z = along * out.wiZ - woZ / eta;
        Microfacet.setNormal(x, y, z, out);
        return out.wiZ < 0;
    }
}
