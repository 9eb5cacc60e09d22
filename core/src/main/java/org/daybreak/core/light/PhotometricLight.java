package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.PiecewiseConstant2D;

/** A point that emits with the measured distribution of a luminaire. Directions are drawn by a table of the intensity. */
public final class PhotometricLight implements Light {
    /** Lumens of a watt of light at the peak of the eye's response. */
    public static final double EFFICACY = 683.002;

    private static final int COLUMNS = 128;
    private static final int ROWS = 256;
    private static final double UNIFORM_SHARE = 0.01;

    private final PhotometricProfile profile;
    private final Spectrum color;
    private final double luminance;
    private final double mean;
    private final double maximum;
    private final double x;
    private final double y;
    private final double z;
    /** Rotation to the world, row by row. */
    private final double[] m;

    private final PiecewiseConstant2D cells;

    /**
     * Creates a light at the transform's image of the origin; the profile's axis is its image of +z.
     *
     * @param profile intensity over directions
     * @param color factor on the intensity, not negative; a luminance of 1 leaves it as measured: radiant intensity in W/sr is
     *     candela over {@value #EFFICACY}
     * @param toWorld rotation with translation (and reflection) to the world; a uniform scale does not matter
     * @throws IllegalArgumentException if the transform shears
     */
    public PhotometricLight(PhotometricProfile profile, Spectrum color, Transform toWorld) {
        this.profile = profile;
        this.color = color.copy();
        luminance = color.luminance();
        m = DistantFrames.rotation(toWorld);
        double[] d = new double[3];
        toWorld.applyPoint(0, 0, 0, d);
        x = d[0];
        y = d[1];
        z = d[2];
        double[] weights = new double[COLUMNS * ROWS];
        double sum = 0;
        for (int cell = 0; cell < weights.length; cell++) {
            for (int k = 0; k < 4; k++) {
                double phi = 2 * Math.PI * (cell % COLUMNS + (k % 2 + 0.5) / 2) / COLUMNS;
                double cosine = 2 * (Math.floorDiv(cell, COLUMNS) + (Math.floorDiv(k, 2) + 0.5) / 2) / ROWS - 1;
                double sine = Math.sqrt((1 - cosine) * (1 + cosine));
                weights[cell] += 0.25 * profile.candela(sine * Math.cos(phi), sine * Math.sin(phi), cosine);
            }
            sum += weights[cell];
        }
        mean = sum / weights.length / EFFICACY;
        maximum = profile.maximum() / EFFICACY;
        double floor = UNIFORM_SHARE / (1 - UNIFORM_SHARE) * sum / weights.length;
        cells = new PiecewiseConstant2D(COLUMNS, ROWS, (column, row) -> weights[row * COLUMNS + column] + floor);
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
        return 4 * Math.PI * mean * luminance;
    }

    @Override
    public double importance(double px, double py, double pz, double nx, double ny, double nz) {
        double dx = px - x;
        double dy = py - y;
        double dz = pz - z;
        double irradiance = PointGeometry.irradiance(-dx, -dy, -dz, nx, ny, nz);
        if (irradiance == 0) {
            return 0;
        }
        double scale = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        return luminance * intensity(scale * dx, scale * dy, scale * dz) * irradiance;
    }

    @Override
    public EmissionBounds bounds() {
        return EmissionBounds.everywhere(new Bounds(x, y, z, x, y, z), luminance * Math.sqrt(mean * maximum));
    }

    @Override
    public boolean sampleIncident(double px, double py, double pz, double u, double v, LightSample out) {
        if (luminance == 0 || !PointGeometry.connect(x, y, z, px, py, pz, out)) {
            return false;
        }
        double intensity = intensity(-out.wiX, -out.wiY, -out.wiZ);
        if (intensity == 0) {
            return false;
        }
        out.weight.set(color);
        out.weight.scale(intensity / (out.distance * out.distance));
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
        double[] d = out.scratch;
        double density = cells.sample(s, t, d) / (4 * Math.PI);
        double phi = 2 * Math.PI * d[0];
        double cosine = 2 * d[1] - 1;
        double sine = Math.sqrt((1 - cosine) * (1 + cosine));
        DistantFrames.toWorld(m, sine * Math.cos(phi), sine * Math.sin(phi), cosine, d);
        double intensity = intensity(d[0], d[1], d[2]);
        if (luminance == 0 || intensity == 0) {
            return false;
        }
        out.dx = d[0];
        out.dy = d[1];
        out.dz = d[2];
        PointGeometry.start(x, y, z, density, out);
        out.weight.set(color);
        out.weight.scale(intensity / density);
        return true;
    }

    @Override
    public void emissionDensity(SurfacePoint onLight, double dx, double dy, double dz, EmissionDensity out) {
        out.position = 1;
        double turn =
                Math.atan2(DistantFrames.localY(m, dx, dy, dz), DistantFrames.localX(m, dx, dy, dz)) / (2 * Math.PI);
        double u = turn < 0 ? turn + 1 : turn;
        double v = 0.5 * (1 + DistantFrames.localZ(m, dx, dy, dz));
        double below = Math.nextDown(1.0);
        out.direction = intensity(dx, dy, dz) > 0
                ? cells.density(Math.min(u, below), Math.max(0, Math.min(v, below))) / (4 * Math.PI)
                : 0;
    }

    @Override
    public void radiance(SurfacePoint onLight, double dx, double dy, double dz, Spectrum out) {
        out.setZero();
    }

    /** Radiant intensity for unit colour in a direction of travel, in W/sr. */
    private double intensity(double dx, double dy, double dz) {
        return profile.candela(
                        DistantFrames.localX(m, dx, dy, dz),
                        DistantFrames.localY(m, dx, dy, dz),
                        DistantFrames.localZ(m, dx, dy, dz))
                / EFFICACY;
    }
}
