package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.function.Supplier;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What {@link Bsdf} promises of every material, at random and at extreme directions. No statistics: each case is exact. */
class BsdfContractTest {
    private static final int PAIRS = 20_000;

    private static final double[][] EXTREME = {
        {0, 0, 1},
        {0, 0, -1},
        {1, 0, 0},
        {-1, 0, 0},
        {0, 1, -0.0},
        {1, 0, 1e-300},
        {-1, 0, 1e-300},
        {1, 0, -1e-300},
        {0, -1, Double.MIN_VALUE},
        {-1, 0, 1e-160},
        {Math.sqrt(1 - 1e-16), 0, 1e-8},
        {-Math.sqrt(1 - 1e-16), 0, 1e-8},
        {0, Math.sqrt(1 - 1e-8), -1e-4},
        {1e-9, 0, 1},
        {0, -1e-200, 1},
        {0, 0, 1 + 2.3e-16},
        {0, 0, -1 - 2.3e-16}
    };

    private final SurfacePoint point = BsdfCases.point();
    private final Spectrum value = new Spectrum();
    private final BsdfSample sample = new BsdfSample();

    static List<BsdfCases.Case> materials() {
        return BsdfCases.all();
    }

    @ParameterizedTest
    @MethodSource("materials")
    void whatScattersCanBeSampledAndDensitiesAgree(BsdfCases.Case material) {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        double[] wo = new double[3];
        double[] wi = new double[3];
        int scattering = 0;
        for (int i = 0; i < PAIRS; i++) {
            randomDirection(random, wo);
            randomDirection(random, wi);
            scattering += checkPair(material, wo, wi) ? 1 : 0;
        }
        assertEquals(material.bsdf().connectable(), scattering > 0);
        for (double[] first : EXTREME) {
            for (double[] second : EXTREME) {
                checkPair(material, first, second);
            }
            for (int i = 0; i < 200; i++) {
                randomDirection(random, wi);
                checkPair(material, first, wi);
                checkPair(material, wi, first);
            }
        }
    }

    private boolean checkPair(BsdfCases.Case material, double[] wo, double[] wi) {
        boolean scatters = false;
        for (TransportMode mode : TransportMode.values()) {
            double density = material.bsdf().evaluate(point, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], mode, value);
            assertTrue(
                    density >= 0 && Double.isFinite(density),
                    () -> describe(material, wo, wi, mode) + ": density " + density);
            assertTrue(
                    value.r >= 0 && value.g >= 0 && value.b >= 0 && value.isFinite(),
                    () -> describe(material, wo, wi, mode) + ": " + value);
            assertTrue(
                    value.isBlack() || density > 0,
                    () -> describe(material, wo, wi, mode) + ": " + value + " with density 0");
            double alone = material.bsdf().density(point, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], mode);
            assertEquals(density, alone, 1e-12 * density, () -> describe(material, wo, wi, mode));
            if (!value.isBlack()) {
                scatters = true;
                double reverse = material.bsdf().density(point, wi[0], wi[1], wi[2], wo[0], wo[1], wo[2], mode);
                // A cosine, or a lobe's tail, of subnormal size may underflow on the way back.
                boolean subnormal = Math.abs(wo[2]) < Double.MIN_NORMAL || value.max() < 1e-290;
                assertTrue(
                        reverse > 0 || subnormal,
                        () -> describe(material, wo, wi, mode) + ": cannot be sampled in reverse");
            }
        }
        return scatters;
    }

    @ParameterizedTest
    @MethodSource("materials")
    void weightOfASampleIsItsValueOverItsDensity(BsdfCases.Case material) {
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        double[] wo = new double[3];
        int drawn = 0;
        for (int i = 0; i < PAIRS; i++) {
            if (i < 50 * EXTREME.length) {
                System.arraycopy(EXTREME[i % EXTREME.length], 0, wo, 0, 3);
            } else {
                randomDirection(random, wo);
            }
            for (TransportMode mode : TransportMode.values()) {
                drawn += checkSample(material, wo, random, mode) ? 1 : 0;
            }
        }
        assertTrue(drawn > PAIRS / 4, material.name() + ": only " + drawn + " samples");
    }

    private boolean checkSample(BsdfCases.Case material, double[] wo, RandomStream random, TransportMode mode) {
        // Corners of the unit cube are where root finding and square roots go wrong.
        double u = corner(random);
        double v = corner(random);
        double w = corner(random);
        if (!material.bsdf().sample(point, wo[0], wo[1], wo[2], u, v, w, mode, sample)) {
            return false;
        }
        double[] wi = {sample.wiX, sample.wiY, sample.wiZ};
        Supplier<String> where = () -> describe(material, wo, wi, mode) + " from (" + u + ", " + v + ", " + w + "): "
                + sample.weight + ", " + sample.density + ", eta " + sample.eta;
        assertEquals(1, wi[0] * wi[0] + wi[1] * wi[1] + wi[2] * wi[2], 1e-12, where);
        Spectrum weight = sample.weight;
        assertTrue(weight.isFinite() && weight.r >= 0 && weight.g >= 0 && weight.b >= 0, where);
        assertTrue(sample.density > 0 && Double.isFinite(sample.density), where);
        boolean refracted = !sample.passThrough && wo[2] > 0 != wi[2] > 0;
        assertTrue(sample.delta || !sample.passThrough, where);
        assertTrue(refracted || sample.eta == 1, where);
        if (sample.delta) {
            assertTrue(sample.density <= 1, where);
            return true;
        }
        double density = material.bsdf().evaluate(point, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], mode, value);
        // Half vectors of sampled directions carry their rounding; with α = 0.05 it grows by some 1/α².
        assertEquals(density, sample.density, 1e-9 * density, where);
        assertEquals(value.r / density, weight.r, 1e-9 * weight.r, where);
        assertEquals(value.g / density, weight.g, 1e-9 * weight.g, where);
        assertEquals(value.b / density, weight.b, 1e-9 * weight.b, where);
        return true;
    }

    /** Evaluation and sampling run for every vertex of every path. */
    @ParameterizedTest
    @MethodSource("materials")
    void nothingIsAllocated(BsdfCases.Case material) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        Assumptions.assumeTrue(threads.isThreadAllocatedMemorySupported());
        long least = Long.MAX_VALUE;
        // The first rounds load classes and let the measurement itself settle.
        for (int round = 0; round < 5; round++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            exercise(material.bsdf());
            least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
        }
        assertTrue(least < 1000, material.name() + ": " + least + " bytes in 1000 calls");
    }

    private void exercise(Bsdf bsdf) {
        for (int i = 0; i < 1000; i++) {
            double u = (i + 0.5) / 1000;
            double v = 0.618034 * i % 1;
            bsdf.sample(point, 0.6, 0, 0.8, u, v, 0.7548777 * i % 1, TransportMode.RADIANCE, sample);
            bsdf.evaluate(point, 0.6, 0, 0.8, sample.wiX, sample.wiY, sample.wiZ, TransportMode.IMPORTANCE, value);
            bsdf.density(point, 0.6, 0, 0.8, sample.wiX, sample.wiY, sample.wiZ, TransportMode.RADIANCE);
            bsdf.deltaLobe(point, 0.6, 0, 0.8, i % 4, TransportMode.RADIANCE, sample);
            bsdf.albedo(point, value);
        }
    }

    @Test
    void oneSidedMaterialsAreBlackFromBehind() {
        List<Bsdf> oneSided = List.of(
                new Diffuse(BsdfCases.base()),
                Conductor.mirror(BsdfCases.white()),
                RoughConductor.mirror(Microfacet.Kind.GGX, 0.3, BsdfCases.white()),
                new Plastic(1.5, 1, BsdfCases.base(), BsdfCases.white(), false),
                new RoughPlastic(Microfacet.Kind.GGX, 0.2, 1.5, 1, BsdfCases.base(), BsdfCases.white(), false));
        RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
        double[] wo = new double[3];
        double[] wi = new double[3];
        for (Bsdf bsdf : oneSided) {
            assertFalse(bsdf.transmissive());
            for (int i = 0; i < 1000; i++) {
                randomDirection(random, wo);
                randomDirection(random, wi);
                if (wo[2] > 0 && wi[2] > 0) {
                    continue;
                }
                bsdf.evaluate(point, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], TransportMode.RADIANCE, value);
                assertTrue(value.isBlack());
                assertTrue(wo[2] > 0
                        || !bsdf.sample(point, wo[0], wo[1], wo[2], 0.3, 0.4, 0.5, TransportMode.RADIANCE, sample));
            }
        }
    }

    private static double corner(RandomStream random) {
        int choice = random.nextInt(16);
        return choice == 0 ? 0 : choice == 1 ? 1 - 0x1p-53 : choice == 2 ? 0.5 : random.nextDouble();
    }

    /** Uniform, but every fourth direction within a degree or less of the horizon. */
    private static void randomDirection(RandomStream random, double[] direction) {
        double z = 2 * random.nextDouble() - 1;
        if (random.nextInt(4) == 0) {
            z *= Math.pow(10, -2 - 8 * random.nextDouble());
        }
        double phi = 2 * Math.PI * random.nextDouble();
        double sin = Math.sqrt((1 - z) * (1 + z));
        direction[0] = sin * Math.cos(phi);
        direction[1] = sin * Math.sin(phi);
        direction[2] = z;
    }

    private static String describe(BsdfCases.Case material, double[] wo, double[] wi, TransportMode mode) {
        return material.name() + ", wo (" + wo[0] + ", " + wo[1] + ", " + wo[2] + "), wi (" + wi[0] + ", " + wi[1]
                + ", " + wi[2] + "), " + mode;
    }
}
