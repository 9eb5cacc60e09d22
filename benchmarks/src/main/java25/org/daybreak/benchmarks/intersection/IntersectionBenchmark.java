package org.daybreak.benchmarks.intersection;

import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.Intersectors;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Ray;

/**
 * Compares an intersector with Embree on the same meshes and rays, in one process, taking turns; thread CPU time. Prints
 * one line of comma-separated values for each scene and kind of ray: rays per second of both in millions, the median over
 * the rounds of their ratio, and the number of rays on which they differ.
 *
 * <p>Arguments: id of the intersector, names of scenes ({@code cornell}, or a number of triangles), both optional.
 */
public final class IntersectionBenchmark {
    private static final int RAYS = 1 << 18;
    private static final int WARM_UP_ROUNDS = 4;
    private static final int ROUNDS = 9;

    private final PrintStream out;

    private IntersectionBenchmark(PrintStream out) {
        this.out = out;
    }

    /** Runs the comparison. */
    public static void main(String[] arguments) {
        IntersectorProvider provider = arguments.length > 0
                ? Intersectors.select(arguments[0])
                : Intersectors.select().provider();
        List<String> scenes = arguments.length > 1
                ? Arrays.asList(arguments).subList(1, arguments.length)
                : List.of("cornell", "50000", "1000000");
        IntersectionBenchmark benchmark = new IntersectionBenchmark(System.out);
        for (String scene : scenes) {
            benchmark.run(provider, scene(scene));
        }
    }

    static void awaitFullSpeed(IntersectorProvider provider) {
        try {
            if (!provider.awaitFullSpeed(120_000)) {
                throw new IllegalStateException(provider.id() + " does not reach full speed here");
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException("interrupted", e);
        }
    }

    static BenchmarkScene scene(String name) {
        return name.equals("cornell") ? BenchmarkScene.cornell() : BenchmarkScene.room(name, Integer.parseInt(name));
    }

    private void run(IntersectorProvider provider, BenchmarkScene scene) {
        PrimitiveSet set = scene.primitives();
        Intersector intersector = provider.build(set, 2);
        awaitFullSpeed(provider);
        RaySet[] kinds = RaySet.trace(set, intersector, RAYS);
        try (Embree embree = new Embree(set, 2)) {
            embree.build();
            for (RaySet rays : kinds) {
                compare(provider, scene, intersector, embree, rays);
            }
        }
    }

    private void compare(
            IntersectorProvider provider, BenchmarkScene scene, Intersector intersector, Embree embree, RaySet rays) {
        double[] ratios = new double[ROUNDS];
        double[] ours = new double[ROUNDS];
        double[] theirs = new double[ROUNDS];
        int differences = countDifferences(intersector, embree, rays);
        for (int round = -WARM_UP_ROUNDS; round < ROUNDS; round++) {
            long start = cpuTime();
            query(intersector, rays);
            long middle = cpuTime();
            query(embree, rays);
            long end = cpuTime();
            if (round >= 0) {
                ours[round] = 1e3 * rays.count / (middle - start);
                theirs[round] = 1e3 * rays.count / (end - middle);
                ratios[round] = (double) (end - middle) / (middle - start);
            }
        }
        out.printf(
                Locale.ROOT,
                "%s,%s,%d,%s,%.3f,%.3f,%.3f,%d%n",
                provider.id(),
                scene.name,
                scene.triangleCount(),
                rays.kind,
                median(ours),
                median(theirs),
                median(ratios),
                differences);
    }

    private static int countDifferences(Intersector intersector, Embree embree, RaySet rays) {
        Ray ray = new Ray();
        int differences = 0;
        for (int i = 0; i < rays.count; i++) {
            rays.load(i, ray);
            int at = RaySet.STRIDE * i;
            if (rays.anyHit) {
                if (intersector.occluded(ray) != embree.occluded(rays.data, at)) {
                    differences++;
                }
                continue;
            }
            boolean hit = intersector.intersect(ray);
            int primitive = embree.intersect(rays.data, at);
            boolean same = hit == (primitive >= 0)
                    && (!hit
                            || ray.primitive == primitive
                            || Math.abs(ray.t - embree.parameter()) <= 1e-4 * Math.abs(ray.t));
            if (!same) {
                differences++;
            }
        }
        return differences;
    }

    static long query(Intersector intersector, RaySet rays) {
        Ray ray = new Ray();
        long sum = 0;
        if (rays.anyHit) {
            for (int i = 0; i < rays.count; i++) {
                rays.load(i, ray);
                sum += intersector.occluded(ray) ? 1 : 0;
            }
        } else {
            for (int i = 0; i < rays.count; i++) {
                rays.load(i, ray);
                sum += intersector.intersect(ray) ? ray.primitive : -1;
            }
        }
        return sum;
    }

    private static long query(Embree embree, RaySet rays) {
        long sum = 0;
        float[] data = rays.data;
        if (rays.anyHit) {
            for (int i = 0; i < rays.count; i++) {
                sum += embree.occluded(data, RaySet.STRIDE * i) ? 1 : 0;
            }
        } else {
            for (int i = 0; i < rays.count; i++) {
                sum += embree.intersect(data, RaySet.STRIDE * i);
            }
        }
        return sum;
    }

    static long cpuTime() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
