package org.daybreak.antialiasing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class DeviationAllocationTest {
    private static final int WIDTH = 40;
    private static final int HEIGHT = 10;

    private static int[] allocate(DeviationAllocation allocation, double[] means, double[] deviations, long average) {
        int[] counts = new int[WIDTH * HEIGHT];
        allocation.allocate(WIDTH, HEIGHT, means, deviations, average, counts);
        return counts;
    }

    private static double[] all(double value) {
        double[] values = new double[WIDTH * HEIGHT];
        Arrays.fill(values, value);
        return values;
    }

    @Test
    void passesDouble() {
        DeviationAllocation allocation = new DeviationAllocation(8, true, 0.1);
        assertArrayEquals(new long[] {8, 8, 16, 32}, allocation.passes(64));
        assertArrayEquals(new long[] {8}, allocation.passes(8));
        assertEquals(1L << 31, Arrays.stream(allocation.passes(1L << 31)).sum());
    }

    @Test
    void evenNoiseIsSampledEvenly() {
        for (boolean relative : new boolean[] {true, false}) {
            int[] counts = allocate(new DeviationAllocation(8, relative, 0.1), all(2), all(0.5), 16);
            assertTrue(Arrays.stream(counts).allMatch(n -> n == 16), Arrays.toString(counts));
        }
    }

    @Test
    void nothingKnownIsSampledEvenly() {
        int[] counts = allocate(new DeviationAllocation(8, true, 0.1), all(0), all(Double.NaN), 32);
        assertTrue(Arrays.stream(counts).allMatch(n -> n == 32), Arrays.toString(counts));
        counts = allocate(new DeviationAllocation(8, true, 0.1), all(0), all(0), 32);
        assertTrue(Arrays.stream(counts).allMatch(n -> n == 32), Arrays.toString(counts));
    }

    /**
     * The right half is eight times as noisy, so away from the border between them it gets eight times as many, but for the
     * rounding of both numbers to powers of two.
     */
    @Test
    void numbersFollowTheDeviation() {
        double[] deviations = all(0.125);
        for (int p = 0; p < deviations.length; p++) {
            deviations[p] = p % WIDTH < WIDTH / 2 ? 0.125 : 1;
        }
        int[] counts = allocate(new DeviationAllocation(8, false, 0.01), all(1), deviations, 64);
        int ratio = counts[WIDTH - 1] / counts[0];
        assertTrue(ratio >= 4 && ratio <= 16, "ratio " + ratio);
        long sum = Arrays.stream(counts).asLongStream().sum();
        assertTrue(sum <= 64L * counts.length && sum > 32L * counts.length, "sum " + sum);
    }

    @Test
    void relativeErrorFavoursDarkParts() {
        double[] means = all(1);
        for (int p = 0; p < means.length; p++) {
            means[p] = p % WIDTH < WIDTH / 2 ? 0.1 : 10;
        }
        int[] relative = allocate(new DeviationAllocation(8, true, 0.1), means, all(1), 16);
        assertTrue(relative[0] > relative[WIDTH - 1]);
        int[] absolute = allocate(new DeviationAllocation(8, false, 0.1), means, all(1), 16);
        assertEquals(absolute[0], absolute[WIDTH - 1]);
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
