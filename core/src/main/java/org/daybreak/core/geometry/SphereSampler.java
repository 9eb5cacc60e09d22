package org.daybreak.core.geometry;

import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.daybreak.core.math.Turns;
import org.daybreak.core.sampling.Warps;

/**
 * The unit sphere under an affine map. From outside, the cone of directions that meet it is sampled uniformly in object
 * space; the map of directions to world space has the density factor |M d|³ / |det M| (1 for similarities). From inside,
 * which matters to flipped spheres only, object-space area is sampled.
 */
final class SphereSampler implements SurfaceSampler {
    private static final double UNIT_SPHERE_AREA = 4 * Math.PI;

    private final Transform toWorld;
    private final boolean flipNormals;
    private final double side;
    private final boolean similarity;
    private final double centreX;
    private final double centreY;
    private final double centreZ;
    /** |det M|. */
    private final double volume;
    /** Rows of the inverse matrix. */
    private final double[] inverse;

    /** Largest stretch of M: the radius of the bounding sphere. */
    private final double radius;

    private final double area;
    private final double offset;

    SphereSampler(Transform toWorld, boolean flipNormals) {
        this.toWorld = toWorld;
        this.flipNormals = flipNormals;
        side = flipNormals ? -1 : 1;
        double[] d = new double[3];
        toWorld.applyPoint(0, 0, 0, d);
        centreX = d[0];
        centreY = d[1];
        centreZ = d[2];
        double[] m = toWorld.rows();
        volume = Math.abs(LinearMaps.determinant(m));
        similarity = LinearMaps.isSimilarity(m);
        inverse = toWorld.inverse().rows();
        radius = similarity ? Math.cbrt(volume) : LinearMaps.largestStretch(m);
        area = similarity ? UNIT_SPHERE_AREA * radius * radius : quadrature();
        offset = SurfaceFrames.quadricOffset(centreX, centreY, centreZ, radius);
    }

    @Override
    public double area() {
        return area;
    }

    @Override
    public double sampleArea(double u, double v, SurfacePoint out) {
        double[] n = out.scratch;
        Warps.toUniformSphere(u, v, n);
        double stretch = fill(n[0], n[1], n[2], out);
        return 1 / (UNIT_SPHERE_AREA * stretch);
    }

    @Override
    public double areaDensity(SurfacePoint on) {
        if (similarity) {
            return 1 / area;
        }
        double[] n = on.scratch;
        toWorld.applyInversePoint(on.x, on.y, on.z, n);
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        return 1 / (UNIT_SPHERE_AREA * stretch(n[0] / length, n[1] / length, n[2] / length, n));
    }

    @Override
    public double sampleDirection(double px, double py, double pz, double u, double v, SurfacePoint out) {
        double[] p = out.scratch;
        toWorld.applyInversePoint(px, py, pz, p);
        double squaredDistance = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
        if (flipNormals) {
            return SurfaceSampler.super.sampleDirection(px, py, pz, u, v, out);
        }
        if (!(squaredDistance > 1)) {
            return 0;
        }
        // Outside: uniform in the cone. The sine of the angle at the centre follows from that at the point by the
        // lateral
        // distance of the surface point from the axis, with the distance along the ray from Vieta's formula: no
        // difference of nearly equal numbers anywhere.
        double distance = Math.sqrt(squaredDistance);
        double least = oneMinusCosine(squaredDistance);
        double t = u * least;
        double squaredSine = t * (2 - t);
        double root = Math.sqrt(Math.max(0, 1 - squaredDistance * squaredSine));
        double along = (distance - 1) * (distance + 1) / (distance * (1 - t) + root);
        double sine = Math.min(1, along * Math.sqrt(squaredSine));
        double cosine = Math.sqrt((1 - sine) * (1 + sine));
        double x = sine * Turns.cos(v);
        double y = sine * Turns.sin(v);
        double wx = p[0] / distance;
        double wy = p[1] / distance;
        double wz = p[2] / distance;
        double sign = Math.copySign(1.0, wz);
        double a = -1 / (sign + wz);
        double b = wx * wy * a;
        double nx = x * (1 + sign * wx * wx * a) + y * b + cosine * wx;
        double ny = x * sign * b + y * (sign + wy * wy * a) + cosine * wy;
        double nz = -x * sign * wx - y * wy + cosine * wz;
        double px0 = p[0];
        double py0 = p[1];
        double pz0 = p[2];
        fill(nx, ny, nz, out);
        double density = 1 / (2 * Math.PI * least);
        return similarity ? density : density * directionStretch(nx - px0, ny - py0, nz - pz0, out.scratch);
    }

    @Override
    public double directionDensity(
            double px, double py, double pz, SurfacePoint on, double wiX, double wiY, double wiZ) {
        if (flipNormals) {
            return SurfaceSampler.super.directionDensity(px, py, pz, on, wiX, wiY, wiZ);
        }
        double[] p = on.scratch;
        toWorld.applyInversePoint(px, py, pz, p);
        double squaredDistance = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
        if (!(squaredDistance > 1) || !(on.geometricCosine(wiX, wiY, wiZ) < 0)) {
            return 0;
        }
        double density = 1 / (2 * Math.PI * oneMinusCosine(squaredDistance));
        if (similarity) {
            return density;
        }
        toWorld.applyInverseVector(wiX, wiY, wiZ, p);
        return density * directionStretch(p[0], p[1], p[2], p);
    }

    @Override
    public void setTextureCoordinates(SurfacePoint point) {
        double[] p = point.scratch;
        toWorld.applyInversePoint(point.x, point.y, point.z, p);
        point.u = SurfaceFrames.turn(p[0], p[1]);
        point.v = Math.atan2(Math.sqrt(p[0] * p[0] + p[1] * p[1]), p[2]) / Math.PI;
        point.setNoAttributes();
    }

    @Override
    public double irradiance(double px, double py, double pz, double nx, double ny, double nz) {
        double dx = centreX - px;
        double dy = centreY - py;
        double dz = centreZ - pz;
        double squaredDistance = dx * dx + dy * dy + dz * dz;
        double squaredRadius = radius * radius;
        boolean fluence = nx == 0 && ny == 0 && nz == 0;
        if (flipNormals && !(squaredDistance > squaredRadius)) {
            // From within a sphere that faces inwards, every direction is bright.
            return fluence ? 4 * Math.PI : Math.PI;
        }
        double receiver = Irradiance.receiver(dx, dy, dz, squaredDistance, squaredRadius, nx, ny, nz);
        if (similarity) {
            if (!(squaredDistance > squaredRadius)) {
                return 0;
            }
            double squaredSine = squaredRadius / squaredDistance;
            return fluence
                    ? 2 * Math.PI * squaredSine / (1 + Math.sqrt(1 - squaredSine))
                    : Math.PI * squaredSine * receiver;
        }
        if (!(squaredDistance > 0)) {
            return 0;
        }
        // The parallel projection of the ellipsoid along a unit vector w has the area π·|det M|·|M⁻¹w|.
        double projected = Math.PI * volume * inverseLength(dx, dy, dz) / Math.sqrt(squaredDistance);
        return receiver * Math.min(fluence ? 2 * Math.PI : Math.PI, projected / squaredDistance);
    }

    /** 1 − cos of the half angle of the cone that touches the unit sphere. */
    private static double oneMinusCosine(double squaredDistance) {
        double squaredSine = 1 / squaredDistance;
        return squaredSine / (1 + Math.sqrt(1 - squaredSine));
    }

    /** |M d|³ / |det M| for the unit vector along d: density in world directions over that in object directions. */
    private double directionStretch(double dx, double dy, double dz, double[] work) {
        toWorld.applyVector(dx, dy, dz, work);
        double squared = (work[0] * work[0] + work[1] * work[1] + work[2] * work[2]) / (dx * dx + dy * dy + dz * dz);
        return squared * Math.sqrt(squared) / volume;
    }

    private double inverseLength(double dx, double dy, double dz) {
        double x = inverse[0] * dx + inverse[1] * dy + inverse[2] * dz;
        double y = inverse[4] * dx + inverse[5] * dy + inverse[6] * dz;
        double z = inverse[8] * dx + inverse[9] * dy + inverse[10] * dz;
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Area in the world per area of the unit sphere at a unit normal: |det M|·|M⁻ᵀn|; leaves M⁻ᵀn in the work array. */
    private double stretch(double nx, double ny, double nz, double[] work) {
        toWorld.applyNormal(nx, ny, nz, work);
        return volume * Math.sqrt(work[0] * work[0] + work[1] * work[1] + work[2] * work[2]);
    }

    private double fill(double nx, double ny, double nz, SurfacePoint out) {
        double[] work = out.scratch;
        toWorld.applyPoint(nx, ny, nz, work);
        out.x = work[0];
        out.y = work[1];
        out.z = work[2];
        double stretch = stretch(nx, ny, nz, work);
        double scale = side * volume / stretch;
        SurfaceFrames.set(out, scale * work[0], scale * work[1], scale * work[2]);
        out.offset = offset;
        out.primitive = 0;
        return stretch;
    }

    /** Midpoint rule over the equal-area map of the sphere; spectrally exact in azimuth. */
    private double quadrature() {
        int rows = 2048;
        int columns = 64;
        double[] work = new double[3];
        double sum = 0;
        for (int i = 0; i < rows; i++) {
            double z = (2 * i + 1.0) / rows - 1;
            double r = Math.sqrt((1 - z) * (1 + z));
            for (int j = 0; j < columns; j++) {
                double phi = 2 * Math.PI * (j + 0.5) / columns;
                sum += stretch(r * Math.cos(phi), r * Math.sin(phi), z, work);
            }
        }
        return UNIT_SPHERE_AREA * sum / rows / columns;
    }

    @Override
    public EmissionBounds bounds() {
        Bounds box = new Bounds(-1, -1, -1, 1, 1, 1).transform(toWorld);
        return EmissionBounds.everywhere(box, area / 4);
    }
}
