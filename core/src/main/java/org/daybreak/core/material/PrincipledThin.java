package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * The principled material for surfaces without thickness, such as panes and leaves (Burley 2015, §5), with the parameters
 * and formulas of Mitsuba 3: reflection and unbent transmission off microfacets, and diffuse light to both sides. Both sides
 * are alike. It conserves energy as {@link Principled} does.
 */
public final class PrincipledThin implements Bsdf {
    private static final double INV_PI = 1 / Math.PI;
    private static final double GRAZING = PrincipledLobes.GRAZING;

    /**
     * The parameters. Textures have values in [0,1], but for {@code diffTrans}.
     *
     * @param baseColor colour of the base and of what is transmitted
     * @param roughness perceptual roughness, the root of α
     * @param anisotropic 0 for round highlights, towards 1 for highlights along ∂p/∂u
     * @param specTrans share of the specular lobes, reflection and transmission; the rest is diffuse
     * @param eta index of refraction of the pane over that around it
     * @param specTint share of the base's hue in the reflection
     * @param sheen cloth-like light at grazing angles
     * @param sheenTint share of the base's hue in it
     * @param flatness blends to an approximation of subsurface scattering
     * @param diffTrans share of diffuse light that is transmitted, in [0,1] of it
     */
    public record Parameters(
            Texture baseColor,
            Texture roughness,
            Texture anisotropic,
            Texture specTrans,
            double eta,
            Texture specTint,
            Texture sheen,
            Texture sheenTint,
            Texture flatness,
            Texture diffTrans) {}

    private final Reflectance baseColor;
    private final UnitScalar roughness;
    private final UnitScalar anisotropic;
    private final UnitScalar specTrans;
    private final double eta;
    private final UnitScalar specTint;
    private final UnitScalar sheen;
    private final UnitScalar sheenTint;
    private final UnitScalar flatness;
    private final UnitScalar diffTrans;

    /**
     * Creates a material.
     *
     * @throws IllegalArgumentException if a texture exceeds 1 or the index is not positive and finite
     */
    public PrincipledThin(Parameters p) {
        baseColor = new Reflectance("base_color", p.baseColor());
        roughness = new UnitScalar("roughness", p.roughness());
        anisotropic = new UnitScalar("anisotropic", p.anisotropic());
        specTrans = new UnitScalar("spec_trans", p.specTrans());
        eta = Checks.requireIor("relative", p.eta());
        specTint = new UnitScalar("spec_tint", p.specTint());
        sheen = new UnitScalar("sheen", p.sheen());
        sheenTint = new UnitScalar("sheen_tint", p.sheenTint());
        flatness = new UnitScalar("flatness", p.flatness());
        diffTrans = new UnitScalar("diff_trans", p.diffTrans());
    }

    @Override
    public boolean textured() {
        return baseColor.varies()
                || UnitScalar.anyVaries(
                        roughness, anisotropic, specTrans, specTint, sheen, sheenTint, flatness, diffTrans);
    }

    @Override
    public TangentFrame tangentFrame() {
        return anisotropic.isZero() ? TangentFrame.ARBITRARY : TangentFrame.ANY_UVS;
    }

    @Override
    public boolean transmissive() {
        return !specTrans.isZero() || !diffTrans.isZero();
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
        return scatter(point, woX, woY, woZ, wiX, wiY, wiZ, value);
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
        return scatter(point, woX, woY, woZ, wiX, wiY, wiZ, null);
    }

    /** Returns the density and, unless it is null, writes the value. */
    private double scatter(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            @Nullable Spectrum value) {
        if (value != null) {
            value.setZero();
        }
        double cosineOut = Math.abs(woZ);
        double cosineIn = Math.abs(wiZ);
        if (!(cosineOut > GRAZING) || !(cosineIn > GRAZING)) {
            return 0;
        }
        boolean reflected = woZ > 0 == wiZ > 0;
        double specular = specTrans.at(point);
        double through = diffTrans.at(point);
        double diffuse = 1 - specular;
        double facets = 0;
        double masking = 0;
        if (specular > 0) {
            double rough = facetRoughness(point, reflected);
            double anisotropy = anisotropic.at(point);
            double alphaU = PrincipledLobes.alphaU(rough, anisotropy);
            double alphaV = PrincipledLobes.alphaV(rough, anisotropy);
            facets = Microfacet.reflectionDensity(
                    Microfacet.Kind.GGX, alphaU, alphaV, woX, woY, cosineOut, wiX, wiY, cosineIn);
            if (value != null) {
                masking = Microfacet.maskingOverCosine(Microfacet.Kind.GGX, alphaU, alphaV, wiX, wiY, cosineIn)
                        * cosineIn;
            }
        }
        if (value != null) {
            double half = Microfacet.halfAngleCosine(woX, woY, cosineOut, wiX, wiY, cosineIn);
            double reflectance = Fresnel.dielectric(half, eta);
            double main = specular * facets * masking;
            baseColor.evaluate(point, value);
            if (reflected) {
                addReflected(point, cosineOut, cosineIn, half, main, reflectance, diffuse * (1 - through), value);
            } else {
                value.scale(main * (1 - reflectance) + diffuse * through * cosineIn * INV_PI);
            }
        }
        return 0.5 * specular * facets + diffuse * (reflected ? 1 - through : through) * cosineIn * INV_PI;
    }

    private double facetRoughness(SurfacePoint point, boolean reflected) {
        // Transmission is blurred less the smaller the index (Burley 2015, figure 15).
        double scale = reflected ? 1 : Math.max(0, 0.65 * eta - 0.35);
        return scale * roughness.at(point);
    }

    /** Replaces the base colour by what is reflected, times the cosine. */
    private void addReflected(
            SurfacePoint point,
            double cosineOut,
            double cosineIn,
            double half,
            double main,
            double reflectance,
            double diffuseShare,
            Spectrum value) {
        double tint = specTint.at(point);
        double grazing = PrincipledLobes.schlick(half, eta);
        double plain = main * ((1 - tint) * reflectance + tint * grazing);
        double hued = main * tint * (1 - grazing) * PrincipledLobes.normalReflectance(eta);
        double perColor = 0;
        if (diffuseShare > 0) {
            perColor = diffuseShare
                    * PrincipledLobes.diffuse(cosineOut, cosineIn, half, roughness.at(point), flatness.at(point));
            double cloth = diffuseShare * sheen.at(point) * PrincipledLobes.schlick(half) * cosineIn;
            double clothTint = sheenTint.at(point);
            plain += cloth * (1 - clothTint);
            hued += cloth * clothTint;
        }
        PrincipledLobes.combine(plain, perColor, hued, value);
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
        double specular = specTrans.at(point);
        boolean reflected;
        if (w < specular) {
            reflected = w < 0.5 * specular;
            double rough = facetRoughness(point, reflected);
            double anisotropy = anisotropic.at(point);
            if (!Microfacet.sampleReflection(
                    Microfacet.Kind.GGX,
                    PrincipledLobes.alphaU(rough, anisotropy),
                    PrincipledLobes.alphaV(rough, anisotropy),
                    woX,
                    woY,
                    Math.abs(woZ),
                    u,
                    v,
                    out)) {
                return false;
            }
        } else {
            reflected = w - specular < (1 - specular) * (1 - diffTrans.at(point));
            out.setCosineDistributed(u, v);
        }
        out.wiZ = woZ > 0 == reflected ? out.wiZ : -out.wiZ;
        double density = evaluate(point, woX, woY, woZ, out.wiX, out.wiY, out.wiZ, mode, out.weight);
        return out.complete(density, 1);
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double specular = specTrans.at(point);
        double reflectance = specular * PrincipledLobes.normalReflectance(eta);
        baseColor.evaluate(point, out);
        double color = 1 - reflectance;
        out.set(color * out.r + reflectance, color * out.g + reflectance, color * out.b + reflectance);
    }
}
