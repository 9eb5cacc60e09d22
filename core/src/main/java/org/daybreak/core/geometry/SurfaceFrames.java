package org.daybreak.core.geometry;

/** Fills what all samplers fill alike. */
final class SurfaceFrames {
    /** Rounding unit of the single precision that triangles are tested in. */
    private static final double TRIANGLE_ROUNDING = 0x1p-24;

    /** Rounding of the double precision that quadrics are tested in, with room for ill-conditioned maps. */
    private static final double QUADRIC_ROUNDING = 0x1p-40;

    private SurfaceFrames() {}

    /** Sets geometric and shading normal to the same unit vector, and an arbitrary frame around it. */
    static void set(SurfacePoint point, double nx, double ny, double nz) {
        point.gx = nx;
        point.gy = ny;
        point.gz = nz;
        setShading(point, nx, ny, nz);
    }

    /** Sets the shading frame around a unit normal (Duff et al., JCGT 6(1), 2017, as in {@code core.math.Frame}). */
    static void setShading(SurfacePoint point, double nx, double ny, double nz) {
        double sign = Math.copySign(1.0, nz);
        double a = -1 / (sign + nz);
        double b = nx * ny * a;
        point.sx = 1 + sign * nx * nx * a;
        point.sy = sign * b;
        point.sz = -sign * nx;
        point.tx = b;
        point.ty = sign + ny * ny * a;
        point.tz = -ny;
        point.nx = nx;
        point.ny = ny;
        point.nz = nz;
    }

    /**
     * Offset for all points of triangles within a sphere: the bound of {@code core.accel.HitRefinement}, 4 ε of the
     * coordinates and 16 ε of the longest edge along an axis, which is at most the diameter.
     */
    static double triangleOffset(double centreX, double centreY, double centreZ, double radius) {
        return TRIANGLE_ROUNDING * (4 * magnitude(centreX, centreY, centreZ, radius) + 32 * radius);
    }

    /** Offset for all points of quadrics within a sphere: as for triangles, but for the precision. */
    static double quadricOffset(double centreX, double centreY, double centreZ, double radius) {
        return QUADRIC_ROUNDING * (4 * magnitude(centreX, centreY, centreZ, radius) + 32 * radius);
    }

    private static double magnitude(double centreX, double centreY, double centreZ, double radius) {
        return Math.max(Math.abs(centreX), Math.max(Math.abs(centreY), Math.abs(centreZ))) + radius;
    }

    /** Azimuth of (x, y) as a fraction of the full turn, in [0, 1). */
    static double turn(double x, double y) {
        double turn = Math.atan2(y, x) / (2 * Math.PI);
        return turn >= 0 ? turn : Math.min(turn + 1, Math.nextDown(1.0));
    }
}
