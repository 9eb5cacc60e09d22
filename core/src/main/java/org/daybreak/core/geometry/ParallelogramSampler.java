package org.daybreak.core.geometry;

import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;

/**
 * The square [−1,1]² under an affine map. If that leaves it a rectangle, nearby points see it sampled uniformly by solid
 * angle, which makes the estimate of direct light from it free of the noise of distance and emitter cosine.
 */
final class ParallelogramSampler implements SurfaceSampler {
    /** Edges whose cosine is at most this count as perpendicular: rounding of matrices in scene files. */
    private static final double RIGHT_ANGLE = 1e-5;

    /** From this many radii away the integrand varies by less than a tenth, so cheap sampling by area is as good. */
    private static final double SQUARED_FAR = 4;

    /** The estimate of the irradiance from the centre alone is good from this many radii away. */
    private static final double SQUARED_MIDDLE = 3 * 3;

    /** Below this solid angle its rounding error, about 1e-15, would show in the density. */
    private static final double LEAST_SOLID_ANGLE = 1e-7;

    private final double cornerX;
    private final double cornerY;
    private final double cornerZ;
    private final double ax;
    private final double ay;
    private final double az;
    private final double bx;
    private final double by;
    private final double bz;
    private final double lengthA;
    private final double lengthB;
    private final double normalX;
    private final double normalY;
    private final double normalZ;
    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final double squaredRadius;
    private final double area;
    private final boolean rectangular;
    private final double offset;

    ParallelogramSampler(Transform toWorld, boolean flipNormals) {
        double[] d = new double[3];
        toWorld.applyPoint(-1, -1, 0, d);
        cornerX = d[0];
        cornerY = d[1];
        cornerZ = d[2];
        toWorld.applyVector(2, 0, 0, d);
        ax = d[0];
        ay = d[1];
        az = d[2];
        toWorld.applyVector(0, 2, 0, d);
        bx = d[0];
        by = d[1];
        bz = d[2];
        lengthA = Math.sqrt(ax * ax + ay * ay + az * az);
        lengthB = Math.sqrt(bx * bx + by * by + bz * bz);
        double kx = ay * bz - az * by;
        double ky = az * bx - ax * bz;
        double kz = ax * by - ay * bx;
        area = Math.sqrt(kx * kx + ky * ky + kz * kz);
        double side = toWorld.isMirroring() != flipNormals ? -1 : 1;
        normalX = side * kx / area;
        normalY = side * ky / area;
        normalZ = side * kz / area;
        double dot = ax * bx + ay * by + az * bz;
        rectangular = Math.abs(dot) <= RIGHT_ANGLE * lengthA * lengthB;
        centreX = cornerX + 0.5 * (ax + bx);
        centreY = cornerY + 0.5 * (ay + by);
        centreZ = cornerZ + 0.5 * (az + bz);
        squaredRadius = 0.25 * (lengthA * lengthA + lengthB * lengthB) + 0.5 * Math.abs(dot);
        offset = SurfaceFrames.triangleOffset(centreX, centreY, centreZ, Math.sqrt(squaredRadius));
    }

    @Override
    public double area() {
        return area;
    }

    @Override
    public double sampleArea(double u, double v, SurfacePoint out) {
        fill(u, v, out);
        return 1 / area;
    }

    @Override
    public double areaDensity(SurfacePoint on) {
        return 1 / area;
    }

    @Override
    public double sampleDirection(double px, double py, double pz, double u, double v, SurfacePoint out) {
        double dx = cornerX - px;
        double dy = cornerY - py;
        double dz = cornerZ - pz;
        double height = -(dx * normalX + dy * normalY + dz * normalZ);
        if (!(height > 0)) {
            return 0;
        }
        if (bySolidAngle(px, py, pz)) {
            double x0 = (dx * ax + dy * ay + dz * az) / lengthA;
            double y0 = (dx * bx + dy * by + dz * bz) / lengthB;
            double x1 = x0 + lengthA;
            double y1 = y0 + lengthB;
            double[] work = out.scratch;
            double solidAngle = SphericalRectangles.solidAngle(x0, x1, y0, y1, height, work);
            if (solidAngle > LEAST_SOLID_ANGLE) {
                double x = SphericalRectangles.sampleX(u, solidAngle, x0, x1, height, work);
                double y = SphericalRectangles.sampleY(v, x, y0, y1, height);
                fill((x - x0) / lengthA, (y - y0) / lengthB, out);
                return 1 / solidAngle;
            }
        }
        fill(u, v, out);
        return SurfaceSampler.perSolidAngle(1 / area, px, py, pz, out);
    }

    @Override
    public double directionDensity(
            double px, double py, double pz, SurfacePoint on, double wiX, double wiY, double wiZ) {
        double dx = cornerX - px;
        double dy = cornerY - py;
        double dz = cornerZ - pz;
        double height = -(dx * normalX + dy * normalY + dz * normalZ);
        if (!(height > 0)) {
            return 0;
        }
        if (bySolidAngle(px, py, pz)) {
            double x0 = (dx * ax + dy * ay + dz * az) / lengthA;
            double y0 = (dx * bx + dy * by + dz * bz) / lengthB;
            double solidAngle = SphericalRectangles.solidAngle(x0, x0 + lengthA, y0, y0 + lengthB, height, on.scratch);
            if (solidAngle > LEAST_SOLID_ANGLE) {
                return 1 / solidAngle;
            }
        }
        return SurfaceSampler.super.directionDensity(px, py, pz, on, wiX, wiY, wiZ);
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
        if (squaredDistance < SQUARED_MIDDLE * squaredRadius) {
            return Irradiance.parallelogram(
                    cornerX - px, cornerY - py, cornerZ - pz, ax, ay, az, bx, by, bz, nx, ny, nz);
        }
        return Irradiance.receiver(dx, dy, dz, squaredDistance, squaredRadius, nx, ny, nz)
                * area
                * height
                / (squaredDistance * Math.sqrt(squaredDistance));
    }

    @Override
    public EmissionBounds bounds() {
        Bounds.Builder box = new Bounds.Builder();
        for (int corner = 0; corner < 4; corner++) {
            double a = corner & 1;
            double b = corner >> 1;
            box.include(cornerX + a * ax + b * bx, cornerY + a * ay + b * by, cornerZ + a * az + b * bz);
        }
        return new EmissionBounds(box.build(), normalX, normalY, normalZ, 0, Math.PI / 2, area);
    }

    /** True if the point is so near that directions are drawn uniformly by solid angle. */
    boolean bySolidAngle(double px, double py, double pz) {
        double x = centreX - px;
        double y = centreY - py;
        double z = centreZ - pz;
        return rectangular && x * x + y * y + z * z < SQUARED_FAR * squaredRadius;
    }

    /** Sets the point at texture coordinates. */
    void fill(double u, double v, SurfacePoint out) {
        out.x = cornerX + u * ax + v * bx;
        out.y = cornerY + u * ay + v * by;
        out.z = cornerZ + u * az + v * bz;
        SurfaceFrames.set(out, normalX, normalY, normalZ);
        out.u = u;
        out.v = v;
        out.setNoAttributes();
        out.offset = offset;
        out.primitive = 0;
    }
}
