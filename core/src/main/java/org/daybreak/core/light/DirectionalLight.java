package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/** Parallel light from infinity (Mitsuba's {@code directional}). */
public final class DirectionalLight implements Light {
    private final double dx;
    private final double dy;
    private final double dz;
    private final Spectrum irradiance;
    private final double luminance;
    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final double sceneRadius;

    /**
     * Creates a light.
     *
     * @param dx direction of travel in the world, of any positive length
     * @param irradiance irradiance of a surface that faces the light in W/m², not negative; copied
     * @param centreX centre of a sphere that holds the scene
     * @param sceneRadius its radius; 0 for an empty scene, to which the light gives no power
     * @throws IllegalArgumentException if the direction is zero or not finite
     */
    public DirectionalLight(
            double dx,
            double dy,
            double dz,
            Spectrum irradiance,
            double centreX,
            double centreY,
            double centreZ,
            double sceneRadius) {
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "the direction of a light must not be zero but is (" + dx + ", " + dy + ", " + dz + ")");
        }
        this.dx = dx / length;
        this.dy = dy / length;
        this.dz = dz / length;
        this.irradiance = irradiance.copy();
        luminance = irradiance.luminance();
        this.centreX = centreX;
        this.centreY = centreY;
        this.centreZ = centreZ;
        this.sceneRadius = sceneRadius;
    }

    @Override
    public boolean isDelta() {
        return true;
    }

    @Override
    public boolean isInfinite() {
        return true;
    }

    @Override
    public double power() {
        return luminance * Math.PI * sceneRadius * sceneRadius;
    }

    @Override
    public double importance(double px, double py, double pz, double nx, double ny, double nz) {
        if (nx == 0 && ny == 0 && nz == 0) {
            return luminance;
        }
        return luminance * Math.max(0, -(nx * dx + ny * dy + nz * dz));
    }

    @Override
    public @Nullable EmissionBounds bounds() {
        return null;
    }

    @Override
    public boolean sampleIncident(double px, double py, double pz, double u, double v, LightSample out) {
        if (luminance == 0) {
            return false;
        }
        InfiniteGeometry.arrive(-dx, -dy, -dz, 1, out);
        out.delta = true;
        out.weight.set(irradiance);
        return true;
    }

    /** 0: no sampled direction is the only one. */
    @Override
    public double incidentDensity(
            double px, double py, double pz, SurfacePoint onLight, double wiX, double wiY, double wiZ) {
        return 0;
    }

    @Override
    public boolean sampleEmission(double u, double v, double s, double t, EmissionSample out) {
        if (luminance == 0 || !(sceneRadius > 0)) {
            return false;
        }
        out.dx = dx;
        out.dy = dy;
        out.dz = dz;
        InfiniteGeometry.start(centreX, centreY, centreZ, sceneRadius, u, v, 1, out);
        out.deltaDirection = true;
        out.weight.set(irradiance);
        out.weight.scale(1 / out.densityPosition);
        return true;
    }

    @Override
    public void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out) {
        out.position = InfiniteGeometry.diskDensity(sceneRadius);
        out.direction = 1;
    }

    @Override
    public void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out) {
        out.setZero();
    }
}
