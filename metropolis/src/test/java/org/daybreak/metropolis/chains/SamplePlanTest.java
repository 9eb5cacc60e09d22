package org.daybreak.metropolis.chains;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.metropolis.chains.PilotWorker.By;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Plans from pilots that are made up. */
class SamplePlanTest {
    private static final long STEADY = 4;
    private static final long RARE = 5;
    private static final long MISSED = 6;
    private static final long SEED = 1;
    private static final double WORK_PER_SAMPLE = 8;

    /** Of steps where none is told. */
    private static final double WORK_PER_STEP = 2.5;

    private final PilotGrid grid = new PilotGrid(new FilmSettings(80, 60, ReconstructionFilter.BOX), SEED);
    private final PilotPaths paths = new PilotPaths();

    /** Surveys a grey image: of luminance 1 by steady paths, and by others that few samples find, or none. */
    private SamplePlan plan(double steady, double rare, double missed, Sharing sharing) {
        RandomStream random = new RandomStream(SEED, StreamDomain.SELF_CHECK, 0, 0);
        paths.clear();
        for (int i = 0; i < grid.surveys(); i++) {
            double x = random.nextDouble() * 80;
            double y = random.nextDouble() * 60;
            add(STEADY, x, y, steady, By.CANDIDATES);
            add(RARE, x, y, rare, By.CANDIDATES);
            add(MISSED, x, y, missed, By.CANDIDATES);
            double px = grid.column(i) + 0.5;
            double py = grid.row(i) + 0.5;
            for (By half : new By[] {By.FIRST, By.SECOND}) {
                add(STEADY, px, py, steady * (0.9 + 0.2 * random.nextDouble()), half);
                add(RARE, px, py, random.nextDouble() < 0.05 ? 20 * rare : 0, half);
            }
            paths.addWork(2 * PilotWorker.BLOCK * WORK_PER_SAMPLE);
            paths.endSurvey();
        }
        return SamplePlan.of(grid, paths, sharing);
    }

    private void add(long pattern, double x, double y, double weight, By by) {
        if (weight > 0) {
            paths.found(pattern, x, y, weight, by, 0);
        }
    }

    @Test
    void samplesGetWhatTheyFindSteadily() {
        SamplePlan plan = plan(0.8, 0.1, 0.1, Sharing.AUTO);
        assertTrue(plan.ofSamples().contains(STEADY));
        assertFalse(plan.ofSamples().contains(RARE), "scatters more than chains");
        assertFalse(plan.ofSamples().contains(MISSED), "samples do not find it");
        assertTrue(plan.gain() > 2, () -> "gain " + plan.gain());
        assertTrue(plan.timeShare() >= 0.2 && plan.timeShare() <= 0.8, () -> "share " + plan.timeShare());
    }

    @Test
    void chainsAloneIfSamplesFindNothingWell() {
        assertTrue(plan(0, 0.5, 0.5, Sharing.AUTO).ofSamples().isEmpty());
        SamplePlan forced = plan(0, 0.5, 0.5, Sharing.ALWAYS);
        assertTrue(forced.ofSamples().contains(RARE));
        assertFalse(forced.ofSamples().contains(MISSED));
        assertTrue(forced.gain() < 1, () -> "gain " + forced.gain());
    }

    /** A little of what samples find well does not pay for the samples. */
    @Test
    void chainsAloneIfThereIsLittleToGain() {
        assertTrue(plan(0.05, 0.5, 0.45, Sharing.AUTO).ofSamples().isEmpty());
    }

    @Test
    void chainsAloneIfNothingElseIsWanted() {
        assertSame(SamplePlan.CHAINS_ALONE, plan(0.8, 0.1, 0.1, Sharing.NEVER));
    }

    @Test
    void chainsAloneInTheDark() {
        assertTrue(plan(0, 0, 0, Sharing.ALWAYS).ofSamples().isEmpty());
    }

    /** What three samples have found and nothing contradicts may be noise that is not seen. */
    @Test
    void chainsGetWhatIsNotKnownWell() {
        paths.clear();
        for (int i = 0; i < grid.surveys(); i++) {
            add(STEADY, grid.column(i), grid.row(i), 0.9, By.CANDIDATES);
            add(RARE, grid.column(i), grid.row(i), 0.1, By.CANDIDATES);
            for (By half : new By[] {By.FIRST, By.SECOND}) {
                add(STEADY, grid.column(i), grid.row(i), 0.9, half);
                add(RARE, grid.column(i), grid.row(i), i < 3 ? 0.1 * grid.surveys() / 3 : 0, half);
            }
            paths.addWork(2 * PilotWorker.BLOCK * WORK_PER_SAMPLE);
            paths.endSurvey();
        }
        SamplePlan plan = SamplePlan.of(grid, paths, Sharing.AUTO);
        assertTrue(plan.ofSamples().contains(STEADY));
        assertFalse(plan.ofSamples().contains(RARE));
    }

    /** A division of luminance 1 whose errors can be computed by hand; all scatter of a half is in one sample, so it gains nothing. */
    @Test
    void gainIsThatOfTheFormula() {
        divide(1);
        SamplePlan plan = SamplePlan.of(grid, paths, Sharing.AUTO);
        checkFormula(plan, 0.02, WORK_PER_STEP, 1);
    }

    /** Steps from what is left to chains may take longer, or not as long. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 3, 7})
    void stepsCountByTheirWork(double workOfMissed) {
        divide(1);
        for (int i = 0; i < 200; i++) {
            paths.moved(STEADY, 0.5, i % 2 == 0 ? 2 : 4);
            paths.moved(MISSED, 0.25, workOfMissed);
            paths.moved(MISSED, 0.25, workOfMissed);
        }
        SamplePlan plan = SamplePlan.of(grid, paths, Sharing.AUTO);
        double ofAll = (3 + workOfMissed) / 2;
        // Steps of the kinds of the samples count by 0.002 of all.
        checkFormula(plan, 0.02, ofAll, (0.5 * workOfMissed + 0.002 * ofAll) / 0.502 / ofAll);
    }

    /** Errors of four samples of which one takes away another. */
    @Test
    void samplesThatAreSpreadGainFurther() {
        divide(4);
        SamplePlan plan = SamplePlan.of(grid, paths, Sharing.AUTO);
        // Variances of 0.2²/2 for means of four and of (0.8² + 2·0.4²)/4/2 for single samples: two thirds of what
        // independent ones had.
        checkFormula(plan, 0.02 * 2 / 3, WORK_PER_STEP, 1);
    }

    /** Half of the light for either; the means of the samples' halves are 0.6 and 0.4. */
    private void divide(int samples) {
        paths.clear();
        for (int i = 0; i < grid.surveys(); i++) {
            add(STEADY, grid.column(i), grid.row(i), 0.5, By.CANDIDATES);
            add(MISSED, grid.column(i), grid.row(i), 0.5, By.CANDIDATES);
            if (samples == 1) {
                add(STEADY, grid.column(i), grid.row(i), 0.6, By.FIRST);
                add(STEADY, grid.column(i), grid.row(i), 0.4, By.SECOND);
            } else {
                double[] differences = {0.2, 0, 0.1, -0.1};
                for (int j = 0; j < PilotWorker.BLOCK; j++) {
                    paths.found(STEADY, grid.column(i), grid.row(i), 0.125 + differences[j] / 2, By.FIRST, j);
                    paths.found(STEADY, grid.column(i), grid.row(i), 0.125 - differences[j] / 2, By.SECOND, j);
                }
            }
            paths.addWork(2 * PilotWorker.BLOCK * WORK_PER_SAMPLE);
            paths.endSurvey();
        }
    }

    /** With τ = 5; the luminance is 1, so both errors are equal but for the floor. */
    private static void checkFormula(SamplePlan plan, double variance, double workPerStep, double stepCost) {
        double samples = 4 * variance * WORK_PER_SAMPLE / workPerStep;
        double chains = 5 * 0.25 * stepCost;
        double share = Math.sqrt(samples) / (Math.sqrt(samples) + Math.sqrt(chains));
        assertEquals(share, plan.timeShare(), 1e-9);
        assertEquals(5 / (samples / share + chains / (1 - share)), plan.gain(), 1e-9);
        assertEquals(stepCost, plan.stepCost(), 1e-9);
        assertEquals(WORK_PER_SAMPLE / workPerStep, plan.stepsPerSample(), 1e-9);
    }

    /** Direct lighting that scatters by a known variance beside chains with luminance 1. */
    @Test
    void directLightingGetsTheTimeOfTheFormula() {
        assertEquals(timeOfDirect(0.3), shareBesideChains(0.3), 1e-9);
        assertEquals(0.04, shareBesideChains(0), 1e-9);
        assertEquals(0.04, shareBesideChains(0.01), 1e-9);
        assertEquals(0.5, shareBesideChains(20), 1e-9);
    }

    private static double timeOfDirect(double difference) {
        // τ = 5. Both are relative to the same luminance.
        double samples = 4 * (2 / WORK_PER_STEP) * difference * difference / 2;
        return Math.sqrt(samples) / (Math.sqrt(samples) + Math.sqrt(5));
    }

    private double shareBesideChains(double difference) {
        paths.clear();
        for (int i = 0; i < grid.surveys(); i++) {
            add(MISSED, grid.column(i), grid.row(i), 1, By.CANDIDATES);
            add(PilotWorker.SHORT, grid.column(i), grid.row(i), 21, By.FIRST);
            add(PilotWorker.SHORT, grid.column(i), grid.row(i), 21 - difference, By.SECOND);
            paths.endSurvey();
        }
        SamplePlan plan = SamplePlan.of(grid, paths, Sharing.AUTO);
        assertTrue(plan.ofSamples().isEmpty());
        return plan.timeShare();
    }
}
