package org.daybreak.core.camera;

/**
 * A camera: maps film positions to rays and scene points back to film positions. Immutable and thread-safe.
 *
 * <p>Measurement convention: a pixel's value is the mean of the incident radiance over the film points under its
 * reconstruction filter. So the sensor response is {@code We(lens point, ω)·cos θ = (film area in pixels² per
 * steradian) × (density of the lens point)}, and W·H uniformly drawn film points of a W×H film have density
 * {@code filmPerSolidAngle/(W·H)} per solid angle.
 */
public interface Camera {
    /** Film width in pixels. */
    int width();

    /** Film height in pixels. */
    int height();

    /**
     * The ray for a film position and a lens position.
     *
     * @param filmX film position in pixels, in [0, width]; y grows downwards
     * @param u uniform number in [0,1) for the lens, with {@code v}; unused by a pinhole
     * @return false if the film position sees nothing (outside a fisheye's circle, say)
     */
    boolean sampleRay(double filmX, double filmY, double u, double v, CameraRay out);

    /**
     * Samples a lens point for a scene point and finds the film position of the connecting line.
     *
     * @return false if the point is behind the camera or outside the film
     */
    boolean sampleLens(double px, double py, double pz, double u, double v, LensSample out);

    /**
     * Finds where a ray from the scene hits the lens, and the film position that it goes to (technique t = 0): fills {@code out}
     * as {@link #sampleLens} does when it draws that point of the lens for the ray's origin.
     *
     * @param dx unit direction of the ray
     * @return false if the ray misses the lens, comes from behind, or goes to no point of the film; always false if the lens
     *     {@linkplain #hasLensArea() has no area}
     */
    default boolean hitLens(double ox, double oy, double oz, double dx, double dy, double dz, LensSample out) {
        return false;
    }

    /**
     * Densities with which {@link #sampleRay} (film point uniform over the whole film) draws a given ray; fills the
     * density fields of {@code out} only.
     *
     * @return false if the camera cannot generate the ray
     */
    boolean rayDensity(double ox, double oy, double oz, double dx, double dy, double dz, CameraRay out);

    /** True if the lens has an area, so that paths can hit it and lens samples have a density. */
    boolean hasLensArea();

    /**
     * True if each film position sees along the same direction (orthographic): it is a single one, so light from infinity
     * can only be found from the film, and {@link #rayDensity} knows no density of it.
     */
    default boolean isParallel() {
        return false;
    }
}
