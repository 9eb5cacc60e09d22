package org.daybreak.core.math;

/**
 * Conversion of probability densities between surface area and solid angle. No other code converts.
 *
 * <p>With x the point that sees the surface, x′ the point on it, r = ‖x′ − x‖ and θ′ the angle between the surface
 * normal at x′ and the direction to x: dω = |cos θ′| / r² dA (Veach 1997, eq. 8.2).
 */
public final class Densities {
    private Densities() {}

    /**
     * Density per solid angle at x of a point that was sampled with a density per area at x′.
     *
     * @param densityPerArea density at x′, per unit of surface area
     * @param squaredDistance r²
     * @param cosine cos θ′; the sign is ignored
     * @return density per steradian; 0 for a surface seen exactly edge-on, which no direction reaches
     */
    public static double areaToSolidAngle(double densityPerArea, double squaredDistance, double cosine) {
        return cosine == 0 ? 0 : densityPerArea * squaredDistance / Math.abs(cosine);
    }

    /**
     * Density per area at x′ of a point that was found by sampling a direction at x.
     *
     * @param densityPerSolidAngle density of the direction at x, per steradian
     * @param squaredDistance r², positive
     * @param cosine cos θ′; the sign is ignored
     * @return density per unit of surface area
     */
    public static double solidAngleToArea(double densityPerSolidAngle, double squaredDistance, double cosine) {
        return densityPerSolidAngle * Math.abs(cosine) / squaredDistance;
    }
}
