package org.daybreak.cli;

import java.io.PrintStream;
import java.util.List;
import org.daybreak.core.render.Progress;
import org.daybreak.core.render.RenderReport;

/** One line on a terminal that is written over and over. */
final class LineProgress extends ProgressDisplay {
    private final PrintStream err;
    private int shown;

    LineProgress(PrintStream err) {
        this.err = err;
    }

    @Override
    public void progress(Progress progress) {
        show(ProgressText.of(progress));
    }

    @Override
    void close() {
        if (shown > 0) {
            show("");
            err.print('\r');
            err.flush();
            shown = 0;
        }
    }

    @Override
    void finished(RenderReport report, double seconds, List<OutputFile> written) {
        err.println(ProgressText.of(report, seconds, written));
        err.flush();
    }

    /** Blanks take out what is left of a longer line before: not every terminal knows how to erase. */
    private void show(String text) {
        err.print('\r' + text + " ".repeat(Math.max(0, shown - text.length())));
        err.flush();
        shown = text.length();
    }
}
