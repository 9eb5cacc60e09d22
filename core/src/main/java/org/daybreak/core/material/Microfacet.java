package org.daybreak.core.material;

/**
 * Microfacet distributions after Walter et al. 2007 (“Microfacet Models for Refraction through Rough
 * Surfaces”): density of facet normals D, Smith's masking G₁, and sampling of visible normals.
 *
 * <p>Directions are in the local frame, z along the macroscopic normal, and lie in its upper hemisphere; the caller
 * tests sides. Masking and shadowing are taken as independent, G = G₁(wo)·G₁(wi) (the separable form; Mitsuba uses it
 * too, so that reference images agree). Anisotropic surfaces are isotropic ones stretched by α_u along x and α_v along y of
 * the local frame (Heitz 2014, “Understanding the Masking-Shadowing Function”, §5.3). G₁ is the exact Smith integral for both distributions, not the rational fit of
 * Walter for Beckmann: only so do the visible normals integrate to 1.
 */
public final class Microfacet {
    /**
     * Smallest roughness. Below, half vectors of double precision directions no longer resolve the lobe; a smooth
     * material is meant.
     */
    public static final double MIN_ALPHA = 1e-6;

    /** Largest roughness; beyond, the surface is a comb of needles. */
    public static final double MAX_ALPHA = 10;

    private static final double SQRT_PI = Math.sqrt(Math.PI);
    private static final int MAX_NEWTON_STEPS = 100;

    /** Shape of the distribution of facet slopes. */
    public enum Kind {
        /** Trowbridge–Reitz: long tails. */
        GGX,
        /** Gaussian slopes; α is √2 times the root-mean-square slope. */
        BECKMANN
    }

    private Microfacet() {}

    /**
     * Checks a roughness.
     *
     * @return the argument
     * @throws IllegalArgumentException if it is not in [{@link #MIN_ALPHA}, {@link #MAX_ALPHA}]
     */
    static double requireAlpha(double alpha) {
        if (!(alpha >= MIN_ALPHA && alpha <= MAX_ALPHA)) {
            String hint = alpha >= 0 && alpha < MIN_ALPHA ? "; for alpha 0 use the smooth material" : "";
            throw new IllegalArgumentException(
                    "alpha must be between " + MIN_ALPHA + " and " + MAX_ALPHA + " but is " + alpha + hint);
        }
        return alpha;
    }

    /**
     * Density D of facet normals, per solid angle of normals and unit of macroscopic area: ∫ D cos θ dω = 1.
     *
     * @param x normal or half vector, of any length
     * @param z its third component, not negative
     */
    public static double distribution(Kind kind, double alpha, double x, double y, double z) {
        double horizontal = x * x + y * y;
        double vertical = z * z;
        double squaredLength = horizontal + vertical;
        double alphaSquared = alpha * alpha;
        if (!(vertical * alphaSquared > Double.MIN_NORMAL)) {
            return 0;
        }
        if (kind == Kind.GGX) {
            double ratio = squaredLength / (horizontal + alphaSquared * vertical);
            return alphaSquared * ratio * ratio / Math.PI;
        }
        double tanSquared = horizontal / vertical;
        double secSquared = squaredLength / vertical;
        double gaussian = Math.exp(-tanSquared / alphaSquared);
        return gaussian == 0 ? 0 : gaussian * secSquared * secSquared / (Math.PI * alphaSquared);
    }

    /**
     * Density D of facet normals of an anisotropic surface: {@link #distribution(Kind, double, double, double, double)}.
     *
     * @param alphaU roughness along x
     * @param alphaV roughness along y
     */
    public static double distribution(Kind kind, double alphaU, double alphaV, double x, double y, double z) {
        if (alphaU == alphaV) {
            return distribution(kind, alphaU, x, y, z);
        }
        double product = alphaU * alphaV;
        double vertical = z * z;
        if (!(vertical * product > Double.MIN_NORMAL)) {
            return 0;
        }
        double squaredLength = x * x + y * y + vertical;
        double u = x / alphaU;
        double v = y / alphaV;
        double stretched = u * u + v * v;
        if (kind == Kind.GGX) {
            double ratio = squaredLength / (stretched + vertical);
            return ratio * ratio / (Math.PI * product);
        }
        double secSquared = squaredLength / vertical;
        double gaussian = Math.exp(-stretched / vertical);
        return gaussian == 0 ? 0 : gaussian * secSquared * secSquared / (Math.PI * product);
    }

    /**
     * Smith's masking function over the cosine, G₁(v)/cos θ: finite also at grazing angles. G₁ itself is this times the
     * cosine, in [0,1].
     *
     * @param cosine cos θ of the direction, in [0,1]
     */
    public static double maskingOverCosine(Kind kind, double alpha, double cosine) {
        double sinSquared = Math.max(0, (1 - cosine) * (1 + cosine));
        return maskingForSpread(kind, cosine, alpha * alpha * sinSquared);
    }

    /**
     * Smith's masking function over the cosine of an anisotropic surface.
     *
     * @param alphaU roughness along x
     * @param alphaV roughness along y
     * @param x first component of the unit direction
     * @param y second component
     * @param cosine third component, in [0,1]
     */
    public static double maskingOverCosine(Kind kind, double alphaU, double alphaV, double x, double y, double cosine) {
        if (alphaU == alphaV) {
            return maskingOverCosine(kind, alphaU, cosine);
        }
        double u = alphaU * x;
        double v = alphaV * y;
        return maskingForSpread(kind, cosine, u * u + v * v);
    }

    /**
     * Smith's masking function over the cosine.
     *
     * @param squaredSpread (α sin θ)², α the roughness in the plane of the direction
     */
    private static double maskingForSpread(Kind kind, double cosine, double squaredSpread) {
        if (kind == Kind.GGX) {
            return 2 / (cosine + Math.sqrt(cosine * cosine + squaredSpread));
        }
        // 1/G₁ = (1 + erf a + exp(−a²)/(a√π)) / 2 with a = cos θ/(α sin θ).
        double alphaSin = Math.sqrt(squaredSpread);
        double a = cosine / alphaSin;
        double gaussian = Math.exp(-a * a);
        return 2 / (cosine * (2 - ErrorFunction.complement(a, gaussian)) + alphaSin * gaussian / SQRT_PI);
    }

    /**
     * Density per solid angle of a direction that {@link #sampleReflection(Kind, double, double, double,
     * double, double, double, BsdfSample)} draws, D·G₁(wo)/(4 cos θ_o) at the half vector;
     * zero unless both directions are above the surface.
     */
    public static double reflectionDensity(
            Kind kind, double alpha, double woX, double woY, double woZ, double wiX, double wiY, double wiZ) {
        return reflectionDensity(kind, alpha, alpha, woX, woY, woZ, wiX, wiY, wiZ);
    }

    /** Density of {@link #sampleReflection(Kind, double, double, double, double, double, double, double, BsdfSample)}. */
    public static double reflectionDensity(
            Kind kind,
            double alphaU,
            double alphaV,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ) {
        if (woZ <= 0 || wiZ <= 0) {
            return 0;
        }
        return 0.25
                * distribution(kind, alphaU, alphaV, woX + wiX, woY + wiY, woZ + wiZ)
                * maskingOverCosine(kind, alphaU, alphaV, woX, woY, woZ);
    }

    /** Cosine of the angle between either direction and the half vector, where Fresnel's reflectance is taken. */
    public static double halfAngleCosine(double woX, double woY, double woZ, double wiX, double wiY, double wiZ) {
        double x = woX + wiX;
        double y = woY + wiY;
        double z = woZ + wiZ;
        // |wo + wi| = 2 cos of the half angle for unit vectors; no cancellation where the sum is short.
        return Math.min(1, 0.5 * Math.sqrt(x * x + y * y + z * z));
    }

    /**
     * Samples a direction by reflection off a visible normal.
     *
     * @param out receives the unit direction in {@code wiX}, {@code wiY}, {@code wiZ}
     * @return false if {@code wo} or the reflected direction is not above the surface
     */
    public static boolean sampleReflection(
            Kind kind, double alpha, double woX, double woY, double woZ, double u, double v, BsdfSample out) {
        return sampleReflection(kind, alpha, alpha, woX, woY, woZ, u, v, out);
    }

    /** Samples a direction by reflection off a visible normal of an anisotropic surface. */
    public static boolean sampleReflection(
            Kind kind,
            double alphaU,
            double alphaV,
            double woX,
            double woY,
            double woZ,
            double u,
            double v,
            BsdfSample out) {
        if (woZ <= 0) {
            return false;
        }
        sampleVisibleNormal(kind, alphaU, alphaV, woX, woY, woZ, u, v, out);
        double twice = 2 * (woX * out.wiX + woY * out.wiY + woZ * out.wiZ);
        out.wiX = twice * out.wiX - woX;
        out.wiY = twice * out.wiY - woY;
        out.wiZ = twice * out.wiZ - woZ;
        return out.wiZ > 0;
    }

    /**
     * Samples a normal from the density of those visible from {@code wo}, D(m)·G₁(wo)·(wo·m)⁺/cos θ_o per solid angle of
     * normals.
     *
     * @param woZ third component, not negative
     * @param out receives the unit normal in {@code wiX}, {@code wiY}, {@code wiZ}; nothing else changes
     */
    public static void sampleVisibleNormal(
            Kind kind, double alpha, double woX, double woY, double woZ, double u, double v, BsdfSample out) {
        sampleVisibleNormal(kind, alpha, alpha, woX, woY, woZ, u, v, out);
    }

    /** Samples a normal from the density of those visible on an anisotropic surface. */
    public static void sampleVisibleNormal(
            Kind kind,
            double alphaU,
            double alphaV,
            double woX,
            double woY,
            double woZ,
            double u,
            double v,
            BsdfSample out) {
        // Stretching the surface by 1/α makes the roughness 1.
        double x = alphaU * woX;
        double y = alphaV * woY;
        double length = Math.sqrt(x * x + y * y + woZ * woZ);
        x /= length;
        y /= length;
        double z = woZ / length;
        if (kind == Kind.GGX) {
            sampleSphericalCap(alphaU, alphaV, x, y, z, u, v, out);
        } else {
            sampleGaussianSlopes(alphaU, alphaV, x, y, z, u, v, out);
        }
    }

    /**
     * Facets of GGX with α = 1 are those of a sphere: reflections of {@code wo} off them fill a spherical cap uniformly
     * (Dupuy and Benyoub 2023, “Sampling Visible GGX Normals with Spherical Caps”).
     */
    private static void sampleSphericalCap(
            double alphaU, double alphaV, double x, double y, double z, double u, double v, BsdfSample out) {
        double phi = 2 * Math.PI * u;
        // The half vector's z is positive for v < 1, and not formed as a difference, to keep it so.
        double halfZ = (1 - v) * (1 + z);
        double capZ = halfZ - z;
        double sin = Math.sqrt(Math.max(0, (1 - capZ) * (1 + capZ)));
        setNormal(alphaU * (sin * Math.cos(phi) + x), alphaV * (sin * Math.sin(phi) + y), halfZ, out);
    }

    /**
     * Slopes of Beckmann facets with α = 1 are Gaussian: across the plane of incidence independent of the direction,
     * along it weighted by the projected area (Heitz and d'Eon 2014, “Importance Sampling Microfacet-Based BSDFs using
     * the Distribution of Visible Normals”).
     */
    private static void sampleGaussianSlopes(
            double alphaU, double alphaV, double x, double y, double z, double u, double v, BsdfSample out) {
        double sin = Math.sqrt(x * x + y * y);
        double along = visibleSlope(z, sin, u);
        double across = visibleSlope(1, 0, v);
        double cosPhi = sin > 0 ? x / sin : 1;
        double sinPhi = sin > 0 ? y / sin : 0;
        double slopeX = cosPhi * along - sinPhi * across;
        double slopeY = sinPhi * along + cosPhi * across;
        setNormal(-alphaU * slopeX, -alphaV * slopeY, 1, out);
    }

    /**
     * Inverts the distribution function of slopes X with density ∝ (cos θ − X sin θ)·exp(−X²) where that is positive.
     * Newton's method starts at the mode, the inflection point of the distribution function, from where it converges
     * monotonically to both sides. With sin θ = 0 this is the Gaussian across the plane of incidence.
     *
     * @param cos cosine of the stretched direction, not negative; not both zero
     * @param sin its sine, not negative
     * @return slope −m_x/m_z of the stretched facet
     */
    static double visibleSlope(double cos, double sin, double u) {
        double limit = cos / sin;
        double limitGaussian = Math.exp(-limit * limit);
        double total =
                cos * 0.5 * SQRT_PI * (2 - ErrorFunction.complement(limit, limitGaussian)) + 0.5 * sin * limitGaussian;
        // u = 0 has no finite slope; half the spacing of uniform numbers stands for its cell.
        double target = Math.max(u, 0x1p-54) * total;
        double slope = -1 / (limit + Math.sqrt(limit * limit + 2));
        for (int i = 0; i < MAX_NEWTON_STEPS; i++) {
            double gaussian = Math.exp(-slope * slope);
            double value = cos * 0.5 * SQRT_PI * ErrorFunction.complement(-slope, gaussian) + 0.5 * sin * gaussian;
            double derivative = (cos - slope * sin) * gaussian;
            if (!(derivative > 0)) {
                break;
            }
            double step = (target - value) / derivative;
            slope = Math.min(slope + step, limit);
            if (Math.abs(step) <= 1e-11 * (1 + Math.abs(slope))) {
                break;
            }
        }
        return slope;
    }

    /** Writes a normal of any length to {@code out}, as a unit vector. */
    static void setNormal(double x, double y, double z, BsdfSample out) {
        double scale = 1 / Math.sqrt(x * x + y * y + z * z);
        out.wiX = x * scale;
        out.wiY = y * scale;
        out.wiZ = z * scale;
    }
}
