package org.daybreak.core.sampling;

import org.daybreak.core.math.Scalars;
import org.daybreak.core.math.Turns;

/**
 * Maps of uniform points of the unit square onto other shapes, each with its density beside it.
 *
 * <p>(u, v) lies in [0, 1)². Results go to the first elements of {@code dest}. Directions are unit vectors in local
 * coordinates with the axis of symmetry along +z; their densities are per solid angle.
 */
public final class Warps {
    private static final double INV_PI = 1 / Math.PI;

    /** Below the least positive height that {@link #toCosineHemisphere} yields by itself, about 2⁻²⁶. */
    private static final double LEAST_HEIGHT = 1e-9;

    private Warps() {}

    /**
     * Uniform point (x, y) of the unit disk, by a map that keeps areas in proportion and neighbours together (Shirley
     * and Chiu, “A Low Distortion Map Between Disk and Square”, JGT 2(3), 1997).
     */
    public static void toConcentricDisk(double u, double v, double[] dest) {
        double a = 2 * u - 1;
        double b = 2 * v - 1;
        if (Math.abs(a) > Math.abs(b)) {
            double eighths = b / a;
            dest[0] = a * Turns.cosEighth(eighths);
            dest[1] = a * Turns.sinEighth(eighths);
        } else {
            double eighths = b == 0 ? 0 : a / b;
            dest[0] = b * Turns.sinEighth(eighths);
            dest[1] = b * Turns.cosEighth(eighths);
        }
    }

    /** Density of {@link #toConcentricDisk} per unit of area. */
    public static double toConcentricDiskPdf(double x, double y) {
        return x * x + y * y <= 1 ? INV_PI : 0;
    }

    /** Direction with density proportional to its cosine to +z; its z is always positive. */
    public static void toCosineHemisphere(double u, double v, double[] dest) {
        toConcentricDisk(u, v, dest);
        double z = Scalars.sqrtClamped(1 - dest[0] * dest[0] - dest[1] * dest[1]);
        // The rim of the disk, at u = 0, would otherwise give a direction of density 0.
        dest[2] = Math.max(z, LEAST_HEIGHT);
    }

    /** Density of {@link #toCosineHemisphere} per solid angle, for the z of a unit vector. */
    public static double toCosineHemispherePdf(double cosTheta) {
        return cosTheta > 0 ? cosTheta * INV_PI : 0;
    }

    /** Uniform direction; u chooses its height from +z down, v its azimuth. */
    public static void toUniformSphere(double u, double v, double[] dest) {
        setSpherical(2 * u, v, dest);
    }

    /** Density of {@link #toUniformSphere} per solid angle. */
    public static double toUniformSpherePdf() {
        return 0.25 * INV_PI;
    }

    /** Uniform direction with z above 0; u chooses its height from +z down, v its azimuth. */
    public static void toUniformHemisphere(double u, double v, double[] dest) {
        setSpherical(u, v, dest);
    }

    /** Density of {@link #toUniformHemisphere} per solid angle, for the z of a unit vector. */
    public static double toUniformHemispherePdf(double cosTheta) {
        return cosTheta > 0 ? 0.5 * INV_PI : 0;
    }

    /**
     * Uniform direction within a cone about +z.
     *
     * @param oneMinusCosMax 1 − cos of the half angle, which unlike the cosine is accurate for narrow cones; 0 … 2
     */
    public static void toUniformCone(double u, double v, double oneMinusCosMax, double[] dest) {
        setSpherical(u * oneMinusCosMax, v, dest);
    }

    /**
     * Density of {@link #toUniformCone} per solid angle.
     *
     * @param oneMinusCosTheta 1 − z of a unit vector
     * @param oneMinusCosMax 1 − cos of the half angle, positive
     */
    public static double toUniformConePdf(double oneMinusCosTheta, double oneMinusCosMax) {
        return oneMinusCosTheta <= oneMinusCosMax ? 0.5 * INV_PI / oneMinusCosMax : 0;
    }

    /**
     * Barycentric coordinates (b₁, b₂) of a uniform point of a triangle, b₀ = 1 − b₁ − b₂ (Heitz, “A Low-Distortion Map
     * Between Triangle and Square”, 2019).
     */
    public static void toTriangle(double u, double v, double[] dest) {
        if (v > u) {
            double half = 0.5 * u;
            dest[0] = half;
            dest[1] = v - half;
        } else {
            double half = 0.5 * v;
            dest[0] = u - half;
            dest[1] = half;
        }
    }

    /**
     * Density of {@link #toTriangle} per db₁ db₂. On a triangle of area A the density per unit of area is 1/A.
     *
     * @param b1 first coordinate
     * @param b2 second coordinate
     */
    public static double toTrianglePdf(double b1, double b2) {
        return b1 >= 0 && b2 >= 0 && b1 + b2 <= 1 ? 2 : 0;
    }

    /** Number in [−1, 1] with the tent density 1 − |x|; increasing in u. */
    public static double toTent(double u) {
        return u < 0.5 ? Math.sqrt(2 * u) - 1 : 1 - Math.sqrt(2 * (1 - u));
    }

    /** Density of {@link #toTent}. */
    public static double toTentPdf(double x) {
        return Math.max(0, 1 - Math.abs(x));
    }

    /** Writes the unit vector with z = 1 − oneMinusZ and azimuth 2πv. */
    private static void setSpherical(double oneMinusZ, double v, double[] dest) {
        double sine = Scalars.sqrtClamped(oneMinusZ * (2 - oneMinusZ));
        dest[0] = sine * Turns.cos(v);
        dest[1] = sine * Turns.sin(v);
        dest[2] = 1 - oneMinusZ;
    }
}
