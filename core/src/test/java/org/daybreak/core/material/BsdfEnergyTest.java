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
        Texture half = ConstantTexture.grey(0.5);
        list.add(new White("thin dielectric", new ThinDielectric(1.5, 1, white, white), true));
        list.add(new White("leaf", new Leaf(half, half, ConstantTexture.grey(0.7), ConstantTexture.grey(0.3)), true));
        list.add(new White("diffuse transmitter", Leaf.transmitter(white), true));
        list.add(new White("null", new NullBsdf(), true));
        list.add(new White("blend", new Blend(half, bothSides, new Diffuse(white)), false));
        list.add(new White("phong", phong(half, half, ConstantTexture.grey(0), 0.5), false));
        list.add(new White("phong glass", phong(half, half, half, 0.8), false));
        for (Microfacet.Kind kind : Microfacet.Kind.values()) {
            for (double alpha : new double[] {0.02, 0.2, 1}) {
                Roughness stretched = Roughness.of(ConstantTexture.grey(alpha), ConstantTexture.grey(0.3));
                String name = kind + " " + alpha + ", 0.3";
                list.add(new White("conductor " + name, RoughConductor.mirror(kind, stretched, white), false));
                list.add(new White(
                        "dielectric " + name, new RoughDielectric(kind, stretched, 1.5, 1, white, white), false));
            }
        }
        for (double rough : new double[] {0.1, 0.5, 1}) {
            list.add(new White("principled metal " + rough, whitePrincipled(rough, 1, 0), false));
            list.add(new White("principled glass " + rough, whitePrincipled(rough, 0, 1), false));
        }
        return list;
    }

    private static Bsdf phong(Texture diffuse, Texture specular, Texture transparency, double shininess) {
        Texture exponent = ConstantTexture.grey(shininess);
        return new GroimpPhong(
                new GroimpPhong.Parameters(
                        diffuse,
                        BsdfCases.white(),
                        specular,
                        exponent,
                        transparency,
                        exponent,
                        ConstantTexture.grey(0),
                        true),
                1.5,
                1);
    }

    private static Bsdf whitePrincipled(double roughness, double metallic, double specTrans) {
        Texture zero = ConstantTexture.grey(0);
        return new Principled(new Principled.Parameters(
                BsdfCases.white(),
                ConstantTexture.grey(roughness),
                ConstantTexture.grey(0.4),
                ConstantTexture.grey(metallic),
                ConstantTexture.grey(specTrans),
                1.5,
                zero,
                zero,
                zero,
                zero,
                zero,
                zero));
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
