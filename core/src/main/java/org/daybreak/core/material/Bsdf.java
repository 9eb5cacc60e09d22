package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * A bidirectional scattering distribution function: the material of a surface. Immutable and thread-safe.
 *
 * <p>Directions are unit vectors in the local shading frame of the point, z along the shading normal; both point away
 * from the surface. {@code wo} is where the walk came from, {@code wi} where it goes on. The caller deals with
 * geometric normals ({@link Scattering}); implementations see shading frames only.
 *
 * <p>Contracts, all tested: {@code f > 0} implies {@code density > 0} in both directions; for non-delta lobes
 * {@code sample} draws from exactly the density that {@code evaluate} and {@code density} report;
 * f·cos/density equals the sampled weight; energy ≤ 1;
 * symmetric in wo, wi but for refraction, where f(wo,wi)·η_o⁻² = f(wi,wo)·η_i⁻² in {@link TransportMode#RADIANCE}
 * (Veach 1997, eq. 5.14). Delta lobes keep to the same: {@link #deltaLobe} reports what {@code sample} draws, and a lobe
 * leads back by its own number, with W(wo→wi) in RADIANCE equal to eta²·W(wi→wo) in IMPORTANCE, times
 * |wo·m| |wi·n| / (|wo·n| |wi·m|) if a map tilts the normal n to m.
 */
public interface Bsdf {
    /**
     * True if some lobe has a density per solid angle, so that vertices of this material can be connected to lights,
     * the lens or other subpaths. Assumed unless a material knows better.
     */
    default boolean connectable() {
        return true;
    }

    /** True if all that this material scatters goes by delta lobes, and it scatters: an ideal mirror, or glass. */
    default boolean scattersByDeltasOnly() {
        return !connectable() && deltaLobes() > 0;
    }

    /**
     * True if some lobe, other than passing straight through a mask, scatters light to the other side of the surface.
     */
    default boolean transmissive() {
        return false;
    }

    /**
     * Evaluates all non-delta lobes for a pair of directions.
     *
     * @param point the surface point, for textures
     * @param mode what the walk that arrived along {@code wo} carries
     * @param value receives {@code f(wo, wi)·|cos θ_i|} in 1/sr; zero where there is no scattering
     * @return the density per solid angle with which {@link #sample} draws {@code wi} given {@code wo}; choice
     *     probabilities of lobes included
     */
    double evaluate(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode,
            Spectrum value);

    /**
     * Density per solid angle with which {@link #sample} draws {@code wi} given {@code wo}, as {@link #evaluate} returns
     * it. Called with the directions swapped it is the reverse density that bidirectional weights need.
     */
    double density(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode);

    /**
     * Samples a direction to go on with.
     *
     * @param u first uniform number in [0,1), used with {@code v} for the direction
     * @param v second uniform number in [0,1)
     * @param w third uniform number in [0,1), chooses the lobe
     * @param out receives direction, weight, density and kind; its content is undefined if the result is false
     * @return false if the walk ends here (absorbed, or a direction below the surface was drawn)
     */
    boolean sample(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double u,
            double v,
            double w,
            TransportMode mode,
            BsdfSample out);

    /**
     * Number of delta lobes that the material may have anywhere, from either side. They are numbered from 0; passing straight
     * through a mask ({@link BsdfSample#passThrough}) is none of them.
     */
    default int deltaLobes() {
        return 0;
    }

    /**
     * Follows a given delta lobe, where {@link #sample} would draw one. A lobe that leads from wo to wi leads from wi to wo as
     * well, under the same number.
     *
     * @param lobe number of the lobe, not negative, as {@link BsdfSample#lobe} reports it; there is none from
     *     {@link #deltaLobes} on
     * @param mode what the walk that arrived along {@code wo} carries
     * @param out receives what {@code sample} reports of this lobe, but in {@link BsdfSample#weight} its reflectance or
     *     transmittance W itself, not divided by the probability of choosing it, which is {@link BsdfSample#density}; its
     *     content is undefined if the result is false
     * @return false if nothing goes this way: total internal reflection, the wrong side, a lobe that is black or no delta
     *     here
     */
    default boolean deltaLobe(
            SurfacePoint point, double woX, double woY, double woZ, int lobe, TransportMode mode, BsdfSample out) {
        return false;
    }

    /**
     * Fraction in [0,1] of light that passes straight through at this point as if there were no surface: 1 − opacity of
     * an alpha mask, 0 for ordinary materials. Occlusion queries multiply with it.
     */
    default double transparency(SurfacePoint point) {
        return 0;
    }

    /** True if {@link #transparency} can be greater than zero anywhere. */
    default boolean maybeTransparent() {
        return false;
    }

    /**
     * True if the material depends on where on the surface a point is, so that texture coordinates must be computed. Assumed
     * unless a material knows better.
     */
    default boolean textured() {
        return true;
    }

    /**
     * Whether the material tells directions around the normal apart, so that the shading frame must lie along texture
     * coordinates ({@link SurfacePoint#sx}) and the derivatives {@link SurfacePoint#uAlongS} and following must be there.
     */
    default TangentFrame tangentFrame() {
        return TangentFrame.ARBITRARY;
    }

    /**
     * True if scattering follows another normal than that of the shading frame anywhere, as with normal and bump maps: the
     * derivative of the normal is then not that of the surface.
     */
    default boolean tiltsNormal() {
        return false;
    }

    /**
     * True if {@link #sample} reads its number {@code w}. Callers may save themselves a random number otherwise.
     */
    default boolean choosesLobe() {
        return true;
    }

    /** Approximate directional-hemispherical reflectance plus transmittance for {@code wo} at the normal: the albedo image. */
    void albedo(SurfacePoint point, Spectrum out);
}
