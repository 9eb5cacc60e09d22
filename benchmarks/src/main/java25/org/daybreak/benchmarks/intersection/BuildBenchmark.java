package org.daybreak.benchmarks.intersection;

import com.sun.management.OperatingSystemMXBean;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.Locale;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.Intersectors;
import org.daybreak.core.accel.PrimitiveSet;

/**
 * Compares the time to build an index with Embree's, taking turns. Prints one line of comma-separated values: medians of
 * wall milliseconds and of CPU milliseconds of all threads, ours and Embree's, and the ratios ours / Embree's. The first
 * build, which runs cold, is printed apart.
 *
 * <p>Arguments: id of the intersector, number of triangles, number of threads.
 */
public final class BuildBenchmark {
    private static final int WARM_UP_ROUNDS = 4;
    private static final int ROUNDS = 9;

    private BuildBenchmark() {}

    /** Runs the comparison. */
    public static void main(String[] arguments) {
        PrintStream out = System.out;
        IntersectorProvider provider = Intersectors.select(arguments[0]);
        PrimitiveSet set = IntersectionBenchmark.scene(arguments[1]).primitives();
        int threads = Integer.parseInt(arguments[2]);
        double[][] times = new double[4][ROUNDS];
        double cold = 0;
        try (Embree embree = new Embree(set, threads)) {
            for (int round = -WARM_UP_ROUNDS; round < ROUNDS; round++) {
                System.gc();
                long wall0 = System.nanoTime();
                long cpu0 = cpuTime();
                Intersector intersector = provider.build(set, threads);
                long wall1 = System.nanoTime();
                long cpu1 = cpuTime();
                embree.build();
                long wall2 = System.nanoTime();
                long cpu2 = cpuTime();
                if (intersector.memoryBytes() == 0) {
                    throw new IllegalStateException("nothing was built");
                }
                if (round == -WARM_UP_ROUNDS) {
                    cold = 1e-6 * (wall1 - wall0);
                    IntersectionBenchmark.awaitFullSpeed(provider);
                }
                if (round >= 0) {
                    times[0][round] = 1e-6 * (wall1 - wall0);
                    times[1][round] = 1e-6 * (wall2 - wall1);
                    times[2][round] = 1e-6 * (cpu1 - cpu0);
                    times[3][round] = 1e-6 * (cpu2 - cpu1);
                }
            }
        }
        double wall = IntersectionBenchmark.median(times[0]);
        double embreeWall = IntersectionBenchmark.median(times[1]);
        double cpu = IntersectionBenchmark.median(times[2]);
        double embreeCpu = IntersectionBenchmark.median(times[3]);
        out.printf(
                Locale.ROOT,
                "%s,%d,%d,%.0f,%.0f,%.2f,%.0f,%.0f,%.2f,%.0f%n",
                provider.id(),
                set.triangleCount(),
                threads,
                wall,
                embreeWall,
                wall / embreeWall,
                cpu,
                embreeCpu,
                cpu / embreeCpu,
                cold);
    }

    private static long cpuTime() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime();
    }
}
