package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A rough metal: reflection off microfacets, f = F·D·G₁·G₁/(4 cos θ_o cos θ_i) (Walter et al. 2007, eq. 20). Light
 * scattered more than once between facets is lost. One-sided: black from behind.
 */
public final class RoughConductor implements Bsdf {
    private final Microfacet.Kind kind;
    private final Roughness roughness;
    private final ConductorFresnel fresnel;
    private final Reflectance specularReflectance;

    /**
     * Creates a rough metal.
     *
     * @param kind distribution of facets
     * @param eta real part of the refractive index, relative to vacuum
     * @param k imaginary part (absorption)
     * @param specularReflectance factor on the lobe, in [0,1]; 1 is physical
     * @throws IllegalArgumentException if a part of the index is negative, not finite, or both are zero, or the reflectance
     *     exceeds 1
     */
    public RoughConductor(
            Microfacet.Kind kind, Roughness roughness, Spectrum eta, Spectrum k, Texture specularReflectance) {
        this(kind, roughness, new ConductorFresnel(eta, k), specularReflectance);
    }

    /**
     * Creates an isotropic rough metal.
     *
     * @param alpha roughness
     * @throws IllegalArgumentException as {@link #RoughConductor(Microfacet.Kind, Roughness, Spectrum, Spectrum, Texture)},
     *     or if the roughness is outside [{@link Microfacet#MIN_ALPHA}, {@link Microfacet#MAX_ALPHA}]
     */
    public RoughConductor(Microfacet.Kind kind, double alpha, Spectrum eta, Spectrum k, Texture specularReflectance) {
        this(kind, Roughness.of(alpha), eta, k, specularReflectance);
    }

    private RoughConductor(
            Microfacet.Kind kind, Roughness roughness, ConductorFresnel fresnel, Texture specularReflectance) {
        this.kind = kind;
        this.roughness = roughness;
        this.fresnel = fresnel;
        this.specularReflectance = new Reflectance("specular reflectance", specularReflectance);
    }

    /**
     * Creates a rough mirror: every facet reflects the same at every angle.
     *
     * @param specularReflectance reflectance of a facet, in [0,1]
     * @throws IllegalArgumentException if the reflectance exceeds 1
     */
    public static RoughConductor mirror(Microfacet.Kind kind, Roughness roughness, Texture specularReflectance) {
        return new RoughConductor(kind, roughness, new ConductorFresnel(null, null), specularReflectance);
    }

    /** Creates an isotropic rough mirror: {@link #mirror(Microfacet.Kind, Roughness, Texture)}. */
    public static RoughConductor mirror(Microfacet.Kind kind, double alpha, Texture specularReflectance) {
        return mirror(kind, Roughness.of(alpha), specularReflectance);
    }

    @Override
    public boolean textured() {
        return specularReflectance.varies() || roughness.varies();
    }

    @Override
    public TangentFrame tangentFrame() {
        return roughness.tangentFrame();
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
        double alphaU = roughness.alongU(point);
        double alphaV = roughness.alongV(point, alphaU);
        double density = Microfacet.reflectionDensity(kind, alphaU, alphaV, woX, woY, woZ, wiX, wiY, wiZ);
        if (density == 0) {
            value.setZero();
            return 0;
        }
        double maskingIn = Microfacet.maskingOverCosine(kind, alphaU, alphaV, wiX, wiY, wiZ) * wiZ;
        specularReflectance.evaluateScaled(point, density * maskingIn, value);
        fresnel.multiply(Microfacet.halfAngleCosine(woX, woY, woZ, wiX, wiY, wiZ), value);
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
        return Microfacet.reflectionDensity(kind, alphaU, alphaV, woX, woY, woZ, wiX, wiY, wiZ);
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
        double alphaU = roughness.alongU(point);
        double alphaV = roughness.alongV(point, alphaU);
        if (!Microfacet.sampleReflection(kind, alphaU, alphaV, woX, woY, woZ, u, v, out)) {
            return false;
        }
        double density = Microfacet.reflectionDensity(kind, alphaU, alphaV, woX, woY, woZ, out.wiX, out.wiY, out.wiZ);
        if (density == 0) {
            return false;
        }
        out.setContinuous(density);
        double maskingIn = Microfacet.maskingOverCosine(kind, alphaU, alphaV, out.wiX, out.wiY, out.wiZ) * out.wiZ;
        specularReflectance.evaluateScaled(point, maskingIn, out.weight);
        fresnel.multiply(Microfacet.halfAngleCosine(woX, woY, woZ, out.wiX, out.wiY, out.wiZ), out.weight);
        return true;
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        specularReflectance.evaluate(point, out);
        fresnel.multiply(1, out);
    }
}
