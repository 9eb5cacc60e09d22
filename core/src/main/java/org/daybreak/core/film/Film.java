package org.daybreak.core.film;

import java.util.Collections;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.daybreak.core.color.Spectrum;
import org.jspecify.annotations.Nullable;

/**
 * Accumulates an image in linear RGB and double precision. Thread-safe; the sums depend on the order of commits, so
 * renderers commit their work units in a fixed order.
 *
 * <p><b>Samples.</b> A pixel is the mean of its samples weighted by the filter, Σw·v/Σw. A constant image stays constant up
 * to the edges for every filter. Samples are taken in the crop and, so that a crop equals that part of the whole image, in
 * a border around it as wide as the filter reaches, cut off at the edges of the film ({@link #sampleArea()}).
 *
 * <p>With {@linkplain FilmSettings#filterSampling() filter sampling} a pixel is the plain mean of its own samples, drawn in
 * proportion to |w| and multiplied by a sign and factor ({@link FilterSampler}); there is no border.
 *
 * <p><b>Splats.</b> They are kept apart: Σ w·splat, where w is the filter scaled to integrate to 1 over the film, times
 * {@link #setSplatScale a scale} over the number of subpaths that were traced. Near the edges of the film both kinds
 * estimate the same mean: that over the part of the filter that lies on the film.
 *
 * <p><b>Variance.</b> Second moments give the variance of each pixel's value as if samples were independent:
 * (Σw²v² − 2μΣw²v + μ²Σw²)/(Σw)²·n/(n−1), n = (Σw)²/Σw². For splats it is (Σ(w·s)²/N − m²)/N, which takes a subpath
 * to hit a pixel at most once.
 */
public final class Film {
    private final FilmSettings settings;
    private final Set<FilmLayer> layers;
    private final FilmLayout layout;
    private final FilterKernel kernel;
    private final double[] sums;
    /** Red, green and blue of the splats, their squared luminance, and with the variance layer the squares per channel. */
    private double @Nullable [] splatSums;

    private final int splatStride;
    /** True if splats count for the pixel that they lie in only. */
    private final boolean unitBox;

    private double splatScale = 1;
    private long splatPaths;
    private long samples;
    private final double[] weightsX;
    private final double[] weightsY;

    /** Creates an empty film without auxiliary images. */
    public Film(FilmSettings settings) {
        this(settings, Set.of());
    }

    /**
     * Creates an empty film.
     *
     * @param layers auxiliary images to gather
     * @throws IllegalArgumentException if so large an image does not fit into an array
     */
    public Film(FilmSettings settings, Set<FilmLayer> layers) {
        this.settings = settings;
        this.layers = Collections.unmodifiableSet(
                layers.isEmpty() ? EnumSet.noneOf(FilmLayer.class) : EnumSet.copyOf(layers));
        this.layout = new FilmLayout(settings, this.layers);
        this.kernel = new FilterKernel(settings.filter());
        this.unitBox = FilmLayout.isUnitBox(settings.filter());
        this.splatStride = layout.variance ? 7 : 4;
        long pixels = (long) settings.crop().width() * settings.crop().height();
        if (pixels * Math.max(layout.stride, splatStride) > Integer.MAX_VALUE - 8) {
            throw new IllegalArgumentException("an image of " + settings.crop().width() + "x"
                    + settings.crop().height()
                    + " pixels is too large to be rendered in one piece; render crops of it");
        }
        sums = new double[(int) pixels * layout.stride];
        int reach = 2 * FilterKernel.border(settings.filter()) + 2;
        weightsX = new double[reach];
        weightsY = new double[reach];
    }

    /** Size, crop and filter. */
    public FilmSettings settings() {
        return settings;
    }

    /** The auxiliary images that are gathered. */
    public Set<FilmLayer> layers() {
        return layers;
    }

    /** True if samples must be added with their features. */
    public boolean needsFeatures() {
        return layout.features;
    }

    /** The pixels in which samples must be taken: the crop and the border that its filter reaches, within the film. */
    public FilmSettings.Crop sampleArea() {
        FilmSettings.Crop crop = settings.crop();
        int border = settings.filterSampling() ? 0 : FilterKernel.border(settings.filter());
        int x0 = Math.max(0, crop.x() - border);
        int y0 = Math.max(0, crop.y() - border);
        int x1 = Math.min(settings.width(), crop.x() + crop.width() + border);
        int y1 = Math.min(settings.height(), crop.y() + crop.height() + border);
        return new FilmSettings.Crop(x0, y0, x1 - x0, y1 - y0);
    }

    /**
     * Draws where in or near a pixel samples are taken; for films with {@link FilmSettings#filterSampling()}. Not limited to
     * one worker.
     */
    public FilterSampler filterSampler() {
        return new FilterSampler(settings, kernel);
    }

    /** A new tile for this film; each worker or work unit has its own. */
    public FilmTile newTile() {
        return new FilmTile(settings, layout, kernel);
    }

    /** Adds the samples of a tile. */
    public synchronized void commit(FilmTile tile) {
        tile.addTo(sums);
        samples += tile.samples();
    }

    /**
     * Adds splats.
     *
     * @param subpaths number of subpaths that were traced for them, those without any splat included
     */
    public synchronized void commit(SplatBuffer splats, long subpaths) {
        splatPaths += subpaths;
        int used = splats.size() * SplatBuffer.STRIDE;
        if (used == 0) {
            return;
        }
        double[] target = splatSums;
        if (target == null) {
            target = new double[settings.crop().width() * settings.crop().height() * splatStride];
            splatSums = target;
        }
        double[] entries = splats.entries();
        for (int i = 0; i < used; i += SplatBuffer.STRIDE) {
            addSplat(target, entries[i], entries[i + 1], entries[i + 2], entries[i + 3], entries[i + 4]);
        }
    }

    /**
     * Sets the factor on the mean of the splats; 1 from the start. Algorithms whose splats are known up to a factor only
     * (Markov chains) set it while they learn it.
     */
    public synchronized void setSplatScale(double scale) {
        splatScale = scale;
    }

    /** Number of samples committed. */
    public synchronized long samples() {
        return samples;
    }

    /** Number of subpaths whose splats were committed. */
    public synchronized long splatPaths() {
        return splatPaths;
    }

    /**
     * The image as it is now. May be called at any time from any thread; pixels without samples are 0.
     */
    public synchronized FilmImage develop() {
        Map<String, float[]> channels = new LinkedHashMap<>();
        List<String> colors = List.of("R", "G", "B");
        for (int c = 0; c < 3; c++) {
            channels.put(colors.get(c), developColor(c));
        }
        for (FilmLayer layer : layers) {
            for (int c = 0; c < layer.channels().size(); c++) {
                channels.put(layer.channels().get(c), developLayer(layer, c));
            }
        }
        return new FilmImage(settings, channels);
    }

    /**
     * Estimate of the image's relative standard error: the root of the mean over pixels of the variance of their
     * luminance, divided by the mean luminance. Samples are taken as independent. NaN while some pixel has fewer than two
     * samples, and 0 for a black image.
     */
    public synchronized double relativeError() {
        int width = settings.crop().width();
        int n = width * settings.crop().height();
        double mean = 0;
        double variance = 0;
        for (int p = 0; p < n; p++) {
            double luminance = 0;
            if (samples > 0) {
                int at = p * layout.stride;
                luminance = sampleMean(at, luminanceSum(at, FilmLayout.COLOR));
                int one = at + layout.squaredWeight;
                double first = layout.unitWeights ? luminanceSum(at, FilmLayout.COLOR) : sums[one + 1];
                variance +=
                        sampleVariance(sums[at], sums[one], first, sums[at + FilmLayout.LUMINANCE_SQUARED], luminance);
            }
            if (splatSums != null) {
                int at = p * splatStride;
                double norm = splatNorm(p % width, p / width) * splatScale;
                luminance +=
                        norm * Spectrum.luminance(splatSums[at], splatSums[at + 1], splatSums[at + 2]) / splatPaths;
                variance += splatVariance(
                        Spectrum.luminance(splatSums[at], splatSums[at + 1], splatSums[at + 2]),
                        splatSums[at + 3],
                        norm);
            }
            mean += luminance;
        }
        if (samples == 0 && splatPaths == 0) {
            return Double.NaN;
        }
        mean /= n;
        variance /= n;
        return variance == 0 ? 0 : Math.sqrt(variance) / Math.abs(mean);
    }

    private float[] developColor(int c) {
        int width = settings.crop().width();
        float[] values = new float[width * settings.crop().height()];
        for (int p = 0; p < values.length; p++) {
            int at = p * layout.stride;
            double value = sampleMean(at, sums[at + FilmLayout.COLOR + c]);
            if (splatSums != null) {
                value += splatNorm(p % width, p / width) * splatScale * splatSums[p * splatStride + c] / splatPaths;
            }
            values[p] = (float) value;
        }
        return values;
    }

    private float[] developLayer(FilmLayer layer, int c) {
        return switch (layer) {
            case ALBEDO -> developFeature(layout.albedo + c, FilmLayout.WEIGHT);
            case NORMAL -> developFeature(layout.normal + c, FilmLayout.WEIGHT);
            case DEPTH -> developFeature(layout.depth, layout.depth + 1);
            case VARIANCE -> developVariance(c);
        };
    }

    private float[] developFeature(int offset, int weight) {
        float[] values = new float[sums.length / layout.stride];
        for (int p = 0; p < values.length; p++) {
            double w = sums[p * layout.stride + weight];
            values[p] = w > 0 ? (float) (sums[p * layout.stride + offset] / w) : 0;
        }
        return values;
    }

    private float[] developVariance(int c) {
        int width = settings.crop().width();
        float[] values = new float[width * settings.crop().height()];
        for (int p = 0; p < values.length; p++) {
            int at = p * layout.stride;
            double variance = samples == 0 && splatPaths == 0 ? Double.NaN : 0;
            if (samples > 0) {
                variance = sampleVariance(
                        sums[at],
                        sums[at + layout.squaredWeight],
                        sums[at + layout.first + c],
                        sums[at + layout.second + c],
                        sampleMean(at, sums[at + FilmLayout.COLOR + c]));
            }
            if (splatSums != null) {
                double norm = splatNorm(p % width, p / width) * splatScale;
                int splat = p * splatStride;
                variance += splatVariance(splatSums[splat + c], splatSums[splat + 4 + c], norm);
            }
            values[p] = (float) variance;
        }
        return values;
    }

    private double luminanceSum(int at, int color) {
        return Spectrum.luminance(sums[at + color], sums[at + color + 1], sums[at + color + 2]);
    }

    /** Σw·v/Σw; 0 where the weights of a filter with negative lobes do not add up to anything yet. */
    private double sampleMean(int at, double weighted) {
        double weight = sums[at + FilmLayout.WEIGHT];
        return weight > 0 ? weighted / weight : 0;
    }

    private static double sampleVariance(double w, double ww, double first, double second, double mean) {
        double n = w * w / ww;
        // n is 1 up to rounding where all samples but one have no weight.
        if (!(n > 1 + 1e-9)) {
            return Double.NaN;
        }
        return Math.max(0, second - 2 * mean * first + mean * mean * ww) / (w * w) * (n / (n - 1));
    }

    private double splatVariance(double sum, double squares, double norm) {
        double mean = sum / splatPaths;
        return Math.max(0, squares / splatPaths - mean * mean) / splatPaths * norm * norm;
    }

    private void addSplat(double[] target, double filmX, double filmY, double r, double g, double b) {
        FilmSettings.Crop crop = settings.crop();
        if (unitBox) {
            int px = (int) Math.floor(filmX) - crop.x();
            int py = (int) Math.floor(filmY) - crop.y();
            if (px >= 0 && py >= 0 && px < crop.width() && py < crop.height()) {
                addSplat(target, (py * crop.width() + px) * splatStride, 1, r, g, b);
            }
            return;
        }
        double radius = settings.filter().radius();
        int fromX = Math.max((int) Math.ceil(filmX - radius - 0.5), crop.x());
        int toX = Math.min((int) Math.floor(filmX + radius - 0.5), crop.x() + crop.width() - 1);
        int fromY = Math.max((int) Math.ceil(filmY - radius - 0.5), crop.y());
        int toY = Math.min((int) Math.floor(filmY + radius - 0.5), crop.y() + crop.height() - 1);
        for (int x = fromX; x <= toX; x++) {
            weightsX[x - fromX] = kernel.weight(x + 0.5 - filmX);
        }
        for (int y = fromY; y <= toY; y++) {
            weightsY[y - fromY] = kernel.weight(y + 0.5 - filmY);
        }
        for (int y = fromY; y <= toY; y++) {
            for (int x = fromX; x <= toX; x++) {
                int at = ((y - crop.y()) * crop.width() + x - crop.x()) * splatStride;
                addSplat(target, at, weightsX[x - fromX] * weightsY[y - fromY], r, g, b);
            }
        }
    }

    private void addSplat(double[] target, int at, double w, double r, double g, double b) {
        double wr = w * r;
        double wg = w * g;
        double wb = w * b;
        target[at] += wr;
        target[at + 1] += wg;
        target[at + 2] += wb;
        double luminance = Spectrum.luminance(wr, wg, wb);
        target[at + 3] += luminance * luminance;
        if (layout.variance) {
            target[at + 4] += wr * wr;
            target[at + 5] += wg * wg;
            target[at + 6] += wb * wb;
        }
    }

    /** 1 over the filter's integral over the film, for a pixel of the crop: not 1 near the edges of the film only. */
    private double splatNorm(int x, int y) {
        if (unitBox) {
            return 1;
        }
        double px = settings.crop().x() + x + 0.5;
        double py = settings.crop().y() + y + 0.5;
        return 1 / (kernel.integral(-px, settings.width() - px) * kernel.integral(-py, settings.height() - py));
    }
}
