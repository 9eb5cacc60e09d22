package org.daybreak.tracing;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.LuminanceStatistics;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.render.SampleAllocation;
import org.daybreak.core.sampling.Mixing;
import org.jspecify.annotations.Nullable;

/**
 * As many samples in a pixel as a {@link SampleAllocation} says. Each pass has a seed of its own, and its samples the weight
 * of the pass over the number of samples of their pixel: so a pass is an unbiased image, whatever the numbers.
 *
 * <p>A pass is cut into slices of about {@value #SLICE} samples per pixel, so that an image which ends early is even. To the render
 * the slices are the passes: it looks at the error after each.
 */
final class AdaptiveSchedule implements SampleSchedule {
    private static final int SLICE = 16;
    private static final String POSITION = "pass";
    private static final String COUNTS = "counts";
    private static final String WEIGHTS = "before.weights";
    private static final String EFFECTIVE_SAMPLES = "before.effectiveSamples";
    private static final String MEANS = "before.means";

    private final TileGrid grid;
    private final Film film;
    private final SampleAllocation allocation;
    private final FilmSettings.Crop area;
    private final long[] passes;
    private final long seed;
    private int pass;
    private int slice;
    private int nextTile;
    private long before;
    private int @Nullable [] counts;

    /** As they were when the pass began. */
    private LuminanceStatistics statistics;

    AdaptiveSchedule(TileGrid grid, Film film, SampleAllocation allocation, long samplesPerPixel, long seed) {
        this.grid = grid;
        this.film = film;
        this.allocation = allocation;
        this.seed = seed;
        area = film.sampleArea();
        passes = allocation.passes(samplesPerPixel);
        statistics = film.luminanceStatistics();
    }

    private int slices(int ofPass) {
        return (int) Math.max(1, Math.min(Integer.MAX_VALUE, passes[ofPass] / SLICE));
    }

    private boolean passEnds() {
        return nextTile == grid.count() && slice + 1 == slices(pass);
    }

    @Override
    public boolean isDone() {
        return passEnds() && pass + 1 == passes.length;
    }

    @Override
    public boolean needsCommits() {
        return passEnds() && pass + 1 < passes.length;
    }

    @Override
    public void next(TileUnit unit) {
        if (passEnds()) {
            before += passes[pass];
            pass++;
            slice = 0;
            nextTile = 0;
            counts = null;
        } else if (nextTile == grid.count()) {
            slice++;
            nextTile = 0;
        }
        int[] now = counts;
        if (now == null) {
            now = pass == 0 ? uniform() : allocate();
            counts = now;
        }
        grid.describe(nextTile, unit);
        unit.seed = Mixing.absorb(seed, pass);
        unit.pass = pass;
        unit.counts = now;
        unit.statistics = statistics;
        unit.slice = slice;
        unit.slices = slices(pass);
        unit.passWeight = passes[pass];
        unit.samplesPerPixelThen = before + first(passes[pass], slice + 1, unit.slices);
        unit.expected = expected(unit, now);
        nextTile++;
        unit.endsPass = nextTile == grid.count();
    }

    private int[] uniform() {
        int[] numbers = new int[area.width() * area.height()];
        Arrays.fill(numbers, Math.toIntExact(passes[0]));
        return numbers;
    }

    private static long first(long count, int slice, int slices) {
        return count * slice / slices;
    }

    /** First of the samples of a pixel in a slice. */
    static long first(TileUnit unit, int count) {
        return first(count, unit.slice, unit.slices);
    }

    /** The sample after the last one of a pixel in a slice. */
    static long end(TileUnit unit, int count) {
        return first(count, unit.slice + 1, unit.slices);
    }

    private long expected(TileUnit unit, int[] numbers) {
        long sum = 0;
        for (int y = unit.y - area.y(); y < unit.y - area.y() + unit.height; y++) {
            for (int x = unit.x - area.x(); x < unit.x - area.x() + unit.width; x++) {
                int count = numbers[y * area.width() + x];
                sum += end(unit, count) - first(unit, count);
            }
        }
        return sum;
    }

    /** Pixels beyond the crop, which the filter reaches, are taken to be like the nearest one within. */
    private int[] allocate() {
        FilmSettings.Crop crop = film.settings().crop();
        LuminanceStatistics now = film.luminanceStatistics();
        double[] cropDeviations = now.deviationsSince(statistics);
        statistics = now;
        int n = area.width() * area.height();
        double[] means = new double[n];
        double[] deviations = new double[n];
        for (int p = 0; p < n; p++) {
            int x = area.x() - crop.x() + p % area.width();
            int y = area.y() - crop.y() + p / area.width();
            int from = Math.max(0, Math.min(crop.height() - 1, y)) * crop.width()
                    + Math.max(0, Math.min(crop.width() - 1, x));
            means[p] = now.means()[from];
            deviations[p] = cropDeviations[from];
        }
        int[] numbers = new int[n];
        SampleAllocation.Statistics all =
                new SampleAllocation.Statistics(area.width(), area.height(), means, deviations);
        allocation.allocate(all, passes[pass], numbers);
        return numbers;
    }

    @Override
    public void restore(RenderState state) {
        long[] position = state.position(POSITION, 3);
        pass = (int) position[0];
        slice = (int) position[1];
        nextTile = (int) position[2];
        if (pass < 0 || pass >= passes.length) {
            throw new ParameterException("the state to go on from has no pass " + pass);
        }
        for (int i = 0; i < pass; i++) {
            before += passes[i];
        }
        counts = unpackInts(state.position(COUNTS, (areaPixels() + 1) / 2), areaPixels());
        int n = film.settings().crop().width() * film.settings().crop().height();
        statistics = new LuminanceStatistics(
                unpackDoubles(state.position(WEIGHTS, n)),
                unpackDoubles(state.position(EFFECTIVE_SAMPLES, n)),
                unpackDoubles(state.position(MEANS, n)));
    }

    private int areaPixels() {
        return area.width() * area.height();
    }

    @Override
    public Map<String, long[]> position(TileUnit unit) {
        return position(unit.pass, unit.slice, unit.index, unit.counts, unit.statistics);
    }

    @Override
    public Map<String, long[]> position() {
        return position(pass, slice, nextTile, counts == null ? uniform() : counts, statistics);
    }

    private static Map<String, long[]> position(
            int pass, int slice, int tile, int @Nullable [] numbers, @Nullable LuminanceStatistics before) {
        Map<String, long[]> position = new LinkedHashMap<>();
        position.put(POSITION, new long[] {pass, slice, tile});
        if (numbers != null) {
            position.put(COUNTS, pack(numbers));
        }
        if (before != null) {
            position.put(WEIGHTS, pack(before.weights()));
            position.put(EFFECTIVE_SAMPLES, pack(before.effectiveSamples()));
            position.put(MEANS, pack(before.means()));
        }
        return position;
    }

    private static long[] pack(int[] values) {
        long[] packed = new long[(values.length + 1) / 2];
        for (int p = 0; p < values.length; p++) {
            packed[p / 2] |= (values[p] & 0xFFFF_FFFFL) << (p % 2 * Integer.SIZE);
        }
        return packed;
    }

    private static int[] unpackInts(long[] packed, int count) {
        int[] values = new int[count];
        for (int p = 0; p < count; p++) {
            values[p] = (int) (packed[p / 2] >>> (p % 2 * Integer.SIZE));
        }
        return values;
    }

    private static long[] pack(double[] values) {
        return Arrays.stream(values).mapToLong(Double::doubleToRawLongBits).toArray();
    }

    private static double[] unpackDoubles(long[] packed) {
        return Arrays.stream(packed).mapToDouble(Double::longBitsToDouble).toArray();
    }
}
