package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.SurfaceBrightness;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.SurfaceSampler;
import org.daybreak.core.geometry.SurfaceSamplers;
import org.daybreak.core.material.Texture;
import org.daybreak.core.math.Transform;
import org.jspecify.annotations.Nullable;

/**
 * A surface that emits from its front, with the same radiance in all directions of that side. The radiance may vary over
 * the surface.
 */
public final class AreaLight implements Light {
    /** Side of the grid of points over which a texture is averaged. */
    private static final int AVERAGING_STEPS = 64;

    private final SurfaceSampler surface;
    private final Texture radiance;
    private final boolean textured;
    private final int shape;
    private final double meanLuminance;

    /**
     * Creates a light.
     *
     * @param surface the emitting surface
     * @param radiance emitted radiance in W/(m²·sr), not negative
     * @param shape index of the shape in the scene's shape table, for the points on this light
     */
    public AreaLight(SurfaceSampler surface, Texture radiance, int shape) {
        this.surface = surface;
        this.radiance = radiance;
        this.shape = shape;
        textured = !radiance.isConstant();
        meanLuminance = meanLuminance();
    }

    /**
     * The light of a shape. On rectangles and meshes with a texture, points are drawn in proportion to its luminance.
     *
     * @param geometry the shape, wound as it is intersected
     * @param toWorld map from the shape's to world coordinates
     * @param flipNormals whether front and back are exchanged
     * @param firstPrimitive number of the shape's first primitive in its level
     * @param radiance emitted radiance in W/(m²·sr), not negative
     * @param shape index of the shape in the scene's shape table
     */
    public static AreaLight of(
            Shape geometry, Transform toWorld, boolean flipNormals, int firstPrimitive, Texture radiance, int shape) {
        SurfaceBrightness brightness = radiance.isConstant() ? null : new TextureBrightness(radiance);
        SurfaceSampler surface = SurfaceSamplers.of(geometry, toWorld, flipNormals, firstPrimitive, brightness);
        return new AreaLight(surface, radiance, shape);
    }

    /** Luminance of a texture. Used while a light is made, by one thread. */
    private static final class TextureBrightness implements SurfaceBrightness {
        private final Texture radiance;
        private final SurfacePoint point = new SurfacePoint();
        private final Spectrum value = new Spectrum();

        TextureBrightness(Texture radiance) {
            this.radiance = radiance;
        }

        @Override
        public double at(double u, double v) {
            point.u = u;
            point.v = v;
            radiance.evaluate(point, value);
            return Math.max(0, value.luminance());
        }

        @Override
        public int detail() {
            return radiance.detail();
        }
    }

    private double meanLuminance() {
        SurfacePoint point = new SurfacePoint();
        Spectrum value = new Spectrum();
        if (!textured) {
            if (!(surface.sampleArea(0.5, 0.5, point) > 0)) {
                return 0;
            }
            read(point, value);
            return value.luminance();
        }
        double sum = 0;
        for (int i = 0; i < AVERAGING_STEPS; i++) {
            for (int j = 0; j < AVERAGING_STEPS; j++) {
                double density = surface.sampleArea((i + 0.5) / AVERAGING_STEPS, (j + 0.5) / AVERAGING_STEPS, point);
                if (density > 0) {
                    read(point, value);
                    sum += value.luminance() / density;
                }
            }
        }
        double area = surface.area();
        // A pattern of bright spots finer than the grid must not count as black.
        double floor = 1e-3 * Math.max(0, radiance.maximum());
        return area > 0 ? Math.max(sum / (AVERAGING_STEPS * AVERAGING_STEPS * area), floor) : 0;
    }

    /** The emitting surface. */
    public SurfaceSampler surface() {
        return surface;
    }

    @Override
    public boolean isDelta() {
        return false;
    }

    @Override
    public boolean isInfinite() {
        return false;
    }

    @Override
    public double power() {
        return Math.PI * surface.area() * meanLuminance;
    }

    @Override
    public double importance(double px, double py, double pz, double nx, double ny, double nz) {
        return meanLuminance * surface.irradiance(px, py, pz, nx, ny, nz);
    }

    @Override
    public @Nullable EmissionBounds bounds() {
        EmissionBounds unit = surface.bounds();
        return unit == null ? null : unit.scaled(meanLuminance);
    }

    @Override
    public boolean sampleIncident(double px, double py, double pz, double u, double v, LightSample out) {
        SurfacePoint point = out.point;
        double density = surface.sampleDirection(px, py, pz, u, v, point);
        if (!(density > 0)) {
            return false;
        }
        double dx = point.x - px;
        double dy = point.y - py;
        double dz = point.z - pz;
        double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (!(distance > 0)) {
            return false;
        }
        out.wiX = dx / distance;
        out.wiY = dy / distance;
        out.wiZ = dz / distance;
        // Rounding may turn a point on the edge of what is visible away.
        if (!(point.geometricCosine(out.wiX, out.wiY, out.wiZ) < 0)) {
            return false;
        }
        read(point, out.weight);
        if (out.weight.isBlack()) {
            return false;
        }
        complete(point);
        out.weight.scale(1 / density);
        out.distance = distance;
        out.density = density;
        out.delta = false;
        return true;
    }

    @Override
    public double incidentDensity(
            double px, double py, double pz, SurfacePoint onLight, double wiX, double wiY, double wiZ) {
        return surface.directionDensity(px, py, pz, onLight, wiX, wiY, wiZ);
    }

    @Override
    public boolean sampleEmission(double u, double v, double s, double t, EmissionSample out) {
        SurfacePoint point = out.point;
        double density = surface.sampleArea(u, v, point);
        if (!(density > 0)) {
            return false;
        }
        read(point, out.weight);
        if (out.weight.isBlack()) {
            return false;
        }
        complete(point);
        double cosine = EmissionDirections.cosineWeighted(point.gx, point.gy, point.gz, s, t, out);
        out.weight.scale(Math.PI / density);
        out.densityPosition = density;
        out.densityDirection = cosine / Math.PI;
        out.deltaPosition = false;
        out.deltaDirection = false;
        return true;
    }

    @Override
    public void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out) {
        out.position = surface.areaDensity(onLight);
        out.direction = Math.max(0, onLight.geometricCosine(dx, dy, dz)) / Math.PI;
    }

    @Override
    public void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out) {
        if (onLight.geometricCosine(dx, dy, dz) > 0) {
            radiance.evaluate(onLight, out);
        } else {
            out.setZero();
        }
    }

    /** Radiance at a point that the sampler has drawn. */
    private void read(SurfacePoint point, Spectrum out) {
        if (textured) {
            surface.setTextureCoordinates(point);
        }
        radiance.evaluate(point, out);
    }

    private void complete(SurfacePoint point) {
        point.shape = shape;
        point.instance = -1;
    }
}
