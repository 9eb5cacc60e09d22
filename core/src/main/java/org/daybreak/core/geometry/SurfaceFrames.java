package org.daybreak.core.geometry;

/** Fills what all samplers fill alike. */
final class SurfaceFrames {
    /**
     * Rounding of positions and of the single-precision traversal, relative to the coordinates: a vertex is off by
     * 2⁻²⁴, a hit by a few times that.
     */
    private static final double RELATIVE_ERROR = 0x1p-20;

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

    /** Offset for all points of a surface within a sphere. */
    static double offset(double centreX, double centreY, double centreZ, double radius) {
        return RELATIVE_ERROR
                * (Math.max(Math.abs(centreX), Math.max(Math.abs(centreY), Math.abs(centreZ))) + radius);
    }

    /** Azimuth of (x, y) as a fraction of the full turn, in [0, 1). */
    static double turn(double x, double y) {
        double turn = Math.atan2(y, x) / (2 * Math.PI);
        return turn >= 0 ? turn : Math.min(turn + 1, Math.nextDown(1.0));
    }
}
