package org.daybreak.cli;

import java.io.PrintStream;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.render.Progress;
import org.daybreak.core.render.RenderReport;

/** A JSON object per line, for programs; {@code docs/cli.md} describes the fields. */
final class JsonProgress extends ProgressDisplay {
    private final PrintStream err;

    JsonProgress(PrintStream err) {
        this.err = err;
    }

    @Override
    public void progress(Progress progress) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("event", "progress");
        values.put("fraction", progress.fraction());
        values.put("samples", progress.samples());
        values.put("samplesPerSecond", progress.samplesPerSecond());
        values.put("secondsElapsed", progress.secondsElapsed());
        values.put("secondsLeft", progress.secondsLeft());
        values.put("relativeError", progress.relativeError());
        print(values);
    }

    @Override
    void finished(RenderReport report, double seconds, List<OutputFile> written) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("event", "finished");
        values.put("cancelled", report.cancelled());
        values.put("samples", report.samples());
        values.put("samplesPerPixel", report.samplesPerPixel());
        values.put("seconds", seconds);
        values.put(
                "outputs",
                written.stream().map(output -> output.path().toString()).toList());
        print(values);
    }

    private void print(Map<String, Object> values) {
        err.println(JsonText.line(values));
        err.flush();
    }
}
