package org.daybreak.core.light;

/** What lights at a single point have in common. Pure functions. */
final class PointGeometry {
    private PointGeometry() {}

    /**
     * Irradiance for unit intensity, or the fluence for a zero normal.
     *
     * @param dx vector from the lit point to the light
     */
    static double irradiance(double dx, double dy, double dz, double nx, double ny, double nz) {
        double squared = dx * dx + dy * dy + dz * dz;
        if (!(squared > 0)) {
            return 0;
        }
        if (nx == 0 && ny == 0 && nz == 0) {
            return 1 / squared;
        }
        return Math.max(0, dx * nx + dy * ny + dz * nz) / (squared * Math.sqrt(squared));
    }

    /** Sets everything of the sample but its weight; returns false if light and lit point coincide. */
    static boolean connect(double x, double y, double z, double px, double py, double pz, LightSample out) {
        double dx = x - px;
        double dy = y - py;
        double dz = z - pz;
        double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (!(distance > 0)) {
            return false;
        }
        out.wiX = dx / distance;
        out.wiY = dy / distance;
        out.wiZ = dz / distance;
        out.distance = distance;
        out.density = 1;
        out.delta = true;
        EmissionDirections.setFree(out.point, x, y, z, -out.wiX, -out.wiY, -out.wiZ);
        return true;
    }

    /** Sets everything of the sample but its weight, for the direction that it holds. */
    static void start(double x, double y, double z, double directionDensity, EmissionSample out) {
        EmissionDirections.setFree(out.point, x, y, z, out.dx, out.dy, out.dz);
        out.densityPosition = 1;
        out.densityDirection = directionDensity;
        out.deltaPosition = true;
        out.deltaDirection = false;
    }
}
