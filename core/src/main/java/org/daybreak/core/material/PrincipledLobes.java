package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;

/**
 * Terms that the principled materials share (Burley 2012, “Physically Based Shading at Disney”, and 2015, “Extending the
 * Disney BRDF to a BSDF with Integrated Subsurface Scattering”), in the form that Mitsuba 3 gives them.
 */
final class PrincipledLobes {
    /** Cosines below this count as along the surface: quotients of smaller ones would overflow. */
    static final double GRAZING = 1e-100;

    private static final double LEAST_ALPHA = 0.001;
    private static final double INV_PI = 1 / Math.PI;

    /** Roughness of the masking of the clear coat, whatever its gloss (Burley 2012, §5.6). */
    private static final double COAT_MASKING_ALPHA = 0.25;

    private PrincipledLobes() {}

    /** Roughness of facets along the tangent from a perceptual roughness and an anisotropy, both in [0,1]. */
    static double alphaU(double roughness, double anisotropic) {
        return Math.max(LEAST_ALPHA, roughness * roughness / Math.sqrt(1 - 0.9 * anisotropic));
    }

    /** Roughness of facets across the tangent. */
    static double alphaV(double roughness, double anisotropic) {
        return Math.max(LEAST_ALPHA, roughness * roughness * Math.sqrt(1 - 0.9 * anisotropic));
    }

    /** (1 − c)⁵, Schlick's weight of grazing incidence. */
    static double schlick(double cosine) {
        double m = Math.min(1, Math.max(0, 1 - cosine));
        double squared = m * m;
        return squared * squared * m;
    }

    /**
     * Schlick's weight at a dielectric interface: into the thinner medium it is taken at the refracted angle.
     *
     * @param eta index of the transmitted side over that of the incident side
     */
    static double schlick(double cosine, double eta) {
        return schlick(eta > 1 ? cosine : Math.max(0, Fresnel.refractedCosine(cosine, 1 / eta)));
    }

    /** Reflectance at normal incidence. */
    static double normalReflectance(double eta) {
        double ratio = (eta - 1) / (eta + 1);
        return ratio * ratio;
    }

    /**
     * Diffuse and retro-reflected light with the flat approximation of subsurface scattering blended in, times cos θ_i/π,
     * for albedo 1.
     *
     * @param half cosine between wi and the half vector
     */
    static double diffuse(double cosineOut, double cosineIn, double half, double roughness, double flatness) {
        double grazingIn = schlick(cosineIn);
        double grazingOut = schlick(cosineOut);
        double base = (1 - 0.5 * grazingIn) * (1 - 0.5 * grazingOut);
        double rr = 2 * roughness * half * half;
        double retro = rr * (grazingIn + grazingOut + grazingIn * grazingOut * (rr - 1));
        double sum = base + retro;
        if (flatness > 0) {
            double fss90 = 0.5 * rr;
            double fss = (1 + (fss90 - 1) * grazingIn) * (1 + (fss90 - 1) * grazingOut);
            double flat = 1.25 * (fss * (1 / (cosineIn + cosineOut) - 0.5) + 0.5);
            sum += flatness * (flat - sum);
        }
        return sum * cosineIn * INV_PI;
    }

    /**
     * Replaces the colour c of the base by plain + perColor·c + hued·(c by its luminance). A black base has no hue: its tint
     * is white.
     */
    static void combine(double plain, double perColor, double hued, Spectrum color) {
        double luminance = color.luminance();
        double white = luminance > 0 ? plain : plain + hued;
        double scale = luminance > 0 ? perColor + hued / luminance : perColor;
        color.set(white + scale * color.r, white + scale * color.g, white + scale * color.b);
    }

    /** Roughness of the clear coat from its gloss. */
    static double coatAlpha(double gloss) {
        return 0.1 + (0.001 - 0.1) * gloss;
    }

    /**
     * Density D of the clear coat's normals, the distribution GTR₁ (Burley 2012, eq. 8 with γ = 1). {@link #sampleCoat}
     * draws with the density D·cos θ per solid angle.
     *
     * @param x half vector of any length, z not negative
     */
    static double coatDistribution(double alpha, double x, double y, double z) {
        double a2 = alpha * alpha;
        double horizontal = x * x + y * y;
        double squaredLength = horizontal + z * z;
        double denominator = (horizontal + a2 * z * z) / squaredLength;
        return (a2 - 1) / (Math.PI * Math.log(a2) * denominator);
    }

    /** Masking and shadowing of the clear coat. */
    static double coatMasking(double cosineOut, double cosineIn) {
        return Microfacet.maskingOverCosine(Microfacet.Kind.GGX, COAT_MASKING_ALPHA, cosineOut)
                * cosineOut
                * Microfacet.maskingOverCosine(Microfacet.Kind.GGX, COAT_MASKING_ALPHA, cosineIn)
                * cosineIn;
    }

    /** Samples a normal of the clear coat into the direction of the sample. */
    static void sampleCoat(double alpha, double u, double v, BsdfSample out) {
        double a2 = alpha * alpha;
        double squaredCosine = (1 - Math.exp(Math.log(a2) * (1 - v))) / (1 - a2);
        double sine = Math.sqrt(Math.max(0, 1 - squaredCosine));
        double phi = 2 * Math.PI * u;
        out.wiX = sine * Math.cos(phi);
        out.wiY = sine * Math.sin(phi);
        out.wiZ = Math.sqrt(Math.min(1, Math.max(0, squaredCosine)));
    }
}
