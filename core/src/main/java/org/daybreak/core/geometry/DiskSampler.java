package org.daybreak.core.geometry;

import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.Warps;

/** The unit disk under an affine map: an ellipse, sampled uniformly by area. */
final class DiskSampler implements SurfaceSampler {
    /** The estimate of the irradiance from the centre alone is good from this many radii away. */
    private static final double SQUARED_MIDDLE = 3 * 3;

    /** Half the side of the square with the area of the unit disk. */
    private static final double EQUAL_SQUARE = Math.sqrt(Math.PI) / 2;

    private final Transform toWorld;
    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final double ax;
    private final double ay;
    private final double az;
    private final double bx;
    private final double by;
    private final double bz;
    private final double normalX;
    private final double normalY;
    private final double normalZ;
    private final double squaredRadius;
    private final double area;
    private final double offset;

    DiskSampler(Transform toWorld, boolean flipNormals) {
        this.toWorld = toWorld;
        double[] d = new double[3];
        toWorld.applyPoint(0, 0, 0, d);
        centreX = d[0];
        centreY = d[1];
        centreZ = d[2];
        toWorld.applyVector(1, 0, 0, d);
        ax = d[0];
        ay = d[1];
        az = d[2];
        toWorld.applyVector(0, 1, 0, d);
        bx = d[0];
        by = d[1];
        bz = d[2];
        double kx = ay * bz - az * by;
        double ky = az * bx - ax * bz;
        double kz = ax * by - ay * bx;
        double cross = Math.sqrt(kx * kx + ky * ky + kz * kz);
        area = Math.PI * cross;
        double side = toWorld.isMirroring() != flipNormals ? -1 : 1;
        normalX = side * kx / cross;
        normalY = side * ky / cross;
        normalZ = side * kz / cross;
        squaredRadius = squaredLongestRadius(ax, ay, az, bx, by, bz);
        offset = SurfaceFrames.quadricOffset(centreX, centreY, centreZ, Math.sqrt(squaredRadius));
    }

    /** Square of the longer half-axis of the ellipse a·cos φ + b·sin φ. */
    static double squaredLongestRadius(double ax, double ay, double az, double bx, double by, double bz) {
        double aa = ax * ax + ay * ay + az * az;
        double bb = bx * bx + by * by + bz * bz;
        double ab = ax * bx + ay * by + az * bz;
        double half = 0.5 * (aa - bb);
        return 0.5 * (aa + bb) + Math.sqrt(half * half + ab * ab);
    }

    @Override
    public double area() {
        return area;
    }

    @Override
    public double sampleArea(double u, double v, SurfacePoint out) {
        Warps.toConcentricDisk(u, v, out.scratch);
        double a = out.scratch[0];
        double b = out.scratch[1];
        out.x = centreX + a * ax + b * bx;
        out.y = centreY + a * ay + b * by;
        out.z = centreZ + a * az + b * bz;
        SurfaceFrames.set(out, normalX, normalY, normalZ);
        out.offset = offset;
        out.primitive = 0;
        return 1 / area;
    }

    @Override
    public double areaDensity(SurfacePoint on) {
        return 1 / area;
    }

    @Override
    public void setTextureCoordinates(SurfacePoint point) {
        double[] p = point.scratch;
        toWorld.applyInversePoint(point.x, point.y, point.z, p);
        point.u = Math.min(1, Math.sqrt(p[0] * p[0] + p[1] * p[1]));
        point.v = SurfaceFrames.turn(p[0], p[1]);
        point.setNoAttributes();
    }

    @Override
    public double irradiance(double px, double py, double pz, double nx, double ny, double nz) {
        double dx = centreX - px;
        double dy = centreY - py;
        double dz = centreZ - pz;
        double height = -(dx * normalX + dy * normalY + dz * normalZ);
        if (!(height > 0)) {
            return 0;
        }
        double squaredDistance = dx * dx + dy * dy + dz * dz;
        double receiver = Irradiance.receiver(dx, dy, dz, squaredDistance, squaredRadius, nx, ny, nz);
        if (receiver == 0) {
            return 0;
        }
        if (squaredDistance < SQUARED_MIDDLE * squaredRadius) {
            // Seen as a parallelogram of the same area. The floor is for what of the disk lies outside of that.
            double e = EQUAL_SQUARE;
            double parallelogram = Irradiance.parallelogram(
                    dx - e * (ax + bx),
                    dy - e * (ay + by),
                    dz - e * (az + bz),
                    2 * e * ax,
                    2 * e * ay,
                    2 * e * az,
                    2 * e * bx,
                    2 * e * by,
                    2 * e * bz,
                    nx,
                    ny,
                    nz);
            return Math.max(parallelogram, 1e-3 * Math.min(Math.PI, area / squaredDistance) * receiver);
        }
        return receiver * area * height / (squaredDistance * Math.sqrt(squaredDistance));
    }

    @Override
    public EmissionBounds bounds() {
        double x = Math.sqrt(ax * ax + bx * bx);
        double y = Math.sqrt(ay * ay + by * by);
        double z = Math.sqrt(az * az + bz * bz);
        Bounds box = new Bounds(centreX - x, centreY - y, centreZ - z, centreX + x, centreY + y, centreZ + z);
        return new EmissionBounds(box, normalX, normalY, normalZ, 0, Math.PI / 2, area);
    }
}
