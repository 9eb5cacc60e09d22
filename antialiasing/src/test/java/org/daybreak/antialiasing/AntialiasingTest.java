package org.daybreak.antialiasing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

final class AntialiasingTest {
    static List<AntialiasingFactory> factories() {
        return ServiceLoader.load(AntialiasingFactory.class).stream()
                .map(ServiceLoader.Provider::get)
                .toList();
    }

    static Stream<Antialiasing> methods() {
        return factories().stream().map(f -> f.create(ParameterValues.defaults(f.parameters())));
    }

    private static Antialiasing method(String id, Map<String, String> parameters) {
        AntialiasingFactory factory =
                factories().stream().filter(f -> f.id().equals(id)).findFirst().orElseThrow();
        return factory.create(ParameterValues.parse(factory.parameters(), parameters, id));
    }

    /** Positions in a pixel, x then y of each sample. */
    private static double[][] positions(Antialiasing method, long pixel, int samples) {
        Sampler sampler = method.newSampler(3, method.samplesPerPixel(samples));
        double[][] positions = new double[samples][];
        for (int i = 0; i < samples; i++) {
            sampler.start(pixel, i);
            positions[i] = new double[] {sampler.next(), sampler.next()};
        }
        return positions;
    }

    /** How many of the positions lie in each cell of a grid. */
    private static int[] count(double[][] positions, int columns, int rows) {
        int[] counts = new int[columns * rows];
        for (double[] p : positions) {
            int row = (int) (p[1] * rows);
            int column = (int) (p[0] * columns);
            counts[row * columns + column]++;
        }
        return counts;
    }

    private static int[] all(int value, int length) {
        int[] array = new int[length];
        Arrays.fill(array, value);
        return array;
    }

    @Test
    void serviceLoaderFindsTheMethods() {
        assertEquals(
                List.of("sobol", "stratified", "grid", "none", "adaptive"),
                factories().stream().map(AntialiasingFactory::id).toList());
        factories()
                .forEach(f -> assertEquals(
                        f.id(),
                        f.create(ParameterValues.defaults(f.parameters())).id()));
    }

    @Test
    void noneSamplesTheCentre() {
        for (double[] p : positions(method("none", Map.of()), 17, 20)) {
            assertArrayEquals(new double[] {0.5, 0.5}, p);
        }
    }

    @Test
    void gridHasOneSampleInEachCell() {
        Antialiasing grid = method("grid", Map.of("gridSize", "5"));
        assertEquals(25, grid.samplesPerPixel(1));
        assertEquals(25, grid.samplesPerPixel(25));
        assertEquals(50, grid.samplesPerPixel(26));
        double[][] positions = positions(grid, 4, 50);
        assertArrayEquals(all(2, 25), count(positions, 5, 5));
        assertNotEquals(positions[0][0], positions[25][0], "the second grid has new random positions");
        assertEquals(1, method("grid", Map.of()).samplesPerPixel(1));
        assertEquals(9, method("grid", Map.of()).samplesPerPixel(5));
        assertArrayEquals(all(1, 9), count(positions(method("grid", Map.of()), 4, 9), 3, 3));
    }

    @Test
    void gridWithoutJitterSamplesTheCentresOfCells() {
        double[][] positions = positions(method("grid", Map.of("gridSize", "2", "jitter", "false")), 4, 4);
        assertArrayEquals(new double[][] {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}, positions);
    }

    @Test
    void stratifiedCoversItsStrataInEveryPairOfDimensions() {
        Antialiasing stratified = method("stratified", Map.of());
        assertEquals(12, stratified.samplesPerPixel(11));
        assertEquals(1024, stratified.samplesPerPixel(1024));
        assertEquals(2048, stratified.samplesPerPixel(1025));
        Sampler sampler = stratified.newSampler(9, 12);
        for (int pair = 0; pair < 5; pair++) {
            double[][] values = new double[12][];
            for (int i = 0; i < 12; i++) {
                sampler.start(7, i);
                sampler.setDimension(2 * pair);
                values[i] = new double[] {sampler.next(), sampler.next()};
            }
            assertArrayEquals(all(1, 12), count(values, 4, 3));
        }
    }

    @Test
    void sobolStratifiesEveryPrefixOfAPowerOfTwo() {
        double[][] positions = positions(method("sobol", Map.of()), 5, 64);
        assertArrayEquals(all(1, 64), count(positions, 8, 8));
        assertArrayEquals(all(1, 16), count(Arrays.copyOf(positions, 16), 4, 4));
        assertArrayEquals(all(1, 16), count(Arrays.copyOf(positions, 16), 16, 1));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 16, 17, 100, 1024})
    void permutationsAreBijectiveAndVary(int count) {
        for (long key = 0; key < 5; key++) {
            boolean[] seen = new boolean[count];
            for (int i = 0; i < count; i++) {
                int image = Strata.permute(i, count, key * 0x1234567L);
                assertTrue(image >= 0 && image < count && !seen[image]);
                seen[image] = true;
            }
        }
    }

    /** Over 4000 keys each of 5 indices must go everywhere alike: χ² by its normal bound, false alarms below 1e-6. */
    @Test
    void permutationsAreUniform() {
        int count = 6;
        int keys = 6000;
        for (int i = 0; i < count; i++) {
            int[] images = new int[count];
            for (long key = 0; key < keys; key++) {
                images[Strata.permute(i, count, key)]++;
            }
            for (int image : images) {
                // standard deviation √(6000·(1/6)(5/6)) = 28.9; 36 comparisons at 5.5 standard deviations: 1.4e-6.
                assertEquals(keys / (double) count, image, 5.5 * 28.9);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("methods")
    void numbersDependOnTheirAddressOnly(Antialiasing method) {
        Sampler sampler = method.newSampler(3, method.samplesPerPixel(16));
        sampler.start(12, 5);
        double[] sequence = new double[12];
        for (int i = 0; i < sequence.length; i++) {
            assertEquals(i, sampler.dimension());
            sequence[i] = sampler.next();
            assertTrue(sequence[i] >= 0 && sequence[i] < 1);
        }
        Sampler other = sampler.copy();
        other.start(99, 2);
        other.next();
        other.start(12, 5);
        for (int i = sequence.length - 1; i >= 0; i--) {
            other.setDimension(i);
            assertEquals(sequence[i], other.next());
        }
    }

    /**
     * Mean ½ of path dimensions over pixels and samples, and no correlation between neighbouring dimensions. Per method 12
     * z-tests at 1e-6: false-alarm rate below 1.2e-5 each.
     */
    @ParameterizedTest
    @MethodSource("methods")
    void pathDimensionsAreUniformAndUncorrelated(Antialiasing method) {
        Sampler sampler = method.newSampler(8, method.samplesPerPixel(1));
        for (int dimension = 2; dimension < 8; dimension++) {
            Moments mean = new Moments();
            Moments product = new Moments();
            for (int pixel = 0; pixel < 20_000; pixel++) {
                sampler.start(pixel, 0);
                sampler.setDimension(dimension);
                double u = sampler.next();
                double v = sampler.next();
                mean.add(u);
                product.add((u - 0.5) * (v - 0.5));
            }
            ZTest.assertNotRejected("mean of dimension " + dimension, ZTest.oneSample(mean, 0.5), 1e-6);
            ZTest.assertNotRejected("correlation at dimension " + dimension, ZTest.oneSample(product, 0), 1e-6);
        }
    }

    @ParameterizedTest
    @MethodSource("methods")
    void hugeNumbersOfSamplesWork(Antialiasing method) {
        long samples = method.samplesPerPixel(Integer.MAX_VALUE);
        assertTrue(samples >= Integer.MAX_VALUE);
        Sampler sampler = method.newSampler(1, samples);
        sampler.start(0, Integer.MAX_VALUE - 1L);
        assertTrue(sampler.next() < 1);
    }
}
