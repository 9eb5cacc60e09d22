package org.daybreak.core.render;

import org.daybreak.core.film.Film;

/**
 * Tells a render's listener how far it is, at a rate that costs nothing. Used from the thread that called the renderer
 * only.
 */
public final class ProgressReporter {
    private static final double SECONDS_BETWEEN = 0.25;

    private final RenderContext context;
    private final RenderClock clock;
    private final Film film;
    private final double total;
    private final long start;
    private double lastReport;
    private long passesSeen;
    private double relativeError = Double.NaN;

    /**
     * Creates a reporter.
     *
     * @param total samples that will be taken if nothing stops the render
     * @param start samples that were taken by the render which this one continues
     */
    public ProgressReporter(RenderContext context, RenderClock clock, Film film, double total, long start) {
        this.context = context;
        this.clock = clock;
        this.film = film;
        this.total = total;
        this.start = start;
    }

    /**
     * Reports if it is time to.
     *
     * @param samples samples committed to the film, those of the render that is continued included
     * @param passes number of passes that are complete; several that were completed since the last call are announced
     *     once
     */
    public void update(long samples, long passes) {
        if (passes > passesSeen) {
            passesSeen = passes;
            relativeError = film.relativeError();
            context.listener().passFinished(film);
        }
        if (clock.seconds() - lastReport >= SECONDS_BETWEEN) {
            report(samples);
        }
    }

    /** Reports the end of the render. */
    public void finish(long samples, long passes) {
        update(samples, passes);
        relativeError = film.relativeError();
        report(samples);
    }

    /** The film's relative error as it was last computed; NaN if unknown. */
    public double relativeError() {
        return relativeError;
    }

    private void report(long samples) {
        double seconds = clock.seconds();
        lastReport = seconds;
        double rate = (samples - start) / Math.max(seconds, 1e-9);
        double byTime = seconds / context.budget().seconds();
        double fraction = Math.min(1, Math.max(samples / total, byTime));
        double secondsLeft =
                Math.max(0, Math.min(clock.secondsLeft(), samples == start ? Double.NaN : (total - samples) / rate));
        context.listener().progress(new Progress(fraction, samples, rate, seconds, secondsLeft, relativeError));
    }
}
