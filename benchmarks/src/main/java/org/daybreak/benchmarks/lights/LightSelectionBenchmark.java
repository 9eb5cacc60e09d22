package org.daybreak.benchmarks.lights;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.SurfaceSamplers;
import org.daybreak.core.light.AreaLight;
import org.daybreak.core.light.ImportanceLightSelection;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightChoice;
import org.daybreak.core.light.LightSelection;
import org.daybreak.core.light.LightTreeSelection;
import org.daybreak.core.light.PointLight;
import org.daybreak.core.light.PowerLightSelection;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.math.Transform;

/**
 * A hall with lamps under its ceiling, points and panels in turn, one for each 4 m² of floor. For numbers of lamps and ways to
 * choose among them, prints the time of a choice with its probability, the time of the probability of a given lamp, and the
 * variance of the estimated irradiance by one choice over its square, in the mean over points of the floor. One line of
 * comma-separated values each; median of several rounds on one thread.
 */
public final class LightSelectionBenchmark {
    private static final int POINTS = 1 << 12;
    private static final int ROUNDS = 9;
    private static final double LONGEST_ROUND = 0.15;

    private final PrintStream out;
    private double sink;

    private LightSelectionBenchmark(PrintStream out) {
        this.out = out;
    }

    /** Runs the measurement. */
    public static void main(String[] arguments) {
        LightSelectionBenchmark benchmark = new LightSelectionBenchmark(System.out);
        benchmark.out.println("lamps,selection,choose_ns,probability_ns,relative_variance");
        for (int lamps : new int[] {1, 4, 8, 16, 32, 100, 1000, 10_000}) {
            List<Light> lights = hall(lamps);
            benchmark.measure(lamps, "tree", new LightTreeSelection(lights), lights);
            benchmark.measure(lamps, "power", new PowerLightSelection(lights), lights);
            if (lamps <= 100) {
                benchmark.measure(lamps, "irradiance", new ImportanceLightSelection(lights), lights);
            }
        }
        if (benchmark.sink == 0.5) {
            benchmark.out.println();
        }
    }

    private static List<Light> hall(int lamps) {
        SplittableRandom random = new SplittableRandom(lamps);
        double side = 2 * Math.sqrt(lamps);
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < lamps; i++) {
            double x = side * random.nextDouble();
            double z = side * random.nextDouble();
            double bright = Math.exp(2 * random.nextDouble());
            if (i % 2 == 0) {
                lights.add(new PointLight(x, 3, z, new Spectrum(bright, bright, bright)));
            } else {
                Transform place = Transform.translate(x, 3, z)
                        .multiply(Transform.rotate(1, 0, 0, 90))
                        .multiply(Transform.scale(0.3, 0.3, 1));
                lights.add(new AreaLight(
                        SurfaceSamplers.of(new Rectangle(), place, false), ConstantTexture.grey(10 * bright), i));
            }
        }
        return lights;
    }

    private void measure(int lamps, String name, LightSelection selection, List<Light> lights) {
        SplittableRandom random = new SplittableRandom(99);
        double side = 2 * Math.sqrt(lamps);
        double[] x = random.doubles(POINTS, 0, side).toArray();
        double[] z = random.doubles(POINTS, 0, side).toArray();
        double[] u = random.doubles(POINTS).toArray();
        int[] lamp = random.ints(POINTS, 0, lamps).toArray();
        double[] choose = new double[ROUNDS];
        double[] probability = new double[ROUNDS];
        for (int round = -2; round < ROUNDS; round++) {
            double chooseTime = time(() -> choices(selection, x, z, u));
            double probabilityTime = time(() -> probabilities(selection, x, z, lamp));
            if (round >= 0) {
                choose[round] = chooseTime;
                probability[round] = probabilityTime;
            }
        }
        Arrays.sort(choose);
        Arrays.sort(probability);
        out.println(String.format(
                Locale.ROOT,
                "%d,%s,%.0f,%.0f,%.3g",
                lamps,
                name,
                choose[ROUNDS / 2],
                probability[ROUNDS / 2],
                relativeVariance(selection, lights, x, z)));
    }

    /** Nanoseconds for each of the points. */
    private static double time(Runnable work) {
        long start = System.nanoTime();
        long passes = 0;
        do {
            work.run();
            passes++;
        } while (System.nanoTime() - start < LONGEST_ROUND * 1e9);
        return (double) (System.nanoTime() - start) / (passes * POINTS);
    }

    private void choices(LightSelection selection, double[] x, double[] z, double[] u) {
        LightChoice choice = new LightChoice();
        double sum = 0;
        for (int i = 0; i < POINTS; i++) {
            if (selection.choose(x[i], 0, z[i], 0, 1, 0, u[i], choice)) {
                sum += choice.probability;
            }
        }
        sink += sum;
    }

    private void probabilities(LightSelection selection, double[] x, double[] z, int[] lamp) {
        double sum = 0;
        for (int i = 0; i < POINTS; i++) {
            sum += selection.probability(lamp[i], x[i], 0, z[i], 0, 1, 0);
        }
        sink += sum;
    }

    private static double relativeVariance(LightSelection selection, List<Light> lights, double[] x, double[] z) {
        SplittableRandom random = new SplittableRandom(7);
        LightChoice choice = new LightChoice();
        int points = 32;
        int samples = 4000;
        double sum = 0;
        for (int k = 0; k < points; k++) {
            double truth = 0;
            for (Light light : lights) {
                truth += light.importance(x[k], 0, z[k], 0, 1, 0);
            }
            double squares = 0;
            for (int i = 0; i < samples; i++) {
                boolean chosen = selection.choose(x[k], 0, z[k], 0, 1, 0, random.nextDouble(), choice);
                double estimate =
                        chosen ? lights.get(choice.light).importance(x[k], 0, z[k], 0, 1, 0) / choice.probability : 0;
                squares += (estimate - truth) * (estimate - truth);
            }
            sum += squares / (samples * truth * truth);
        }
        return sum / points;
    }
}
