package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * The principled material of Burley (2012, 2015) with the parameters and formulas of Mitsuba 3: metal, rough glass and a
 * diffuse base, blended by {@code metallic} and {@code specTrans}, under a sheen and a clear coat.
 *
 * <p>The front is the side of the normal. From behind only what transmits scatters, as glass. An artist's model: base, sheen
 * and coat are added without taking from each other, so that bright ones reflect somewhat more than they receive, at
 * grazing angles most; metals ({@code metallic} 1) and glass ({@code specTrans} 1) without sheen and coat do not.
 */
public final class Principled implements Bsdf {
    private static final double INV_PI = 1 / Math.PI;
    private static final double GRAZING = PrincipledLobes.GRAZING;

    /** Clear coat has a quarter of the energy of the main reflection (Burley 2012, §5.6). */
    private static final double COAT_SHARE = 0.25;

    private static final double COAT_REFLECTANCE = 0.04;

    /** Stands for an index of 1 where something is transmitted: that would go straight, without a density. */
    private static final double LEAST_ETA = 1.001;

    /**
     * The parameters. All textures have values in [0,1]; of those but {@code baseColor} the luminance counts.
     *
     * @param baseColor colour of the base, of metals and, by its root, of what is transmitted
     * @param roughness perceptual roughness, the root of α
     * @param anisotropic 0 for round highlights, towards 1 for highlights along ∂p/∂u
     * @param metallic 0 for a dielectric, 1 for a metal
     * @param specTrans share of the dielectric that transmits
     * @param eta index of refraction of the inside over that of the outside
     * @param specTint share of the base's hue in the dielectric reflection
     * @param sheen cloth-like light at grazing angles
     * @param sheenTint share of the base's hue in it
     * @param flatness blends to an approximation of subsurface scattering
     * @param clearcoat strength of the coat
     * @param clearcoatGloss gloss of the coat
     */
    public record Parameters(
            Texture baseColor,
            Texture roughness,
            Texture anisotropic,
            Texture metallic,
            Texture specTrans,
            double eta,
            Texture specTint,
            Texture sheen,
            Texture sheenTint,
            Texture flatness,
            Texture clearcoat,
            Texture clearcoatGloss) {}

    private final Reflectance baseColor;
    private final UnitScalar roughness;
    private final UnitScalar anisotropic;
    private final UnitScalar metallic;
    private final UnitScalar specTrans;
    private final double eta;
    private final UnitScalar specTint;
    private final UnitScalar sheen;
    private final UnitScalar sheenTint;
    private final UnitScalar flatness;
    private final UnitScalar clearcoat;
    private final UnitScalar clearcoatGloss;

    /**
     * Creates a material. An index of 1 is taken as 1.001 if something is transmitted.
     *
     * @throws IllegalArgumentException if a texture exceeds 1 or the index is not positive and finite
     */
    public Principled(Parameters p) {
        baseColor = new Reflectance("base_color", p.baseColor());
        roughness = new UnitScalar("roughness", p.roughness());
        anisotropic = new UnitScalar("anisotropic", p.anisotropic());
        metallic = new UnitScalar("metallic", p.metallic());
        specTrans = new UnitScalar("spec_trans", p.specTrans());
        double index = Checks.requireIor("relative", p.eta());
        eta = index == 1 && !specTrans.isZero() ? LEAST_ETA : index;
        specTint = new UnitScalar("spec_tint", p.specTint());
        sheen = new UnitScalar("sheen", p.sheen());
        sheenTint = new UnitScalar("sheen_tint", p.sheenTint());
        flatness = new UnitScalar("flatness", p.flatness());
        clearcoat = new UnitScalar("clearcoat", p.clearcoat());
        clearcoatGloss = new UnitScalar("clearcoat_gloss", p.clearcoatGloss());
    }

    /**
     * The relative index of refraction for a value of the parameter {@code specular} in [0,1], which maps to reflectances
     * at normal incidence from 0 to 8 %.
     */
    public static double etaOfSpecular(double specular) {
        return 2 / (1 - Math.sqrt(0.08 * specular)) - 1;
    }

    @Override
    public boolean textured() {
        return baseColor.varies()
                || UnitScalar.anyVaries(
                        roughness,
                        anisotropic,
                        metallic,
                        specTrans,
                        specTint,
                        sheen,
                        sheenTint,
                        flatness,
                        clearcoat,
                        clearcoatGloss);
    }

    @Override
    public TangentFrame tangentFrame() {
        return anisotropic.isZero() ? TangentFrame.ARBITRARY : TangentFrame.ANY_UVS;
    }

    @Override
    public boolean transmissive() {
        return !specTrans.isZero();
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
        return scatter(point, woX, woY, woZ, wiX, wiY, wiZ, mode, value);
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
        return scatter(point, woX, woY, woZ, wiX, wiY, wiZ, mode, null);
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
            TransportMode mode,
            @Nullable Spectrum value) {
        if (value != null) {
            value.setZero();
        }
        double metal = metallic.at(point);
        double glass = (1 - metal) * specTrans.at(point);
        boolean front = woZ > 0;
        double cosineOut = Math.abs(woZ);
        double inZ = front ? wiZ : -wiZ;
        if (!(cosineOut > GRAZING) || !(Math.abs(inZ) > GRAZING) || (glass == 0 && (!front || inZ < 0))) {
            return 0;
        }
        double rough = roughness.at(point);
        double anisotropy = anisotropic.at(point);
        double alphaU = PrincipledLobes.alphaU(rough, anisotropy);
        double alphaV = PrincipledLobes.alphaV(rough, anisotropy);
        double relative = front ? eta : 1 / eta;
        double maskingIn = value == null
                ? 0
                : Microfacet.maskingOverCosine(Microfacet.Kind.GGX, alphaU, alphaV, wiX, wiY, Math.abs(inZ))
                        * Math.abs(inZ);
        if (inZ < 0) {
            double density = DielectricFacets.refractionDensity(
                    Microfacet.Kind.GGX, alphaU, alphaV, relative, woX, woY, cosineOut, wiX, wiY, inZ);
            if (value != null && density != 0) {
                double crossing = mode == TransportMode.RADIANCE ? 1 / (relative * relative) : 1;
                baseColor.evaluate(point, value);
                double scale = glass * density * maskingIn * crossing;
                value.set(scale * Math.sqrt(value.r), scale * Math.sqrt(value.g), scale * Math.sqrt(value.b));
            }
            return front ? density * glass / weights(point, metal) : density;
        }
        double facets =
                Microfacet.reflectionDensity(Microfacet.Kind.GGX, alphaU, alphaV, woX, woY, cosineOut, wiX, wiY, inZ);
        double half = Microfacet.halfAngleCosine(woX, woY, cosineOut, wiX, wiY, inZ);
        double reflectance = Fresnel.dielectric(half, relative);
        if (!front) {
            if (value != null) {
                value.set(glass * reflectance * facets * maskingIn);
            }
            return reflectance * facets;
        }
        if (value != null) {
            baseColor.evaluate(point, value);
            addFront(point, woX, woY, woZ, wiX, wiY, wiZ, metal, rough, half, facets * maskingIn, reflectance, value);
        }
        return frontDensity(point, woX, woY, woZ, wiX, wiY, wiZ, metal, glass, half, facets, reflectance);
    }

    /**
     * Replaces the base colour by what the front reflects, times the cosine.
     *
     * @param main D·G/(4 cos θ_o) of the main reflection
     * @param reflectance Fresnel's reflectance at the half vector
     */
    private void addFront(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            double metal,
            double rough,
            double half,
            double main,
            double reflectance,
            Spectrum value) {
        double diffuseShare = (1 - metal) * (1 - specTrans.at(point));
        double grazing = PrincipledLobes.schlick(half, eta);
        double tint = specTint.at(point);
        double tinted = main * (1 - metal) * tint;
        double normalReflectance = PrincipledLobes.normalReflectance(eta);
        double untinted = main * (1 - metal) * (1 - tint) * reflectance;
        double coat = clearcoat.at(point);
        if (coat > 0) {
            untinted += coat * coat(point, woX, woY, woZ, wiX, wiY, wiZ, grazing);
        }
        double diffuse = 0;
        double cloth = 0;
        double clothTint = 0;
        if (diffuseShare > 0) {
            diffuse = diffuseShare * PrincipledLobes.diffuse(woZ, wiZ, half, rough, flatness.at(point));
            cloth = sheen.at(point) * (1 - metal) * PrincipledLobes.schlick(half) * wiZ;
            clothTint = sheenTint.at(point);
        }
        double metalGrazing = main * metal * grazing;
        double metalBase = main * metal * (1 - grazing);
        double plain = untinted + metalGrazing + tinted * grazing + cloth * (1 - clothTint);
        double perColor = metalBase + diffuse;
        double hued = tinted * (1 - grazing) * normalReflectance + cloth * clothTint;
        PrincipledLobes.combine(plain, perColor, hued, value);
    }

    private double coat(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            double grazing) {
        double alpha = PrincipledLobes.coatAlpha(clearcoatGloss.at(point));
        return COAT_SHARE
                * (COAT_REFLECTANCE + (1 - COAT_REFLECTANCE) * grazing)
                * PrincipledLobes.coatDistribution(alpha, woX + wiX, woY + wiY, woZ + wiZ)
                * PrincipledLobes.coatMasking(woZ, wiZ)
                * wiZ;
    }

    private double frontDensity(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            double metal,
            double glass,
            double half,
            double facets,
            double reflectance) {
        double sum = (1 - glass * (1 - reflectance)) * facets;
        double coat = COAT_SHARE * clearcoat.at(point);
        if (coat > 0) {
            double alpha = PrincipledLobes.coatAlpha(clearcoatGloss.at(point));
            double normalCosine = 0.5 * (woZ + wiZ) / half;
            sum += coat
                    * PrincipledLobes.coatDistribution(alpha, woX + wiX, woY + wiY, woZ + wiZ)
                    * normalCosine
                    / (4 * half);
        }
        sum += (1 - metal) * (1 - specTrans.at(point)) * wiZ * INV_PI;
        return sum / weights(point, metal);
    }

    /** Sum of the weights of the lobes seen from the front: main reflection with transmission 1, coat, and base. */
    private double weights(SurfacePoint point, double metal) {
        return 1 + COAT_SHARE * clearcoat.at(point) + (1 - metal) * (1 - specTrans.at(point));
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
        double metal = metallic.at(point);
        double trans = specTrans.at(point);
        double glass = (1 - metal) * trans;
        boolean front = woZ > 0;
        if (!(Math.abs(woZ) > GRAZING) || (!front && glass == 0)) {
            return false;
        }
        double total = front ? weights(point, metal) : 1;
        double base = front ? (1 - metal) * (1 - trans) : 0;
        double coat = front ? COAT_SHARE * clearcoat.at(point) : 0;
        double chosen = w * total;
        boolean refracted = false;
        if (chosen < base) {
            out.setCosineDistributed(u, v);
        } else if (chosen < base + coat) {
            PrincipledLobes.sampleCoat(PrincipledLobes.coatAlpha(clearcoatGloss.at(point)), u, v, out);
            double twice = 2 * (woX * out.wiX + woY * out.wiY + woZ * out.wiZ);
            out.wiX = twice * out.wiX - woX;
            out.wiY = twice * out.wiY - woY;
            out.wiZ = twice * out.wiZ - woZ;
        } else {
            double rough = roughness.at(point);
            double anisotropy = anisotropic.at(point);
            double share = front ? glass : 1;
            // With a share s of glass, light is refracted with probability s (1 − F).
            double choice = share == 0 ? -1 : 1 - Math.min(1, Math.max(0, chosen - base - coat)) / share;
            if (!DielectricFacets.sample(
                    Microfacet.Kind.GGX,
                    PrincipledLobes.alphaU(rough, anisotropy),
                    PrincipledLobes.alphaV(rough, anisotropy),
                    front ? eta : 1 / eta,
                    woX,
                    woY,
                    Math.abs(woZ),
                    u,
                    v,
                    choice,
                    out)) {
                return false;
            }
            refracted = out.wiZ < 0;
            out.wiZ = front ? out.wiZ : -out.wiZ;
        }
        if (!refracted && woZ > 0 != out.wiZ > 0) {
            return false;
        }
        double density = evaluate(point, woX, woY, woZ, out.wiX, out.wiY, out.wiZ, mode, out.weight);
        return out.complete(density, refracted ? (front ? 1 / eta : eta) : 1);
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double metal = metallic.at(point);
        double trans = specTrans.at(point);
        double reflectance = (1 - metal) * PrincipledLobes.normalReflectance(eta);
        double glass = (1 - metal) * trans * (1 - PrincipledLobes.normalReflectance(eta));
        double color = metal + (1 - metal) * (1 - trans);
        baseColor.evaluate(point, out);
        out.set(
                Math.min(1, color * out.r + glass * Math.sqrt(out.r) + reflectance),
                Math.min(1, color * out.g + glass * Math.sqrt(out.g) + reflectance),
                Math.min(1, color * out.b + glass * Math.sqrt(out.b) + reflectance));
    }
}
