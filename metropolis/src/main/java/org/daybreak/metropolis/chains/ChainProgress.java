package org.daybreak.metropolis.chains;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.daybreak.core.render.NonFiniteLog;
import org.daybreak.core.render.ProgressReporter;
import org.daybreak.core.render.RenderClock;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;

/**
 * How far a render by chains is and what it took: samples, passes, the seconds of its phases, and what was left out as
 * not finite. Work is committed one unit at a time; only those who watch read meanwhile.
 */
final class ChainProgress {
    /** Mutations per pixel in the first pass; up to the largest pass, the number at the end of each is double that before. */
    private static final double FIRST_PASS = 0.25;

    private static final int LARGEST_PASS = 16;

    private final RenderClock clock;
    private final ProgressReporter reporter;
    private final long pixels;
    private final NonFiniteLog nonFinite = new NonFiniteLog();
    private final Map<String, Double> seconds = new LinkedHashMap<>();
    private double phaseStart;
    private volatile long directSamples;
    private volatile long steps;
    private volatile long passes;

    /**
     * Creates the progress of a render that begins.
     *
     * @param pixels of the film
     */
    ChainProgress(RenderClock clock, ProgressReporter reporter, long pixels) {
        this.clock = clock;
        this.reporter = reporter;
        this.pixels = pixels;
    }

    /** Goes on from a state of the render. */
    void restore(RenderState start) {
        nonFinite.addAll(start.nonFiniteSamples(), start.nonFiniteAddresses());
        directSamples = start.film().samples();
        steps = start.samples() - directSamples;
    }

    /** Goes on from where the chains of a state were. */
    void restore(long direct, long chainSteps, long chainPasses) {
        directSamples = direct;
        steps = chainSteps;
        passes = chainPasses;
    }

    /** Takes over what rendering the direct light came to. */
    void addDirect(RenderReport report) {
        directSamples = report.samples();
        nonFinite.addAll(report.nonFiniteSamples(), report.nonFiniteAddresses());
    }

    /**
     * Counts steps of the chains that make the image.
     *
     * @return true if a pass is complete with them
     */
    boolean addSteps(int taken) {
        long done = steps + taken;
        steps = done;
        long now = passes(done / (double) pixels);
        boolean more = now > passes;
        if (more) {
            passes = now;
        }
        return more;
    }

    /** Number of passes that are complete after a number of mutations per pixel: ¼, ½, 1, … 16, 32, 48, … */
    private static long passes(double mutations) {
        long done = (long) (mutations / LARGEST_PASS);
        for (double end = FIRST_PASS; end < LARGEST_PASS && end <= mutations; end *= 2) {
            done++;
        }
        return done;
    }

    /**
     * Counts what a chain in a round has left out.
     *
     * @param seed of the chain, for the address
     */
    void addNonFinite(ChainRounds.Unit unit, long seed) {
        if (unit.statistics.nonFinite > 0) {
            String address = String.format(
                    Locale.ROOT,
                    "seed %d, chain %d, steps %d to %d",
                    seed,
                    unit.chain,
                    unit.firstStep,
                    unit.firstStep + unit.steps - 1);
            nonFinite.addAll(unit.statistics.nonFinite, List.of(address));
        }
    }

    /** Ends a phase, or one more piece of it. */
    void endPhase(String name) {
        double now = clock.seconds();
        seconds.merge(name, now - phaseStart, Double::sum);
        phaseStart = now;
    }

    /** Tells the listener, if it is time to. */
    void show() {
        reporter.update(samples(), passes);
    }

    /** Tells the listener that the render ends. */
    void finish() {
        reporter.finish(samples(), passes);
    }

    /** Samples of the direct light and steps of the chains together. */
    long samples() {
        return directSamples + steps;
    }

    /** Samples of the direct light. */
    long directSamples() {
        return directSamples;
    }

    /** Steps of the chains that make the image. */
    long steps() {
        return steps;
    }

    /** Number of passes that are complete. */
    long passes() {
        return passes;
    }

    /** Seconds by phase. */
    Map<String, Double> seconds() {
        return seconds;
    }

    /** What was left out. */
    NonFiniteLog nonFinite() {
        return nonFinite;
    }

    /** The film's relative error as it was last computed; NaN if unknown. */
    double relativeError() {
        return reporter.relativeError();
    }
}
