package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Significance;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Sampled directions follow the reported density (χ²), and delta lobes are chosen with the reported probability. Seeds
 * are fixed; a change of the random numbers raises a false alarm in all of these tests together with probability 1e-4.
 */
class BsdfSamplingTest {
    private static final double FALSE_ALARM = 1e-4;
    private static final int SAMPLES = 40_000;

    @TestFactory
    Stream<DynamicTest> samplesFollowTheDensity() {
        List<DynamicTest> tests = new ArrayList<>();
        int count = BsdfCases.all().size() * BsdfCases.directions().size() * TransportMode.values().length * 2;
        double level = Significance.sidak(FALSE_ALARM, count);
        long seed = 1;
        for (BsdfCases.Case material : BsdfCases.all()) {
            for (BsdfCases.Direction wo : BsdfCases.directions()) {
                for (TransportMode mode : TransportMode.values()) {
                    String name = material.name() + ", " + wo.name() + ", " + mode;
                    long caseSeed = seed++;
                    tests.add(DynamicTest.dynamicTest(
                            name, () -> check(name, material.bsdf(), wo, mode, caseSeed, level)));
                }
            }
        }
        return tests.stream();
    }

    private static void check(
            String name, Bsdf bsdf, BsdfCases.Direction wo, TransportMode mode, long seed, double level) {
        SurfacePoint point = BsdfCases.point();
        checkDeltaLobes(name, bsdf, wo, mode, seed, level);
        if (!hasDensity(bsdf, wo, mode)) {
            assertFalse(drawsContinuously(bsdf, wo, mode, seed), name + ": samples where the density is 0");
            return;
        }
        BsdfSample sample = new BsdfSample();
        ChiSquareTest.ofDirections(
                        name,
                        (u, v, w, direction) -> {
                            if (!bsdf.sample(point, wo.x(), wo.y(), wo.z(), u, v, w, mode, sample) || sample.delta) {
                                return false;
                            }
                            direction[0] = sample.wiX;
                            direction[1] = sample.wiY;
                            direction[2] = sample.wiZ;
                            return true;
                        },
                        (x, y, z) -> bsdf.density(point, wo.x(), wo.y(), wo.z(), x, y, z, mode))
                .samples(SAMPLES)
                .seed(seed)
                .cells(31, 17)
                .equalAngles()
                .assertAgrees(level);
    }

    /**
     * How often each delta lobe is chosen against what {@link Bsdf#deltaLobe} says of it, and passing straight through
     * against the transparency, as a χ² test; the rest is one class.
     */
    private static void checkDeltaLobes(
            String name, Bsdf bsdf, BsdfCases.Direction wo, TransportMode mode, long seed, double level) {
        SurfacePoint point = BsdfCases.point();
        RandomStream random = new RandomStream(seed, StreamDomain.SELF_CHECK, 1, 0);
        BsdfSample sample = new BsdfSample();
        int lobes = bsdf.deltaLobes();
        int straight = lobes;
        int rest = lobes + 1;
        double[] expected = new double[lobes + 2];
        expected[straight] = bsdf.transparency(point) * SAMPLES;
        expected[rest] = SAMPLES - expected[straight];
        for (int lobe = 0; lobe < lobes; lobe++) {
            if (bsdf.deltaLobe(point, wo.x(), wo.y(), wo.z(), lobe, mode, sample)) {
                expected[lobe] = sample.density * SAMPLES;
                expected[rest] -= expected[lobe];
            }
        }
        long[] observed = new long[lobes + 2];
        for (int i = 0; i < SAMPLES; i++) {
            int lobe = rest;
            if (bsdf.sample(
                            point,
                            wo.x(),
                            wo.y(),
                            wo.z(),
                            random.nextDouble(),
                            random.nextDouble(),
                            random.nextDouble(),
                            mode,
                            sample)
                    && sample.delta
                    && !sample.weight.isBlack()) {
                lobe = sample.passThrough ? straight : sample.lobe;
                double share = sample.density * SAMPLES;
                assertEquals(expected[lobe], share, 1e-9 * share, name);
            }
            observed[lobe]++;
        }
        if (Math.abs(expected[rest]) < 1e-9 * SAMPLES) {
            expected[rest] = 0;
        }
        assertTrue(expected[rest] >= 0, name + ": the probabilities of the delta lobes exceed 1");
        if (testableClasses(expected) < 2) {
            assertEquals(expected[rest] == 0 ? 0 : observed[rest], observed[rest], name);
            return;
        }
        ChiSquareTest.Result result = ChiSquareTest.compare(name + ", delta lobes", observed, expected);
        assertTrue(result.pValue() >= level, result.message());
    }

    private static int testableClasses(double[] expected) {
        int count = 0;
        for (double value : expected) {
            count += value >= 5 ? 1 : 0;
        }
        return count;
    }

    private static boolean hasDensity(Bsdf bsdf, BsdfCases.Direction wo, TransportMode mode) {
        SurfacePoint point = BsdfCases.point();
        for (int i = 0; i < 2000; i++) {
            double z = (i + 0.5) / 1000 - 1;
            double phi = 2.399963 * i;
            double sin = Math.sqrt(1 - z * z);
            if (bsdf.density(point, wo.x(), wo.y(), wo.z(), sin * Math.cos(phi), sin * Math.sin(phi), z, mode) > 0) {
                return true;
            }
        }
        return false;
    }

    private static boolean drawsContinuously(Bsdf bsdf, BsdfCases.Direction wo, TransportMode mode, long seed) {
        SurfacePoint point = BsdfCases.point();
        RandomStream random = new RandomStream(seed, StreamDomain.SELF_CHECK, 2, 0);
        BsdfSample sample = new BsdfSample();
        for (int i = 0; i < 10_000; i++) {
            if (bsdf.sample(
                            point,
                            wo.x(),
                            wo.y(),
                            wo.z(),
                            random.nextDouble(),
                            random.nextDouble(),
                            random.nextDouble(),
                            mode,
                            sample)
                    && !sample.delta) {
                return true;
            }
        }
        return false;
    }
}
