package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * An image laid over texture space: the image covers the unit square, row 0 at v = 0, pixel centres at half-integers.
 * This is Mitsuba 3's convention; its readers of OBJ files flip v, so that pictures stand upright there.
 */
public final class BitmapTexture implements Texture {
    /** How values between pixel centres come about. */
    public enum Filter {
        /** Linear between the four nearest pixels. */
        BILINEAR,
        /** The nearest pixel. */
        NEAREST
    }

    /** What lies outside the unit square. */
    public enum Wrap {
        /** The image again. */
        REPEAT,
        /** The image, every second time mirrored. */
        MIRROR,
        /** The pixels of the border. */
        CLAMP
    }

    /** Stands for the luminance where a channel is asked for. */
    private static final int SCALAR = -1;

    private final TextureImage image;
    private final Filter filter;
    private final Wrap wrapU;
    private final Wrap wrapV;
    private final double[] uvTransform;
    private final boolean secondUvs;
    private final int width;
    private final int height;
    private final int channels;
    private final double meanR;
    private final double meanG;
    private final double meanB;
    private final double maximum;

    /**
     * Creates a texture over the first texture coordinates:
     * {@link #BitmapTexture(TextureImage, Filter, Wrap, Wrap, double[], boolean)}.
     */
    public BitmapTexture(TextureImage image, Filter filter, Wrap wrap, double[] uvTransform) {
        this(image, filter, wrap, wrap, uvTransform, false);
    }

    /**
     * Creates a texture.
     *
     * @param wrapU what lies to the left and right of the image
     * @param wrapV what lies above and below it
     * @param uvTransform 2×3 affine matrix, row by row, applied to texture coordinates before the look-up:
     *     u′ = m₀u + m₁v + m₂, v′ = m₃u + m₄v + m₅
     * @param secondUvs true to lay the image over the second texture coordinates
     * @throws IllegalArgumentException if the matrix has not 6 finite elements
     */
    public BitmapTexture(
            TextureImage image, Filter filter, Wrap wrapU, Wrap wrapV, double[] uvTransform, boolean secondUvs) {
        this.secondUvs = secondUvs;
        this.image = image;
        this.filter = filter;
        this.wrapU = wrapU;
        this.wrapV = wrapV;
        this.uvTransform = Checks.requireAffine(uvTransform);
        this.width = image.width();
        this.height = image.height();
        this.channels = image.channels();
        double[] sum = new double[channels];
        double largest = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < channels; c++) {
                    double value = image.value(x, y, c);
                    sum[c] += value;
                    largest = Math.max(largest, value);
                }
            }
        }
        double pixels = (double) width * height;
        this.meanR = sum[0] / pixels;
        this.meanG = sum[channels == 3 ? 1 : 0] / pixels;
        this.meanB = sum[channels == 3 ? 2 : 0] / pixels;
        this.maximum = largest;
    }

    @Override
    public void evaluate(SurfacePoint point, Spectrum out) {
        double[] m = uvTransform;
        double u = secondUvs ? point.u2 : point.u;
        double v = secondUvs ? point.v2 : point.v;
        double x = coordinate(m[0] * u + m[1] * v + m[2], width, wrapU);
        double y = coordinate(m[3] * u + m[4] * v + m[5], height, wrapV);
        if (filter == Filter.NEAREST) {
            int index = wrapped(Math.floor(y), height, wrapV) * width + wrapped(Math.floor(x), width, wrapU);
            if (channels == 1) {
                out.set(image.value(index));
            } else {
                out.set(image.value(3 * index), image.value(3 * index + 1), image.value(3 * index + 2));
            }
            return;
        }
        double left = Math.floor(x - 0.5);
        double top = Math.floor(y - 0.5);
        double fx = x - 0.5 - left;
        double fy = y - 0.5 - top;
        int x0 = wrapped(left, width, wrapU);
        int x1 = wrapped(left + 1, width, wrapU);
        int row0 = wrapped(top, height, wrapV) * width;
        int row1 = wrapped(top + 1, height, wrapV) * width;
        int i00 = (row0 + x0) * channels;
        int i10 = (row0 + x1) * channels;
        int i01 = (row1 + x0) * channels;
        int i11 = (row1 + x1) * channels;
        double first = interpolate(i00, i10, i01, i11, fx, fy);
        if (channels == 1) {
            out.set(first);
        } else {
            out.set(
                    first,
                    interpolate(i00 + 1, i10 + 1, i01 + 1, i11 + 1, fx, fy),
                    interpolate(i00 + 2, i10 + 2, i01 + 2, i11 + 2, fx, fy));
        }
    }

    @Override
    public double evaluateScalar(SurfacePoint point) {
        return sample(point, SCALAR, false, 0, 0);
    }

    @Override
    public double component(SurfacePoint point, int index) {
        return sample(point, channels == 1 ? 0 : index, false, 0, 0);
    }

    @Override
    public boolean differentiable() {
        return true;
    }

    @Override
    public boolean usesSecondUvs() {
        return secondUvs;
    }

    @Override
    public double derivativeU(SurfacePoint point) {
        return sample(point, SCALAR, true, uvTransform[0], uvTransform[3]);
    }

    @Override
    public double derivativeV(SurfacePoint point) {
        return sample(point, SCALAR, true, uvTransform[1], uvTransform[4]);
    }

    /**
     * A channel or the scalar value at a point, or its derivative.
     *
     * @param channel a channel or {@link #SCALAR}
     * @param derivative whether the derivative is asked for
     * @param dx with {@code dy} the direction in the image's own unit square to take the derivative along
     */
    private double sample(SurfacePoint point, int channel, boolean derivative, double dx, double dy) {
        double[] m = uvTransform;
        double pu = secondUvs ? point.u2 : point.u;
        double pv = secondUvs ? point.v2 : point.v;
        double u = m[0] * pu + m[1] * pv + m[2];
        double v = m[3] * pu + m[4] * pv + m[5];
        double x = coordinate(u, width, wrapU);
        double y = coordinate(v, height, wrapV);
        if (filter == Filter.NEAREST) {
            return derivative
                    ? 0
                    : value(
                            wrapped(Math.floor(y), height, wrapV) * width + wrapped(Math.floor(x), width, wrapU),
                            channel);
        }
        double left = Math.floor(x - 0.5);
        double top = Math.floor(y - 0.5);
        double fx = x - 0.5 - left;
        double fy = y - 0.5 - top;
        int x0 = wrapped(left, width, wrapU);
        int x1 = wrapped(left + 1, width, wrapU);
        int row0 = wrapped(top, height, wrapV) * width;
        int row1 = wrapped(top + 1, height, wrapV) * width;
        double v00 = value(row0 + x0, channel);
        double v10 = value(row0 + x1, channel);
        double v01 = value(row1 + x0, channel);
        double v11 = value(row1 + x1, channel);
        if (derivative) {
            return dx * width * ((1 - fy) * (v10 - v00) + fy * (v11 - v01))
                    + dy * height * ((1 - fx) * (v01 - v00) + fx * (v11 - v10));
        }
        return (1 - fy) * ((1 - fx) * v00 + fx * v10) + fy * ((1 - fx) * v01 + fx * v11);
    }

    @Override
    public void mean(Spectrum out) {
        out.set(meanR, meanG, meanB);
    }

    @Override
    public int detail() {
        double[] m = uvTransform;
        double columns = width * (Math.abs(m[0]) + Math.abs(m[1]));
        double rows = height * (Math.abs(m[3]) + Math.abs(m[4]));
        return (int) Math.max(1, Math.min(65_536, Math.ceil(Math.max(columns, rows))));
    }

    @Override
    public double maximum() {
        return maximum;
    }

    private double interpolate(int i00, int i10, int i01, int i11, double fx, double fy) {
        return (1 - fy) * ((1 - fx) * image.value(i00) + fx * image.value(i10))
                + fy * ((1 - fx) * image.value(i01) + fx * image.value(i11));
    }

    private double value(int pixel, int channel) {
        return channel != SCALAR || channels == 1
                ? image.value(channels * pixel + Math.max(0, channel))
                : Spectrum.luminance(image.value(3 * pixel), image.value(3 * pixel + 1), image.value(3 * pixel + 2));
    }

    /** Position in pixels, brought to within one pixel of the first period so that no precision is lost later. */
    private static double coordinate(double u, int size, Wrap wrap) {
        if (!Double.isFinite(u)) {
            return 0;
        }
        return switch (wrap) {
            case REPEAT -> (u - Math.floor(u)) * size;
            case MIRROR -> (u - 2 * Math.floor(0.5 * u)) * size;
            case CLAMP -> Math.min(Math.max(u, -1), 2) * size;
        };
    }

    /** Column or row of the image for one within a pixel of the first period. */
    private static int wrapped(double cell, int size, Wrap wrap) {
        int i = (int) cell;
        return switch (wrap) {
            case REPEAT -> i < 0 ? i + size : (i >= size ? i - size : i);
            case MIRROR -> i < 0 || i >= 2 * size ? 0 : (i < size ? i : 2 * size - 1 - i);
            case CLAMP -> Math.min(Math.max(i, 0), size - 1);
        };
    }
}
