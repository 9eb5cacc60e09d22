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

    private final TextureImage image;
    private final Filter filter;
    private final Wrap wrap;
    private final double[] uvTransform;
    private final int width;
    private final int height;
    private final int channels;
    private final double meanR;
    private final double meanG;
    private final double meanB;
    private final double maximum;

    /**
     * Creates a texture.
     *
     * @param uvTransform 2×3 affine matrix, row by row, applied to texture coordinates before the look-up:
     *     u′ = m₀u + m₁v + m₂, v′ = m₃u + m₄v + m₅
     * @throws IllegalArgumentException if the matrix has not 6 finite elements
     */
    public BitmapTexture(TextureImage image, Filter filter, Wrap wrap, double[] uvTransform) {
        this.image = image;
        this.filter = filter;
        this.wrap = wrap;
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
        double x = coordinate(m[0] * point.u + m[1] * point.v + m[2], width);
        double y = coordinate(m[3] * point.u + m[4] * point.v + m[5], height);
        if (filter == Filter.NEAREST) {
            int index = wrapped(Math.floor(y), height) * width + wrapped(Math.floor(x), width);
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
        int x0 = wrapped(left, width);
        int x1 = wrapped(left + 1, width);
        int row0 = wrapped(top, height) * width;
        int row1 = wrapped(top + 1, height) * width;
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
        double[] m = uvTransform;
        double x = coordinate(m[0] * point.u + m[1] * point.v + m[2], width);
        double y = coordinate(m[3] * point.u + m[4] * point.v + m[5], height);
        if (filter == Filter.NEAREST) {
            return scalar(wrapped(Math.floor(y), height) * width + wrapped(Math.floor(x), width));
        }
        double left = Math.floor(x - 0.5);
        double top = Math.floor(y - 0.5);
        double fx = x - 0.5 - left;
        double fy = y - 0.5 - top;
        int x0 = wrapped(left, width);
        int x1 = wrapped(left + 1, width);
        int row0 = wrapped(top, height) * width;
        int row1 = wrapped(top + 1, height) * width;
        return (1 - fy) * ((1 - fx) * scalar(row0 + x0) + fx * scalar(row0 + x1))
                + fy * ((1 - fx) * scalar(row1 + x0) + fx * scalar(row1 + x1));
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

    private double scalar(int pixel) {
        return channels == 1
                ? image.value(pixel)
                : Spectrum.luminance(image.value(3 * pixel), image.value(3 * pixel + 1), image.value(3 * pixel + 2));
    }

    /** Position in pixels, brought to within one pixel of the first period so that no precision is lost later. */
    private double coordinate(double u, int size) {
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
    private int wrapped(double cell, int size) {
        int i = (int) cell;
        return switch (wrap) {
            case REPEAT -> i < 0 ? i + size : (i >= size ? i - size : i);
            case MIRROR -> i < 0 || i >= 2 * size ? 0 : (i < size ? i : 2 * size - 1 - i);
            case CLAMP -> Math.min(Math.max(i, 0), size - 1);
        };
    }
}
