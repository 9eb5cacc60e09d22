package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/** A light at infinity that is a function of direction, with directions drawn by a density of its own. */
abstract class DistantRadiance implements Light {
    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final double sceneRadius;

    /**
     * Creates a light.
     *
     * @param centreX centre of a sphere that holds the scene
     * @param sceneRadius its radius; 0 for an empty scene, to which the light gives no power
     */
    DistantRadiance(double centreX, double centreY, double centreZ, double sceneRadius) {
        this.centreX = centreX;
        this.centreY = centreY;
        this.centreZ = centreZ;
        this.sceneRadius = sceneRadius;
    }

    /** Sets the radiance from a unit direction of the world. */
    abstract void look(double wx, double wy, double wz, Spectrum out);

    /**
     * Draws a direction of the world.
     *
     * @param dest receives it
     * @return its density per solid angle
     */
    abstract double sampleDirection(double u, double v, double[] dest);

    /** Density per solid angle with which {@link #sampleDirection} draws a unit direction of the world. */
    abstract double density(double wx, double wy, double wz);

    /** The irradiance by normal. */
    abstract IrradianceHarmonics harmonics();

    @Override
    public final boolean isDelta() {
        return false;
    }

    @Override
    public final boolean isInfinite() {
        return true;
    }

    @Override
    public final double power() {
        return harmonics().fluence() * Math.PI * sceneRadius * sceneRadius;
    }

    @Override
    public final double importance(double px, double py, double pz, double nx, double ny, double nz) {
        IrradianceHarmonics irradiance = harmonics();
        return nx == 0 && ny == 0 && nz == 0 ? irradiance.fluence() : irradiance.irradiance(nx, ny, nz);
    }

    @Override
    public final @Nullable EmissionBounds bounds() {
        return null;
    }

    @Override
    public final boolean sampleIncident(double px, double py, double pz, double u, double v, LightSample out) {
        double[] d = out.scratch;
        double density = sampleDirection(u, v, d);
        double wx = d[0];
        double wy = d[1];
        double wz = d[2];
        look(wx, wy, wz, out.weight);
        if (out.weight.isBlack()) {
            return false;
        }
        InfiniteGeometry.arrive(wx, wy, wz, density, out);
        out.weight.scale(1 / density);
        return true;
    }

    @Override
    public final double incidentDensity(
            double px, double py, double pz, SurfacePoint onLight, double wiX, double wiY, double wiZ) {
        return density(wiX, wiY, wiZ);
    }

    @Override
    public final boolean sampleEmission(double u, double v, double s, double t, EmissionSample out) {
        if (!(sceneRadius > 0)) {
            return false;
        }
        double[] d = out.scratch;
        double density = sampleDirection(s, t, d);
        look(d[0], d[1], d[2], out.weight);
        if (out.weight.isBlack()) {
            return false;
        }
        out.dx = -d[0];
        out.dy = -d[1];
        out.dz = -d[2];
        InfiniteGeometry.start(centreX, centreY, centreZ, sceneRadius, u, v, density, out);
        out.weight.scale(1 / (out.densityPosition * density));
        return true;
    }

    @Override
    public final void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out) {
        out.position = InfiniteGeometry.diskDensity(sceneRadius);
        out.direction = density(-dx, -dy, -dz);
    }

    @Override
    public final void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out) {
        look(-dx, -dy, -dz, out);
    }
}
