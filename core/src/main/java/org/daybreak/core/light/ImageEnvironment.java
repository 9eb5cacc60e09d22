package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.PiecewiseConstant2D;

/**
 * A panorama around the scene: radiance interpolated bilinearly between the pixels of a {@link RadianceMap}.
 *
 * <p>Directions are drawn in proportion to luminance, colour and the shape of sin θ within a row aside: first a cell between
 * four pixels by its exact integral, then a point in it by a bilinear density. A cell gets a positive density
 * everywhere if any of its corners is not black, so wherever there is radiance there is density.
 */
public final class ImageEnvironment extends DistantRadiance {
    /** Least sine of the polar angle in densities, which are singular at the poles. */
    private static final double LEAST_SINE = 1e-12;

    private final RadianceMap map;
    private final double scale;
    private final int width;
    private final int height;
    /** Rows of cells; a single row of pixels makes one that is constant in the polar angle. */
    private final int rows;

    private final PiecewiseConstant2D cells;
    /** Integrals of 1 − t and t times sin θ over each row of cells, t running from 0 to 1. */
    private final double[] upperWeights;

    private final double[] lowerWeights;

    /** World-to-local and local-to-world matrices for directions, of determinant ±1. */
    private final double[] inverse;

    private final double[] forward;

    private final IrradianceHarmonics harmonics;

    /**
     * Creates a light.
     *
     * @param map the panorama
     * @param scale factor on its values, not negative
     * @param toWorld map of the panorama's directions to the world; the translation does not matter
     * @param centreX centre of a sphere that holds the scene
     * @param sceneRadius its radius; 0 for an empty scene, to which the light gives no power
     * @throws IllegalArgumentException if the scale is negative or not finite
     */
    public ImageEnvironment(
            RadianceMap map,
            double scale,
            Transform toWorld,
            double centreX,
            double centreY,
            double centreZ,
            double sceneRadius) {
        super(centreX, centreY, centreZ, sceneRadius);
        if (!(scale >= 0) || Double.isInfinite(scale)) {
            throw new IllegalArgumentException("the scale of an environment must not be negative but is " + scale);
        }
        this.map = map;
        this.scale = scale;
        width = map.width();
        height = map.height();
        rows = Math.max(1, height - 1);
        upperWeights = new double[rows];
        lowerWeights = new double[rows];
        double step = Math.PI / rows;
        for (int row = 0; row < rows; row++) {
            // ∫₀¹ sin(θ₀ + tΔ) dt and ∫₀¹ t sin(θ₀ + tΔ) dt, written about the middle of the row, where nothing
            // cancels.
            double middle = (row + 0.5) * step;
            double half = 0.5 * step;
            double whole = Math.sin(middle) * Math.sin(half) / half;
            double tilt = 0.5 * Math.cos(middle) * firstMoment(half);
            lowerWeights[row] = 0.5 * whole + tilt;
            upperWeights[row] = 0.5 * whole - tilt;
        }
        cells = new PiecewiseConstant2D(width, rows, this::cellWeight);
        double[] m = toWorld.rows();
        double[] r = toWorld.inverse().rows();
        double unit = Math.cbrt(Math.abs(m[0] * (m[5] * m[10] - m[6] * m[9])
                - m[1] * (m[4] * m[10] - m[6] * m[8])
                + m[2] * (m[4] * m[9] - m[5] * m[8])));
        forward = new double[] {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]};
        inverse = new double[] {r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10]};
        for (int i = 0; i < 9; i++) {
            forward[i] /= unit;
            inverse[i] *= unit;
        }
        harmonics = integrate();
    }

    /** {@code ½∫₋₁¹ s·sin(hs) ds = (sin h − h cos h)/h²}, by its series where that cancels. */
    private static double firstMoment(double h) {
        return h < 1e-3 ? h / 3 * (1 - h * h / 10) : (Math.sin(h) - h * Math.cos(h)) / (h * h);
    }

    private double cellWeight(int column, int row) {
        int next = column + 1 < width ? column + 1 : 0;
        int below = Math.min(row + 1, height - 1);
        double upper = 0.5 * (luminance(column, row) + luminance(next, row));
        double lower = 0.5 * (luminance(column, below) + luminance(next, below));
        return upper * upperWeights[row] + lower * lowerWeights[row];
    }

    private IrradianceHarmonics integrate() {
        IrradianceHarmonics.Builder builder = new IrradianceHarmonics.Builder();
        double cellAngle = 2 * Math.PI / width * (Math.PI / rows);
        for (int row = 0; row < rows; row++) {
            double theta = Math.PI * (row + 0.5) / rows;
            double sine = Math.sin(theta);
            double y = Math.cos(theta);
            for (int column = 0; column < width; column++) {
                double phi = 2 * Math.PI * (column + 1.0) / width;
                double x = Math.sin(phi) * sine;
                double z = -Math.cos(phi) * sine;
                double wx = forward[0] * x + forward[1] * y + forward[2] * z;
                double wy = forward[3] * x + forward[4] * y + forward[5] * z;
                double wz = forward[6] * x + forward[7] * y + forward[8] * z;
                double length = Math.sqrt(wx * wx + wy * wy + wz * wz);
                double angle = cellAngle / (length * length * length);
                builder.add(scale * cellWeight(column, row) * angle, wx / length, wy / length, wz / length);
            }
        }
        return builder.build();
    }

    @Override
    IrradianceHarmonics harmonics() {
        return harmonics;
    }

    @Override
    void look(double wx, double wy, double wz, Spectrum out) {
        double x = inverse[0] * wx + inverse[1] * wy + inverse[2] * wz;
        double y = inverse[3] * wx + inverse[4] * wy + inverse[5] * wz;
        double z = inverse[6] * wx + inverse[7] * wy + inverse[8] * wz;
        double column = columnPosition(x, z);
        double row = rowPosition(x, y, z);
        int c0 = Math.min((int) column, width - 1);
        int r0 = Math.min((int) row, rows - 1);
        double s = column - c0;
        double t = row - r0;
        int c1 = c0 + 1 < width ? c0 + 1 : 0;
        int r1 = Math.min(r0 + 1, height - 1);
        float[] rgb = map.rgb();
        int i00 = pixel(c0, r0);
        int i10 = pixel(c1, r0);
        int i01 = pixel(c0, r1);
        int i11 = pixel(c1, r1);
        double w00 = scale * (1 - s) * (1 - t);
        double w10 = scale * s * (1 - t);
        double w01 = scale * (1 - s) * t;
        double w11 = scale * s * t;
        out.set(
                w00 * rgb[i00] + w10 * rgb[i10] + w01 * rgb[i01] + w11 * rgb[i11],
                w00 * rgb[i00 + 1] + w10 * rgb[i10 + 1] + w01 * rgb[i01 + 1] + w11 * rgb[i11 + 1],
                w00 * rgb[i00 + 2] + w10 * rgb[i10 + 2] + w01 * rgb[i01 + 2] + w11 * rgb[i11 + 2]);
    }

    /** Draws a unit direction of the world and returns its density per solid angle. */
    @Override
    double sampleDirection(double u, double v, double[] dest) {
        double cellDensity = cells.sample(u, v, dest);
        double column = dest[0] * width;
        double row = dest[1] * rows;
        int c = Math.min((int) column, width - 1);
        int r = Math.min((int) row, rows - 1);
        int next = c + 1 < width ? c + 1 : 0;
        int below = Math.min(r + 1, height - 1);
        double w00 = upperWeights[r] * luminance(c, r);
        double w10 = upperWeights[r] * luminance(next, r);
        double w01 = lowerWeights[r] * luminance(c, below);
        double w11 = lowerWeights[r] * luminance(next, below);
        double t = sampleLinear(row - r, w00 + w10, w01 + w11);
        double left = (1 - t) * w00 + t * w01;
        double right = (1 - t) * w10 + t * w11;
        double s = sampleLinear(column - c, left, right);
        double density = cellDensity * shape(w00, w10, w01, w11, s, t);
        double phi = 2 * Math.PI * (c + s + 0.5) / width;
        double theta = Math.PI * (r + t) / rows;
        double sine = Math.sin(theta);
        double x = Math.sin(phi) * sine;
        double y = Math.cos(theta);
        double z = -Math.cos(phi) * sine;
        double wx = forward[0] * x + forward[1] * y + forward[2] * z;
        double wy = forward[3] * x + forward[4] * y + forward[5] * z;
        double wz = forward[6] * x + forward[7] * y + forward[8] * z;
        double length = Math.sqrt(wx * wx + wy * wy + wz * wz);
        dest[0] = wx / length;
        dest[1] = wy / length;
        dest[2] = wz / length;
        return density * length * length * length / (2 * Math.PI * Math.PI * Math.max(sine, LEAST_SINE));
    }

    /** Density per solid angle of a unit direction of the world. */
    @Override
    double density(double wx, double wy, double wz) {
        double x = inverse[0] * wx + inverse[1] * wy + inverse[2] * wz;
        double y = inverse[3] * wx + inverse[4] * wy + inverse[5] * wz;
        double z = inverse[6] * wx + inverse[7] * wy + inverse[8] * wz;
        double column = columnPosition(x, z);
        double row = rowPosition(x, y, z);
        int c = Math.min((int) column, width - 1);
        int r = Math.min((int) row, rows - 1);
        int next = c + 1 < width ? c + 1 : 0;
        int below = Math.min(r + 1, height - 1);
        double shape = shape(
                upperWeights[r] * luminance(c, r),
                upperWeights[r] * luminance(next, r),
                lowerWeights[r] * luminance(c, below),
                lowerWeights[r] * luminance(next, below),
                column - c,
                row - r);
        double cellDensity = cells.density((c + 0.5) / width, (r + 0.5) / rows);
        double length = Math.sqrt(x * x + y * y + z * z);
        double sine = Math.max(Math.sqrt(x * x + z * z) / length, LEAST_SINE);
        return cellDensity * shape / (2 * Math.PI * Math.PI * sine * length * length * length);
    }

    /** Position among the columns of cells, in [0, width]: cell i spans the pixel centres i and i + 1. */
    private double columnPosition(double x, double z) {
        double position = Math.atan2(x, -z) / (2 * Math.PI) * width - 0.5;
        return position < 0 ? position + width : position;
    }

    /** Position among the rows of cells, in [0, rows]. */
    private double rowPosition(double x, double y, double z) {
        return Math.atan2(Math.sqrt(x * x + z * z), y) / Math.PI * rows;
    }

    /** Density within a cell for bilinear corner weights, relative to the uniform one. */
    private static double shape(double w00, double w10, double w01, double w11, double s, double t) {
        double sum = w00 + w10 + w01 + w11;
        if (!(sum > 0)) {
            return 1;
        }
        return 4 * ((1 - t) * ((1 - s) * w00 + s * w10) + t * ((1 - s) * w01 + s * w11)) / sum;
    }

    /** Number in [0, 1] with a density that runs linearly from a to b, increasing in u. */
    private static double sampleLinear(double u, double a, double b) {
        if (!(a + b > 0)) {
            return u;
        }
        return Math.min(1, u * (a + b) / (a + Math.sqrt((1 - u) * a * a + u * b * b)));
    }

    private double luminance(int column, int row) {
        float[] rgb = map.rgb();
        int i = pixel(column, row);
        return Spectrum.luminance(rgb[i], rgb[i + 1], rgb[i + 2]);
    }

    private int pixel(int column, int row) {
        return 3 * (row * width + column);
    }
}
