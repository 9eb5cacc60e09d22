package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * The Phong shader of GroIMP, alike on both sides. With α the alpha of the diffuse colour, ct = 1 + α (transparency − 1) and
 * r Fresnel's reflectance, a surface with interpolated transparency has k_d = (1 − ct)·diffuse, k_s = (1 − ct)·specular +
 * r ct and k_t = (1 − r) ct; else k_d = diffuse, k_s = specular + r ct (0 without a specular colour), k_t = (1 − r) ct.
 *
 * <ul>
 *   <li>Reflection: f = k_d/π + k_s (n + 2) cosⁿβ/2π, β the angle to the mirror direction (Lafortune and Willems 1994).
 *   <li>Transmission: f = k_t (n_t + 2) cosⁿβ/2π, β the angle to the refracted direction, plus diffuseTransparency/π.
 * </ul>
 *
 * An exponent above {@value #MIRROR_EXPONENT} makes its lobe a delta. Exponents come from channel values x in [0,1]: with
 * y = x (2 − x) it is 0 for y ≤ 0, infinite for y ≥ 1 and −2/ln y else.
 *
 * <p>So that every lobe is reciprocal, r is taken at the half angle of the pair, which is the angle of incidence on the axis of
 * the lobe, and β in transmission is measured in the exterior: with equal indices that is the angle to the straight
 * continuation. As in GroIMP nothing bounds the sum of the colours; k_d + k_s > 1 makes light.
 */
public final class GroimpPhong implements Bsdf {
    /** Exponents above this, lobes of less than 0.03 degrees, count as mirrors. */
    static final double MIRROR_EXPONENT = 1e7;

    private static final int REFLECTION = 0;
    private static final int REFRACTION = 1;

    private static final double INV_PI = 1 / Math.PI;
    private static final double INV_TWO_PI = 0.5 / Math.PI;

    /** Least and largest reflectance by which lobes are chosen: no lobe that scatters gets probability 0. */
    private static final double LEAST_CHOICE = 0.02;

    /**
     * The parameters, all in [0,1].
     *
     * @param diffuse diffuse colour
     * @param alpha its alpha, 1 for opaque
     * @param specular specular colour, null for none
     * @param shininess channel value of the exponent of reflection
     * @param transparency transparency colour
     * @param transparencyShininess channel value of the exponent of transmission
     * @param diffuseTransparency diffuse transmittance, such as of leaves
     * @param interpolated whether transparency takes its share from the diffuse and specular colours
     */
    public record Parameters(
            Texture diffuse,
            Texture alpha,
            @Nullable Texture specular,
            Texture shininess,
            Texture transparency,
            Texture transparencyShininess,
            Texture diffuseTransparency,
            boolean interpolated) {}

    private final Reflectance diffuse;
    private final UnitScalar alpha;
    private final boolean hasSpecular;
    private final Reflectance specular;
    private final UnitScalar shininess;
    private final Reflectance transparency;
    private final UnitScalar transparencyShininess;
    private final Reflectance diffuseTransparency;
    private final boolean interpolated;
    private final boolean opaque;
    private final int deltaLobes;
    /** Interior over exterior. */
    private final double eta;

    /**
     * Creates a material.
     *
     * @param intIor refractive index on the side away from the normal
     * @param extIor refractive index on the normal's side
     * @throws IllegalArgumentException if an index is not positive and finite or a texture exceeds 1
     */
    public GroimpPhong(Parameters p, double intIor, double extIor) {
        diffuse = new Reflectance("diffuse", p.diffuse());
        alpha = new UnitScalar("alpha", p.alpha());
        Texture specularColor = p.specular();
        hasSpecular = specularColor != null;
        specular = new Reflectance("specular", specularColor == null ? ConstantTexture.grey(0) : specularColor);
        shininess = new UnitScalar("shininess", p.shininess());
        transparency = new Reflectance("transparency", p.transparency());
        transparencyShininess = new UnitScalar("transparency_shininess", p.transparencyShininess());
        diffuseTransparency = new Reflectance("diffuse_transparency", p.diffuseTransparency());
        interpolated = p.interpolated();
        boolean solid = p.alpha().isConstant() && p.alpha().evaluateScalar(new SurfacePoint()) == 1;
        opaque = solid && p.transparency().maximum() == 0;
        boolean mirror = exponent(shininess.maximum()) == Double.POSITIVE_INFINITY;
        boolean clear = !opaque && exponent(transparencyShininess.maximum()) == Double.POSITIVE_INFINITY;
        deltaLobes = clear ? REFRACTION + 1 : mirror ? REFLECTION + 1 : 0;
        eta = Checks.requireIor("interior", intIor) / Checks.requireIor("exterior", extIor);
    }

    /**
     * The exponent for a channel value.
     *
     * @param x value in [0,1]
     * @return the exponent, infinite for a mirror
     */
    public static double exponent(double x) {
        double y = x * (2 - x);
        double n = y <= 0 ? 0 : y >= 1 ? Double.POSITIVE_INFINITY : -2 / Math.log(y);
        return n > MIRROR_EXPONENT ? Double.POSITIVE_INFINITY : n;
    }

    @Override
    public boolean textured() {
        return diffuse.varies()
                || specular.varies()
                || transparency.varies()
                || diffuseTransparency.varies()
                || UnitScalar.anyVaries(alpha, shininess, transparencyShininess);
    }

    @Override
    public boolean transmissive() {
        return !opaque || diffuseTransparency.samplingWeight() > 0;
    }

    /** One component of ct = 1 + α (transparency − 1). */
    private static double through(double a, double transparent) {
        return 1 + a * (transparent - 1);
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
        double cosine = Math.abs(wiZ);
        if (woZ == 0 || wiZ == 0) {
            value.setZero();
            return 0;
        }
        if (woZ > 0 == wiZ > 0) {
            setReflected(point, woX, woY, woZ, wiX, wiY, wiZ, value);
            value.scale(cosine);
        } else {
            diffuseTransparency.evaluateScaled(point, INV_PI, value);
            addTransmitted(point, woX, woY, woZ, wiX, wiY, wiZ, mode, value);
            value.scale(cosine);
        }
        return density(point, woX, woY, woZ, wiX, wiY, wiZ, mode);
    }

    private void setReflected(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            Spectrum value) {
        double a = alpha.at(point);
        transparency.evaluate(point, value);
        double ctR = through(a, value.r);
        double ctG = through(a, value.g);
        double ctB = through(a, value.b);
        double n = exponent(shininess.at(point));
        double lobe = n < Double.POSITIVE_INFINITY ? lobe(n, n + 2, -woX, -woY, woZ, wiX, wiY, wiZ) : 0;
        double half = Microfacet.halfAngleCosine(woX, woY, Math.abs(woZ), wiX, wiY, Math.abs(wiZ));
        double r = lobe * mirrored(Fresnel.dielectric(half, woZ > 0 ? eta : 1 / eta));
        specular.evaluateScaled(point, lobe, value);
        double sR = value.r;
        double sG = value.g;
        double sB = value.b;
        diffuse.evaluateScaled(point, INV_PI, value);
        value.set(
                base(ctR, sR + value.r) + r * ctR,
                base(ctG, sG + value.g) + r * ctG,
                base(ctB, sB + value.b) + r * ctB);
    }

    private double base(double ct, double color) {
        return interpolated ? (1 - ct) * color : color;
    }

    /** Fresnel's reflectance, as far as the surface shows it. */
    private double mirrored(double reflectance) {
        return interpolated || hasSpecular ? reflectance : 0;
    }

    private void addTransmitted(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode,
            Spectrum value) {
        double n = exponent(transparencyShininess.at(point));
        if (opaque || n == Double.POSITIVE_INFINITY) {
            return;
        }
        boolean outside = woZ > 0;
        double ax = outside ? woX : wiX;
        double ay = outside ? woY : wiY;
        double az = outside ? woZ : wiZ;
        double bx = outside ? wiX : woX;
        double by = outside ? wiY : woY;
        double refracted = Fresnel.refractedCosine(Math.min(1, Math.abs(outside ? wiZ : woZ)), eta);
        if (refracted <= 0) {
            return;
        }
        double ex = -eta * bx;
        double ey = -eta * by;
        double lobe = lobe(n, n + 2, ex, ey, refracted, ax, ay, az);
        double half = Microfacet.halfAngleCosine(ax, ay, az, -ex, -ey, refracted);
        double crossing = (mode == TransportMode.RADIANCE) == outside ? 1 : eta * eta;
        double scale = crossing * lobe * (1 - Fresnel.dielectric(half, eta));
        double a = alpha.at(point);
        double r = value.r;
        double g = value.g;
        double b = value.b;
        transparency.evaluate(point, value);
        value.set(r + scale * through(a, value.r), g + scale * through(a, value.g), b + scale * through(a, value.b));
    }

    /** factor·cosⁿβ/2π, β the angle between two unit vectors; from their distance, which keeps digits near the axis. */
    private static double lobe(double n, double factor, double mx, double my, double mz, double x, double y, double z) {
        double dx = x - mx;
        double dy = y - my;
        double dz = z - mz;
        double deficit = 0.5 * (dx * dx + dy * dy + dz * dz);
        return deficit < 1 ? factor * INV_TWO_PI * Math.exp(n * Math.log1p(-deficit)) : 0;
    }

    private double diffuseWeight(SurfacePoint point, double ct) {
        return base(ct, diffuse.luminance(point));
    }

    private double specularWeight(SurfacePoint point, double ct, double reflectance) {
        return base(ct, specular.luminance(point)) + mirrored(reflectance) * ct;
    }

    /** Reflectance to choose lobes by. */
    private double choiceReflectance(double woZ) {
        if (eta == 1) {
            return 0;
        }
        double r = Fresnel.dielectric(Math.min(1, Math.abs(woZ)), woZ > 0 ? eta : 1 / eta);
        return Math.min(1 - LEAST_CHOICE, Math.max(LEAST_CHOICE, r));
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
        if (woZ == 0 || wiZ == 0) {
            return 0;
        }
        double ct = opaque ? 0 : through(alpha.at(point), transparency.luminance(point));
        double r = choiceReflectance(woZ);
        double base = diffuseWeight(point, ct);
        double mirror = specularWeight(point, ct, r);
        double refraction = (1 - r) * ct;
        double translucent = diffuseTransparency.luminance(point);
        double total = base + mirror + refraction + translucent;
        if (!(total > 0)) {
            return 0;
        }
        double cosine = Math.abs(wiZ) * INV_PI;
        if (woZ > 0 == wiZ > 0) {
            double n = exponent(shininess.at(point));
            double lobe = n < Double.POSITIVE_INFINITY ? lobe(n, n + 1, -woX, -woY, woZ, wiX, wiY, wiZ) : 0;
            return (base * cosine + mirror * lobe) / total;
        }
        double n = exponent(transparencyShininess.at(point));
        double lobe =
                opaque || n == Double.POSITIVE_INFINITY ? 0 : transmissionDensity(n, woX, woY, woZ, wiX, wiY, wiZ);
        return (translucent * cosine + refraction * lobe) / total;
    }

    private double transmissionDensity(
            double n, double woX, double woY, double woZ, double wiX, double wiY, double wiZ) {
        boolean outside = woZ > 0;
        double bz = Math.abs(outside ? wiZ : woZ);
        double refracted = Fresnel.refractedCosine(Math.min(1, bz), eta);
        if (refracted <= 0) {
            return 0;
        }
        return outside
                ? lobe(n, n + 1, -eta * wiX, -eta * wiY, refracted, woX, woY, woZ) * eta * eta * bz / refracted
                : lobe(n, n + 1, -eta * woX, -eta * woY, refracted, wiX, wiY, wiZ);
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
        double ct = opaque ? 0 : through(alpha.at(point), transparency.luminance(point));
        double r = choiceReflectance(woZ);
        double base = diffuseWeight(point, ct);
        double mirror = specularWeight(point, ct, r);
        double refraction = (1 - r) * ct;
        double translucent = diffuseTransparency.luminance(point);
        double total = base + mirror + refraction + translucent;
        double chosen = w * total;
        boolean reflected = true;
        if (!(total > 0)) {
            return false;
        } else if (chosen < base) {
            setDiffuse(u, v, woZ > 0, out);
        } else if (chosen < base + mirror) {
            double n = exponent(shininess.at(point));
            if (n == Double.POSITIVE_INFINITY) {
                return reflect(point, woX, woY, woZ, mirror / total, out);
            }
            setLobe(n, -woX, -woY, woZ, u, v, out);
        } else if (chosen < base + mirror + translucent) {
            reflected = false;
            setDiffuse(u, v, woZ < 0, out);
        } else {
            reflected = false;
            double n = exponent(transparencyShininess.at(point));
            if (n == Double.POSITIVE_INFINITY) {
                return refract(point, woX, woY, woZ, refraction / total, mode, out);
            }
            if (!setTransmitted(n, woX, woY, woZ, u, v, out)) {
                return false;
            }
        }
        if (out.wiZ == 0 || reflected != (woZ > 0 == out.wiZ > 0)) {
            return false;
        }
        double density = evaluate(point, woX, woY, woZ, out.wiX, out.wiY, out.wiZ, mode, out.weight);
        return out.complete(density, reflected ? 1 : woZ > 0 ? 1 / eta : eta);
    }

    private static void setDiffuse(double u, double v, boolean up, BsdfSample out) {
        out.setCosineDistributed(u, v);
        out.wiZ = up ? out.wiZ : -out.wiZ;
    }

    /** Draws with density (n + 1) cosⁿβ/2π about a unit axis. */
    private static void setLobe(double n, double mx, double my, double mz, double u, double v, BsdfSample out) {
        double cosine = Math.exp(Math.log1p(-u) / (n + 1));
        double sine = Math.sqrt(Math.max(0, (1 - cosine) * (1 + cosine)));
        double phi = 2 * Math.PI * v;
        double x = sine * Math.cos(phi);
        double y = sine * Math.sin(phi);
        // Any frame about the axis (Duff et al., JCGT 6(1), 2017).
        double sign = Math.copySign(1.0, mz);
        double a = -1 / (sign + mz);
        double b = mx * my * a;
        Microfacet.setNormal(
                x * (1 + sign * mx * mx * a) + y * b + cosine * mx,
                x * sign * b + y * (sign + my * my * a) + cosine * my,
                -x * sign * mx - y * my + cosine * mz,
                out);
    }

    private boolean setTransmitted(double n, double woX, double woY, double woZ, double u, double v, BsdfSample out) {
        if (woZ < 0) {
            double refracted = Fresnel.refractedCosine(Math.min(1, -woZ), eta);
            if (refracted <= 0) {
                return false;
            }
            setLobe(n, -eta * woX, -eta * woY, refracted, u, v, out);
            return true;
        }
        setLobe(n, woX, woY, woZ, u, v, out);
        double refracted = Fresnel.refractedCosine(Math.min(1, out.wiZ), 1 / eta);
        if (out.wiZ <= 0 || refracted <= 0) {
            return false;
        }
        Microfacet.setNormal(-out.wiX / eta, -out.wiY / eta, -refracted, out);
        return true;
    }

    private boolean reflect(
            SurfacePoint point, double woX, double woY, double woZ, double probability, BsdfSample out) {
        double a = alpha.at(point);
        transparency.evaluate(point, out.weight);
        double ctR = through(a, out.weight.r);
        double ctG = through(a, out.weight.g);
        double ctB = through(a, out.weight.b);
        double r = mirrored(Fresnel.dielectric(Math.min(1, Math.abs(woZ)), woZ > 0 ? eta : 1 / eta));
        specular.evaluate(point, out.weight);
        out.weight.set(
                (base(ctR, out.weight.r) + r * ctR) / probability,
                (base(ctG, out.weight.g) + r * ctG) / probability,
                (base(ctB, out.weight.b) + r * ctB) / probability);
        out.setMirrored(woX, woY, woZ);
        out.setDelta(REFLECTION, probability, 1);
        return true;
    }

    private boolean refract(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double probability,
            TransportMode mode,
            BsdfSample out) {
        double etaRatio = woZ > 0 ? 1 / eta : eta;
        double cosine = Math.min(1, Math.abs(woZ));
        double refracted = Fresnel.refractedCosine(cosine, etaRatio);
        if (refracted < 0) {
            return false;
        }
        double transmittance = 1 - Fresnel.dielectric(cosine, refracted, 1 / etaRatio);
        double scale = transmittance * (mode == TransportMode.RADIANCE ? etaRatio * etaRatio : 1) / probability;
        double a = alpha.at(point);
        transparency.evaluate(point, out.weight);
        out.weight.set(
                scale * through(a, out.weight.r), scale * through(a, out.weight.g), scale * through(a, out.weight.b));
        out.wiX = -etaRatio * woX;
        out.wiY = -etaRatio * woY;
        out.wiZ = woZ > 0 ? -refracted : refracted;
        out.setDelta(REFRACTION, probability, etaRatio);
        return true;
    }

    @Override
    public int deltaLobes() {
        return deltaLobes;
    }

    @Override
    public boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        if (woZ == 0 || lobe > REFRACTION) {
            return false;
        }
        UnitScalar channel = lobe == REFLECTION ? shininess : transparencyShininess;
        if (exponent(channel.at(point)) < Double.POSITIVE_INFINITY) {
            return false;
        }
        double ct = opaque ? 0 : through(alpha.at(point), transparency.luminance(point));
        double r = choiceReflectance(woZ);
        double mirror = specularWeight(point, ct, r);
        double refraction = (1 - r) * ct;
        double total = diffuseWeight(point, ct) + mirror + refraction + diffuseTransparency.luminance(point);
        boolean followed = lobe == REFLECTION
                ? reflect(point, woX, woY, woZ, mirror / total, out)
                : refract(point, woX, woY, woZ, refraction / total, mode, out);
        return followed && out.undoChoice();
    }

    /** Without Fresnel's reflection, and at most 1. */
    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        double a = alpha.at(point);
        transparency.evaluate(point, out);
        double ctR = through(a, out.r);
        double ctG = through(a, out.g);
        double ctB = through(a, out.b);
        specular.evaluate(point, out);
        double sR = out.r;
        double sG = out.g;
        double sB = out.b;
        diffuse.evaluate(point, out);
        double dR = base(ctR, sR + out.r) + ctR;
        double dG = base(ctG, sG + out.g) + ctG;
        double dB = base(ctB, sB + out.b) + ctB;
        diffuseTransparency.evaluate(point, out);
        out.set(Math.min(1, dR + out.r), Math.min(1, dG + out.g), Math.min(1, dB + out.b));
    }
}
