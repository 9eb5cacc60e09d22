package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A thin sheet that scatters diffusely to both sides, such as a plant's leaf or paper: light that arrives on a side is
 * reflected with that side's reflectance ρ, f = ρ/π, and transmitted with its transmittance τ, f = τ/π. Without
 * reflectance it is the diffuse transmitter.
 *
 * <p>Reciprocal if both transmittances are equal, as those of real leaves are. If they differ, the two transport modes are
 * adjoint to each other: the side that light arrives on counts, which is that of {@code wi} in {@link
 * TransportMode#RADIANCE} and that of {@code wo} in {@link TransportMode#IMPORTANCE}.
 *
 * <p>Where textures add up to more than 1, both are scaled down to 1 together.
 */
public final class Leaf implements Bsdf {
    private static final double INV_PI = 1 / Math.PI;

    private final Reflectance frontReflectance;
    private final Reflectance backReflectance;
    private final Reflectance frontTransmittance;
    private final Reflectance backTransmittance;
    private final boolean bounded;

    /**
     * Creates a sheet.
     *
     * @param frontReflectance ρ for light on the side of the normal, in [0,1]
     * @param frontTransmittance τ for light that arrives there
     * @param backReflectance ρ for light on the other side
     * @param backTransmittance τ for light that arrives there
     * @throws IllegalArgumentException if a texture exceeds 1, or two constants of a side together do
     */
    public Leaf(
            Texture frontReflectance, Texture frontTransmittance, Texture backReflectance, Texture backTransmittance) {
        this.frontReflectance = new Reflectance("front reflectance", frontReflectance);
        this.frontTransmittance = new Reflectance("front transmittance", frontTransmittance);
        this.backReflectance = new Reflectance("back reflectance", backReflectance);
        this.backTransmittance = new Reflectance("back transmittance", backTransmittance);
        requireSum("front", frontReflectance, frontTransmittance);
        requireSum("back", backReflectance, backTransmittance);
        bounded = frontReflectance.maximum() + frontTransmittance.maximum() <= 1
                && backReflectance.maximum() + backTransmittance.maximum() <= 1;
    }

    /**
     * A diffuse transmitter: it reflects nothing.
     *
     * @param transmittance of both sides, in [0,1]
     * @throws IllegalArgumentException if the texture exceeds 1
     */
    public static Leaf transmitter(Texture transmittance) {
        Texture black = ConstantTexture.grey(0);
        return new Leaf(black, transmittance, black, transmittance);
    }

    private static void requireSum(String side, Texture reflectance, Texture transmittance) {
        if (!reflectance.isConstant() || !transmittance.isConstant()) {
            return;
        }
        Spectrum sum = new Spectrum();
        Spectrum other = new Spectrum();
        reflectance.mean(sum);
        transmittance.mean(other);
        sum.add(other);
        if (sum.max() > 1 + 1e-9) {
            throw new IllegalArgumentException(
                    side + " reflectance and transmittance must not exceed 1 together but reach " + sum.max());
        }
    }

    @Override
    public boolean textured() {
        return frontReflectance.varies()
                || backReflectance.varies()
                || frontTransmittance.varies()
                || backTransmittance.varies();
    }

    @Override
    public boolean transmissive() {
        return true;
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
        if (woZ == 0 || wiZ == 0) {
            value.setZero();
            return 0;
        }
        boolean reflected = woZ > 0 == wiZ > 0;
        lit(point, reflected, arrivesInFront(woZ, wiZ, mode), value);
        value.scale(Math.abs(wiZ) * INV_PI);
        return density(point, woX, woY, woZ, wiX, wiY, wiZ, mode);
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
        double reflection = reflectionProbability(point, woZ > 0, mode);
        double probability = reflection < 0 ? 0 : woZ > 0 == wiZ > 0 ? reflection : 1 - reflection;
        return probability * Math.abs(wiZ) * INV_PI;
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
        double reflection = woZ == 0 ? -1 : reflectionProbability(point, woZ > 0, mode);
        if (reflection < 0) {
            return false;
        }
        boolean reflected = w < reflection;
        out.setCosineDistributed(u, v);
        if (out.wiZ == 0) {
            return false;
        }
        double probability = reflected ? reflection : 1 - reflection;
        out.setContinuous(probability * out.wiZ * INV_PI);
        out.wiZ = woZ > 0 == reflected ? out.wiZ : -out.wiZ;
        lit(point, reflected, arrivesInFront(woZ, out.wiZ, mode), out.weight);
        out.weight.scale(1 / probability);
        return true;
    }

    private static boolean arrivesInFront(double woZ, double wiZ, TransportMode mode) {
        return (mode == TransportMode.RADIANCE ? wiZ : woZ) > 0;
    }

    /** Writes ρ or τ of the side that light arrives on. */
    private void lit(SurfacePoint point, boolean reflected, boolean front, Spectrum out) {
        Reflectance rho = front ? frontReflectance : backReflectance;
        Reflectance tau = front ? frontTransmittance : backTransmittance;
        if (bounded) {
            (reflected ? rho : tau).evaluate(point, out);
            return;
        }
        (reflected ? tau : rho).evaluate(point, out);
        double otherR = out.r;
        double otherG = out.g;
        double otherB = out.b;
        (reflected ? rho : tau).evaluate(point, out);
        out.set(
                out.r / Math.max(1, out.r + otherR),
                out.g / Math.max(1, out.g + otherG),
                out.b / Math.max(1, out.b + otherB));
    }

    /** Probability of reflecting a walk that came from a side; −1 if it ends there. Without the scaling: it cancels nearly. */
    private double reflectionProbability(SurfacePoint point, boolean front, TransportMode mode) {
        boolean arrives = front == (mode == TransportMode.IMPORTANCE);
        double rho = (front ? frontReflectance : backReflectance).luminance(point);
        double tau = (arrives ? frontTransmittance : backTransmittance).luminance(point);
        double sum = rho + tau;
        return sum > 0 ? rho / sum : -1;
    }

    /** The front's. */
    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        lit(point, true, true, out);
        double r = out.r;
        double g = out.g;
        double b = out.b;
        lit(point, false, true, out);
        out.set(out.r + r, out.g + g, out.b + b);
    }
}
