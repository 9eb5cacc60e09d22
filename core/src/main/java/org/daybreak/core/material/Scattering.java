package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * Scattering at a surface point in world space: the one place where local frames, geometric side tests and the
 * shading-normal adjoint meet. Random walks and connections both go through here, so they cannot disagree
 * (light-transport notes §3; Veach 1997, §5.3).
 *
 * <p>Side test: a pair of directions scatters only if each lies on the same side of the geometric and of the shading
 * normal; otherwise interpolated normals would leak light through closed surfaces.
 *
 * <p>Adjoint: on light subpaths f·|cos θ_i| is multiplied by |wo·n_s| |wi·n_g| / (|wo·n_g| |wi·n_s|)
 * (Veach 1997, eq. 5.19), where wo points back along the light path and wi goes on.
 */
public final class Scattering {
    private Scattering() {}

    /**
     * Evaluates {@code f·|wi·n_s|}, with the adjoint factor in {@link TransportMode#IMPORTANCE}, for world-space unit
     * directions pointing away from the surface.
     *
     * @param value receives the product in 1/sr; zero if the side test fails
     * @return density per solid angle of sampling wi given wo
     */
    public static double evaluate(
            Bsdf bsdf,
            SurfacePoint p,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode,
            Spectrum value) {
        double oz = p.localZ(woX, woY, woZ);
        double iz = p.localZ(wiX, wiY, wiZ);
        double og = p.geometricCosine(woX, woY, woZ);
        double ig = p.geometricCosine(wiX, wiY, wiZ);
        if (oz * og <= 0 || iz * ig <= 0) {
            value.setZero();
            return density(bsdf, p, woX, woY, woZ, wiX, wiY, wiZ, mode);
        }
        double density = bsdf.evaluate(
                p,
                p.localX(woX, woY, woZ),
                p.localY(woX, woY, woZ),
                oz,
                p.localX(wiX, wiY, wiZ),
                p.localY(wiX, wiY, wiZ),
                iz,
                mode,
                value);
        if (mode == TransportMode.IMPORTANCE) {
            value.scale(adjoint(oz, og, iz, ig));
        }
        return density;
    }

    /** Density per solid angle of sampling wi given wo, world-space unit directions pointing away from the surface. */
    public static double density(
            Bsdf bsdf,
            SurfacePoint p,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode) {
        return bsdf.density(
                p,
                p.localX(woX, woY, woZ),
                p.localY(woX, woY, woZ),
                p.localZ(woX, woY, woZ),
                p.localX(wiX, wiY, wiZ),
                p.localY(wiX, wiY, wiZ),
                p.localZ(wiX, wiY, wiZ),
                mode);
    }

    /**
     * Samples a direction to go on with. On success {@code out} holds the world-space direction and its weight
     * including the adjoint factor.
     *
     * @return false if the walk ends: nothing sampled, or the direction fails the side test
     */
    public static boolean sample(
            Bsdf bsdf,
            SurfacePoint p,
            double woX,
            double woY,
            double woZ,
            double u,
            double v,
            double w,
            TransportMode mode,
            BsdfSample out) {
        double oz = p.localZ(woX, woY, woZ);
        double og = p.geometricCosine(woX, woY, woZ);
        if (!bsdf.sample(p, p.localX(woX, woY, woZ), p.localY(woX, woY, woZ), oz, u, v, w, mode, out)) {
            return false;
        }
        return toWorld(p, oz, og, mode, out);
    }

    /**
     * Follows a given delta lobe, as {@link Bsdf#deltaLobe}. On success {@code out} holds the world-space direction, and as
     * weight the reflectance or transmittance including the adjoint factor.
     *
     * @return false if nothing goes this way, or the directions fail the side test
     */
    public static boolean deltaLobe(
            Bsdf bsdf,
            SurfacePoint p,
            double woX,
            double woY,
            double woZ,
            int lobe,
            TransportMode mode,
            BsdfSample out) {
        double oz = p.localZ(woX, woY, woZ);
        double og = p.geometricCosine(woX, woY, woZ);
        return bsdf.deltaLobe(p, p.localX(woX, woY, woZ), p.localY(woX, woY, woZ), oz, lobe, mode, out)
                && toWorld(p, oz, og, mode, out);
    }

    /** Turns the direction to world space, makes the side test and applies the adjoint factor. */
    private static boolean toWorld(SurfacePoint p, double oz, double og, TransportMode mode, BsdfSample out) {
        double lx = out.wiX;
        double ly = out.wiY;
        double iz = out.wiZ;
        double x = lx * p.sx + ly * p.tx + iz * p.nx;
        double y = lx * p.sy + ly * p.ty + iz * p.ny;
        double z = lx * p.sz + ly * p.tz + iz * p.nz;
        out.wiX = x;
        out.wiY = y;
        out.wiZ = z;
        if (out.passThrough) {
            return true;
        }
        double ig = p.geometricCosine(x, y, z);
        if (oz * og <= 0 || iz * ig <= 0) {
            return false;
        }
        if (mode == TransportMode.IMPORTANCE) {
            out.weight.scale(adjoint(oz, og, iz, ig));
        }
        return true;
    }

    private static double adjoint(double oz, double og, double iz, double ig) {
        return Math.abs(oz * ig / (og * iz));
    }
}
