package org.daybreak.core.geometry;

import org.daybreak.core.math.Densities;
import org.jspecify.annotations.Nullable;

/**
 * A surface in world space that points can be drawn from: the shape of an area light. Immutable and thread-safe.
 *
 * <p>The surface has a front, the side its geometric normal points to. Points are drawn by area, or by the direction in
 * which a reference point sees them. From where only the back is seen, drawing by direction may fail.
 *
 * <p>Drawn points carry position, geometric normal, shading frame, offset and primitive. Their texture coordinates may
 * be missing until {@link #setTextureCoordinates} is called, as most lights do not need them and they can cost more
 * than the rest. Shape and instance are left to the caller.
 */
public interface SurfaceSampler {
    /** Area in world units squared; 0 if all of the surface is degenerate. */
    double area();

    /**
     * Draws a point from the whole surface.
     *
     * @param u uniform number in [0,1), with {@code v}
     * @param out receives the point
     * @return density per area at the point; 0 if the surface has no area, and then {@code out} is undefined
     */
    double sampleArea(double u, double v, SurfacePoint out);

    /** Density per area with which {@link #sampleArea} draws a point of this surface. */
    double areaDensity(SurfacePoint on);

    /**
     * Draws a point of the surface as seen from a reference point. Visibility is not regarded.
     *
     * @param u uniform number in [0,1), with {@code v}
     * @param out receives the point
     * @return density of the direction to the point per solid angle at the reference point; 0 on failure: no point, or
     *     one that turns its back
     */
    default double sampleDirection(double px, double py, double pz, double u, double v, SurfacePoint out) {
        double perArea = sampleArea(u, v, out);
        return perArea > 0 ? perSolidAngle(perArea, px, py, pz, out) : 0;
    }

    /**
     * Density per solid angle at the reference point with which {@link #sampleDirection} draws the direction to a point
     * of this surface; 0 if the point turns its back.
     *
     * @param wiX unit direction from the reference point to the point on the surface
     */
    default double directionDensity(
            double px, double py, double pz, SurfacePoint on, double wiX, double wiY, double wiZ) {
        double cosine = -on.geometricCosine(wiX, wiY, wiZ);
        return cosine > 0 ? Densities.areaToSolidAngle(areaDensity(on), squaredDistance(px, py, pz, on), cosine) : 0;
    }

    /** Completes a point that this sampler has drawn by its texture coordinates. */
    default void setTextureCoordinates(SurfacePoint point) {}

    /**
     * Estimate of the irradiance that unit radiance from the front of the whole surface would cause at a point without
     * occlusion; of the fluence, if the normal is the zero vector. Positive wherever some of the front is seen above
     * the horizon.
     */
    double irradiance(double px, double py, double pz, double nx, double ny, double nz);

    /** Where the surface is and which way it faces, with the intensity of unit radiance; null if it has no area. */
    @Nullable
    EmissionBounds bounds();

    /**
     * Converts a density per area at a drawn point to one per solid angle at the reference point; 0 if the point turns
     * its back.
     */
    static double perSolidAngle(double densityPerArea, double px, double py, double pz, SurfacePoint on) {
        double dx = px - on.x;
        double dy = py - on.y;
        double dz = pz - on.z;
        double projected = dx * on.gx + dy * on.gy + dz * on.gz;
        if (!(projected > 0)) {
            return 0;
        }
        double squared = dx * dx + dy * dy + dz * dz;
        return Densities.areaToSolidAngle(densityPerArea, squared, projected / Math.sqrt(squared));
    }

    private static double squaredDistance(double px, double py, double pz, SurfacePoint on) {
        double dx = on.x - px;
        double dy = on.y - py;
        double dz = on.z - pz;
        return dx * dx + dy * dy + dz * dz;
    }
}
