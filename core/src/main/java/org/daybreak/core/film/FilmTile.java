package org.daybreak.core.film;

import java.util.Arrays;
import org.daybreak.core.color.Spectrum;
import org.jspecify.annotations.Nullable;

/**
 * A part of a film that one worker fills: the samples of a rectangle of pixels, with the border that the filter reaches
 * into. Mutable, owned by one worker at a time, reused; {@link Film#commit(FilmTile)} adds it to the film.
 */
public final class FilmTile {
    private final FilmLayout layout;
    private final FilterKernel kernel;
    private final int border;
    private final double radius;
    private final FilmSettings.Crop crop;
    private final double[] weightsX;
    private final double[] weightsY;
    private double[] sums = new double[0];
    private int x0;
    private int y0;
    private int width;
    private int height;
    private long samples;
    private double sampleWeight = 1;

    FilmTile(FilmSettings settings, FilmLayout layout, FilterKernel kernel) {
        this.layout = layout;
        this.kernel = kernel;
        this.crop = settings.crop();
        this.radius = settings.filter().radius();
        this.border = settings.filterSampling() ? 0 : FilterKernel.border(settings.filter());
        int reach = 2 * border + 2;
        weightsX = new double[reach];
        weightsY = new double[reach];
    }

    /**
     * Empties the tile and moves it to a rectangle of pixels, within {@link Film#sampleArea()}, where samples will be
     * taken.
     */
    public void begin(int x, int y, int width, int height) {
        x0 = Math.max(crop.x(), x - border);
        y0 = Math.max(crop.y(), y - border);
        this.width = Math.max(0, Math.min(crop.x() + crop.width(), x + width + border) - x0);
        this.height = Math.max(0, Math.min(crop.y() + crop.height(), y + height + border) - y0);
        int length = Math.multiplyExact(Math.multiplyExact(this.width, this.height), layout.stride);
        if (sums.length < length) {
            sums = new double[length];
        } else {
            Arrays.fill(sums, 0, length, 0);
        }
        samples = 0;
        sampleWeight = 1;
    }

    /**
     * Sets the weight of the samples that follow, on top of the filter's; 1 after {@link #begin}.
     *
     * @param weight finite and positive; 1 unless the film {@linkplain Film#useSampleWeights() uses weights}
     */
    public void setSampleWeight(double weight) {
        sampleWeight = weight;
    }

    /**
     * Adds a sample.
     *
     * @param filmX film position in pixels, in the rectangle given to {@link #begin}
     * @param value radiance
     * @return false if the value is not finite: it is then left out, and the caller records the sample's address
     */
    public boolean add(double filmX, double filmY, Spectrum value) {
        return add(filmX, filmY, value, null);
    }

    /**
     * Adds a sample with what it sees first. Auxiliary images are means over all samples, so each sample that is added to a
     * film with such layers must bring its features.
     *
     * @return false if a value is not finite: the whole sample is then left out, and the caller records its address
     */
    public boolean add(double filmX, double filmY, Spectrum value, @Nullable FilmFeatures features) {
        if (!value.isFinite() || (features != null && !features.isFinite())) {
            return false;
        }
        samples++;
        if (layout.unitWeights) {
            int px = (int) filmX - x0;
            int py = (int) filmY - y0;
            if (px >= 0 && py >= 0 && px < width && py < height) {
                int at = (py * width + px) * layout.stride;
                addUnweighted(at, value);
                if (features != null && features.hit) {
                    addFeatures(at, 1, features);
                }
            }
            return true;
        }
        if (layout.pixelBox) {
            int px = (int) filmX - x0;
            int py = (int) filmY - y0;
            if (px >= 0 && py >= 0 && px < width && py < height) {
                int at = (py * width + px) * layout.stride;
                addWeighted(at, sampleWeight, value, value.luminance());
                if (features != null && features.hit) {
                    addFeatures(at, sampleWeight, features);
                }
            }
            return true;
        }
        int fromX = Math.max((int) Math.ceil(filmX - radius - 0.5), x0);
        int toX = Math.min((int) Math.floor(filmX + radius - 0.5), x0 + width - 1);
        int fromY = Math.max((int) Math.ceil(filmY - radius - 0.5), y0);
        int toY = Math.min((int) Math.floor(filmY + radius - 0.5), y0 + height - 1);
        for (int x = fromX; x <= toX; x++) {
            weightsX[x - fromX] = kernel.weight(x + 0.5 - filmX);
        }
        for (int y = fromY; y <= toY; y++) {
            weightsY[y - fromY] = kernel.weight(y + 0.5 - filmY);
        }
        double luminance = value.luminance();
        for (int y = fromY; y <= toY; y++) {
            double wy = sampleWeight * weightsY[y - fromY];
            int at = ((y - y0) * width + fromX - x0) * layout.stride;
            for (int x = fromX; x <= toX; x++, at += layout.stride) {
                double w = wy * weightsX[x - fromX];
                addWeighted(at, w, value, luminance);
                if (features != null && features.hit) {
                    addFeatures(at, w, features);
                }
            }
        }
        return true;
    }

    /**
     * Adds a sample to a pixel, for films with {@linkplain FilmSettings#filterSampling() filter sampling}.
     *
     * @param x column of the pixel, in the rectangle given to {@link #begin}
     * @param factor what {@link FilterSampler} says about the sample's position
     * @param value radiance; multiplied by the factor on return
     * @return false if a value is not finite: the whole sample is then left out, and the caller records its address
     */
    public boolean addToPixel(int x, int y, double factor, Spectrum value, @Nullable FilmFeatures features) {
        if (!value.isFinite() || (features != null && !features.isFinite())) {
            return false;
        }
        samples++;
        value.scale(factor);
        int at = ((y - y0) * width + x - x0) * layout.stride;
        if (layout.unitWeights) {
            addUnweighted(at, value);
        } else {
            addWeighted(at, sampleWeight, value, value.luminance());
        }
        if (features != null && features.hit) {
            addFeatures(at, sampleWeight * factor, features);
        }
        return true;
    }

    /** Number of samples added since {@link #begin}. */
    public long samples() {
        return samples;
    }

    private void addUnweighted(int at, Spectrum v) {
        double luminance = v.luminance();
        sums[at] += 1;
        sums[at + 1] += v.r;
        sums[at + 2] += v.g;
        sums[at + 3] += v.b;
        sums[at + FilmLayout.LUMINANCE_SQUARED] += luminance * luminance;
        if (layout.variance) {
            int second = at + layout.second;
            sums[second] += v.r * v.r;
            sums[second + 1] += v.g * v.g;
            sums[second + 2] += v.b * v.b;
        }
    }

    private void addWeighted(int at, double w, Spectrum v, double luminance) {
        sums[at] += w;
        sums[at + 1] += w * v.r;
        sums[at + 2] += w * v.g;
        sums[at + 3] += w * v.b;
        double ww = w * w;
        sums[at + FilmLayout.LUMINANCE_SQUARED] += ww * luminance * luminance;
        sums[at + layout.squaredWeight] += ww;
        sums[at + layout.squaredWeight + 1] += ww * luminance;
        if (layout.variance) {
            int first = at + layout.first;
            sums[first] += ww * v.r;
            sums[first + 1] += ww * v.g;
            sums[first + 2] += ww * v.b;
            int second = at + layout.second;
            sums[second] += ww * v.r * v.r;
            sums[second + 1] += ww * v.g * v.g;
            sums[second + 2] += ww * v.b * v.b;
        }
    }

    private void addFeatures(int at, double w, FilmFeatures f) {
        if (layout.albedo >= 0) {
            int i = at + layout.albedo;
            sums[i] += w * f.albedo.r;
            sums[i + 1] += w * f.albedo.g;
            sums[i + 2] += w * f.albedo.b;
        }
        if (layout.normal >= 0) {
            int i = at + layout.normal;
            sums[i] += w * f.nx;
            sums[i + 1] += w * f.ny;
            sums[i + 2] += w * f.nz;
        }
        if (layout.depth >= 0) {
            int i = at + layout.depth;
            sums[i] += w * f.depth;
            sums[i + 1] += w;
        }
    }

    /** Adds all sums to those of the crop. */
    void addTo(double[] target) {
        int row = width * layout.stride;
        for (int y = 0; y < height; y++) {
            int from = y * row;
            int to = ((y0 - crop.y() + y) * crop.width() + x0 - crop.x()) * layout.stride;
            for (int i = 0; i < row; i++) {
                target[to + i] += sums[from + i];
            }
        }
    }
}
