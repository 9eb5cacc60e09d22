package org.daybreak.cli;

import java.util.List;
import java.util.Locale;
import org.daybreak.core.render.Progress;
import org.daybreak.core.render.RenderReport;

/** Progress in words. */
final class ProgressText {
    private static final double SECONDS_PER_MINUTE = 60;
    private static final double SECONDS_PER_HOUR = 3600;

    private ProgressText() {}

    /** Percent, rate, time left and error estimate. */
    static String of(Progress progress) {
        StringBuilder text = new StringBuilder(String.format(
                Locale.ROOT,
                "%5.1f %%  %s samples/s  ",
                100 * progress.fraction(),
                quantity(progress.samplesPerSecond())));
        text.append(
                Double.isFinite(progress.secondsLeft())
                        ? duration(progress.secondsLeft()) + " left"
                        : duration(progress.secondsElapsed()) + " so far");
        if (Double.isFinite(progress.relativeError())) {
            text.append(String.format(Locale.ROOT, "  error %.2f %%", 100 * progress.relativeError()));
        }
        return text.toString();
    }

    /** What was done, and the files written. */
    static String of(RenderReport report, double seconds, List<OutputFile> written) {
        long rays = 0;
        for (long count : report.raysByKind().values()) {
            rays += count;
        }
        StringBuilder text = new StringBuilder(String.format(
                Locale.ROOT,
                "%s in %s: %s samples (%d per pixel), %s samples/s, %s rays/s",
                report.cancelled() ? "interrupted" : "rendered",
                duration(seconds),
                quantity((double) report.samples()),
                report.samplesPerPixel(),
                quantity(report.samples() / seconds),
                quantity(rays / seconds)));
        for (OutputFile output : written) {
            text.append(System.lineSeparator()).append("wrote ").append(output.path());
        }
        return text.toString();
    }

    /** Seconds as {@code 1.23 s}, {@code 4:05 min} or {@code 1:02:03 h}. */
    static String duration(double seconds) {
        if (seconds < SECONDS_PER_MINUTE) {
            return String.format(Locale.ROOT, "%.2f s", seconds);
        }
        long whole = Math.round(seconds);
        long inMinute = whole % 60;
        long minutes = whole / 60;
        return seconds < SECONDS_PER_HOUR
                ? String.format(Locale.ROOT, "%d:%02d min", minutes, inMinute)
                : String.format(Locale.ROOT, "%d:%02d:%02d h", minutes / 60, minutes % 60, inMinute);
    }

    /** A number with three digits or so and k, M or G for the thousands. */
    static String quantity(double value) {
        String[] units = {"", " k", " M", " G", " T"};
        int unit = 0;
        double scaled = value;
        while (scaled >= 1000 && unit < units.length - 1) {
            scaled /= 1000;
            unit++;
        }
        return (scaled >= 100 || scaled == Math.rint(scaled)
                        ? String.format(Locale.ROOT, "%.0f", scaled)
                        : String.format(Locale.ROOT, "%.3g", scaled))
                + units[unit];
    }
}
