package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ConnectionRouletteTest {
    private static final int SAMPLES = 4000;

    /** A roulette after samples of luminance 0 and 2 in turns, with some black ones before. */
    private static ConnectionRoulette after(int black, long cost) {
        ConnectionRoulette roulette = new ConnectionRoulette(true);
        roulette.beginUnit();
        for (int i = 0; i < black + SAMPLES; i++) {
            roulette.beginSample(0.5);
            roulette.endSample(i < black ? 0 : 2 * (i & 1), cost);
        }
        return roulette;
    }

    /** The contribution from which on all are tested. */
    private static double threshold(ConnectionRoulette roulette) {
        roulette.beginSample(0.3);
        double low = 0;
        double high = 10;
        for (int i = 0; i < 60; i++) {
            double middle = 0.5 * (low + high);
            boolean always = true;
            for (int j = 0; always && j < 200; j++) {
                always = roulette.survive(middle) == 1;
            }
            if (always) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }

    /** δ = σ/√n: successive samples differ by 2, which for a normal distribution is a σ of √π. */
    @Test
    void thresholdIsTheDeviationOverTheRootOfTheCost() {
        assertEquals(Math.sqrt(Math.PI) / 5, threshold(after(0, 25)), 0.01);
        assertEquals(Math.sqrt(Math.PI) / 10, threshold(after(0, 100)), 0.005);
    }

    @Test
    void whatIsTestedCountsForWhatIsLeftOut() {
        ConnectionRoulette roulette = after(0, 25);
        double contribution = 0.1 * Math.sqrt(Math.PI) / 5;
        roulette.beginSample(0.7);
        int count = 100_000;
        double sum = 0;
        int tested = 0;
        for (int i = 0; i < count; i++) {
            double factor = roulette.survive(contribution);
            sum += factor;
            tested += factor > 0 ? 1 : 0;
        }
        // Five standard deviations of a binomial distribution with q = 0.1: a false alarm in 10^6.
        assertEquals(0.1, tested / (double) count, 5 * Math.sqrt(0.1 * 0.9 / count) + 0.002);
        assertEquals(1, sum / count, 5 * Math.sqrt(9.0 / count));
    }

    @Test
    void unitsThatBeginBlackPlayToo() {
        assertTrue(threshold(after(100, 25)) > 0.3);
    }

    @Test
    void firstSamplesTestAll() {
        ConnectionRoulette roulette = new ConnectionRoulette(true);
        roulette.beginUnit();
        for (int i = 0; i < 8; i++) {
            roulette.beginSample(0.5);
            assertEquals(1, roulette.survive(1e-9));
            roulette.endSample(2 * (i & 1), 25);
        }
    }
}
