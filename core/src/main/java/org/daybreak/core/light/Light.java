package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * An emitter, ready for sampling in both transport directions. Immutable and thread-safe.
 *
 * <p>All densities are those of this light alone; the probability of choosing the light is the business of
 * {@link LightSelection}. Visibility is the caller's.
 */
public interface Light {
    /** True for lights of zero extent (point, spot, directional): a scattered ray never hits them. */
    boolean isDelta();

    /** True for environment and directional lights: they have no position. */
    boolean isInfinite();

    /** Total emitted power as luminance, in watts; for lights at infinity the power through the disk covering the scene. */
    double power();

    /**
     * Estimate of the irradiance that the light would cause without occlusion at a surface point, or of the fluence
     * if the normal is the zero vector. Used to choose lights; must be positive wherever the light can contribute.
     */
    double importance(double px, double py, double pz, double nx, double ny, double nz);

    /** Where the light is and which way it shines, for a light tree; null for lights at infinity and without area. */
    @Nullable
    EmissionBounds bounds();

    /**
     * Samples a direction towards the light from a reference point (technique s = 1).
     *
     * @return false if no light can arrive from the sample: behind an emitter, outside a cone
     */
    boolean sampleIncident(double px, double py, double pz, double u, double v, LightSample out);

    /**
     * Density per solid angle at the reference point with which {@link #sampleIncident} draws the direction to a point of
     * this light that a ray has hit.
     *
     * @param onLight the hit point; ignored by lights at infinity
     * @param wiX unit direction from the reference point to the light
     */
    double incidentDensity(double px, double py, double pz, SurfacePoint onLight, double wiX, double wiY, double wiZ);

    /**
     * Samples a ray that leaves the light (start of a light subpath).
     *
     * @param u first number for the position, with {@code v}
     * @param s first number for the direction, with {@code t}
     */
    boolean sampleEmission(double u, double v, double s, double t, EmissionSample out);

    /**
     * Densities with which {@link #sampleEmission} draws a given ray.
     *
     * @param onLight origin on the light; for lights at infinity any point on the ray
     * @param dx unit direction of travel, away from the light
     */
    void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out);

    /**
     * Radiance that leaves a point of the light in a unit direction of travel; for lights at infinity the radiance that
     * travels along that direction. Zero for delta lights and on the dark side. For point-like lights use
     * {@link #sampleIncident}.
     */
    void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out);
}
