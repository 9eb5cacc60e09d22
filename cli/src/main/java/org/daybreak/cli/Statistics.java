package org.daybreak.cli;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.accel.Intersectors;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.scene.Scene;
import org.jspecify.annotations.Nullable;

/** The statistics of a render as {@code --stats} writes them; {@code docs/stats.md} describes each field. */
final class Statistics {
    private static final int BYTES_PER_KIBIBYTE = 1024;

    private final RenderPlan plan;
    private final PhaseTimes times;
    private final Scene scene;
    private final RenderReport report;
    private final double relativeError;
    private final List<String> warnings;
    private final List<OutputFile> written;

    Statistics(
            RenderPlan plan,
            PhaseTimes times,
            Scene scene,
            RenderReport report,
            double relativeError,
            List<String> warnings,
            List<OutputFile> written) {
        this.plan = plan;
        this.times = times;
        this.scene = scene;
        this.report = report;
        this.relativeError = relativeError;
        this.warnings = warnings;
        this.written = written;
    }

    /** The fields in order. */
    Map<String, Object> values() {
        double seconds = times.wall("render");
        long rays =
                report.raysByKind().values().stream().mapToLong(Long::longValue).sum();
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("software", Version.software());
        values.put("java", Version.java());
        values.put("scene", Scenes.name(plan.scene()));
        values.put("renderer", component(report.renderer(), plan.parameterMap()));
        values.put(
                "antialiasing",
                component(
                        plan.antialiasing().id(), plan.antialiasingParameters().asMap()));
        values.put("intersector", intersector());
        values.put("film", film());
        values.put("seed", plan.seed());
        values.put("threads", plan.threads());
        values.put("cancelled", report.cancelled());
        values.put("samples", report.samples());
        values.put("resumedSamples", report.resumedSamples());
        values.put("samplesPerPixel", report.samplesPerPixel());
        values.put("samplesPerSecond", (report.samples() - report.resumedSamples()) / seconds);
        values.put("relativeError", relativeError);
        values.put("seconds", seconds());
        values.put("secondsOfRenderer", report.secondsByPhase());
        values.put("rays", report.raysByKind());
        values.put("raysTotal", rays);
        values.put("megaraysPerSecond", rays / seconds * 1e-6);
        values.put("figures", report.figures());
        values.put("memory", memory());
        values.put("nonFinite", nonFinite());
        values.put("warnings", warnings);
        values.put(
                "outputs",
                written.stream().map(output -> output.path().toString()).toList());
        return values;
    }

    private static Map<String, Object> component(String id, Map<String, Object> parameters) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("id", id);
        values.put("parameters", parameters);
        return values;
    }

    private Map<String, Object> intersector() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("description", scene.intersector().describe());
        values.put("memoryBytes", scene.intersector().memoryBytes());
        values.put("rejected", Intersectors.select().rejected());
        return values;
    }

    private Map<String, Object> film() {
        FilmSettings film = plan.film();
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("width", film.width());
        values.put("height", film.height());
        values.put(
                "crop",
                List.of(
                        film.crop().x(),
                        film.crop().y(),
                        film.crop().width(),
                        film.crop().height()));
        values.put("filter", film.filter().kind().id());
        return values;
    }

    private Map<String, Object> seconds() {
        Map<String, Object> values = new LinkedHashMap<>();
        double wall = 0;
        double cpu = 0;
        for (Map.Entry<String, PhaseTimes.Seconds> phase : times.phases().entrySet()) {
            values.put(
                    phase.getKey(),
                    seconds(phase.getValue().wall(), phase.getValue().cpu()));
            wall += phase.getValue().wall();
            cpu += phase.getValue().cpu();
        }
        values.put("total", seconds(wall, cpu));
        return values;
    }

    private static Map<String, Object> seconds(double wall, double cpu) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("wall", wall);
        values.put("cpu", cpu);
        return values;
    }

    private static Map<String, @Nullable Object> memory() {
        long heap = 0;
        for (MemoryPoolMXBean pool : ManagementFactory.getMemoryPoolMXBeans()) {
            if (pool.getType() == MemoryType.HEAP) {
                heap += pool.getPeakUsage().getUsed();
            }
        }
        Map<String, @Nullable Object> values = new LinkedHashMap<>();
        values.put("peakHeapBytes", heap);
        values.put("peakResidentBytes", peakResidentBytes());
        return values;
    }

    /** The process's largest resident set, null where the system has no /proc. */
    private static @Nullable Long peakResidentBytes() {
        try {
            for (String line : Files.readAllLines(Path.of("/proc/self/status"))) {
                if (line.startsWith("VmHWM:")) {
                    return Long.parseLong(line.replaceAll("[^0-9]", "")) * BYTES_PER_KIBIBYTE;
                }
            }
        } catch (IOException e) {
            return null;
        }
        return null;
    }

    private Map<String, Object> nonFinite() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("count", report.nonFiniteSamples());
        values.put("addresses", report.nonFiniteAddresses());
        return values;
    }
}
