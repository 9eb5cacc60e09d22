package org.daybreak.core.render;

import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Takes the checkpoints of one render: states are copied between two commits, and saved in the thread that called the
 * renderer, while the workers go on.
 */
public final class Checkpoints {
    /** A checkpoint begins so much before it is due that its copying and saving are done in time. */
    private static final double SAVING_MARGIN = 2;

    private static final double WATCH_SECONDS = 0.2;

    private final CheckpointSink sink;
    private final RenderClock clock;
    private volatile boolean due;
    private volatile @Nullable RenderState taken;
    private @Nullable RenderState last;
    private double lastTaken;
    private double savingSeconds;

    /** Creates the checkpoints of a render. */
    public Checkpoints(RenderContext context, RenderClock clock) {
        sink = context.checkpoints();
        this.clock = clock;
    }

    /**
     * To be called before the commit of a unit.
     *
     * @param whole false if the unit was cut short: no state after it can be continued, and the one before it is the last
     * @param state makes the state before the commit
     */
    public void beforeCommit(boolean whole, Supplier<RenderState> state) {
        if (last != null || !sink.takesStates()) {
            return;
        }
        if (!whole) {
            last = state.get();
        } else if (due) {
            taken = state.get();
            due = false;
        }
    }

    /**
     * True if the next call of {@link #beforeCommit} takes a state: for work whose state is whole only when nothing is under way,
     * so that it can wait for that.
     */
    public boolean isDue() {
        return due;
    }

    /** Saves what was taken, and asks for the next if it is time to. To be called several times a second. */
    public void watch() {
        if (!sink.takesStates()) {
            return;
        }
        RenderState state = taken;
        double now = clock.seconds();
        if (state != null) {
            taken = null;
            sink.save(state);
            savingSeconds = clock.seconds() - now;
        } else if (!due && now - lastTaken + SAVING_MARGIN * savingSeconds + WATCH_SECONDS >= sink.intervalSeconds()) {
            lastTaken = now;
            due = true;
        }
    }

    /**
     * Saves the last state. To be called once, when all units are committed.
     *
     * @param state makes the state now
     */
    public void finish(Supplier<RenderState> state) {
        if (sink.takesStates()) {
            RenderState before = last;
            sink.save(before != null ? before : state.get());
        }
    }
}
