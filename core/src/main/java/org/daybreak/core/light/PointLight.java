package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.sampling.Warps;

/** A point that emits the same intensity in all directions. */
public final class PointLight implements Light {
    private final double x;
    private final double y;
    private final double z;
    private final Spectrum intensity;
    private final double luminance;

    /**
     * Creates a light.
     *
     * @param x position in the world
     * @param intensity radiant intensity in W/sr, not negative; copied
     */
    public PointLight(double x, double y, double z, Spectrum intensity) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.intensity = intensity.copy();
        luminance = intensity.luminance();
    }

    @Override
    public boolean isDelta() {
        return true;
    }

    @Override
    public boolean isInfinite() {
        return false;
    }

    @Override
    public double power() {
        return 4 * Math.PI * luminance;
    }

    @Override
    public double importance(double px, double py, double pz, double nx, double ny, double nz) {
        return luminance * PointGeometry.irradiance(x - px, y - py, z - pz, nx, ny, nz);
    }

    @Override
    public EmissionBounds bounds() {
        return EmissionBounds.everywhere(new Bounds(x, y, z, x, y, z), luminance);
    }

    @Override
    public boolean sampleIncident(double px, double py, double pz, double u, double v, LightSample out) {
        if (luminance == 0 || !PointGeometry.connect(x, y, z, px, py, pz, out)) {
            return false;
        }
        out.weight.set(intensity);
        out.weight.scale(1 / (out.distance * out.distance));
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
        if (luminance == 0) {
            return false;
        }
        Warps.toUniformSphere(s, t, out.scratch);
        out.dx = out.scratch[0];
        out.dy = out.scratch[1];
        out.dz = out.scratch[2];
        PointGeometry.start(x, y, z, Warps.toUniformSpherePdf(), out);
        out.weight.set(intensity);
        out.weight.scale(1 / out.densityDirection);
        return true;
    }

    @Override
    public void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out) {
        out.position = 1;
        out.direction = Warps.toUniformSpherePdf();
    }

    @Override
    public void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out) {
        out.setZero();
    }
}
