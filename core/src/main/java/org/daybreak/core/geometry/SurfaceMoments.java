package org.daybreak.core.geometry;

/**
 * What of a surface matters from afar: its area, how much of it faces which way, and a sphere around it. Immutable.
 *
 * <p>The area a surface turns to a direction w is ½(∫|n·w| dA + w·∫n dA). By Jensen's inequality, the first integral is
 * at most √(A·wᵀ(∫n nᵀ dA)w): exact for planar surfaces and 15 % too much for spheres.
 */
final class SurfaceMoments {
    private final double area;
    private final double vx;
    private final double vy;
    private final double vz;
    private final double nxx;
    private final double nyy;
    private final double nzz;
    private final double nxy;
    private final double nxz;
    private final double nyz;
    private final boolean planar;

    private final double cx;
    private final double cy;
    private final double cz;
    private final double radius;

    private SurfaceMoments(Builder b, double cx, double cy, double cz, double radius) {
        area = b.area;
        vx = b.vx;
        vy = b.vy;
        vz = b.vz;
        nxx = b.nxx;
        nyy = b.nyy;
        nzz = b.nzz;
        nxy = b.nxy;
        nxz = b.nxz;
        nyz = b.nyz;
        planar = Math.sqrt(vx * vx + vy * vy + vz * vz) >= area * (1 - 1e-12);
        this.cx = cx;
        this.cy = cy;
        this.cz = cz;
        this.radius = radius;
    }

    double area() {
        return area;
    }

    /** Estimate as {@link SurfaceSampler#irradiance} defines it. */
    double irradiance(double px, double py, double pz, double nx, double ny, double nz) {
        double dx = cx - px;
        double dy = cy - py;
        double dz = cz - pz;
        double squaredDistance = dx * dx + dy * dy + dz * dz;
        double facing = 0;
        if (squaredDistance > 0) {
            double square = area
                    * (nxx * dx * dx
                            + nyy * dy * dy
                            + nzz * dz * dz
                            + 2 * (nxy * dx * dy + nxz * dx * dz + nyz * dy * dz));
            facing = 0.5 * (Math.sqrt(Math.max(0, square)) - vx * dx - vy * dy - vz * dz) / Math.sqrt(squaredDistance);
        }
        return irradiance(px, py, pz, nx, ny, nz, facing);
    }

    /**
     * Estimate of a surface that knows better what it turns to a point.
     *
     * @param facing area that the front turns to the direction from the centre to the point
     */
    double irradiance(double px, double py, double pz, double nx, double ny, double nz, double facing) {
        double dx = cx - px;
        double dy = cy - py;
        double dz = cz - pz;
        double squaredDistance = dx * dx + dy * dy + dz * dz;
        double squaredRadius = radius * radius;
        double receiver = Irradiance.receiver(dx, dy, dz, squaredDistance, squaredRadius, nx, ny, nz);
        if (receiver == 0) {
            return 0;
        }
        // From nearby, parts are seen that turn away from the direction of the centre.
        double nearness = Math.min(1, radius / Math.sqrt(squaredDistance));
        double seen = Math.max(facing, (planar ? 1e-3 : 0.1) * nearness * area);
        // Nothing fills more than the hemisphere, or the whole sphere of directions for the fluence.
        boolean fluence = nx == 0 && ny == 0 && nz == 0;
        double limit = fluence ? 4 * Math.PI : Math.PI;
        return receiver * Math.min(limit, seen / squaredDistance);
    }

    /** Adds up patches. */
    static final class Builder {
        private double area;
        private double vx;
        private double vy;
        private double vz;
        private double nxx;
        private double nyy;
        private double nzz;
        private double nxy;
        private double nxz;
        private double nyz;

        /** Adds a flat patch with a unit normal. */
        void add(double patchArea, double nx, double ny, double nz) {
            area += patchArea;
            vx += patchArea * nx;
            vy += patchArea * ny;
            vz += patchArea * nz;
            nxx += patchArea * nx * nx;
            nyy += patchArea * ny * ny;
            nzz += patchArea * nz * nz;
            nxy += patchArea * nx * ny;
            nxz += patchArea * nx * nz;
            nyz += patchArea * ny * nz;
        }

        /** Ends with a sphere that holds the surface. */
        SurfaceMoments build(double cx, double cy, double cz, double radius) {
            return new SurfaceMoments(this, cx, cy, cz, radius);
        }
    }
}
