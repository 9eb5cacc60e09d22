package org.daybreak.cli;

import java.io.PrintStream;
import java.util.List;
import org.daybreak.core.render.Progress;
import org.daybreak.core.render.RenderReport;

/** A line every few seconds, for log files. */
final class PlainProgress extends ProgressDisplay {
    private static final double SECONDS_BETWEEN = 5;

    private final PrintStream err;
    private double lastLine;

    PlainProgress(PrintStream err) {
        this.err = err;
    }

    @Override
    public void progress(Progress progress) {
        if (progress.secondsElapsed() - lastLine >= SECONDS_BETWEEN) {
            lastLine = progress.secondsElapsed();
            err.println(ProgressText.of(progress));
            err.flush();
        }
    }

    @Override
    void finished(RenderReport report, double seconds, List<OutputFile> written) {
        err.println(ProgressText.of(report, seconds, written));
        err.flush();
    }
}
