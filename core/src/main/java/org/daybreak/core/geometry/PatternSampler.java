package org.daybreak.core.geometry;

import org.daybreak.core.sampling.PiecewiseConstant2D;

/**
 * A parallelogram with a pattern: points are drawn in proportion to its brightness, tabulated on a grid of texture coordinates.
 * A small share is drawn from everywhere, so that whatever the grid misses has density. From nearby half of the directions
 * are drawn as if there were no pattern, for there the distance matters as much as the brightness.
 */
final class PatternSampler implements SurfaceSampler {
    private static final int LARGEST_GRID = 1024;

    /** Samples along each side of a cell that its brightness is averaged over. */
    private static final int STEPS = 3;

    /** Part of the points that does not follow the pattern. */
    private static final double UNIFORM_SHARE = 0.02;

    private final ParallelogramSampler plain;
    private final PiecewiseConstant2D pattern;

    PatternSampler(ParallelogramSampler plain, SurfaceBrightness brightness) {
        this.plain = plain;
        int cells = Math.min(LARGEST_GRID, brightness.detail());
        double[] means = new double[cells * cells];
        double sum = 0;
        for (int row = 0; row < cells; row++) {
            for (int column = 0; column < cells; column++) {
                double cell = 0;
                for (int i = 0; i < STEPS * STEPS; i++) {
                    cell += brightness.at(
                            (column + (i % STEPS + 0.5) / STEPS) / cells,
                            (row + (Math.floorDiv(i, STEPS) + 0.5) / STEPS) / cells);
                }
                means[row * cells + column] = cell / (STEPS * STEPS);
                sum += cell / (STEPS * STEPS);
            }
        }
        double floor = UNIFORM_SHARE / (1 - UNIFORM_SHARE) * sum / means.length;
        pattern = new PiecewiseConstant2D(cells, cells, (column, row) -> means[row * cells + column] + floor);
    }

    @Override
    public double area() {
        return plain.area();
    }

    @Override
    public double sampleArea(double u, double v, SurfacePoint out) {
        double density = pattern.sample(u, v, out.scratch);
        plain.fill(out.scratch[0], out.scratch[1], out);
        return density / plain.area();
    }

    /** The point must have the texture coordinates of the rectangle, as hits and drawn points have. */
    @Override
    public double areaDensity(SurfacePoint on) {
        return pattern.density(inside(on.u), inside(on.v)) / plain.area();
    }

    private static double inside(double coordinate) {
        return Math.max(0, Math.min(coordinate, Math.nextDown(1.0)));
    }

    @Override
    public double sampleDirection(double px, double py, double pz, double u, double v, SurfacePoint out) {
        if (!plain.bySolidAngle(px, py, pz)) {
            return SurfaceSampler.super.sampleDirection(px, py, pz, u, v, out);
        }
        if (u < 0.5) {
            double density = plain.sampleDirection(px, py, pz, 2 * u, v, out);
            return density > 0 ? 0.5 * (density + SurfaceSampler.perSolidAngle(areaDensity(out), px, py, pz, out)) : 0;
        }
        double perArea = sampleArea(2 * u - 1, v, out);
        double density = SurfaceSampler.perSolidAngle(perArea, px, py, pz, out);
        if (!(density > 0)) {
            return 0;
        }
        double dx = out.x - px;
        double dy = out.y - py;
        double dz = out.z - pz;
        double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return 0.5 * (density + plain.directionDensity(px, py, pz, out, dx / distance, dy / distance, dz / distance));
    }

    @Override
    public double directionDensity(
            double px, double py, double pz, SurfacePoint on, double wiX, double wiY, double wiZ) {
        double density = SurfaceSampler.super.directionDensity(px, py, pz, on, wiX, wiY, wiZ);
        return plain.bySolidAngle(px, py, pz)
                ? 0.5 * (density + plain.directionDensity(px, py, pz, on, wiX, wiY, wiZ))
                : density;
    }

    @Override
    public double irradiance(double px, double py, double pz, double nx, double ny, double nz) {
        return plain.irradiance(px, py, pz, nx, ny, nz);
    }

    @Override
    public EmissionBounds bounds() {
        return plain.bounds();
    }
}
