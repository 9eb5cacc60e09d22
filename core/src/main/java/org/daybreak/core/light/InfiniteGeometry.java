package org.daybreak.core.light;

/** What lights at infinity have in common. Pure functions. */
final class InfiniteGeometry {
    private InfiniteGeometry() {}

    /** Density per area of a uniform point of the disk that covers the scene; 0 for an empty scene. */
    static double diskDensity(double sceneRadius) {
        return sceneRadius > 0 ? 1 / (Math.PI * sceneRadius * sceneRadius) : 0;
    }

    /** Sets everything of the sample but its weight. */
    static void arrive(double wiX, double wiY, double wiZ, double density, LightSample out) {
        out.wiX = wiX;
        out.wiY = wiY;
        out.wiZ = wiZ;
        out.distance = Double.POSITIVE_INFINITY;
        out.density = density;
        out.delta = false;
        EmissionDirections.setFree(out.point, 0, 0, 0, -wiX, -wiY, -wiZ);
    }

    /** Sets everything of the sample but its weight, for the direction that it holds. */
    static void start(
            double cx,
            double cy,
            double cz,
            double sceneRadius,
            double u,
            double v,
            double directionDensity,
            EmissionSample out) {
        EmissionDirections.startBefore(cx, cy, cz, sceneRadius, u, v, out);
        out.densityPosition = diskDensity(sceneRadius);
        out.densityDirection = directionDensity;
        out.deltaPosition = false;
        out.deltaDirection = false;
    }
}
