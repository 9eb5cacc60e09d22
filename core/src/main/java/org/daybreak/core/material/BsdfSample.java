package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.sampling.Warps;

/**
 * A sampled scattering direction, or the direction of a given delta lobe. Mutable, owned by one worker; filled by
 * {@link Bsdf#sample} and {@link Bsdf#deltaLobe}.
 */
public final class BsdfSample {
    /** Sampled direction, unit length. Local shading frame as filled by a BSDF; world space after {@link Scattering#sample}. */
    public double wiX;

    public double wiY;
    public double wiZ;

    /**
     * Throughput factor {@code f·|cos θ_i| / density}: what a path's throughput is multiplied with. Finite for delta
     * lobes as well, where it is the lobe's reflectance or transmittance divided by its choice probability; {@link
     * Bsdf#deltaLobe} leaves it undivided.
     */
    public final Spectrum weight = new Spectrum();

    /**
     * Density of the direction per solid angle, over all non-delta lobes together; for a delta lobe the discrete
     * probability of choosing it.
     */
    public double density;

    /** True if the direction comes from a delta lobe: it cannot be connected to and has no density per solid angle. */
    public boolean delta;

    /** Number of the delta lobe, for {@link Bsdf#deltaLobe}; 0 for non-delta lobes and if {@link #passThrough}. */
    public int lobe;

    /** True if the path goes straight on as if there were no surface (alpha masks). Implies {@link #delta}. */
    public boolean passThrough;

    /**
     * Ratio η_i/η_t of the refractive indices of incident-side and transmitted-side medium for refraction (the
     * medium {@code wo} is in over the medium {@code wi} is in), 1 otherwise. Russian roulette uses it to undo the
     * scaling of radiance by refraction.
     */
    public double eta;

    /** Destination of the warps of the square; what implementations leave here means nothing to the caller. */
    final double[] direction = new double[3];

    /** Draws a direction with the density cos θ/π about +z. */
    void setCosineDistributed(double u, double v) {
        Warps.toCosineHemisphere(u, v, direction);
        wiX = direction[0];
        wiY = direction[1];
        wiZ = direction[2];
    }

    /** Sets the direction of ideal reflection. */
    void setMirrored(double woX, double woY, double woZ) {
        wiX = -woX;
        wiY = -woY;
        wiZ = woZ;
    }

    /** Sets the direction that goes straight on. */
    void setStraight(double woX, double woY, double woZ) {
        wiX = -woX;
        wiY = -woY;
        wiZ = -woZ;
    }

    /**
     * Completes a sample from a lobe with a density per solid angle, whose direction is set.
     *
     * @param density what {@link Bsdf#evaluate} returns for the direction, having written its value into {@link #weight}
     * @param eta as for {@link #eta}
     * @return false if the density is 0, as rounding may have it: there is nothing to go on with
     */
    boolean complete(double density, double eta) {
        if (density == 0) {
            return false;
        }
        setContinuous(density);
        this.eta = eta;
        // Division, as the reciprocal of a subnormal density is infinite.
        weight.set(weight.r / density, weight.g / density, weight.b / density);
        return true;
    }

    /** Marks the sample as drawn from a lobe with a density per solid angle that does not refract. */
    void setContinuous(double density) {
        this.density = density;
        delta = false;
        lobe = 0;
        passThrough = false;
        eta = 1;
    }

    /** Marks the sample as drawn from a delta lobe. */
    void setDelta(int lobe, double probability, double eta) {
        this.density = probability;
        delta = true;
        this.lobe = lobe;
        passThrough = false;
        this.eta = eta;
    }

    /** Marks the sample as going straight on as if there were no surface, and sets its direction and weight. */
    void setPassThrough(double woX, double woY, double woZ, double probability) {
        setStraight(woX, woY, woZ);
        weight.set(1);
        setDelta(0, probability, 1);
        passThrough = true;
    }

    /**
     * Turns the sample of a delta lobe into the lobe itself: {@link #weight} becomes its reflectance or transmittance.
     *
     * @return false if the lobe is black
     */
    boolean undoChoice() {
        weight.scale(density);
        return density > 0 && !weight.isBlack();
    }
}
