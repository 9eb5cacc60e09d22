package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A diffuse base under a rough dielectric coating: reflection off the coating's microfacets, and diffuse light from below
 * with internal reflections. One-sided: black from behind.
 *
 * <p>The coating transmits T(θ) by single scattering off its facets. From inside it reflects what it does not let
 * out, R = 1 − T_int, where T_int = T_ext/η² under diffuse light by reciprocity: no energy is made up, and none is lost
 * inside. Renderers differ here; see the tests for our figures.
 */
public final class RoughPlastic implements Bsdf {
    private static final double INV_PI = 1 / Math.PI;

    private final Microfacet.Kind kind;
    private final double alpha;
    private final double eta;
    private final RoughTransmittance transmittance;
    private final CoatedDiffuse base;
    private final Reflectance specularReflectance;
    private final LobeChoice choice;

    /**
     * Creates a coated diffuse material.
     *
     * @param kind distribution of the coating's facets
     * @param alpha roughness of the coating
     * @param intIor refractive index of the coating
     * @param extIor refractive index of the outside
     * @param diffuseReflectance albedo of the base, in [0,1]
     * @param specularReflectance factor on the reflection off the coating, in [0,1]; 1 is physical
     * @param nonlinear whether the colour of the base shifts with internal reflections
     * @throws IllegalArgumentException if the roughness is outside [{@link Microfacet#MIN_ALPHA}, {@link
     *     Microfacet#MAX_ALPHA}], an index is not positive and finite, or a reflectance exceeds 1
     */
    public RoughPlastic(
            Microfacet.Kind kind,
            double alpha,
            double intIor,
            double extIor,
            Texture diffuseReflectance,
            Texture specularReflectance,
            boolean nonlinear) {
        this.kind = kind;
        this.alpha = Microfacet.requireAlpha(alpha);
        this.eta = Checks.requireIor("interior", intIor) / Checks.requireIor("exterior", extIor);
        Reflectance diffuse = new Reflectance("diffuse reflectance", diffuseReflectance);
        this.specularReflectance = new Reflectance("specular reflectance", specularReflectance);
        this.transmittance = new RoughTransmittance(kind, alpha, eta);
        double internalReflectance = Math.max(0, 1 - transmittance.hemispherical() / (eta * eta));
        this.base = new CoatedDiffuse(diffuse, eta, internalReflectance, nonlinear);
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
        double facetDensity = Microfacet.reflectionDensity(kind, alpha, woX, woY, woZ, wiX, wiY, wiZ);
        double reflectance = Fresnel.dielectric(Microfacet.halfAngleCosine(woX, woY, woZ, wiX, wiY, wiZ), eta);
        double maskingIn = Microfacet.maskingOverCosine(kind, alpha, wiZ) * wiZ;
        specularReflectance.evaluateScaled(point, facetDensity * maskingIn * reflectance, value);
        double r = value.r;
        double g = value.g;
        double b = value.b;
        double transmittanceOut = transmittance.at(woZ);
        double cosineDensity = wiZ * INV_PI;
        base.evaluate(point, transmittanceOut * transmittance.at(wiZ) * cosineDensity, value);
        value.set(value.r + r, value.g + g, value.b + b);
        double diffuse = choice.diffuseProbability(transmittanceOut);
        return diffuse * cosineDensity + (1 - diffuse) * facetDensity;
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
        double diffuse = choice.diffuseProbability(transmittance.at(woZ));
        return diffuse * wiZ * INV_PI
                + (1 - diffuse) * Microfacet.reflectionDensity(kind, alpha, woX, woY, woZ, wiX, wiY, wiZ);
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
        if (woZ <= 0 || !choice.anyLobe()) {
            return false;
        }
        if (w < choice.diffuseProbability(transmittance.at(woZ))) {
            out.setCosineDistributed(u, v);
        } else if (!Microfacet.sampleReflection(kind, alpha, woX, woY, woZ, u, v, out)) {
            return false;
        }
        double density = evaluate(point, woX, woY, woZ, out.wiX, out.wiY, out.wiZ, mode, out.weight);
        return out.complete(density, 1);
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double transmitted = transmittance.at(1);
        specularReflectance.evaluateScaled(point, 1 - transmitted, out);
        double r = out.r;
        double g = out.g;
        double b = out.b;
        base.evaluate(point, transmitted * transmittance.hemispherical(), out);
        out.set(out.r + r, out.g + g, out.b + b);
    }
}
