package org.daybreak.core.render;

/** Lets one thread ask a render to stop. Thread-safe; once cancelled it stays so. */
public final class CancellationToken {
    private volatile boolean cancelled;

    /** Asks every render that holds this token to stop soon, leaving a valid image. Idempotent, does not block. */
    public void cancel() {
        cancelled = true;
    }

    /** True once {@link #cancel} was called. */
    public boolean isCancelled() {
        return cancelled;
    }
}
