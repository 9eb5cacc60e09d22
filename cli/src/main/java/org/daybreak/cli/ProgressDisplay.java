package org.daybreak.cli;

import java.util.List;
import org.daybreak.core.render.Progress;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderReport;

/** Shows the user how far a render is. */
abstract class ProgressDisplay implements RenderListener {
    /** The display of a mode. */
    static ProgressDisplay of(ProgressMode mode, Session session) {
        return switch (mode) {
            case AUTO -> session.isTerminal() ? new LineProgress(session.err()) : new PlainProgress(session.err());
            case PLAIN -> new PlainProgress(session.err());
            case JSON -> new JsonProgress(session.err());
            case NONE -> new NoProgress();
        };
    }

    @Override
    public abstract void progress(Progress progress);

    /** The render has ended: other messages may follow. */
    void close() {}

    /**
     * Sums the render up.
     *
     * @param seconds wall-clock seconds of rendering
     * @param written the files that were written
     */
    abstract void finished(RenderReport report, double seconds, List<OutputFile> written);

    /** Shows nothing. */
    private static final class NoProgress extends ProgressDisplay {
        @Override
        public void progress(Progress progress) {
            // This display is silent.
        }

        @Override
        void finished(RenderReport report, double seconds, List<OutputFile> written) {
            // This display is silent.
        }
    }
}
