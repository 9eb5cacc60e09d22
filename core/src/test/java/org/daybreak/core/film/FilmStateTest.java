package org.daybreak.core.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class FilmStateTest {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 9;

    static List<ReconstructionFilter> filters() {
        return ReconstructionFilterTest.filters().toList();
    }

    private static Film film(ReconstructionFilter filter) {
        return new Film(new FilmSettings(WIDTH, HEIGHT, filter), Set.of(FilmLayer.VARIANCE));
    }

    private static void addSamples(Film film, SplittableRandom random, double weight) {
        FilmTile tile = film.newTile();
        tile.begin(0, 0, WIDTH, HEIGHT);
        tile.setSampleWeight(weight);
        Spectrum value = new Spectrum();
        for (int i = 0; i < 500; i++) {
            value.set(random.nextDouble(), random.nextDouble(), random.nextDouble());
            tile.add(WIDTH * random.nextDouble(), HEIGHT * random.nextDouble(), value);
        }
        film.commit(tile);
    }

    private static void addSplats(Film film, SplittableRandom random) {
        SplatBuffer splats = new SplatBuffer();
        for (int i = 0; i < 300; i++) {
            splats.add(WIDTH * random.nextDouble(), HEIGHT * random.nextDouble(), random.nextDouble(), 1, 0.1);
        }
        film.commit(splats, 400);
    }

    private static void assertSame(Film expected, Film actual) {
        FilmImage a = expected.develop();
        FilmImage b = actual.develop();
        for (String channel : a.channelNames()) {
            assertArrayEquals(a.channel(channel), b.channel(channel), channel);
        }
        assertEquals(expected.relativeError(), actual.relativeError());
        assertEquals(expected.samples(), actual.samples());
        assertEquals(expected.splatPaths(), actual.splatPaths());
    }

    @ParameterizedTest
    @MethodSource("filters")
    void restoredFilmsAreTheSameAndGoOn(ReconstructionFilter filter) {
        Film film = film(filter);
        SplittableRandom random = new SplittableRandom(1);
        addSamples(film, random, 1);
        addSplats(film, random);
        film.closeSplatLane();
        addSplats(film, random);
        Film restored = film(filter);
        restored.restore(film.state(List.of(film.settings().crop())));
        assertSame(film, restored);
        for (Film each : List.of(film, restored)) {
            SplittableRandom more = new SplittableRandom(2);
            addSamples(each, more, 1);
            addSplats(each, more);
            each.closeSplatLane();
        }
        assertSame(film, restored);
    }

    @ParameterizedTest
    @MethodSource("filters")
    void lanesOfPartsAddUpToTheWhole(ReconstructionFilter filter) {
        Film whole = film(filter);
        Film merged = film(filter);
        for (int part = 0; part < 3; part++) {
            Film own = film(filter);
            own.keepSplatLanes();
            for (int lane = 0; lane < 2; lane++) {
                addSplats(whole, new SplittableRandom(2 * part + lane));
                whole.closeSplatLane();
                addSplats(own, new SplittableRandom(2 * part + lane));
                own.closeSplatLane();
            }
            merged.merge(own.state(List.of()));
        }
        assertSame(whole, merged);
    }

    /** Lanes that are filled by turns are added up in the order of their numbers, whatever is asked for meanwhile. */
    @ParameterizedTest
    @MethodSource("filters")
    void lanesThatAreFilledByTurnsAddUpToTheWhole(ReconstructionFilter filter) {
        int lanes = 5;
        Film whole = film(filter);
        Film resumed = film(filter);
        for (int pass = 0; pass < 3; pass++) {
            for (int lane = 0; lane < lanes; lane++) {
                whole.commit(pass == 0 && lane % 2 == 1 ? new SplatBuffer() : splats(10 * pass + lane), 400, lane);
            }
        }
        for (int pass = 0; pass < 3; pass++) {
            for (int lane = 0; lane < lanes; lane++) {
                resumed.commit(pass == 0 && lane % 2 == 1 ? new SplatBuffer() : splats(10 * pass + lane), 400, lane);
                FilmState state = resumed.state(List.of());
                resumed.develop();
                resumed = film(filter);
                resumed.restore(state);
            }
        }
        assertSame(whole, resumed);
        Film merged = film(filter);
        for (int[] part : new int[][] {{0, 1}, {1, 4}, {4, 5}}) {
            Film own = film(filter);
            for (int pass = 0; pass < 3; pass++) {
                for (int lane = part[0]; lane < part[1]; lane++) {
                    own.commit(pass == 0 && lane % 2 == 1 ? new SplatBuffer() : splats(10 * pass + lane), 400, lane);
                }
            }
            merged.merge(own.state(List.of()));
        }
        assertSame(whole, merged);
    }

    /** What a state holds does not change with the film that it was taken of, nor the other way round. */
    @Test
    void statesOfLanesAreCopies() {
        Film film = film(ReconstructionFilter.BOX);
        film.commit(splats(1), 400, 3);
        FilmState state = film.state(List.of());
        Film restored = film(ReconstructionFilter.BOX);
        restored.restore(state);
        restored.commit(splats(2), 400, 3);
        film.commit(splats(3), 400, 3);
        Film again = film(ReconstructionFilter.BOX);
        again.restore(state);
        Film expected = film(ReconstructionFilter.BOX);
        expected.commit(splats(1), 400, 3);
        assertSame(expected, again);
        FilmState.Lane lane = state.splats().lanes().get(0);
        assertEquals(3, lane.number());
        assertThrows(IllegalArgumentException.class, () -> new FilmState.Splats(null, List.of(lane, lane), null));
    }

    /** Three lanes of unequal numbers of steps; expectation by hand. */
    @Test
    void varianceOfDependentSplatsIsTheScatterOfLanes() {
        Film film = new Film(new FilmSettings(1, 1, ReconstructionFilter.BOX), Set.of(FilmLayer.VARIANCE));
        film.useDependentSplats();
        film.setSplatScale(2, 0.1);
        double[] sums = {3, 10, 2};
        long[] paths = {2, 4, 2};
        for (int lane = 0; lane < 3; lane++) {
            for (int i = 0; i < paths[lane]; i++) {
                SplatBuffer buffer = new SplatBuffer();
                double value = sums[lane] / paths[lane];
                buffer.add(0.5, 0.5, value, value, value);
                film.commit(buffer, 1, lane);
            }
        }
        // m = 15/8; Σ(S − m·n)² = 0.75² + 2.5² + 1.75².
        double scatter = 1.5 * (0.5625 + 6.25 + 3.0625);
        double expected = (scatter + 0.1 * 0.1 * 15 * 15) * 4 / 64;
        assertEquals(expected, film.develop().get("variance.G", 0, 0), 1e-6);
        assertEquals(Math.sqrt(expected) / (2 * 15 / 8.0), film.relativeError(), 1e-12);
    }

    @Test
    void dependentSplatsAreMergedAndRestored() {
        Film whole = film(ReconstructionFilter.GAUSSIAN);
        Film merged = film(ReconstructionFilter.GAUSSIAN);
        whole.useDependentSplats();
        whole.setSplatScale(3, 0.2);
        for (int part = 0; part < 3; part++) {
            Film own = film(ReconstructionFilter.GAUSSIAN);
            own.useDependentSplats();
            own.setSplatScale(3, 0.2);
            for (int lane = 2 * part; lane < 2 * part + 2; lane++) {
                whole.commit(splats(lane), 400 + lane, lane);
                own.commit(splats(lane), 400 + lane, lane);
            }
            merged.merge(own.state(List.of()));
        }
        assertSame(whole, merged);
        Film restored = film(ReconstructionFilter.GAUSSIAN);
        restored.restore(merged.state(List.of()));
        restored.commit(splats(9), 10, 1);
        whole.commit(splats(9), 10, 1);
        assertSame(whole, restored);
    }

    private static SplatBuffer splats(long seed) {
        SplatBuffer splats = new SplatBuffer();
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 300; i++) {
            splats.add(WIDTH * random.nextDouble(), HEIGHT * random.nextDouble(), random.nextDouble(), 1, 0.1);
        }
        return splats;
    }

    @Test
    void openLanesAreNotMerged() {
        Film part = film(ReconstructionFilter.BOX);
        addSplats(part, new SplittableRandom(1));
        FilmState state = part.state(List.of());
        assertThrows(
                IllegalArgumentException.class,
                () -> film(ReconstructionFilter.BOX).merge(state));
    }

    /** Twice the weight is twice the sample, in the mean; a mean of the same samples with any weight is the same. */
    @ParameterizedTest
    @MethodSource("filters")
    void weightsWeigh(ReconstructionFilter filter) {
        Film plain = film(filter);
        addSamples(plain, new SplittableRandom(1), 1);
        addSamples(plain, new SplittableRandom(2), 1);
        addSamples(plain, new SplittableRandom(2), 1);
        Film weighted = film(filter);
        weighted.useSampleWeights();
        addSamples(weighted, new SplittableRandom(1), 0.5);
        addSamples(weighted, new SplittableRandom(2), 1);
        FilmImage a = plain.develop();
        FilmImage b = weighted.develop();
        for (int p = 0; p < WIDTH * HEIGHT; p++) {
            assertEquals(a.channel("G")[p], b.channel("G")[p], 1e-5);
        }
        assertThrows(IllegalStateException.class, weighted::useSampleWeights);
    }

    @Test
    void statisticsOfPixels() {
        Film film = new Film(new FilmSettings(1, 1, ReconstructionFilter.BOX));
        film.useSampleWeights();
        FilmTile tile = film.newTile();
        tile.begin(0, 0, 1, 1);
        tile.setSampleWeight(0.25);
        for (double v : new double[] {1, 2, 3, 6}) {
            tile.add(0.5, 0.5, grey(v));
        }
        film.commit(tile);
        LuminanceStatistics statistics = film.luminanceStatistics();
        assertEquals(1, statistics.weights()[0], 1e-12);
        assertEquals(4, statistics.effectiveSamples()[0], 1e-12);
        assertEquals(3, statistics.means()[0], 1e-6);
    }

    /**
     * Of 4 samples and then 8 of twice the weight, all with variance 1: the mean square of the deviations by the difference is 1.
     * A z-test over 20000 pixels with a fixed seed, false-alarm rate 1e-5.
     */
    @Test
    void deviationsByDifferencesAreUnbiased() {
        int width = 200;
        int height = 100;
        Film film = new Film(new FilmSettings(width, height, ReconstructionFilter.BOX));
        film.useSampleWeights();
        SplittableRandom random = new SplittableRandom(3);
        LuminanceStatistics none = film.luminanceStatistics();
        addNormal(film, random, 4, 1);
        LuminanceStatistics before = film.luminanceStatistics();
        addNormal(film, random, 8, 2);
        LuminanceStatistics now = film.luminanceStatistics();
        Moments squares = new Moments();
        for (double deviation : now.deviationsSince(before)) {
            squares.add(deviation * deviation);
        }
        ZTest.assertNotRejected("mean square", ZTest.oneSample(squares, 1), 1e-5);
        assertTrue(Arrays.stream(now.deviationsSince(none)).allMatch(Double::isNaN), "nothing before");
        assertTrue(Arrays.stream(before.deviationsSince(before)).allMatch(Double::isNaN), "nothing since");
    }

    private static void addNormal(Film film, SplittableRandom random, int samples, double weight) {
        FilmTile tile = film.newTile();
        FilmSettings.Crop crop = film.settings().crop();
        tile.begin(0, 0, crop.width(), crop.height());
        tile.setSampleWeight(weight);
        for (int y = 0; y < crop.height(); y++) {
            for (int x = 0; x < crop.width(); x++) {
                for (int i = 0; i < samples; i++) {
                    tile.add(x + 0.5, y + 0.5, grey(10 + random.nextGaussian()));
                }
            }
        }
        film.commit(tile);
    }

    private static Spectrum grey(double value) {
        Spectrum spectrum = new Spectrum();
        spectrum.set(value, value, value);
        return spectrum;
    }

    @Test
    void statesThatDoNotFitAreRefused() {
        Film film = film(ReconstructionFilter.BOX);
        FilmSettings.Crop outside = new FilmSettings.Crop(5, 5, WIDTH, 1);
        FilmState state = film.state(List.of(film.settings().crop()));
        assertThrows(
                IllegalArgumentException.class,
                () -> new FilmState(
                        state.settings(),
                        state.layers(),
                        false,
                        List.of(outside),
                        new double[1],
                        0,
                        FilmState.Splats.NONE,
                        0,
                        1));
        Film other = film(ReconstructionFilter.TENT);
        assertThrows(IllegalArgumentException.class, () -> other.restore(state));
        Film weighted = film(ReconstructionFilter.BOX);
        weighted.useSampleWeights();
        assertThrows(IllegalArgumentException.class, () -> weighted.restore(state));
    }
}
