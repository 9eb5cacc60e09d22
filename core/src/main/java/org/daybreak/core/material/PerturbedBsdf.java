package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * A material in a shading frame whose normal is tilted by a texture. As with interpolated normals, a pair of directions
 * scatters only if each lies on the same side of both normals, the value in {@link TransportMode#RADIANCE} is the nested
 * material's with the cosine to the tilted normal, and {@link TransportMode#IMPORTANCE} has the adjoint of that
 * (Veach 1997, §5.3).
 *
 * <p>With the tilted normal n the frame is s = (c, −n_x n_y/c, −n_x n_z/c) and t = (0, n_z/c, −n_y/c), c² = 1 − n_x²: the
 * tangent stays in the plane of ∂p/∂u and the normal.
 */
abstract class PerturbedBsdf implements Bsdf {
    /** Sines of elevation below this are grazing: the adjoint's quotient of cosines would overflow. */
    private static final double GRAZING = 1e-12;

    private final Bsdf nested;
    private final TangentFrame tangentFrame;
    private final boolean shadowed;

    /**
     * Wraps a material.
     *
     * @param map the texture that tilts the normal
     * @throws IllegalArgumentException if the nested material has a map over other texture coordinates
     */
    PerturbedBsdf(Texture map, Bsdf nested, boolean shadowed) {
        this.nested = nested;
        this.tangentFrame =
                (map.usesSecondUvs() ? TangentFrame.SECOND_UVS : TangentFrame.FIRST_UVS).and(nested.tangentFrame());
        this.shadowed = shadowed;
    }

    /** Slope −n_x/n_z of the tilted surface along s of the shading frame. */
    abstract double slopeS(SurfacePoint point);

    /** Slope −n_y/n_z of the tilted surface along t of the shading frame. */
    abstract double slopeT(SurfacePoint point);

    @Override
    public final boolean textured() {
        return true;
    }

    @Override
    public final TangentFrame tangentFrame() {
        return tangentFrame;
    }

    @Override
    public final boolean tiltsNormal() {
        return true;
    }

    @Override
    public final boolean choosesLobe() {
        return nested.choosesLobe();
    }

    @Override
    public final boolean connectable() {
        return nested.connectable();
    }

    @Override
    public final boolean transmissive() {
        return nested.transmissive();
    }

    @Override
    public final double transparency(SurfacePoint point) {
        return nested.transparency(point);
    }

    @Override
    public final boolean maybeTransparent() {
        return nested.maybeTransparent();
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
        double slopeS = slopeS(point);
        double slopeT = slopeT(point);
        double nz = 1 / Math.sqrt(1 + slopeS * slopeS + slopeT * slopeT);
        double nx = -slopeS * nz;
        double ny = -slopeT * nz;
        double oz = woX * nx + woY * ny + woZ * nz;
        double iz = wiX * nx + wiY * ny + wiZ * nz;
        if (!sameSide(oz, woZ) || !sameSide(iz, wiZ)) {
            return 0;
        }
        double c = Math.sqrt(ny * ny + nz * nz);
        double ox = alongS(c, nx, ny, nz, woX, woY, woZ);
        double oy = alongT(c, ny, nz, woY, woZ);
        double ix = alongS(c, nx, ny, nz, wiX, wiY, wiZ);
        double iy = alongT(c, ny, nz, wiY, wiZ);
        if (value == null) {
            return nested.density(point, ox, oy, oz, ix, iy, iz, mode);
        }
        double density = nested.evaluate(point, ox, oy, oz, ix, iy, iz, mode, value);
        value.scale(factor(slopeS * slopeS + slopeT * slopeT, woZ, oz, wiZ, iz, mode));
        return density;
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
        return follow(point, woX, woY, woZ, u, v, w, DeltaBsdf.CHOOSE, mode, out);
    }

    @Override
    public final int deltaLobes() {
        return nested.deltaLobes();
    }

    @Override
    public final boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        return follow(point, woX, woY, woZ, 0, 0, 0, lobe, mode, out);
    }

    /** Samples, or follows a given delta lobe. */
    private boolean follow(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double u,
            double v,
            double w,
            int lobe,
            TransportMode mode,
            BsdfSample out) {
        double slopeS = slopeS(point);
        double slopeT = slopeT(point);
        double nz = 1 / Math.sqrt(1 + slopeS * slopeS + slopeT * slopeT);
        double nx = -slopeS * nz;
        double ny = -slopeT * nz;
        double c = Math.sqrt(ny * ny + nz * nz);
        double ox = alongS(c, nx, ny, nz, woX, woY, woZ);
        double oy = alongT(c, ny, nz, woY, woZ);
        double oz = woX * nx + woY * ny + woZ * nz;
        boolean followed = lobe == DeltaBsdf.CHOOSE
                ? nested.sample(point, ox, oy, oz, u, v, w, mode, out)
                : nested.deltaLobe(point, ox, oy, oz, lobe, mode, out);
        if (!followed) {
            return false;
        }
        if (out.passThrough) {
            out.setStraight(woX, woY, woZ);
            return true;
        }
        double x = out.wiX;
        double y = out.wiY;
        double iz = out.wiZ;
        double wiX = c * x + nx * iz;
        double wiY = nz / c * y - nx * ny / c * x + ny * iz;
        double wiZ = nz * iz - nx * nz / c * x - ny / c * y;
        if (!sameSide(oz, woZ) || !sameSide(iz, wiZ)) {
            return false;
        }
        if (!out.delta) {
            // Evaluated anew: at grazing angles turning the direction has rounded away digits that the nested material
            // used.
            double density = evaluate(point, woX, woY, woZ, wiX, wiY, wiZ, mode, out.weight);
            if (!out.complete(density, out.eta)) {
                return false;
            }
        } else {
            out.weight.scale(factor(slopeS * slopeS + slopeT * slopeT, woZ, oz, wiZ, iz, mode));
        }
        out.wiX = wiX;
        out.wiY = wiY;
        out.wiZ = wiZ;
        return true;
    }

    /**
     * The adjoint's quotient of cosines, times the shadow that the tilted facets throw (Estevez, Lecocq and Stein 2019, “A
     * Microfacet-Based Shadowing Function to Solve the Bump Terminator Problem”): GGX of α² = tan²θ_n/8 for the direction
     * that light comes from.
     *
     * @param squaredTangent tan²θ_n of the tilted normal
     */
    private double factor(double squaredTangent, double woZ, double oz, double wiZ, double iz, TransportMode mode) {
        boolean radiance = mode == TransportMode.RADIANCE;
        double quotient = radiance ? 1 : Math.abs(oz * wiZ / (woZ * iz));
        if (!shadowed) {
            return quotient;
        }
        double cosine = Math.min(1, Math.abs(radiance ? wiZ : woZ));
        double alpha = Math.sqrt(Math.min(1, 0.125 * squaredTangent));
        return quotient * cosine * Microfacet.maskingOverCosine(Microfacet.Kind.GGX, alpha, cosine);
    }

    private static boolean sameSide(double tilted, double upright) {
        return tilted * upright > 0 && Math.abs(tilted) > GRAZING && Math.abs(upright) > GRAZING;
    }

    private static double alongS(double c, double nx, double ny, double nz, double x, double y, double z) {
        return c * x - nx / c * (ny * y + nz * z);
    }

    private static double alongT(double c, double ny, double nz, double y, double z) {
        return (nz * y - ny * z) / c;
    }

    @Override
    public final void albedo(SurfacePoint point, Spectrum out) {
        nested.albedo(point, out);
    }
}
