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
 * <p><b>Splats.</b> They are kept apart, in lanes ({@link #closeSplatLane}, {@link #commit(SplatBuffer, long, int)}):
 * Σ w·splat, where w is the filter scaled to
 * integrate to 1 over the film, times {@link #setSplatScale a scale} over the number of subpaths that were traced. Near the edges of the film both kinds
 * estimate the same mean: that over the part of the filter that lies on the film.
 *
 * <p><b>Variance.</b> Second moments give the variance of each pixel's value as if samples were independent:
 * (Σw²v² − 2μΣw²v + μ²Σw²)/(Σw)²·n/(n−1), n = (Σw)²/Σw². For splats it is (Σ(w·s)²/N − m²)/N, which takes a subpath
 * to hit a pixel at most once. If splats depend on each other ({@link #useDependentSplats}), it is G/(G−1)·Σ(S−m·n)²/N² from the G lanes
 * with sums S of n subpaths each, plus the square of what the error of the scale contributes.
 */
public final class Film {
    private final FilmSettings settings;
    private final Set<FilmLayer> layers;
    private final FilterKernel kernel;
    private FilmLayout layout;
    private double[] sums;
    private final FilmSplats splats;
    private boolean weighted;
    private long samples;

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
        this.layout = new FilmLayout(settings, this.layers, false);
        this.kernel = new FilterKernel(settings.filter());
        this.splats = new FilmSplats(
                settings, kernel, FilmLayout.isUnitBox(settings.filter()), FilmState.splatStride(this.layers));
        sums = newSums(layout);
    }

    private double[] newSums(FilmLayout forLayout) {
        long pixels = (long) settings.crop().width() * settings.crop().height();
        if (pixels * Math.max(forLayout.stride, FilmState.splatStride(layers)) > Integer.MAX_VALUE - 8) {
            throw new IllegalArgumentException("an image of " + settings.crop().width() + "x"
                    + settings.crop().height()
                    + " pixels is too large to be rendered in one piece; render crops of it");
        }
        return new double[(int) pixels * forLayout.stride];
    }

    /**
     * From now on samples may have weights of their own ({@link FilmTile#setSampleWeight}), for methods that take more
     * samples in some pixels than in others. Must be called before the first tile is made.
     *
     * @throws IllegalStateException if the film has samples
     * @throws IllegalArgumentException if so large an image does not fit into an array then
     */
    public synchronized void useSampleWeights() {
        if (samples > 0) {
            throw new IllegalStateException("the film has samples already");
        }
        layout = new FilmLayout(settings, layers, true);
        weighted = true;
        sums = newSums(layout);
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
    public synchronized boolean needsFeatures() {
        return layout.features;
    }

    /** How many pixels beyond its own a sample can reach. */
    public int filterBorder() {
        return settings.filterSampling() ? 0 : FilterKernel.border(settings.filter());
    }

    /** The pixels in which samples must be taken: the crop and the border that its filter reaches, within the film. */
    public FilmSettings.Crop sampleArea() {
        FilmSettings.Crop crop = settings.crop();
        int border = filterBorder();
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
    public synchronized FilmTile newTile() {
        return new FilmTile(settings, layout, kernel);
    }

    /** Adds the samples of a tile. */
    public void commit(FilmTile tile) {
        commit(tile, tile.samples());
    }

    /**
     * Adds the samples of a tile.
     *
     * @param counted how many of them count in {@link #samples()}: none of a tile that another part of the image counts
     */
    public synchronized void commit(FilmTile tile, long counted) {
        tile.addTo(sums);
        samples += counted;
    }

    /**
     * Adds splats.
     *
     * @param subpaths number of subpaths that were traced for them, those without any splat included
     */
    public synchronized void commit(SplatBuffer buffer, long subpaths) {
        splats.add(buffer, subpaths);
    }

    /**
     * Adds splats to one of several lanes that are filled at the same time. They are added up in the order of their numbers, and
     * each has sums of its own, that start at zero, until then: so a film that is put together from parts of whole lanes has the
     * bits of one that was rendered at once. Each lane with any splat takes as much memory as an image.
     *
     * @param subpaths number of subpaths that were traced for them, those without any splat included
     * @param lane number of the lane, from 0
     */
    public synchronized void commit(SplatBuffer buffer, long subpaths, int lane) {
        splats.add(buffer, subpaths, lane);
    }

    /**
     * Ends the lane of splats that {@link #commit(SplatBuffer, long)} fills. The splats of a lane are added up apart, and the
     * lanes then in their order. So a film that is put together from parts of whole lanes has the bits of one that was rendered
     * at once.
     */
    public synchronized void closeSplatLane() {
        splats.closeLane();
    }

    /** Keeps lanes of splats apart when they are closed, as a part of a render has to. Before one is closed or restored. */
    public synchronized void keepSplatLanes() {
        splats.keepLanes();
    }

    /**
     * From now on splats may depend on others of the same lane, as those of Markov chains do, but not on those of other lanes: their
     * variance is estimated from how much the lanes differ. All splats are committed to lanes with numbers then. Must be called
     * before the first splat.
     */
    public synchronized void useDependentSplats() {
        splats.useDependentSplats();
    }

    /** Sets the factor on the mean of the splats; 1 from the start. */
    public synchronized void setSplatScale(double scale) {
        splats.setScale(scale, 0);
    }

    /**
     * Sets the factor on the mean of the splats, for algorithms that estimate it (Markov chains).
     *
     * @param relativeError its standard error over itself: enters the variance of splats that depend on each other
     */
    public synchronized void setSplatScale(double scale, double relativeError) {
        splats.setScale(scale, relativeError);
    }

    /** Number of samples committed. */
    public synchronized long samples() {
        return samples;
    }

    /** Number of subpaths whose splats were committed. */
    public synchronized long splatPaths() {
        return splats.paths();
    }

    /**
     * The image as it is now. May be called at any time from any thread; pixels without samples are 0.
     */
    public synchronized FilmImage develop() {
        FilmSplats.Totals splatted = splats.totals();
        Map<String, float[]> channels = new LinkedHashMap<>();
        List<String> colors = List.of("R", "G", "B");
        for (int c = 0; c < 3; c++) {
            channels.put(colors.get(c), developColor(c, splatted));
        }
        for (FilmLayer layer : layers) {
            for (int c = 0; c < layer.channels().size(); c++) {
                channels.put(layer.channels().get(c), developLayer(layer, c, splatted));
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
        int n = settings.crop().width() * settings.crop().height();
        FilmSplats.Totals splatted = splats.totals();
        double mean = 0;
        double variance = 0;
        for (int p = 0; p < n; p++) {
            double luminance = 0;
            if (samples > 0) {
                int at = p * layout.stride;
                luminance = sampleMean(at, luminanceSum(at, FilmLayout.COLOR));
                variance += luminanceVariance(at, luminance);
            }
            if (splatted != null) {
                luminance += splatted.luminance(p);
                variance += splatted.luminanceVariance(p);
            }
            mean += luminance;
        }
        if (samples == 0 && splats.paths() == 0) {
            return Double.NaN;
        }
        mean /= n;
        variance /= n;
        return variance == 0 ? 0 : Math.sqrt(variance) / Math.abs(mean);
    }

    /** What the samples so far say of the luminance of the pixels. */
    public synchronized LuminanceStatistics luminanceStatistics() {
        int n = settings.crop().width() * settings.crop().height();
        double[] weights = new double[n];
        double[] effectiveSamples = new double[n];
        double[] means = new double[n];
        for (int p = 0; p < n; p++) {
            int at = p * layout.stride;
            double weight = sums[at];
            double squaredWeights = sums[at + layout.squaredWeight];
            weights[p] = weight;
            effectiveSamples[p] = squaredWeights > 0 ? weight * weight / squaredWeights : 0;
            means[p] = sampleMean(at, luminanceSum(at, FilmLayout.COLOR));
        }
        return new LuminanceStatistics(weights, effectiveSamples, means);
    }

    /**
     * All that was accumulated, as a copy.
     *
     * @param regions rectangles whose sample sums are of interest, see {@link FilmState#regions()}
     */
    public synchronized FilmState state(List<FilmSettings.Crop> regions) {
        long length = 0;
        for (FilmSettings.Crop region : regions) {
            length += (long) region.width() * region.height() * layout.stride;
        }
        double[] copy = new double[Math.toIntExact(length)];
        int to = 0;
        for (FilmSettings.Crop region : regions) {
            int row = region.width() * layout.stride;
            for (int y = 0; y < region.height(); y++, to += row) {
                System.arraycopy(sums, indexOf(region, y), copy, to, row);
            }
        }
        return new FilmState(
                settings,
                layers,
                weighted,
                regions,
                copy,
                samples,
                splats.state(),
                splats.paths(),
                splats.scale(),
                splats.dependence());
    }

    /**
     * Makes this film, which must be empty, what another one was.
     *
     * @throws IllegalArgumentException if the state has other settings or layers
     */
    public synchronized void restore(FilmState state) {
        checkSame(state);
        if (state.weighted() && !weighted) {
            useSampleWeights();
        }
        checkWeights(state);
        addSums(state);
        samples = state.samples();
        splats.restore(state);
    }

    /**
     * Adds what was accumulated for another part of the same image: other pixels, or the splat lanes that follow. All lanes
     * of the part are closed.
     *
     * @throws IllegalArgumentException if the state has other settings or layers
     */
    public synchronized void merge(FilmState state) {
        checkSame(state);
        checkWeights(state);
        addSums(state);
        samples += state.samples();
        splats.merge(state);
    }

    private void checkSame(FilmState state) {
        if (!state.settings().equals(settings) || !state.layers().equals(layers)) {
            throw new IllegalArgumentException("the films differ in their settings or layers");
        }
    }

    private void checkWeights(FilmState state) {
        if (state.weighted() != weighted) {
            throw new IllegalArgumentException("only one of the films has weights of samples");
        }
    }

    private void addSums(FilmState state) {
        int from = 0;
        for (FilmSettings.Crop region : state.regions()) {
            int row = region.width() * layout.stride;
            for (int y = 0; y < region.height(); y++) {
                int to = indexOf(region, y);
                for (int i = 0; i < row; i++) {
                    sums[to + i] += state.sums()[from++];
                }
            }
        }
    }

    private int indexOf(FilmSettings.Crop region, int y) {
        FilmSettings.Crop crop = settings.crop();
        return ((region.y() - crop.y() + y) * crop.width() + region.x() - crop.x()) * layout.stride;
    }

    private double luminanceVariance(int at, double mean) {
        int one = at + layout.squaredWeight;
        double first = layout.unitWeights ? luminanceSum(at, FilmLayout.COLOR) : sums[one + 1];
        return sampleVariance(sums[at], sums[one], first, sums[at + FilmLayout.LUMINANCE_SQUARED], mean);
    }

    private float[] developColor(int c, FilmSplats.@Nullable Totals splatted) {
        float[] values = new float[settings.crop().width() * settings.crop().height()];
        for (int p = 0; p < values.length; p++) {
            int at = p * layout.stride;
            double value = sampleMean(at, sums[at + FilmLayout.COLOR + c]);
            if (splatted != null) {
                value += splatted.mean(p, c);
            }
            values[p] = (float) value;
        }
        return values;
    }

    private float[] developLayer(FilmLayer layer, int c, FilmSplats.@Nullable Totals splatted) {
        return switch (layer) {
            case ALBEDO -> developFeature(layout.albedo + c, FilmLayout.WEIGHT);
            case NORMAL -> developFeature(layout.normal + c, FilmLayout.WEIGHT);
            case DEPTH -> developFeature(layout.depth, layout.depth + 1);
            case VARIANCE -> developVariance(c, splatted);
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

    private float[] developVariance(int c, FilmSplats.@Nullable Totals splatted) {
        float[] values = new float[settings.crop().width() * settings.crop().height()];
        for (int p = 0; p < values.length; p++) {
            int at = p * layout.stride;
            double variance = samples == 0 && splats.paths() == 0 ? Double.NaN : 0;
            if (samples > 0) {
                variance = sampleVariance(
                        sums[at],
                        sums[at + layout.squaredWeight],
                        sums[at + layout.first + c],
                        sums[at + layout.second + c],
                        sampleMean(at, sums[at + FilmLayout.COLOR + c]));
            }
            if (splatted != null) {
                variance += splatted.variance(p, c);
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
}
