package org.daybreak.core.render;

/**
 * Tells the workers of one render when to stop: its time is up, it was cancelled, or the algorithm is done. Thread-safe.
 * Once it says stop it keeps saying so.
 */
public final class RenderClock {
    private final CancellationToken cancellation;
    private final double limit;
    private final boolean limited;
    private final long start = System.nanoTime();
    private volatile boolean stopped;

    /** Starts the clock for a render. */
    public RenderClock(RenderContext context) {
        cancellation = context.cancellation();
        limit = context.budget().seconds();
        limited = limit < Double.POSITIVE_INFINITY;
    }

    /** Wall-clock seconds since the clock was made. */
    public double seconds() {
        return (System.nanoTime() - start) * 1e-9;
    }

    /** Wall-clock seconds until the time limit; infinite without one. */
    public double secondsLeft() {
        return limited ? limit - seconds() : Double.POSITIVE_INFINITY;
    }

    /** True if work should stop now. Costs a few tens of nanoseconds: ask once per some samples, not per ray. */
    public boolean shouldStop() {
        return stopped || cancellation.isCancelled() || (limited && secondsLeft() <= 0);
    }

    /** Makes the render stop, for a reason of the algorithm's own. */
    public void stop() {
        stopped = true;
    }
}
