package org.daybreak.core.light;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.Warps;

/** Directions and disks around an axis, written to emission samples. */
final class EmissionDirections {
    private EmissionDirections() {}

    /**
     * Sets a direction with density cos/π around a unit normal.
     *
     * @return the cosine to the normal, positive
     */
    static double cosineWeighted(double nx, double ny, double nz, double s, double t, EmissionSample out) {
        double[] local = out.scratch;
        Warps.toCosineHemisphere(s, t, local);
        double cosine = local[2];
        around(nx, ny, nz, local);
        out.dx = local[0];
        out.dy = local[1];
        out.dz = local[2];
        return cosine;
    }

    /** Replaces local coordinates by those of the world, for an arbitrary frame with the given unit normal. */
    static void around(double nx, double ny, double nz, double[] vector) {
        double x = vector[0];
        double y = vector[1];
        double z = vector[2];
        double sign = Math.copySign(1.0, nz);
        double a = -1 / (sign + nz);
        double b = nx * ny * a;
        vector[0] = x * (1 + sign * nx * nx * a) + y * b + z * nx;
        vector[1] = x * sign * b + y * (sign + ny * ny * a) + z * ny;
        vector[2] = -x * sign * nx - y * ny + z * nz;
    }

    /**
     * Sets the origin of a ray from infinity: uniform on the disk across the ray that covers a sphere, one radius before its
     * centre. The direction of travel must be set.
     */
    static void startBefore(double cx, double cy, double cz, double radius, double u, double v, EmissionSample out) {
        double[] local = out.scratch;
        Warps.toConcentricDisk(u, v, local);
        local[0] *= radius;
        local[1] *= radius;
        local[2] = -radius;
        around(out.dx, out.dy, out.dz, local);
        setFree(out.point, cx + local[0], cy + local[1], cz + local[2], out.dx, out.dy, out.dz);
    }

    /** Sets a point in free space that faces a direction. */
    static void setFree(SurfacePoint point, double x, double y, double z, double gx, double gy, double gz) {
        point.x = x;
        point.y = y;
        point.z = z;
        point.gx = gx;
        point.gy = gy;
        point.gz = gz;
        point.offset = 0;
        point.shape = -1;
        point.primitive = -1;
        point.instance = -1;
    }
}
