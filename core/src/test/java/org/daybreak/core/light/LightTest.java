package org.daybreak.core.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.List;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.DirectionChart;
import org.daybreak.core.geometry.SurfaceCase;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What holds for every light. */
class LightTest {
    /** False-alarm rate of each kind of test here, over all its cases. */
    private static final double SIGNIFICANCE = 1e-4;

    static List<LightCases.Case> cases() {
        return LightCases.all();
    }

    static List<LightCases.Case> infinite() {
        return LightCases.infinite();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void incidentSamplesAreConsistent(LightCases.Case c) {
        Light light = c.light();
        LightSample sample = new LightSample();
        Spectrum radiance = new Spectrum();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        for (double[] p : SurfaceCase.views()) {
            for (int i = 0; i < 500; i++) {
                if (!light.sampleIncident(p[0], p[1], p[2], random.nextDouble(), random.nextDouble(), sample)) {
                    continue;
                }
                assertEquals(1, norm(sample.wiX, sample.wiY, sample.wiZ), 1e-12);
                assertEquals(light.isDelta(), sample.delta);
                assertEquals(light.isInfinite(), sample.distance == Double.POSITIVE_INFINITY);
                assertTrue(sample.weight.isFinite() && sample.weight.max() > 0);
                if (light.isInfinite()) {
                    assertEquals(-1, sample.point.geometricCosine(sample.wiX, sample.wiY, sample.wiZ), 1e-12);
                } else {
                    assertEquals(p[0] + sample.distance * sample.wiX, sample.point.x, 1e-12);
                    assertEquals(p[1] + sample.distance * sample.wiY, sample.point.y, 1e-12);
                    assertEquals(p[2] + sample.distance * sample.wiZ, sample.point.z, 1e-12);
                    assertTrue(sample.point.geometricCosine(sample.wiX, sample.wiY, sample.wiZ) < 0);
                }
                light.radiance(sample.point, -sample.wiX, -sample.wiY, -sample.wiZ, radiance);
                double density =
                        light.incidentDensity(p[0], p[1], p[2], sample.point, sample.wiX, sample.wiY, sample.wiZ);
                if (light.isDelta()) {
                    assertEquals(1, sample.density);
                    assertEquals(0, density);
                    assertTrue(radiance.isBlack());
                    continue;
                }
                // At grazing angles the rounding of the cosine counts.
                if (sample.point.geometricCosine(sample.wiX, sample.wiY, sample.wiZ) < -1e-5) {
                    assertEquals(sample.density, density, 1e-7 * density);
                }
                assertEquals(radiance.r, sample.weight.r * sample.density, 1e-9 * radiance.r);
                assertEquals(radiance.g, sample.weight.g * sample.density, 1e-9 * radiance.g);
                assertEquals(radiance.b, sample.weight.b * sample.density, 1e-9 * radiance.b);
                if (!light.isInfinite()) {
                    light.radiance(sample.point, sample.wiX, sample.wiY, sample.wiZ, radiance);
                    assertTrue(radiance.isBlack(), "the back is dark");
                    assertEquals(7, sample.point.shape);
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("cases")
    void emissionSamplesAreConsistent(LightCases.Case c) {
        Light light = c.light();
        EmissionSample sample = new EmissionSample();
        EmissionDensity density = new EmissionDensity();
        Spectrum radiance = new Spectrum();
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        int emitted = 0;
        for (int i = 0; i < 2000; i++) {
            if (!sampleEmission(light, random, sample)) {
                continue;
            }
            emitted++;
            assertEquals(1, norm(sample.dx, sample.dy, sample.dz), 1e-12);
            assertEquals(light.isDelta() && !light.isInfinite(), sample.deltaPosition);
            assertEquals(light.isDelta() && light.isInfinite(), sample.deltaDirection);
            light.emissionDensity(sample.point, sample.dx, sample.dy, sample.dz, density);
            assertEquals(sample.densityPosition, density.position, 1e-7 * density.position);
            assertEquals(sample.densityDirection, density.direction, 1e-6 * density.direction);
            light.radiance(sample.point, sample.dx, sample.dy, sample.dz, radiance);
            if (light.isDelta()) {
                assertEquals(1, sample.deltaPosition ? sample.densityPosition : sample.densityDirection);
                assertTrue(radiance.isBlack());
                continue;
            }
            double cosine = sample.point.geometricCosine(sample.dx, sample.dy, sample.dz);
            assertTrue(cosine > 0);
            double densities = sample.densityPosition * sample.densityDirection;
            assertEquals(radiance.g * cosine, sample.weight.g * densities, 1e-6 * radiance.g * cosine);
            assertEquals(radiance.b * cosine, sample.weight.b * densities, 1e-6 * radiance.b * cosine);
        }
        assertTrue(emitted > 200, "emitted " + emitted);
    }

    @ParameterizedTest
    @MethodSource("cases")
    void powerIsTheMeanWeightOfEmission(LightCases.Case c) {
        EmissionSample sample = new EmissionSample();
        RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
        Moments power = new Moments();
        for (int i = 0; i < 20_000; i++) {
            power.add(sampleEmission(c.light(), random, sample) ? sample.weight.luminance() : 0);
        }
        double expected = c.light().power();
        // Quadrature in the constructors; of equal weights the rounding is all there is.
        if (Math.abs(power.mean() - expected) > 1e-4 * expected) {
            ZTest.assertNotRejected(
                    c.name(), ZTest.oneSample(power, expected), Significance.sidak(SIGNIFICANCE, cases().size()));
        }
    }

    @ParameterizedTest
    @MethodSource("infinite")
    void distantLightArrivesWithItsDensity(LightCases.Case c) {
        LightSample sample = new LightSample();
        ChiSquareTest.ofDirections(
                        c.name(),
                        (u, v, w, d) -> {
                            if (!c.light().sampleIncident(1, 2, 3, u, v, sample)) {
                                return false;
                            }
                            d[0] = sample.wiX;
                            d[1] = sample.wiY;
                            d[2] = sample.wiZ;
                            return true;
                        },
                        (x, y, z) -> c.light().incidentDensity(1, 2, 3, sample.point, x, y, z))
                .cells(41, 21)
                .samples(100_000)
                // Deep, for the density has a pole at the zenith.
                .depth(2, 13)
                .assertAgrees(Significance.sidak(SIGNIFICANCE, infinite().size()));
    }

    /** The rays that pass through the scene do so evenly in every direction, and start outside of it. */
    @ParameterizedTest
    @MethodSource("infinite")
    void distantLightCoversTheScene(LightCases.Case c) {
        EmissionSample sample = new EmissionSample();
        double radius = 2.5;
        double[] centre = {0.5, -0.5, 1};
        ChiSquareTest.ofDirections(
                        c.name(),
                        (u, v, w, d) -> {
                            // A uniform disk across the ray is a uniform distribution of where it enters the sphere,
                            // seen
                            // along the ray: (2r², azimuth) go over into z and φ of a uniform direction.
                            if (!c.light().sampleEmission(u, v, w, 0.37, sample)) {
                                return false;
                            }
                            double x = sample.point.x - centre[0];
                            double y = sample.point.y - centre[1];
                            double z = sample.point.z - centre[2];
                            double along = x * sample.dx + y * sample.dy + z * sample.dz;
                            assertEquals(-radius, along, 1e-9);
                            DirectionChart chart = new DirectionChart(sample.dx, sample.dy, sample.dz);
                            double squared = (x * x + y * y + z * z - along * along) / (radius * radius);
                            double[] lateral = new double[2];
                            double norm = Math.sqrt(x * x + y * y + z * z);
                            chart.toChart(x / norm, y / norm, z / norm, lateral);
                            double azimuth = Math.atan2(lateral[1], lateral[0]);
                            double height = 1 - 2 * squared;
                            double sine = Math.sqrt(Math.max(0, 1 - height * height));
                            d[0] = sine * Math.cos(azimuth);
                            d[1] = sine * Math.sin(azimuth);
                            d[2] = height;
                            return true;
                        },
                        (x, y, z) -> 1 / (4 * Math.PI))
                .cells(21, 11)
                .samples(20_000)
                .assertAgrees(Significance.sidak(SIGNIFICANCE, infinite().size()));
    }

    /** Emission of a surface: points by area as in the sampler's own test, directions by their cosine to the normal. */
    @Test
    void surfacesEmitByTheCosine() {
        EmissionSample sample = new EmissionSample();
        EmissionDensity density = new EmissionDensity();
        SurfaceCase[] surfaces = {SurfaceCase.all().get(1), SurfaceCase.all().get(6)};
        for (SurfaceCase surface : surfaces) {
            Light light = new AreaLight(surface.sampler(), new TestTexture(1, 1, 1, false), 0);
            light.sampleEmission(0.3, 0.6, 0.5, 0.5, sample);
            SurfacePoint origin = new SurfacePoint();
            origin.set(sample.point);
            ChiSquareTest.ofDirections(
                            surface.name(),
                            (u, v, w, d) -> {
                                light.sampleEmission(0.3, 0.6, u, v, sample);
                                d[0] = sample.dx;
                                d[1] = sample.dy;
                                d[2] = sample.dz;
                                return true;
                            },
                            (x, y, z) -> {
                                light.emissionDensity(origin, x, y, z, density);
                                return density.direction;
                            })
                    .assertAgrees(Significance.sidak(SIGNIFICANCE, surfaces.length));
        }
    }

    @Test
    void spotsEmitWithinTheirCone() {
        EmissionSample sample = new EmissionSample();
        EmissionDensity density = new EmissionDensity();
        for (LightCases.Case c : LightCases.points()) {
            ChiSquareTest.ofDirections(
                            c.name(),
                            (u, v, w, d) -> {
                                if (!c.light().sampleEmission(0.5, 0.5, u, v, sample)) {
                                    return false;
                                }
                                d[0] = sample.dx;
                                d[1] = sample.dy;
                                d[2] = sample.dz;
                                return true;
                            },
                            (x, y, z) -> {
                                c.light().emissionDensity(sample.point, x, y, z, density);
                                return density.direction;
                            })
                    .cells(31, 15)
                    .samples(50_000)
                    .depth(3, 7)
                    .assertAgrees(
                            Significance.sidak(SIGNIFICANCE, LightCases.points().size()));
        }
    }

    /** Importance decides which lights are looked at: it must be positive wherever one of their samples arrives. */
    @ParameterizedTest
    @MethodSource("cases")
    void importanceIsPositiveWhereLightArrives(LightCases.Case c) {
        LightSample sample = new LightSample();
        RandomStream random = new RandomStream(4, StreamDomain.SELF_CHECK, 0, 0);
        int arrived = 0;
        for (int i = 0; i < 20_000; i++) {
            double spread = Math.pow(10, 3 * random.nextDouble() - 1);
            double px = spread * (2 * random.nextDouble() - 1);
            double py = spread * (2 * random.nextDouble() - 1);
            double pz = spread * (2 * random.nextDouble() - 1);
            double z = 2 * random.nextDouble() - 1;
            double phi = 2 * Math.PI * random.nextDouble();
            double nx = Math.sqrt(1 - z * z) * Math.cos(phi);
            double ny = Math.sqrt(1 - z * z) * Math.sin(phi);
            boolean arrives = c.light().sampleIncident(px, py, pz, random.nextDouble(), random.nextDouble(), sample);
            if (arrives) {
                assertTrue(c.light().importance(px, py, pz, 0, 0, 0) > 0);
                if (sample.wiX * nx + sample.wiY * ny + sample.wiZ * z > 0) {
                    arrived++;
                    assertTrue(c.light().importance(px, py, pz, nx, ny, z) > 0);
                }
            }
            assertTrue(Double.isFinite(c.light().importance(px, py, pz, nx, ny, z)));
            assertTrue(c.light().importance(px, py, pz, nx, ny, z) >= 0);
        }
        assertTrue(arrived > 100, "arrived " + arrived);
    }

    @Test
    void samplingAllocatesNothing() {
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        LightSample incident = new LightSample();
        EmissionSample emission = new EmissionSample();
        EmissionDensity density = new EmissionDensity();
        Spectrum radiance = new Spectrum();
        LightChoice choice = new LightChoice();
        List<LightCases.Case> cases = cases();
        LightSelection selection = LightSelections.forLights(
                cases.stream().limit(30).map(LightCases.Case::light).toList());
        LightSelection tree = new LightTreeSelection(
                cases.stream().map(LightCases.Case::light).toList());
        RandomStream random = new RandomStream(5, StreamDomain.SELF_CHECK, 0, 0);
        long before = 0;
        int rounds = 200;
        for (int round = 0; round < 2 * rounds; round++) {
            if (round == rounds) {
                before = threads.getCurrentThreadAllocatedBytes();
            }
            for (int k = 0; k < cases.size(); k++) {
                Light light = cases.get(k).light();
                double px = 3 * random.nextDouble();
                if (light.sampleIncident(px, 0.5, -1, random.nextDouble(), random.nextDouble(), incident)) {
                    light.incidentDensity(px, 0.5, -1, incident.point, incident.wiX, incident.wiY, incident.wiZ);
                }
                if (sampleEmission(light, random, emission)) {
                    light.emissionDensity(emission.point, emission.dx, emission.dy, emission.dz, density);
                    light.radiance(emission.point, emission.dx, emission.dy, emission.dz, radiance);
                }
                if (selection.choose(px, 0.5, -1, 0, 1, 0, random.nextDouble(), choice)) {
                    selection.probability(choice.light, px, 0.5, -1, 0, 1, 0);
                }
                if (tree.choose(px, 0.5, -1, 0, 1, 0, random.nextDouble(), choice)) {
                    tree.probability(choice.light, px, 0.5, -1, 0, 1, 0);
                }
                selection.emissionProbability(selection.chooseForEmission(random.nextDouble()));
            }
        }
        long bytes = threads.getCurrentThreadAllocatedBytes() - before;
        // The measurement itself, and what the compiler threads charge to this one, is some hundred bytes at most.
        assertTrue(bytes < 2000, bytes + " bytes in " + rounds * cases.size() + " rounds");
    }

    private static boolean sampleEmission(Light light, RandomStream random, EmissionSample sample) {
        return light.sampleEmission(
                random.nextDouble(), random.nextDouble(), random.nextDouble(), random.nextDouble(), sample);
    }

    private static double norm(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
