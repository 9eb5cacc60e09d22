package org.daybreak.metropolis.chains;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StartDistributionTest {
    @Test
    void estimatesTheMeanAndItsError() {
        StartDistribution distribution = new StartDistribution(new double[] {0, 3, 1, 0, 2});
        assertEquals(1.2, distribution.mean(), 1e-15);
        assertEquals(Math.sqrt(6.8 / 5 / 4), distribution.standardError(), 1e-15);
        assertEquals(2, distribution.withoutLight());
        assertEquals(5, distribution.candidates());
        assertTrue(Double.isNaN(new StartDistribution(new double[] {1}).standardError()));
        assertEquals(0, new StartDistribution(new double[0]).mean());
    }

    /** Over all offsets each candidate is drawn as often as its weight asks for: by midpoints, exact up to their spacing. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3, 10})
    void drawsInProportionToWeights(int chains) {
        double[] weights = {0, 3, 1e-3, 0, 2, 0.5, 0};
        StartDistribution distribution = new StartDistribution(weights);
        int offsets = 100_000;
        double[] counts = new double[weights.length];
        for (int i = 0; i < offsets; i++) {
            StartDistribution.Starts starts = distribution.draw((i + 0.5) / offsets, 0, chains, chains);
            for (int c = 0; c < chains; c++) {
                int candidate = (int) starts.candidates()[c];
                counts[candidate] += 1.0 / offsets / chains;
                assertTrue(starts.offsets()[c] >= 0 && starts.offsets()[c] <= weights[candidate]);
            }
        }
        for (int i = 0; i < weights.length; i++) {
            assertEquals(weights[i] / 5.501, counts[i], 2.0 / offsets);
        }
    }

    @Test
    void partsDrawTheSame() {
        double[] weights = new double[1000];
        for (int i = 0; i < weights.length; i++) {
            weights[i] = i % 7;
        }
        StartDistribution distribution = new StartDistribution(weights);
        StartDistribution.Starts all = distribution.draw(0.3, 0, 50, 50);
        StartDistribution.Starts part = distribution.draw(0.3, 20, 30, 50);
        assertArrayEquals(Arrays.copyOfRange(all.candidates(), 20, 30), part.candidates());
        assertArrayEquals(Arrays.copyOfRange(all.offsets(), 20, 30), part.offsets());
    }

    @Test
    void onlyOneCandidateWithLight() {
        double[] weights = new double[100];
        weights[42] = 1e-300;
        StartDistribution.Starts starts = new StartDistribution(weights).draw(0.999_999_999, 0, 1000, 1000);
        for (long candidate : starts.candidates()) {
            assertEquals(42, candidate);
        }
    }
}
