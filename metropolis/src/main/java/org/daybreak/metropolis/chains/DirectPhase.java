package org.daybreak.metropolis.chains;

import java.util.LinkedHashMap;
import java.util.Map;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.render.CheckpointSink;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * The first phase of a render by chains: renders the {@link DirectPart}, if there is one, and makes its states states
 * of the whole render.
 */
final class DirectPhase {
    /** Entry of the position of a state: whether the direct light is done. */
    private static final String POSITION = "direct";

    private final DirectPart part;
    private final RenderContext context;
    private @Nullable RenderReport report;

    /** The last state of the direct light: it need not be that of the whole render. */
    private @Nullable RenderState state;

    /**
     * Creates the phase.
     *
     * @param context of the whole render
     */
    DirectPhase(DirectPart part, RenderContext context) {
        this.part = part;
        this.context = context;
    }

    /** The position of states of the whole render in which this phase is done. */
    static Map<String, long[]> donePosition() {
        return Map.of(POSITION, new long[] {1});
    }

    /** True if there is something to do after a state of the whole render, or from the beginning. */
    boolean isLeft(@Nullable RenderState start) {
        boolean done = start != null && start.position(POSITION, 1)[0] != 0;
        return part.exists() && !done;
    }

    /** Renders the direct light, and saves that it is done if chains follow. */
    RenderReport render(
            DirectPart.Samples samples,
            Scene scene,
            Camera camera,
            Film film,
            @Nullable RenderState start,
            double secondsGone) {
        RenderContext ofPart = context.withStart(start).withCheckpoints(new Sink());
        RenderReport done = part.render(samples, scene, camera, film, ofPart, secondsGone);
        report = done;
        RenderState last = state;
        if (last != null
                && last.complete()
                && !part.isAll()
                && context.checkpoints().intervalSeconds() < Double.POSITIVE_INFINITY) {
            context.checkpoints().save(ofWhole(last, true));
        }
        return done;
    }

    /** True if this render has completed it. */
    boolean isDone() {
        RenderReport done = report;
        RenderState last = state;
        return last != null
                ? last.complete()
                : done != null && !done.cancelled() && !Thread.currentThread().isInterrupted();
    }

    /** The last state of the direct light; null if this render has made none. */
    @Nullable
    RenderState state() {
        return state;
    }

    /** Number of rays of a kind traced. */
    long rays(String kind) {
        RenderReport done = report;
        return done == null ? 0 : done.raysByKind().getOrDefault(kind, 0L);
    }

    /** A state of the direct light as one of the whole render, to which chains are still to come. */
    static RenderState ofWhole(RenderState direct, boolean done) {
        Map<String, long[]> position = new LinkedHashMap<>(direct.position());
        position.put(POSITION, new long[] {done ? 1 : 0});
        return new RenderState(
                direct.film(),
                position,
                direct.samples(),
                0,
                false,
                direct.nonFiniteSamples(),
                direct.nonFiniteAddresses(),
                direct.seconds());
    }

    /** Takes the states of the direct light. */
    private final class Sink implements CheckpointSink {
        private final CheckpointSink whole = context.checkpoints();

        @Override
        public double intervalSeconds() {
            return whole.intervalSeconds();
        }

        @Override
        public boolean takesStates() {
            return whole.takesStates();
        }

        @Override
        public void save(RenderState direct) {
            state = direct;
            if (!direct.complete()) {
                whole.save(ofWhole(direct, false));
            }
        }
    }
}
