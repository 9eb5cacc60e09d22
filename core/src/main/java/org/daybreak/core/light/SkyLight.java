package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.PiecewiseConstant2D;

/**
 * A clear sky without its sun, over the upper half of all directions. Directions are drawn by a table of the luminance over azimuth
 * from the sun and height, whose cells are equal in solid angle; the radiance is that of the model, not of the table.
 */
public final class SkyLight extends DistantRadiance {
    private static final int COLUMNS = 256;
    private static final int ROWS = 128;

    /** Samples along each side of a cell that its luminance is averaged over. */
    private static final int STEPS = 2;

    /** Part of the directions that is uniform over the hemisphere. */
    private static final double UNIFORM_SHARE = 0.01;

    private static final double CELL_ANGLE = 2 * Math.PI / (COLUMNS * ROWS);

    private final SkyModel model;
    private final double scale;
    private final boolean day;
    private final double sunX;
    private final double sunY;
    private final double sunZ;
    /** Azimuth of the sun. */
    private final double azimuth;
    /** Rotation to the world, row by row. */
    private final double[] m;

    private final PiecewiseConstant2D cells;
    private final IrradianceHarmonics harmonics;

    /**
     * Creates a light.
     *
     * @param settings atmosphere and sun; the zenith is +z
     * @param scale factor on the radiance, not negative
     * @param toWorld rotation (or reflection) to the world; a uniform scale and the translation do not matter
     * @param centreX centre of a sphere that holds the scene
     * @param sceneRadius its radius; 0 for an empty scene, to which the light gives no power
     * @throws IllegalArgumentException if the scale is negative or not finite
     */
    public SkyLight(
            SkySettings settings,
            double scale,
            Transform toWorld,
            double centreX,
            double centreY,
            double centreZ,
            double sceneRadius) {
        super(centreX, centreY, centreZ, sceneRadius);
        if (!(scale >= 0) || Double.isInfinite(scale)) {
            throw new IllegalArgumentException("the scale of the sky must not be negative but is " + scale);
        }
        model = settings.model();
        this.scale = scale;
        sunX = settings.sun().x;
        sunY = settings.sun().y;
        sunZ = settings.sun().z;
        day = sunZ >= 0;
        azimuth = Math.atan2(sunY, sunX);
        m = DistantFrames.rotation(toWorld);
        double[] luminance = new double[COLUMNS * ROWS];
        IrradianceHarmonics.Builder builder = new IrradianceHarmonics.Builder();
        Spectrum value = new Spectrum();
        double[] d = new double[3];
        double sum = 0;
        for (int cell = 0; cell < luminance.length; cell++) {
            for (int k = 0; k < STEPS * STEPS; k++) {
                direction(
                        (cell % COLUMNS + (k % STEPS + 0.5) / STEPS) / COLUMNS,
                        (Math.floorDiv(cell, COLUMNS) + (Math.floorDiv(k, STEPS) + 0.5) / STEPS) / ROWS,
                        d);
                look(d[0], d[1], d[2], value);
                double part = value.luminance() / (STEPS * STEPS);
                luminance[cell] += part;
                builder.add(part * CELL_ANGLE, d[0], d[1], d[2]);
            }
            sum += luminance[cell];
        }
        double floor = UNIFORM_SHARE / (1 - UNIFORM_SHARE) * sum / luminance.length;
        cells = new PiecewiseConstant2D(COLUMNS, ROWS, (column, row) -> luminance[row * COLUMNS + column] + floor);
        harmonics = builder.build();
    }

    /** Direction in the world of a place in the table. */
    private void direction(double u, double v, double[] dest) {
        double phi = azimuth + 2 * Math.PI * u;
        double sine = Math.sqrt((1 - v) * (1 + v));
        DistantFrames.toWorld(m, sine * Math.cos(phi), sine * Math.sin(phi), v, dest);
    }

    @Override
    IrradianceHarmonics harmonics() {
        return harmonics;
    }

    @Override
    double sampleDirection(double u, double v, double[] dest) {
        double density = cells.sample(u, v, dest);
        direction(dest[0], dest[1], dest);
        return density / (2 * Math.PI);
    }

    @Override
    double density(double wx, double wy, double wz) {
        double z = DistantFrames.localZ(m, wx, wy, wz);
        if (!(z >= 0)) {
            return 0;
        }
        double phi = Math.atan2(DistantFrames.localY(m, wx, wy, wz), DistantFrames.localX(m, wx, wy, wz)) - azimuth;
        double u = phi / (2 * Math.PI);
        u -= Math.floor(u);
        return cells.density(Math.min(u, Math.nextDown(1.0)), Math.min(z, Math.nextDown(1.0))) / (2 * Math.PI);
    }

    @Override
    void look(double wx, double wy, double wz, Spectrum out) {
        double z = DistantFrames.localZ(m, wx, wy, wz);
        if (!day || !(z >= 0)) {
            out.setZero();
            return;
        }
        double x = DistantFrames.localX(m, wx, wy, wz);
        double y = DistantFrames.localY(m, wx, wy, wz);
        double gamma = Math.acos(Math.max(-1, Math.min(1, x * sunX + y * sunY + z * sunZ)));
        model.radiance(Math.min(z, 1), gamma, out);
        out.scale(scale);
    }
}
