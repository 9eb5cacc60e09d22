package org.daybreak.core.geometry;

import org.daybreak.core.math.Arcs;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;

/**
 * The lateral surface x² + y² = (1 − t·z)², 0 ≤ z ≤ 1 under an affine map: a cylinder, or with a taper t > 0 a cone. Sampling
 * by direction takes only the part whose front faces the point: an arc of the circle, as a tangent plane contains a
 * whole ruling.
 */
final class CylinderSampler implements SurfaceSampler {
    /** Midpoint rule in azimuth: spectrally exact. */
    private static final int STEPS = 512;

    private final Transform toWorld;
    private final double taper;
    /** Whether texture coordinates run from z = 1 to z = 0 and the other way around. */
    private final boolean reversed;
    /** Mean of the radius along the axis. */
    private final double meanRadius;

    private final boolean flipNormals;
    private final double side;
    /** |det M|. */
    private final double volume;

    /** Rows of the inverse map. */
    private final double[] inverse;

    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final SurfaceMoments moments;
    private final double offset;

    CylinderSampler(Transform toWorld, double taper, boolean reversed, boolean flipNormals) {
        this.toWorld = toWorld;
        this.taper = taper;
        this.reversed = reversed;
        meanRadius = 1 - 0.5 * taper;
        this.flipNormals = flipNormals;
        side = flipNormals ? -1 : 1;
        double[] m = toWorld.rows();
        volume = Math.abs(LinearMaps.determinant(m));
        SurfaceMoments.Builder builder = new SurfaceMoments.Builder();
        double[] n = new double[3];
        for (int i = 0; i < STEPS; i++) {
            double phi = 2 * Math.PI * (i + 0.5) / STEPS;
            double stretch = stretch(Math.cos(phi), Math.sin(phi), n);
            double scale = side * volume / stretch;
            builder.add(2 * Math.PI / STEPS * meanRadius * stretch, scale * n[0], scale * n[1], scale * n[2]);
        }
        inverse = toWorld.inverse().rows();
        double[] c = new double[3];
        toWorld.applyPoint(0, 0, 0.5, c);
        centreX = c[0];
        centreY = c[1];
        centreZ = c[2];
        // |±h + a·cos φ + b·sin φ| with half the axis h: both parts of the square at their largest.
        double hx = 0.5 * m[2];
        double hy = 0.5 * m[6];
        double hz = 0.5 * m[10];
        double ha = hx * m[0] + hy * m[4] + hz * m[8];
        double hb = hx * m[1] + hy * m[5] + hz * m[9];
        double squaredRadius = hx * hx
                + hy * hy
                + hz * hz
                + DiskSampler.squaredLongestRadius(m[0], m[4], m[8], m[1], m[5], m[9])
                + 2 * Math.sqrt(ha * ha + hb * hb);
        double radius = Math.sqrt(squaredRadius) * (1 + 1e-9);
        moments = builder.build(c[0], c[1], c[2], radius);
        offset = SurfaceFrames.quadricOffset(c[0], c[1], c[2], radius);
    }

    @Override
    public double area() {
        return moments.area();
    }

    @Override
    public double sampleArea(double u, double v, SurfacePoint out) {
        return 1 / (2 * Math.PI * meanRadius * fill(2 * Math.PI * u, v, out));
    }

    @Override
    public double areaDensity(SurfacePoint on) {
        return 1 / (2 * Math.PI * meanRadius * stretchAt(on));
    }

    @Override
    public double sampleDirection(double px, double py, double pz, double u, double v, SurfacePoint out) {
        double[] p = out.scratch;
        toWorld.applyInversePoint(px, py, pz, p);
        double half = facingHalfArc(p);
        if (!(half > 0)) {
            return 0;
        }
        double towards = Arcs.atan2(p[1], p[0]) + (flipNormals ? Math.PI : 0);
        double stretch = fill(towards + (2 * u - 1) * half, v, out);
        return SurfaceSampler.perSolidAngle(1 / (2 * half * meanRadius * stretch), px, py, pz, out);
    }

    @Override
    public double directionDensity(
            double px, double py, double pz, SurfacePoint on, double wiX, double wiY, double wiZ) {
        double[] p = on.scratch;
        toWorld.applyInversePoint(px, py, pz, p);
        double half = facingHalfArc(p);
        return half > 0 ? SurfaceSampler.perSolidAngle(1 / (2 * half * meanRadius * stretchAt(on)), px, py, pz, on) : 0;
    }

    @Override
    public void setTextureCoordinates(SurfacePoint point) {
        double[] p = point.scratch;
        toWorld.applyInversePoint(point.x, point.y, point.z, p);
        point.u = SurfaceFrames.turn(p[0], reversed ? -p[1] : p[1]);
        double z = Math.max(0, Math.min(1, p[2]));
        point.v = reversed ? 1 - z : z;
        point.setNoAttributes();
    }

    @Override
    public double irradiance(double px, double py, double pz, double nx, double ny, double nz) {
        return moments.irradiance(px, py, pz, nx, ny, nz, facing(px - centreX, py - centreY, pz - centreZ));
    }

    /** Area that the front turns to a direction of any length: ∫ max(0, n·w) dA in closed form, as n dA is linear in n. */
    private double facing(double wx, double wy, double wz) {
        double length = Math.sqrt(wx * wx + wy * wy + wz * wz);
        if (!(length > 0)) {
            return 0;
        }
        double scale = side * volume * meanRadius / length;
        double qx = scale * (inverse[0] * wx + inverse[1] * wy + inverse[2] * wz);
        double qy = scale * (inverse[4] * wx + inverse[5] * wy + inverse[6] * wz);
        double h = taper * scale * (inverse[8] * wx + inverse[9] * wy + inverse[10] * wz);
        double r = Math.sqrt(qx * qx + qy * qy);
        if (h >= r) {
            return 2 * Math.PI * h;
        }
        if (h <= -r) {
            return 0;
        }
        return 2 * (h * Arcs.acos(-h / r) + Math.sqrt(r * r - h * h));
    }

    /**
     * Half the arc on which the front faces a point p, in object space. The outside at φ faces it if
     * p · (cos φ, sin φ, t) > 1.
     */
    private double facingHalfArc(double[] p) {
        double squared = p[0] * p[0] + p[1] * p[1];
        double height = 1 - taper * p[2];
        double outer = height <= 0 && squared <= height * height
                ? Math.PI
                : squared > height * height ? Arcs.acos(height / Math.sqrt(squared)) : 0;
        return flipNormals ? Math.PI - outer : outer;
    }

    /** Area in the world per dφ dz and radius at an object-space normal: |det M|·|M⁻ᵀn|; leaves M⁻ᵀn in the work array. */
    private double stretch(double nx, double ny, double[] work) {
        toWorld.applyNormal(nx, ny, taper, work);
        return volume * Math.sqrt(work[0] * work[0] + work[1] * work[1] + work[2] * work[2]);
    }

    private double stretchAt(SurfacePoint on) {
        double[] p = on.scratch;
        toWorld.applyInversePoint(on.x, on.y, on.z, p);
        double length = Math.sqrt(p[0] * p[0] + p[1] * p[1]);
        return length > 0 ? stretch(p[0] / length, p[1] / length, p) : stretch(1, 0, p);
    }

    /**
     * Fills a point.
     *
     * @param v part of the area of the ruling at φ that lies below the point
     */
    private double fill(double phi, double v, SurfacePoint out) {
        double[] work = out.scratch;
        double nx = Math.cos(phi);
        double ny = Math.sin(phi);
        // z − t·z²/2 = v (1 − t/2), solved without cancellation.
        double z = 2 * v * meanRadius / (1 + Math.sqrt(Math.max(0, 1 - 2 * taper * v * meanRadius)));
        double radius = 1 - taper * z;
        toWorld.applyPoint(radius * nx, radius * ny, z, work);
        out.x = work[0];
        out.y = work[1];
        out.z = work[2];
        double stretch = stretch(nx, ny, work);
        double scale = side * volume / stretch;
        SurfaceFrames.set(out, scale * work[0], scale * work[1], scale * work[2]);
        out.offset = offset;
        out.primitive = 0;
        return stretch;
    }

    @Override
    public EmissionBounds bounds() {
        Bounds box = new Bounds(-1, -1, 0, 1, 1, 1).transform(toWorld);
        return EmissionBounds.everywhere(box, area() / 4);
    }
}
