package org.daybreak.antialiasing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.daybreak.core.render.SampleAllocation.Statistics;
import org.junit.jupiter.api.Test;

/** No randomness here: statistics are given. The image has two halves whose middles the smoothing of the other does not reach. */
class DeviationAllocationTest {
    private static final int WIDTH = 200;
    private static final int HEIGHT = 40;

    /** Rounding numbers to 2ᵏ and 3·2ᵏ leaves this much of an error in the mean of a quarter of the image. */
    private static final double ROUNDING = 0.002;

    private static int[] allocate(DeviationAllocation allocation, double[] means, double[] deviations, long average) {
        int[] counts = new int[WIDTH * HEIGHT];
        allocation.allocate(new Statistics(WIDTH, HEIGHT, means, deviations), average, counts);
        long sum = Arrays.stream(counts).asLongStream().sum();
        long budget = average * counts.length;
        assertTrue(sum <= budget && sum > (1 - ROUNDING) * budget, () -> "sum " + sum + " of " + budget);
        for (int count : counts) {
            int power = Integer.highestOneBit(count);
            assertTrue(count == power || 2 * count == 3 * power, () -> count + " is neither 2^k nor 3*2^k");
        }
        return counts;
    }

    private static double[] all(double value) {
        return halves(value, value);
    }

    private static double[] halves(double left, double right) {
        double[] values = new double[WIDTH * HEIGHT];
        for (int p = 0; p < values.length; p++) {
            values[p] = p % WIDTH < WIDTH / 2 ? left : right;
        }
        return values;
    }

    private static double mean(int[] counts, IntPredicate column) {
        return IntStream.range(0, counts.length)
                .filter(p -> column.test(p % WIDTH))
                .map(p -> counts[p])
                .average()
                .orElseThrow();
    }

    /** The mean number far on the right over that far on the left. */
    private static double ratio(int[] counts) {
        return mean(counts, x -> x >= WIDTH * 3 / 4) / mean(counts, x -> x < WIDTH / 4);
    }

    @Test
    void passesGrowAndTheLastOneIsLarge() {
        DeviationAllocation allocation = new DeviationAllocation(4, true, 0.1);
        assertArrayEquals(new long[] {15}, allocation.passes(15));
        assertArrayEquals(new long[] {4, 4, 8}, allocation.passes(16));
        assertArrayEquals(new long[] {4, 4, 56}, allocation.passes(64));
        assertArrayEquals(new long[] {4, 4, 24, 68}, allocation.passes(100));
        assertArrayEquals(new long[] {4, 4, 24, 96, 872}, allocation.passes(1000));
        assertEquals(
                Integer.MAX_VALUE,
                Arrays.stream(allocation.passes(Integer.MAX_VALUE)).sum());
    }

    @Test
    void evenNoiseIsSampledEvenly() {
        for (boolean relative : new boolean[] {true, false}) {
            int[] counts = allocate(new DeviationAllocation(4, relative, 0.1), all(2), all(0.5), 16);
            assertTrue(Arrays.stream(counts).allMatch(n -> n == 16), Arrays.toString(counts));
            counts = allocate(new DeviationAllocation(4, relative, 0.1), all(2), all(0.5), 56);
            assertTrue(Arrays.stream(counts).allMatch(n -> n == 48 || n == 64), Arrays.toString(counts));
            assertEquals(1, ratio(counts), 2 * ROUNDING);
        }
    }

    @Test
    void nothingKnownIsSampledEvenly() {
        DeviationAllocation allocation = new DeviationAllocation(4, true, 0.1);
        for (double[] unknown : new double[][] {all(Double.NaN), all(0)}) {
            int[] counts = allocate(allocation, all(0), unknown, 32);
            assertTrue(Arrays.stream(counts).allMatch(n -> n == 32), Arrays.toString(counts));
        }
        int[] counts = allocate(allocation, halves(0.1, 3), all(Double.NaN), 32);
        assertTrue(Arrays.stream(counts).allMatch(n -> n == 32), Arrays.toString(counts));
    }

    /**
     * The right half is eight times as noisy and, but for the even share, gets eight times as many. Near the border the smoothing
     * changes the normalization of both, which cancels but in the even share: that moves the ratio by less than 0.01.
     */
    @Test
    void numbersFollowTheError() {
        double share = 0.01;
        double expected = (share + (1 - share) * 16 / 9.0) / (share + (1 - share) * 2 / 9.0);
        int[] counts = allocate(new DeviationAllocation(4, false, share), all(1), halves(0.125, 1), 64);
        assertEquals(expected, ratio(counts), 0.01 + 2 * ROUNDING * expected);
    }

    /** Squared errors count over the square of the brightness plus that of a quarter of the mean. */
    @Test
    void relativeErrorFavoursDarkParts() {
        double[] means = halves(0.1, 10);
        double offset = 0.25 * 5.05;
        double noise = Math.sqrt((0.1 * 0.1 + offset * offset) / (10 * 10 + offset * offset));
        double share = 0.01;
        double expected = (share + (1 - share) * 2 * noise / (1 + noise)) / (share + (1 - share) * 2 / (1 + noise));
        int[] relative = allocate(new DeviationAllocation(4, true, share), means, all(1), 64);
        assertEquals(1 / expected, 1 / ratio(relative), 0.01 + 2 * ROUNDING / expected);
        int[] absolute = allocate(new DeviationAllocation(4, false, share), means, all(1), 64);
        assertTrue(Arrays.stream(absolute).allMatch(n -> n == 64), Arrays.toString(absolute));
    }

    @Test
    void everyPixelHasASample() {
        double[] deviations = all(0);
        deviations[55] = 1e9;
        int[] counts = allocate(new DeviationAllocation(2, false, 0.01), all(1), deviations, 2);
        assertTrue(Arrays.stream(counts).allMatch(n -> n >= 1));
        assertTrue(counts[55] > 2, "count " + counts[55]);
    }
}
