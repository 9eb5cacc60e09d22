package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Texture;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.Warps;
import org.jspecify.annotations.Nullable;

/**
 * A point that emits within a cone, through a slide if there is one: with full intensity up to the beam angle, from there to the cutoff angle with an intensity
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
    private final @Nullable Texture slide;
    private final double slideScale;
    private final double meanOfSlide;
    private final double rightX;
    private final double rightY;
    private final double rightZ;
    private final double upX;
    private final double upY;
    private final double upZ;

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
        this(toWorld, intensity, cutoffDegrees, beamDegrees, null);
    }

    /**
     * Creates a light that projects a slide.
     *
     * @param toWorld rotation with translation (and reflection) to the world; a uniform scale does not matter
     * @param slide factor on the intensity; its unit square fills the square about the cutoff cone, u along +x and v along +y:
     *     direction (x, y, z) has u = ½ + x/(2z·tan cutoff). Null for none
     * @throws IllegalArgumentException if an angle is out of range: with a slide, the cutoff must be less than 90 degrees
     */
    public SpotLight(
            Transform toWorld, Spectrum intensity, double cutoffDegrees, double beamDegrees, @Nullable Texture slide) {
        if (slide != null && !(cutoffDegrees < 90)) {
            throw new IllegalArgumentException(
                    "the cutoff angle of a spot with a texture must be less than 90 degrees but is " + cutoffDegrees);
        }
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
        this.slide = slide;
        slideScale = 0.5 / Math.tan(cutoff);
        toWorld.applyVector(1, 0, 0, d);
        double across = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        rightX = d[0] / across;
        rightY = d[1] / across;
        rightZ = d[2] / across;
        toWorld.applyVector(0, 1, 0, d);
        double up = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        upX = d[0] / up;
        upY = d[1] / up;
        upZ = d[2] / up;
        meanOfSlide = slide == null ? 1 : meanOfSlide();
    }

    /** Mean over the cone of fall-off times slide, over that of the fall-off; a little at least. */
    private double meanOfSlide() {
        int steps = 64;
        double sum = 0;
        double weight = 0;
        double[] local = new double[3];
        Spectrum value = new Spectrum();
        SurfacePoint point = new SurfacePoint();
        for (int i = 0; i < steps * steps; i++) {
            Warps.toUniformCone(
                    (i % steps + 0.5) / steps, (Math.floorDiv(i, steps) + 0.5) / steps, oneMinusCosCutoff, local);
            double falloff = falloff(local[2]);
            EmissionDirections.around(axisX, axisY, axisZ, local);
            value.set(intensity);
            project(local[0], local[1], local[2], point, value);
            sum += falloff * value.luminance();
            weight += falloff * luminance;
        }
        return weight > 0 ? Math.max(sum / weight, 1e-3) : 0;
    }

    /** Multiplies with the slide in a direction of travel within the cone. */
    private void project(double dx, double dy, double dz, SurfacePoint point, Spectrum value) {
        Texture texture = slide;
        if (texture == null) {
            return;
        }
        double scale = slideScale / (dx * axisX + dy * axisY + dz * axisZ);
        point.u = 0.5 + scale * (dx * rightX + dy * rightY + dz * rightZ);
        point.v = 0.5 + scale * (dx * upX + dy * upY + dz * upZ);
        double r = value.r;
        double g = value.g;
        double b = value.b;
        texture.evaluate(point, value);
        value.set(r * value.r, g * value.g, b * value.b);
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
        return 2 * Math.PI * luminance * meanOfSlide * (1 - slope);
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
        return luminance * meanOfSlide * falloff(-(dx * axisX + dy * axisY + dz * axisZ) / length) * irradiance;
    }

    @Override
    public EmissionBounds bounds() {
        return new EmissionBounds(
                new Bounds(x, y, z, x, y, z), axisX, axisY, axisZ, cutoff, 0, luminance * meanOfSlide);
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
        project(-out.wiX, -out.wiY, -out.wiZ, out.point, out.weight);
        out.weight.scale(falloff / (out.distance * out.distance));
        return !out.weight.isBlack();
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
        // What the slide holds back is black, but it has a density.
        project(out.dx, out.dy, out.dz, out.point, out.weight);
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
