package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/**
 * White materials return at most what they receive, lossless ones all of it. Seeds are fixed; a change of the random
 * numbers raises a false alarm in all of these tests together with probability at most 1e-4.
 */
class BsdfEnergyTest {
    private static final double FALSE_ALARM = 1e-4;
    private static final int SAMPLES = 20_000;
    private static final double[] COSINES = {1, 0.9, 0.6, 0.3, 0.1, 0.02, 0.001};

    private record White(String name, Bsdf bsdf, boolean lossless) {}

    private static List<White> whites() {
        List<White> list = new ArrayList<>();
        Texture white = BsdfCases.white();
        list.add(new White("diffuse", new Diffuse(white), true));
        list.add(new White("mirror", Conductor.mirror(white), true));
        list.add(new White("conductor", new Conductor(BsdfCases.eta(), BsdfCases.k(), white), false));
        list.add(new White("dielectric", new Dielectric(1.5, 1, white, white), true));
        for (double ior : new double[] {1, 1.5, 1.9, 0.7}) {
            list.add(new White("plastic " + ior, new Plastic(ior, 1, white, white, false), true));
            list.add(new White("nonlinear plastic " + ior, new Plastic(ior, 1, white, white, true), true));
            for (Microfacet.Kind kind : Microfacet.Kind.values()) {
                for (double alpha : new double[] {0.02, 0.2, 1}) {
                    String name = "rough plastic " + kind + " " + alpha + " " + ior;
                    list.add(new White(name, new RoughPlastic(kind, alpha, ior, 1, white, white, false), false));
                }
            }
        }
        for (Microfacet.Kind kind : Microfacet.Kind.values()) {
            for (double alpha : new double[] {0.02, 0.2, 1}) {
                list.add(new White("rough " + kind + " " + alpha, RoughConductor.mirror(kind, alpha, white), false));
            }
        }
        Bsdf bothSides = new TwoSided(new Diffuse(white), new Plastic(1.5, 1, white, white, false));
        list.add(new White("mask", new Mask(ConstantTexture.grey(0.3), bothSides), true));
        list.add(new White("two-sided", bothSides, true));
        return list;
    }

    @TestFactory
    Stream<DynamicTest> energyIsConserved() {
        List<White> whites = whites();
        int count = whites.size() * COSINES.length * 2;
        double level = Significance.sidak(FALSE_ALARM, count);
        List<DynamicTest> tests = new ArrayList<>();
        for (White white : whites) {
            tests.add(DynamicTest.dynamicTest(white.name(), () -> {
                for (double cosine : COSINES) {
                    check(white, cosine, level);
                    check(white, -cosine, level);
                }
            }));
        }
        return tests.stream();
    }

    private static void check(White white, double woZ, double level) {
        SurfacePoint point = BsdfCases.point();
        BsdfSample sample = new BsdfSample();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        Moments energy = new Moments();
        double woX = Math.sqrt(1 - woZ * woZ);
        for (int i = 0; i < SAMPLES; i++) {
            double u = random.nextDouble();
            double v = random.nextDouble();
            double w = random.nextDouble();
            boolean alive = white.bsdf().sample(point, woX, 0, woZ, u, v, w, TransportMode.IMPORTANCE, sample);
            energy.add(alive ? sample.weight.r : 0);
        }
        String where = white.name() + " at cosine " + woZ + ": " + energy.mean();
        if (energy.variance() < 1e-20) {
            // Every sample has the same weight: no statistics needed.
            assertTrue(energy.mean() <= 1 + 1e-12, where);
            if (white.lossless() && energy.mean() != 0) {
                assertEquals(1, energy.mean(), 1e-12, where);
            }
            return;
        }
        boolean tooMuch = energy.mean() > 1;
        if (white.lossless() || tooMuch) {
            ZTest.assertNotRejected(where, ZTest.oneSample(energy, 1), level);
        }
    }

    @Test
    void albedoImageShowsWhatIsReturnedAtTheNormal() {
        SurfacePoint point = BsdfCases.point();
        Spectrum albedo = new Spectrum();
        for (White white : whites()) {
            white.bsdf().albedo(point, albedo);
            assertTrue(albedo.r > 0 && albedo.r <= 1 + 1e-6, white.name() + ": " + albedo);
            if (white.lossless()) {
                assertEquals(1, albedo.r, 1e-9, white.name());
            }
        }
    }
}
