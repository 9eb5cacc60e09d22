package org.daybreak.core.film;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.daybreak.core.color.Spectrum;
import org.jspecify.annotations.Nullable;

/**
 * The splats of a film. Each pixel holds the sums of red, green and blue, of the squared luminance, and with the variance
 * layer of the squares per channel. Not thread-safe; the film guards it.
 *
 * <p>Splats are added to the open lane; closed lanes are added up in their order. Or they are added to lanes with numbers, several
 * of which are filled at the same time: these are kept to the end. What is asked for in between is the sum as it would be if
 * all lanes were closed.
 */
final class FilmSplats {
    private final FilmSettings settings;
    private final FilterKernel kernel;
    private final boolean pixelBox;
    private final int stride;
    private final double[] weightsX;
    private final double[] weightsY;

    /** Lanes that are kept apart, by number. */
    private final SortedMap<Integer, double[]> lanes = new TreeMap<>();

    private boolean keepLanes;
    private double @Nullable [] total;
    private double @Nullable [] open;
    private double scale = 1;
    private long paths;

    /** Whether splats of a lane depend on each other; then the relative error of the scale, and the subpaths of each lane. */
    private boolean dependent;

    private double scaleError;
    private final SortedMap<Integer, Long> lanePaths = new TreeMap<>();

    FilmSplats(FilmSettings settings, FilterKernel kernel, boolean pixelBox, int stride) {
        this.settings = settings;
        this.kernel = kernel;
        this.pixelBox = pixelBox;
        this.stride = stride;
        int reach = 2 * FilterKernel.border(settings.filter()) + 2;
        weightsX = new double[reach];
        weightsY = new double[reach];
    }

    void add(SplatBuffer splats, long subpaths) {
        paths += subpaths;
        if (splats.size() == 0) {
            return;
        }
        double[] target = open;
        if (target == null) {
            target = newLane();
            open = target;
        }
        addAll(splats, target);
    }

    void add(SplatBuffer splats, long subpaths, int lane) {
        paths += subpaths;
        if (splats.size() > 0) {
            addAll(splats, lanes.computeIfAbsent(lane, number -> newLane()));
        }
        if (dependent) {
            lanePaths.merge(lane, subpaths, Long::sum);
        }
    }

    private double[] newLane() {
        return new double[settings.crop().width() * settings.crop().height() * stride];
    }

    private void addAll(SplatBuffer splats, double[] target) {
        double[] entries = splats.entries();
        int used = splats.size() * SplatBuffer.STRIDE;
        for (int i = 0; i < used; i += SplatBuffer.STRIDE) {
            add(target, entries[i], entries[i + 1], entries[i + 2], entries[i + 3], entries[i + 4]);
        }
    }

    void closeLane() {
        double[] lane = open;
        open = null;
        if (lane == null) {
            return;
        }
        if (keepLanes) {
            lanes.put(lanes.isEmpty() ? 0 : lanes.lastKey() + 1, lane);
        } else {
            addToTotal(lane);
        }
    }

    void keepLanes() {
        keepLanes = true;
    }

    void useDependentSplats() {
        dependent = true;
    }

    private void addToTotal(double[] lane) {
        double[] sum = total;
        if (sum == null) {
            total = lane;
        } else {
            addTo(sum, lane);
        }
    }

    private static void addTo(double[] sum, double[] lane) {
        for (int i = 0; i < sum.length; i++) {
            sum[i] += lane[i];
        }
    }

    long paths() {
        return paths;
    }

    double scale() {
        return scale;
    }

    void setScale(double scale, double relativeError) {
        this.scale = scale;
        scaleError = relativeError;
    }

    /** What is known of splats that depend on each other; null if they do not. */
    FilmState.@Nullable DependentSplats dependence() {
        if (!dependent) {
            return null;
        }
        long[] counts = new long[lanes.size()];
        int i = 0;
        for (int number : lanes.keySet()) {
            counts[i++] = pathsOf(number);
        }
        return new FilmState.DependentSplats(scaleError, counts);
    }

    private long pathsOf(int lane) {
        return lanePaths.getOrDefault(lane, 0L);
    }

    private void addDependence(FilmState.@Nullable DependentSplats dependence, List<FilmState.Lane> ofLanes) {
        if (dependence != null) {
            dependent = true;
            scaleError = dependence.scaleError();
            for (int i = 0; i < ofLanes.size(); i++) {
                lanePaths.merge(ofLanes.get(i).number(), dependence.lanePaths()[i], Long::sum);
            }
        }
    }

    /** A copy of all sums; lanes that were closed and kept are not written to any more and are handed out as they are. */
    FilmState.Splats state() {
        List<FilmState.Lane> copies = new ArrayList<>();
        for (Map.Entry<Integer, double[]> lane : lanes.entrySet()) {
            copies.add(new FilmState.Lane(lane.getKey(), own(lane.getValue())));
        }
        double[] sum = total;
        double[] lane = open;
        return new FilmState.Splats(sum == null ? null : sum.clone(), copies, lane == null ? null : lane.clone());
    }

    void restore(FilmState film) {
        FilmState.Splats state = film.splats();
        double[] sum = state.total();
        double[] lane = state.open();
        total = sum == null ? null : sum.clone();
        open = lane == null ? null : lane.clone();
        lanes.clear();
        for (FilmState.Lane numbered : state.lanes()) {
            lanes.put(numbered.number(), own(numbered.sums()));
        }
        lanePaths.clear();
        addDependence(film.dependence(), state.lanes());
        paths = film.splatPaths();
        scale = film.splatScale();
    }

    private double[] own(double[] lane) {
        return keepLanes ? lane : lane.clone();
    }

    /** Adds the lanes of a part that comes next. */
    void merge(FilmState film) {
        FilmState.Splats state = film.splats();
        if (state.total() != null || state.open() != null) {
            throw new IllegalArgumentException("the splats of a part must be in lanes that are kept apart");
        }
        for (FilmState.Lane lane : state.lanes()) {
            if (film.dependence() != null) {
                lanes.put(lane.number(), lane.sums().clone());
            } else {
                addToTotal(total == null ? lane.sums().clone() : lane.sums());
            }
        }
        addDependence(film.dependence(), state.lanes());
        paths += film.splatPaths();
        scale = film.splatScale();
    }

    /** What all splats add up to now; null if there are none. */
    @Nullable
    Totals totals() {
        List<double[]> all = new ArrayList<>();
        double[] first = total;
        double[] last = open;
        if (first != null) {
            all.add(first);
        }
        all.addAll(lanes.values());
        if (last != null) {
            all.add(last);
        }
        if (all.isEmpty()) {
            return null;
        }
        double[] sum = all.get(0);
        if (all.size() > 1) {
            sum = sum.clone();
            for (double[] lane : all.subList(1, all.size())) {
                addTo(sum, lane);
            }
        }
        return new Totals(sum);
    }

    /** Sums of all splats. Valid as long as the film is guarded. */
    final class Totals {
        private final double[] sums;

        private Totals(double[] sums) {
            this.sums = sums;
        }

        /** Mean of a colour channel in a pixel. */
        double mean(int pixel, int channel) {
            return norm(pixel) * scale * sums[pixel * stride + channel] / paths;
        }

        /** Mean luminance of a pixel. */
        double luminance(int pixel) {
            return norm(pixel) * scale * luminanceSum(sums, pixel) / paths;
        }

        /** Variance of a colour channel's mean in a pixel. */
        double variance(int pixel, int channel) {
            int at = pixel * stride;
            if (dependent) {
                double sum = sums[at + channel];
                double scatter = 0;
                for (Map.Entry<Integer, double[]> lane : lanes.entrySet()) {
                    scatter += squaredDifference(lane.getKey(), lane.getValue()[at + channel], sum);
                }
                return dependentVariance(pixel, sum, scatter);
            }
            return variance(pixel, sums[at + channel], sums[at + 4 + channel]);
        }

        /** Variance of the mean luminance of a pixel. */
        double luminanceVariance(int pixel) {
            if (dependent) {
                double sum = luminanceSum(sums, pixel);
                double scatter = 0;
                for (Map.Entry<Integer, double[]> lane : lanes.entrySet()) {
                    scatter += squaredDifference(lane.getKey(), luminanceSum(lane.getValue(), pixel), sum);
                }
                return dependentVariance(pixel, sum, scatter);
            }
            return variance(pixel, luminanceSum(sums, pixel), sums[pixel * stride + 3]);
        }

        private double luminanceSum(double[] of, int pixel) {
            int at = pixel * stride;
            return Spectrum.luminance(of[at], of[at + 1], of[at + 2]);
        }

        private double squaredDifference(int lane, double ofLane, double sum) {
            double difference = ofLane - sum * ((double) pathsOf(lane) / paths);
            return difference * difference;
        }

        private double dependentVariance(int pixel, double sum, double scatter) {
            int n = lanes.size();
            double factor = norm(pixel) * scale / paths;
            double error = scaleError * sum;
            return n < 2 ? Double.NaN : (scatter * n / (n - 1) + error * error) * factor * factor;
        }

        private double variance(int pixel, double sum, double squares) {
            double mean = sum / paths;
            double factor = norm(pixel) * scale;
            return Math.max(0, squares / paths - mean * mean) / paths * factor * factor;
        }
    }

    private void add(double[] target, double filmX, double filmY, double r, double g, double b) {
        FilmSettings.Crop crop = settings.crop();
        if (pixelBox) {
            int px = (int) Math.floor(filmX) - crop.x();
            int py = (int) Math.floor(filmY) - crop.y();
            if (px >= 0 && py >= 0 && px < crop.width() && py < crop.height()) {
                add(target, (py * crop.width() + px) * stride, 1, r, g, b);
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
                int at = ((y - crop.y()) * crop.width() + x - crop.x()) * stride;
                add(target, at, weightsX[x - fromX] * weightsY[y - fromY], r, g, b);
            }
        }
    }

    private void add(double[] target, int at, double w, double r, double g, double b) {
        double wr = w * r;
        double wg = w * g;
        double wb = w * b;
        target[at] += wr;
        target[at + 1] += wg;
        target[at + 2] += wb;
        double luminance = Spectrum.luminance(wr, wg, wb);
        target[at + 3] += luminance * luminance;
        if (stride > 4) {
            target[at + 4] += wr * wr;
            target[at + 5] += wg * wg;
            target[at + 6] += wb * wb;
        }
    }

    /** 1 over the filter's integral over the film, for a pixel of the crop: not 1 near the edges of the film only. */
    private double norm(int pixel) {
        if (pixelBox) {
            return 1;
        }
        FilmSettings.Crop crop = settings.crop();
        double px = crop.x() + pixel % crop.width() + 0.5;
        double py = crop.y() + pixel / crop.width() + 0.5;
        return 1 / (kernel.integral(-px, settings.width() - px) * kernel.integral(-py, settings.height() - py));
    }
}
