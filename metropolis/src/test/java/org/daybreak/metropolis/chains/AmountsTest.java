package org.daybreak.metropolis.chains;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@link Amounts}. */
class AmountsTest {
    private static final long PIXELS = 5000;
    private static final SamplePlan SHARED = new SamplePlan(new PatternSet(3, 5), 2, 0.6, 2.5, 1.6);
    private static final SamplePlan DIRECT = new SamplePlan(PatternSet.NONE, 1, 0.1, 0.9, 1);

    private static ChainSettings settings(int mutations, int directSamples) {
        return new ChainSettings(1000, mutations, true, directSamples, false, 8, 0);
    }

    @Test
    void numbersThatAreGivenHold() {
        for (SamplePlan plan : new SamplePlan[] {SHARED, DIRECT, SamplePlan.CHAINS_ALONE}) {
            assertEquals(new Amounts(7, 250 * PIXELS), Amounts.of(settings(250, 7), plan, PIXELS));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 100, 250, 100_000})
    void samplesAndChainsThatShareLightDoTheWorkOfTheMutations(int mutations) {
        Amounts amounts = Amounts.of(settings(mutations, 0), SHARED, PIXELS);
        double work = 2.5 * amounts.samplesPerPixel() * PIXELS + 1.6 * amounts.steps();
        // The number of samples is rounded.
        assertEquals((double) mutations * PIXELS, work, 1.25 * PIXELS);
        assertEquals(0.4 / 1.6 * mutations * PIXELS, (double) amounts.steps(), 1);
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 100, 250, 100_000})
    void directLightingAloneComesOnTop(int mutations) {
        Amounts amounts = Amounts.of(settings(mutations, 0), DIRECT, PIXELS);
        assertEquals(mutations * PIXELS, amounts.steps());
        // A tenth of all work is for samples; their number is rounded.
        assertEquals(mutations / 9.0, 0.9 * amounts.samplesPerPixel(), 0.45);
    }

    @Test
    void withoutPlanThereAreSixteenSamplesForAHundredMutations() {
        assertEquals(new Amounts(16, 100 * PIXELS), Amounts.of(settings(100, 0), SamplePlan.CHAINS_ALONE, PIXELS));
        assertEquals(new Amounts(160, 1000 * PIXELS), Amounts.of(settings(1000, 0), SamplePlan.CHAINS_ALONE, PIXELS));
        assertEquals(settings(100, 16).directShare(), settings(100, 0).directShare(), 1e-12);
    }

    @Test
    void thereIsAtLeastOneOfEach() {
        assertEquals(1, Amounts.of(settings(1, 0), SamplePlan.CHAINS_ALONE, 1).samplesPerPixel());
        Amounts least = Amounts.of(settings(1, 0), new SamplePlan(new PatternSet(3), 9, 0.8, 4, 1), 1);
        assertEquals(new Amounts(1, 1), least);
    }

    @Test
    void hugeNumbersStayInRange() {
        Amounts most =
                Amounts.of(settings(Integer.MAX_VALUE, 0), new SamplePlan(new PatternSet(3), 9, 0.8, 0.1, 1), PIXELS);
        assertEquals(Integer.MAX_VALUE, most.samplesPerPixel());
        assertTrue(most.shareOfSamples(PIXELS) > 0.8);
    }
}
