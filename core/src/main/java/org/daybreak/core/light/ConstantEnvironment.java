package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.Warps;
import org.jspecify.annotations.Nullable;

/** The same radiance from all directions, from infinity. */
public final class ConstantEnvironment implements Light {
    private static final double DIRECTION_DENSITY = Warps.toUniformSpherePdf();

    private final Spectrum radiance;
    private final double luminance;
    private final double centreX;
    private final double centreY;
    private final double centreZ;
    private final double sceneRadius;

    /**
     * Creates a light.
     *
     * @param radiance radiance in W/(m²·sr), not negative; copied
     * @param centreX centre of a sphere that holds the scene
     * @param sceneRadius its radius; 0 for an empty scene, to which the light gives no power
     */
    public ConstantEnvironment(Spectrum radiance, double centreX, double centreY, double centreZ, double sceneRadius) {
        this.radiance = radiance.copy();
        luminance = radiance.luminance();
        this.centreX = centreX;
        this.centreY = centreY;
        this.centreZ = centreZ;
        this.sceneRadius = sceneRadius;
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
        return 4 * Math.PI * luminance * Math.PI * sceneRadius * sceneRadius;
    }

    @Override
    public double importance(double px, double py, double pz, double nx, double ny, double nz) {
        return luminance * (nx == 0 && ny == 0 && nz == 0 ? 4 * Math.PI : Math.PI);
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
        Warps.toUniformSphere(u, v, out.scratch);
        InfiniteGeometry.arrive(out.scratch[0], out.scratch[1], out.scratch[2], DIRECTION_DENSITY, out);
        out.weight.set(radiance);
        out.weight.scale(1 / DIRECTION_DENSITY);
        return true;
    }

    @Override
    public double incidentDensity(
            double px, double py, double pz, SurfacePoint onLight, double wiX, double wiY, double wiZ) {
        return DIRECTION_DENSITY;
    }

    @Override
    public boolean sampleEmission(double u, double v, double s, double t, EmissionSample out) {
        if (luminance == 0 || !(sceneRadius > 0)) {
            return false;
        }
        Warps.toUniformSphere(s, t, out.scratch);
        out.dx = out.scratch[0];
        out.dy = out.scratch[1];
        out.dz = out.scratch[2];
        InfiniteGeometry.start(centreX, centreY, centreZ, sceneRadius, u, v, DIRECTION_DENSITY, out);
        out.weight.set(radiance);
        out.weight.scale(1 / (out.densityPosition * out.densityDirection));
        return true;
    }

    @Override
    public void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out) {
        out.position = InfiniteGeometry.diskDensity(sceneRadius);
        out.direction = DIRECTION_DENSITY;
    }

    @Override
    public void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out) {
        out.set(radiance);
    }
}
