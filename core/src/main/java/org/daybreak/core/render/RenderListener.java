package org.daybreak.core.render;

import java.util.function.Consumer;
import org.daybreak.core.film.Film;

/** Hears of a render's progress. Called from one thread at a time, never concurrently; should return quickly. */
public interface RenderListener {
    /** A listener that ignores everything. */
    RenderListener NONE = new RenderListener() {};

    /** A listener that hears of progress only. */
    static RenderListener ofProgress(Consumer<Progress> consumer) {
        return new RenderListener() {
            @Override
            public void progress(Progress progress) {
                consumer.accept(progress);
            }
        };
    }

    /** Called several times a second at most. */
    default void progress(Progress progress) {}

    /** Called when a pass is complete and the film is consistent; {@code film.develop()} may be called here. */
    default void passFinished(Film film) {}
}
