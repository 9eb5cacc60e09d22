package org.daybreak.benchmarks.intersection;

import java.io.PrintStream;
import java.util.Locale;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.Intersectors;
import org.daybreak.core.accel.PrimitiveSet;

/**
 * Time per ray against the number of triangles, for the scene of {@link BenchmarkScene#room}. Prints comma-separated
 * values with a heading: triangles, milliseconds to build, bytes per triangle, and nanoseconds of CPU time for a primary,
 * a diffuse and a shadow ray.
 *
 * <p>Arguments: id of the intersector, greatest power of ten (7 needs a heap of 6 GB).
 */
public final class ScalingBenchmark {
    private static final int RAYS = 1 << 17;
    private static final int ROUNDS = 7;
    private static final int THREADS = 2;

    private ScalingBenchmark() {}

    /** Runs the measurement. */
    public static void main(String[] arguments) {
        PrintStream out = System.out;
        IntersectorProvider provider = Intersectors.select(arguments[0]);
        int greatest = Integer.parseInt(arguments[1]);
        measure(provider, 1000);
        out.println("triangles,build_ms,bytes_per_triangle,primary_ns,diffuse_ns,shadow_ns");
        for (int power = 3; power <= greatest; power++) {
            out.println(measure(provider, (int) Math.pow(10, power)));
            if (power < greatest) {
                out.println(measure(provider, (int) (Math.pow(10, power) * Math.sqrt(10))));
            }
        }
    }

    private static String measure(IntersectorProvider provider, int triangles) {
        PrimitiveSet set = BenchmarkScene.room("room", triangles).primitives();
        long start = System.nanoTime();
        Intersector intersector = provider.build(set, THREADS);
        double build = 1e-6 * (System.nanoTime() - start);
        IntersectionBenchmark.awaitFullSpeed(provider);
        StringBuilder line = new StringBuilder(String.format(
                Locale.ROOT,
                "%d,%.1f,%.1f",
                set.triangleCount(),
                build,
                (double) intersector.memoryBytes() / set.triangleCount()));
        for (RaySet rays : RaySet.trace(set, intersector, RAYS)) {
            double[] times = new double[ROUNDS];
            for (int round = -3; round < ROUNDS; round++) {
                long before = IntersectionBenchmark.cpuTime();
                IntersectionBenchmark.query(intersector, rays);
                if (round >= 0) {
                    times[round] = (double) (IntersectionBenchmark.cpuTime() - before) / rays.count;
                }
            }
            line.append(String.format(Locale.ROOT, ",%.1f", IntersectionBenchmark.median(times)));
        }
        return line.toString();
    }
}
