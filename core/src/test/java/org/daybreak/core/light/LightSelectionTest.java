package org.daybreak.core.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import javax.vecmath.Point3d;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfaceSamplers;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;

class LightSelectionTest {
    /** False-alarm rate of each statistical test. */
    private static final double SIGNIFICANCE = 1e-4;

    private static List<Light> lights() {
        List<Light> lights = new ArrayList<>();
        List<LightCases.Case> all = LightCases.all();
        for (int i = 0; i < all.size(); i += 3) {
            lights.add(all.get(i).light());
        }
        return lights;
    }

    /** Softbox, constant sky and small bright sphere, as in the scene gold_ring. */
    private static List<Light> goldRing() {
        Transform softbox = Transform.ofRows(
                2.933407, -0.2088203, -0.1639173, 1.5, 0, 1.251701, -0.6228857, 6, 0.6285873, 0.9744947, 0.7649474, -7);
        return List.of(
                new AreaLight(
                        SurfaceSamplers.of(new Rectangle(), softbox, false), new TestTexture(2.2, 2.05, 1.8, false), 0),
                new ConstantEnvironment(new Spectrum(0.07, 0.065, 0.06), 0, 0, 0, 20),
                new AreaLight(
                        SurfaceSamplers.of(new Sphere(new Point3d(-4.9, 4.3, 3.4), 0.13), Transform.identity(), false),
                        new TestTexture(3050, 2560, 1860, false),
                        1));
    }

    @Test
    void probabilitiesSumToOneAndAreTheFrequencies() {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        List<Light> lights = lights();
        LightSelection[] selections = {
            new ImportanceLightSelection(lights), new PowerLightSelection(lights), new LightTreeSelection(lights)
        };
        LightChoice choice = new LightChoice();
        int points = 10;
        for (LightSelection selection : selections) {
            for (int k = 0; k < points; k++) {
                double[] p = {4 * random.nextDouble() - 2, 4 * random.nextDouble() - 2, 4 * random.nextDouble() - 2};
                double ny = k % 3 == 0 ? 0 : 1;
                int samples = 20_000;
                // One more for failure, as when all of a leaf that seemed possible is behind the horizon.
                long[] counts = new long[lights.size() + 1];
                double[] expected = new double[lights.size() + 1];
                double sum = 0;
                for (int i = 0; i < lights.size(); i++) {
                    double probability = selection.probability(i, p[0], p[1], p[2], 0, ny, 0);
                    sum += probability;
                    expected[i] = samples * probability;
                }
                if (selection instanceof LightTreeSelection) {
                    assertTrue(sum <= 1 + 1e-12 && sum > 0.5);
                    expected[lights.size()] = samples * Math.max(0, 1 - sum);
                } else {
                    assertEquals(1, sum, 1e-12);
                }
                for (int i = 0; i < samples; i++) {
                    if (selection.choose(p[0], p[1], p[2], 0, ny, 0, random.nextDouble(), choice)) {
                        counts[choice.light]++;
                        double own = selection.probability(choice.light, p[0], p[1], p[2], 0, ny, 0);
                        assertEquals(own, choice.probability, 1e-15);
                        int other = i % lights.size();
                        assertEquals(
                                selection instanceof ImportanceLightSelection && other < 4
                                        ? selection.probability(other, p[0], p[1], p[2], 0, ny, 0)
                                        : -1,
                                choice.probabilityOf(other));
                    } else {
                        counts[lights.size()]++;
                    }
                }
                for (int i = 0; i < counts.length; i++) {
                    assertTrue(expected[i] > 0 || counts[i] == 0, "light " + i);
                }
                ZTest.assertNotRejected(
                        "choice",
                        ChiSquareTest.compare("choice", counts, expected).pValue(),
                        Significance.sidak(SIGNIFICANCE, selections.length * points));
            }
        }
    }

    @Test
    void emissionIsChosenByPower() {
        List<Light> lights = lights();
        double total = lights.stream().mapToDouble(Light::power).sum();
        LightSelection selection = LightSelections.forLights(lights);
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        int samples = 50_000;
        long[] counts = new long[lights.size()];
        double[] expected = new double[lights.size()];
        for (int i = 0; i < expected.length; i++) {
            assertEquals(lights.get(i).power() / total, selection.emissionProbability(i), 1e-12);
            expected[i] = samples * selection.emissionProbability(i);
        }
        for (int i = 0; i < samples; i++) {
            counts[selection.chooseForEmission(random.nextDouble())]++;
        }
        ZTest.assertNotRejected(
                "emission", ChiSquareTest.compare("emission", counts, expected).pValue(), SIGNIFICANCE);
    }

    @Test
    void everyLightThatArrivesCanBeChosen() {
        List<Light> lights = lights();
        LightSelection selection = LightSelections.forLights(lights);
        RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
        LightSample sample = new LightSample();
        int arrived = 0;
        for (int k = 0; k < 5000; k++) {
            double scale = Math.pow(10, 4 * random.nextDouble() - 2);
            double px = scale * (2 * random.nextDouble() - 1);
            double py = scale * (2 * random.nextDouble() - 1);
            double pz = scale * (2 * random.nextDouble() - 1);
            double z = 2 * random.nextDouble() - 1;
            double phi = 2 * Math.PI * random.nextDouble();
            double nx = Math.sqrt(1 - z * z) * Math.cos(phi);
            double ny = Math.sqrt(1 - z * z) * Math.sin(phi);
            int i = random.nextInt(lights.size());
            if (lights.get(i).sampleIncident(px, py, pz, random.nextDouble(), random.nextDouble(), sample)) {
                assertTrue(selection.probability(i, px, py, pz, 0, 0, 0) > 0);
                if (sample.wiX * nx + sample.wiY * ny + sample.wiZ * z > 0) {
                    arrived++;
                    assertTrue(selection.probability(i, px, py, pz, nx, ny, z) > 0);
                }
            }
        }
        assertTrue(arrived > 500, "arrived " + arrived);
    }

    /** On the floor of gold_ring the shares must be those of the true irradiances, nearly. */
    @Test
    void sharesAreThoseOfTheIrradiance() {
        List<Light> lights = goldRing();
        LightSelection selection = LightSelections.forLights(lights);
        RandomStream random = new RandomStream(4, StreamDomain.SELF_CHECK, 0, 0);
        LightSample sample = new LightSample();
        for (double[] p : new double[][] {{0, 0, 0}, {3, 0, -3}, {-4, 0, 3}, {1, 0, 4}, {-3, 0, -2}}) {
            double[] irradiance = new double[3];
            double total = 0;
            for (int i = 0; i < 3; i++) {
                for (int k = 0; k < 4000; k++) {
                    if (lights.get(i).sampleIncident(p[0], 0, p[2], random.nextDouble(), random.nextDouble(), sample)) {
                        irradiance[i] += sample.weight.luminance() * Math.max(0, sample.wiY) / 4000;
                    }
                }
                total += irradiance[i];
            }
            for (int i = 0; i < 3; i++) {
                double ideal = 0.95 * irradiance[i] / total + 0.05 / 3;
                assertEquals(1, selection.probability(i, p[0], 0, p[2], 0, 1, 0) / ideal, 0.15, "light " + i);
            }
        }
    }

    @Test
    void nothingIsChosenFromNothing() {
        LightSelection none = LightSelections.forLights(List.of());
        LightChoice choice = new LightChoice();
        assertFalse(none.choose(0, 0, 0, 0, 0, 1, 0.5, choice));
        assertFalse(new PowerLightSelection(List.of()).choose(0, 0, 0, 0, 0, 1, 0.5, choice));
        assertEquals(-1, none.chooseForEmission(0.5));
        // Lights behind the horizon cannot reach the point.
        LightSelection two = LightSelections.forLights(List.of(
                new PointLight(0, 0, -1, new Spectrum(1, 1, 1)), new PointLight(1, 0, -1, new Spectrum(1, 1, 1))));
        assertFalse(two.choose(0, 0, 0, 0, 0, 1, 0.5, choice));
        assertEquals(0, two.probability(0, 0, 0, 0, 0, 0, 1));
        assertTrue(two.choose(0, 0, 0, 0, 0, -1, 0.999, choice));
        assertEquals(1, choice.light);
        assertEquals(1, two.probability(0, 0, 0, 0, 0, 0, -1) + two.probability(1, 0, 0, 0, 0, 0, -1), 1e-15);
    }

    @Test
    void aSingleLightIsAlwaysChosen() {
        LightSelection one = LightSelections.forLights(List.of(new PointLight(0, 0, -1, new Spectrum(1, 1, 1))));
        LightChoice choice = new LightChoice();
        assertTrue(one.choose(0, 0, 0, 0, 0, 1, 0.5, choice));
        assertEquals(0, choice.light);
        assertEquals(1, choice.probability);
        assertEquals(1, one.probability(0, 0, 0, 0, 0, 0, 1));
    }

    @Test
    void manyLightsAreChosenByATree() {
        Light light = new PointLight(0, 0, -1, new Spectrum(1, 1, 1));
        assertInstanceOf(ImportanceLightSelection.class, LightSelections.forLights(Collections.nCopies(32, light)));
        LightSelection many = LightSelections.forLights(Collections.nCopies(40, light));
        assertInstanceOf(LightTreeSelection.class, many);
        double sum = 0;
        for (int i = 0; i < 40; i++) {
            sum += many.probability(i, 1, 2, 3, 0, 0, 0);
        }
        assertEquals(1, sum, 1e-12);
    }

    /** Lamps of all kinds in a hall: of each point, the tree chooses the ones that matter. */
    @Test
    void treesFollowTheContribution() {
        RandomStream random = new RandomStream(5, StreamDomain.SELF_CHECK, 0, 0);
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < 3000; i++) {
            double x = 100 * random.nextDouble();
            double z = 100 * random.nextDouble();
            double bright = Math.exp(2 * random.nextDouble());
            Transform down = Transform.translate(x, 5, z)
                    .multiply(Transform.rotate(1, 0, 0, 90 + 20 * random.nextDouble()))
                    .multiply(Transform.scale(0.2, 0.1, 0.3));
            lights.add(
                    switch (i % 3) {
                        case 0 -> new PointLight(x, 4, z, new Spectrum(bright, bright, bright));
                        case 1 -> new SpotLight(down, new Spectrum(bright, bright, bright), 35, 20);
                        default ->
                            new AreaLight(
                                    SurfaceSamplers.of(new Rectangle(), down, false),
                                    new TestTexture(40 * bright, 40 * bright, 40 * bright, false),
                                    i);
                    });
        }
        lights.add(new ConstantEnvironment(new Spectrum(0.01, 0.01, 0.01), 50, 0, 50, 80));
        lights.add(new DirectionalLight(1, -1, 0, new Spectrum(0.02, 0.02, 0.02), 50, 0, 50, 80));
        LightSelection tree = new LightTreeSelection(lights);
        LightSelection power = new PowerLightSelection(lights);
        LightChoice choice = new LightChoice();
        double treeSpread = 0;
        double powerSpread = 0;
        int points = 20;
        for (int k = 0; k < points; k++) {
            double px = 100 * random.nextDouble();
            double pz = 100 * random.nextDouble();
            double truth = 0;
            for (int i = 0; i < lights.size(); i++) {
                double importance = lights.get(i).importance(px, 0, pz, 0, 1, 0);
                truth += importance;
                assertTrue(!(importance > 0) || tree.probability(i, px, 0, pz, 0, 1, 0) > 0);
            }
            Moments byTree = irradiance(tree, lights, px, pz, 20_000, random, choice);
            Moments byPower = irradiance(power, lights, px, pz, 20_000, random, choice);
            ZTest.assertNotRejected("tree", ZTest.oneSample(byTree, truth), Significance.sidak(SIGNIFICANCE, points));
            treeSpread += byTree.variance() / (truth * truth);
            powerSpread += byPower.variance() / (truth * truth);
        }
        assertTrue(treeSpread < 0.05 * powerSpread, treeSpread + " against " + powerSpread);
        assertTrue(treeSpread < 3 * points, "relative variance " + treeSpread / points);
    }

    private static Moments irradiance(
            LightSelection selection,
            List<Light> lights,
            double px,
            double pz,
            int samples,
            RandomStream random,
            LightChoice choice) {
        Moments moments = new Moments();
        for (int i = 0; i < samples; i++) {
            boolean chosen = selection.choose(px, 0, pz, 0, 1, 0, random.nextDouble(), choice);
            moments.add(chosen ? lights.get(choice.light).importance(px, 0, pz, 0, 1, 0) / choice.probability : 0);
        }
        return moments;
    }
}
