package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.Warps;

/**
 * A point that emits within a cone: with full intensity up to the beam angle, from there to the cutoff angle with an intensity
 * that falls linearly in the angle to 0 (Mitsuba's {@code spot}).
 */
public final class SpotLight implements Light {
    private final double x;
    private final double y;
    private final double z;
    private final double axisX;
    private final double axisY;
    private final double axisZ;
    private final Spectrum intensity;
    private final double luminance;
    private final double cutoff;
    private final double beam;
    private final double cosCutoff;
    private final double cosBeam;
    private final double oneMinusCosCutoff;

    /**
     * Creates a light at the transform's image of the origin that shines along its image of +z.
     *
     * @param toWorld map to the world; angles are measured there
     * @param intensity radiant intensity along the axis in W/sr, not negative; copied
     * @param cutoffDegrees angle from the axis beyond which there is no light, in (0, 180]
     * @param beamDegrees angle up to which the intensity is full, from 0 to the cutoff
     * @throws IllegalArgumentException if an angle is out of range
     */
    public SpotLight(Transform toWorld, Spectrum intensity, double cutoffDegrees, double beamDegrees) {
        if (!(cutoffDegrees > 0 && cutoffDegrees <= 180)) {
            throw new IllegalArgumentException(
                    "the cutoff angle of a spot must lie between 0 and 180 degrees but is " + cutoffDegrees);
        }
        if (!(beamDegrees >= 0 && beamDegrees <= cutoffDegrees)) {
            throw new IllegalArgumentException("the beam angle of a spot must lie between 0 and its cutoff angle of "
                    + cutoffDegrees + " degrees but is " + beamDegrees);
        }
        double[] d = new double[3];
        toWorld.applyPoint(0, 0, 0, d);
        x = d[0];
        y = d[1];
        z = d[2];
        toWorld.applyVector(0, 0, 1, d);
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        axisX = d[0] / length;
        axisY = d[1] / length;
        axisZ = d[2] / length;
        this.intensity = intensity.copy();
        luminance = intensity.luminance();
        cutoff = Math.toRadians(cutoffDegrees);
        beam = Math.toRadians(beamDegrees);
        cosCutoff = Math.cos(cutoff);
        cosBeam = Math.cos(beam);
        double half = Math.sin(0.5 * cutoff);
        oneMinusCosCutoff = 2 * half * half;
    }

    @Override
    public boolean isDelta() {
        return true;
    }

    @Override
    public boolean isInfinite() {
        return false;
    }

    /** {@code 2πI(1 − (sin c − sin b)/(c − b))}: the fall-off integrated in closed form. */
    @Override
    public double power() {
        double half = 0.5 * (cutoff - beam);
        double slope = Math.cos(0.5 * (cutoff + beam)) * (half > 0 ? Math.sin(half) / half : 1);
        return 2 * Math.PI * luminance * (1 - slope);
    }

    @Override
    public double importance(double px, double py, double pz, double nx, double ny, double nz) {
        double dx = x - px;
        double dy = y - py;
        double dz = z - pz;
        double irradiance = PointGeometry.irradiance(dx, dy, dz, nx, ny, nz);
        if (irradiance == 0) {
            return 0;
        }
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return luminance * falloff(-(dx * axisX + dy * axisY + dz * axisZ) / length) * irradiance;
    }

    @Override
    public EmissionBounds bounds() {
        return new EmissionBounds(new Bounds(x, y, z, x, y, z), axisX, axisY, axisZ, cutoff, 0, luminance);
    }

    @Override
    public boolean sampleIncident(double px, double py, double pz, double u, double v, LightSample out) {
        if (luminance == 0 || !PointGeometry.connect(x, y, z, px, py, pz, out)) {
            return false;
        }
        double falloff = falloff(-(out.wiX * axisX + out.wiY * axisY + out.wiZ * axisZ));
        if (falloff == 0) {
            return false;
        }
        out.weight.set(intensity);
        out.weight.scale(falloff / (out.distance * out.distance));
        return true;
    }

    /** 0: nothing hits a point. */
    @Override
    public double incidentDensity(
            double px, double py, double pz, SurfacePoint onLight, double wiX, double wiY, double wiZ) {
        return 0;
    }

    @Override
    public boolean sampleEmission(double u, double v, double s, double t, EmissionSample out) {
        double[] local = out.scratch;
        Warps.toUniformCone(s, t, oneMinusCosCutoff, local);
        double falloff = falloff(local[2]);
        if (falloff == 0 || luminance == 0) {
            return false;
        }
        EmissionDirections.around(axisX, axisY, axisZ, local);
        out.dx = local[0];
        out.dy = local[1];
        out.dz = local[2];
        PointGeometry.start(x, y, z, coneDensity(), out);
        out.weight.set(intensity);
        out.weight.scale(falloff / out.densityDirection);
        return true;
    }

    @Override
    public void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out) {
        out.position = 1;
        out.direction = falloff(dx * axisX + dy * axisY + dz * axisZ) > 0 ? coneDensity() : 0;
    }

    @Override
    public void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out) {
        out.setZero();
    }

    private double coneDensity() {
        return 1 / (2 * Math.PI * oneMinusCosCutoff);
    }

    /** Part of the full intensity at an angle from the axis. */
    private double falloff(double cosine) {
        if (cosine >= cosBeam) {
            return 1;
        }
        if (cosine <= cosCutoff) {
            return 0;
        }
        return Math.max(0, (cutoff - Math.acos(cosine)) / (cutoff - beam));
    }
}
