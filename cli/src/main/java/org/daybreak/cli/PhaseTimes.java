package org.daybreak.cli;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Wall-clock and processor seconds of the phases of a run. Processor time is that of all threads of the process, the
 * compiler of the virtual machine included, in the resolution of the system (10 ms on Linux).
 */
final class PhaseTimes {
    /**
     * Seconds of a phase.
     *
     * @param wall wall-clock seconds
     * @param cpu processor seconds; NaN where the system does not tell
     */
    record Seconds(double wall, double cpu) {}

    private final Map<String, Seconds> phases = new LinkedHashMap<>();
    private @Nullable String phase;
    private long wallStart;
    private double cpuStart;

    /** Ends the phase under way and begins the next. */
    void begin(String name) {
        end();
        phase = name;
        wallStart = System.nanoTime();
        cpuStart = cpuSeconds();
    }

    /** Ends the phase under way, if there is one. */
    void end() {
        String ended = phase;
        if (ended != null) {
            phases.put(ended, new Seconds((System.nanoTime() - wallStart) * 1e-9, cpuSeconds() - cpuStart));
            phase = null;
        }
    }

    /** The phases that ended, in order. */
    Map<String, Seconds> phases() {
        return phases;
    }

    /** Wall-clock seconds of a phase that ended. */
    double wall(String name) {
        Seconds seconds = phases.get(name);
        return seconds == null ? Double.NaN : seconds.wall();
    }

    private static double cpuSeconds() {
        // Not the management bean, whose classes take longer to load than a small scene to render.
        return ProcessHandle.current()
                .info()
                .totalCpuDuration()
                .map(Duration::toNanos)
                .map(nanos -> nanos * 1e-9)
                .orElse(Double.NaN);
    }
}
