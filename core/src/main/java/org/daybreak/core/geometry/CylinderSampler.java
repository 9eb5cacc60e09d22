package org.daybreak.core.geometry;

import org.daybreak.core.math.Arcs;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;

/**
 * The lateral surface x² + y² = 1, 0 ≤ z ≤ 1 under an affine map. Sampling by direction takes only the part whose front faces
 * the point: an arc of the circle, as a tangent plane contains a whole ruling.
 */
final class CylinderSampler implements SurfaceSampler {
    /** Midpoint rule in azimuth: spectrally exact. */
    private static final int STEPS = 512;

    private final Transform toWorld;
    private final boolean flipNormals;
    private final double side;
    /** |det M|. */
    private final double volume;

    private final SurfaceMoments moments;
    private final double offset;

    CylinderSampler(Transform toWorld, boolean flipNormals) {
        this.toWorld = toWorld;
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
            builder.add(2 * Math.PI / STEPS * stretch, scale * n[0], scale * n[1], scale * n[2]);
        }
        double[] c = new double[3];
        toWorld.applyPoint(0, 0, 0.5, c);
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
        return 1 / (2 * Math.PI * fill(2 * Math.PI * u, v, out));
    }

    @Override
    public double areaDensity(SurfacePoint on) {
        return 1 / (2 * Math.PI * stretchAt(on));
    }

    @Override
    public double sampleDirection(double px, double py, double pz, double u, double v, SurfacePoint out) {
        double[] p = out.scratch;
        toWorld.applyInversePoint(px, py, pz, p);
        double squared = p[0] * p[0] + p[1] * p[1];
        double half = facingHalfArc(squared);
        if (!(half > 0)) {
            return 0;
        }
        double towards = Arcs.atan2(p[1], p[0]) + (flipNormals ? Math.PI : 0);
        double stretch = fill(towards + (2 * u - 1) * half, v, out);
        return SurfaceSampler.perSolidAngle(1 / (2 * half * stretch), px, py, pz, out);
    }

    @Override
    public double directionDensity(
            double px, double py, double pz, SurfacePoint on, double wiX, double wiY, double wiZ) {
        double[] p = on.scratch;
        toWorld.applyInversePoint(px, py, pz, p);
        double half = facingHalfArc(p[0] * p[0] + p[1] * p[1]);
        return half > 0 ? SurfaceSampler.perSolidAngle(1 / (2 * half * stretchAt(on)), px, py, pz, on) : 0;
    }

    @Override
    public void setTextureCoordinates(SurfacePoint point) {
        double[] p = point.scratch;
        toWorld.applyInversePoint(point.x, point.y, point.z, p);
        point.u = SurfaceFrames.turn(p[0], p[1]);
        point.v = Math.max(0, Math.min(1, p[2]));
        point.setNoAttributes();
    }

    @Override
    public double irradiance(double px, double py, double pz, double nx, double ny, double nz) {
        return moments.irradiance(px, py, pz, nx, ny, nz);
    }

    /**
     * Half the arc on which the front faces a point, in object space.
     *
     * @param squared squared distance of the point from the axis
     */
    private double facingHalfArc(double squared) {
        if (squared > 1) {
            double outer = Arcs.acos(1 / Math.sqrt(squared));
            return flipNormals ? Math.PI - outer : outer;
        }
        return flipNormals ? Math.PI : 0;
    }

    /** Area in the world per dφ dz at an object-space normal: |det M|·|M⁻ᵀn|; leaves M⁻ᵀn in the work array. */
    private double stretch(double nx, double ny, double[] work) {
        toWorld.applyNormal(nx, ny, 0, work);
        return volume * Math.sqrt(work[0] * work[0] + work[1] * work[1] + work[2] * work[2]);
    }

    private double stretchAt(SurfacePoint on) {
        double[] p = on.scratch;
        toWorld.applyInversePoint(on.x, on.y, on.z, p);
        double length = Math.sqrt(p[0] * p[0] + p[1] * p[1]);
        return stretch(p[0] / length, p[1] / length, p);
    }

    private double fill(double phi, double z, SurfacePoint out) {
        double[] work = out.scratch;
        double nx = Math.cos(phi);
        double ny = Math.sin(phi);
        toWorld.applyPoint(nx, ny, z, work);
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
