package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.Warps;
import org.jspecify.annotations.Nullable;

/** The disk of the sun: the same radiance from a cone of directions, as far as it is above the horizon. */
public final class SunLight implements Light {
    /** The sun's angular diameter in degrees. */
    public static final double APERTURE_DEGREES = 0.5358;

    /** Slack of the cone for directions that were drawn in it. */
    private static final double ROUNDING = 1e-13;

    private final Spectrum radiance;
    private final double luminance;
    private final double sunX;
    private final double sunY;
    private final double sunZ;
    private final double upX;
    private final double upY;
    private final double upZ;
    private final double oneMinusCosine;
    private final double sine;
    private final double density;
    private final double visibleShare;
    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final double sceneRadius;

    /**
     * Creates a light. The irradiance across its rays does not depend on the aperture.
     *
     * @param settings atmosphere and sun; the zenith is +z. The sun is that of Hosek and Wilkie for either model
     * @param apertureDegrees angular diameter in degrees, between 0 and 180; {@link #APERTURE_DEGREES} is true
     * @param scale factor on the radiance, not negative
     * @param toWorld rotation (or reflection) to the world; a uniform scale and the translation do not matter
     * @param centreX centre of a sphere that holds the scene
     * @param sceneRadius its radius; 0 for an empty scene, to which the light gives no power
     * @throws IllegalArgumentException if a number is out of range
     */
    public SunLight(
            SkySettings settings,
            double apertureDegrees,
            double scale,
            Transform toWorld,
            double centreX,
            double centreY,
            double centreZ,
            double sceneRadius) {
        if (!(apertureDegrees > 0 && apertureDegrees < 180)) {
            throw new IllegalArgumentException(
                    "the aperture of the sun must lie between 0 and 180 degrees but is " + apertureDegrees);
        }
        if (!(scale >= 0) || Double.isInfinite(scale)) {
            throw new IllegalArgumentException("the scale of the sun must not be negative but is " + scale);
        }
        double half = Math.toRadians(0.5 * apertureDegrees);
        double sineOfHalf = Math.sin(0.5 * half);
        oneMinusCosine = 2 * sineOfHalf * sineOfHalf;
        sine = Math.sin(half);
        density = 1 / (2 * Math.PI * oneMinusCosine);
        double trueSine = Math.sin(0.5 * HosekWilkieSky.SUN_HALF_ANGLE);
        radiance = settings.sun().z >= 0
                ? HosekWilkieSky.meanSunRadiance(settings.turbidity(), settings.zenithAngle())
                : new Spectrum();
        radiance.scale(scale * 2 * trueSine * trueSine / oneMinusCosine);
        luminance = radiance.luminance();
        double[] m = DistantFrames.rotation(toWorld);
        double[] d = new double[3];
        DistantFrames.toWorld(m, settings.sun().x, settings.sun().y, settings.sun().z, d);
        sunX = d[0];
        sunY = d[1];
        sunZ = d[2];
        DistantFrames.toWorld(m, 0, 0, 1, d);
        upX = d[0];
        upY = d[1];
        upZ = d[2];
        this.centreX = centreX;
        this.centreY = centreY;
        this.centreZ = centreZ;
        this.sceneRadius = sceneRadius;
        visibleShare = visibleShare();
    }

    /** Part of the disk that is above the horizon, by counting. */
    private double visibleShare() {
        if (sunX * upX + sunY * upY + sunZ * upZ >= sine) {
            return 1;
        }
        int steps = 128;
        int above = 0;
        double[] d = new double[3];
        for (int i = 0; i < steps * steps; i++) {
            draw((i % steps + 0.5) / steps, (Math.floorDiv(i, steps) + 0.5) / steps, d);
            above += aboveHorizon(d[0], d[1], d[2]) ? 1 : 0;
        }
        return (double) above / (steps * steps);
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean isInfinite() {
        return true;
    }

    @Override
    public double power() {
        return visibleShare * luminance / density * Math.PI * sceneRadius * sceneRadius;
    }

    @Override
    public double importance(double px, double py, double pz, double nx, double ny, double nz) {
        if (nx == 0 && ny == 0 && nz == 0) {
            return luminance / density;
        }
        double cosine = nx * sunX + ny * sunY + nz * sunZ;
        // Across the horizon of the surface the mean of the cosine runs from 0 to the sine of the cone, as a parabola.
        double mean = cosine >= sine ? cosine : cosine > -sine ? (cosine + sine) * (cosine + sine) / (4 * sine) : 0;
        return luminance / density * (mean > 0 ? Math.max(mean, 1e-6 * sine) : 0);
    }

    @Override
    public @Nullable EmissionBounds bounds() {
        return null;
    }

    @Override
    public boolean sampleIncident(double px, double py, double pz, double u, double v, LightSample out) {
        double[] d = out.scratch;
        draw(u, v, d);
        if (luminance == 0 || !aboveHorizon(d[0], d[1], d[2])) {
            return false;
        }
        InfiniteGeometry.arrive(d[0], d[1], d[2], density, out);
        out.weight.set(radiance);
        out.weight.scale(1 / density);
        return true;
    }

    @Override
    public double incidentDensity(
            double px, double py, double pz, SurfacePoint onLight, double wiX, double wiY, double wiZ) {
        return density(wiX, wiY, wiZ);
    }

    @Override
    public boolean sampleEmission(double u, double v, double s, double t, EmissionSample out) {
        double[] d = out.scratch;
        draw(s, t, d);
        if (luminance == 0 || !(sceneRadius > 0) || !aboveHorizon(d[0], d[1], d[2])) {
            return false;
        }
        out.dx = -d[0];
        out.dy = -d[1];
        out.dz = -d[2];
        InfiniteGeometry.start(centreX, centreY, centreZ, sceneRadius, u, v, density, out);
        out.weight.set(radiance);
        out.weight.scale(1 / (out.densityPosition * density));
        return true;
    }

    @Override
    public void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out) {
        out.position = InfiniteGeometry.diskDensity(sceneRadius);
        out.direction = density(-dx, -dy, -dz);
    }

    @Override
    public void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out) {
        if (density(-dx, -dy, -dz) > 0) {
            out.set(radiance);
        } else {
            out.setZero();
        }
    }

    private void draw(double u, double v, double[] dest) {
        Warps.toUniformCone(u, v, oneMinusCosine, dest);
        EmissionDirections.around(sunX, sunY, sunZ, dest);
    }

    private double density(double wx, double wy, double wz) {
        // Half the squared distance of the unit vectors is 1 − cos without cancellation.
        double x = wx - sunX;
        double y = wy - sunY;
        double z = wz - sunZ;
        boolean inside = 0.5 * (x * x + y * y + z * z) <= oneMinusCosine * (1 + ROUNDING) + ROUNDING * sine;
        return luminance > 0 && inside && aboveHorizon(wx, wy, wz) ? density : 0;
    }

    private boolean aboveHorizon(double wx, double wy, double wz) {
        return wx * upX + wy * upY + wz * upZ >= 0;
    }
}
