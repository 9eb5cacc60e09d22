package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Supplier;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Symmetry of scattering, or its stated adjoint. Exact, no statistics. */
class BsdfReciprocityTest {
    private final SurfacePoint point = BsdfCases.point();
    private final Spectrum forward = new Spectrum();
    private final Spectrum backward = new Spectrum();
    private final BsdfSample sample = new BsdfSample();

    static List<BsdfCases.Case> materials() {
        return BsdfCases.all();
    }

    @ParameterizedTest
    @MethodSource("materials")
    void reflectionIsSymmetric(BsdfCases.Case material) {
        Bsdf bsdf = material.bsdf();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        for (int i = 0; i < 20_000; i++) {
            double oz = 2 * random.nextDouble() - 1;
            double iz = Math.copySign(random.nextDouble(), oz);
            double op = 2 * Math.PI * random.nextDouble();
            double ip = 2 * Math.PI * random.nextDouble();
            double os = Math.sqrt(1 - oz * oz);
            double is = Math.sqrt(1 - iz * iz);
            double ox = os * Math.cos(op);
            double oy = os * Math.sin(op);
            double ix = is * Math.cos(ip);
            double iy = is * Math.sin(ip);
            bsdf.evaluate(point, ox, oy, oz, ix, iy, iz, TransportMode.RADIANCE, forward);
            bsdf.evaluate(point, ix, iy, iz, ox, oy, oz, TransportMode.IMPORTANCE, backward);
            // f·|cos θ_i| both ways: compare f. Tails of subnormal size have few digits.
            double scale = Math.abs(oz / iz);
            Supplier<String> where = () -> material.name() + ", " + oz + ", " + iz;
            assertEquals(forward.r * scale, backward.r, 1e-11 * backward.r + 1e-300, where);
            assertEquals(forward.g * scale, backward.g, 1e-11 * backward.g + 1e-300, where);
            assertEquals(forward.b * scale, backward.b, 1e-11 * backward.b + 1e-300, where);
        }
    }

    /** Carrying radiance one way and importance the other is the same, also through the surface. */
    @ParameterizedTest
    @MethodSource("materials")
    void modesAreAdjoint(BsdfCases.Case material) {
        Bsdf bsdf = material.bsdf();
        RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
        for (int i = 0; i < 20_000; i++) {
            double oz = 2 * random.nextDouble() - 1;
            double iz = 2 * random.nextDouble() - 1;
            double op = 2 * Math.PI * random.nextDouble();
            double ip = 2 * Math.PI * random.nextDouble();
            double os = Math.sqrt(1 - oz * oz);
            double is = Math.sqrt(1 - iz * iz);
            double ox = os * Math.cos(op);
            double oy = os * Math.sin(op);
            double ix = is * Math.cos(ip);
            double iy = is * Math.sin(ip);
            bsdf.evaluate(point, ox, oy, oz, ix, iy, iz, TransportMode.RADIANCE, forward);
            bsdf.evaluate(point, ix, iy, iz, ox, oy, oz, TransportMode.IMPORTANCE, backward);
            double scale = Math.abs(oz / iz);
            Supplier<String> where = () -> material.name() + ", " + oz + ", " + iz;
            // Fresnel's equations from both sides differ by rounding, most near total reflection.
            assertEquals(forward.r * scale, backward.r, 1e-9 * backward.r + 1e-300, where);
            assertEquals(forward.g * scale, backward.g, 1e-9 * backward.g + 1e-300, where);
            assertEquals(forward.b * scale, backward.b, 1e-9 * backward.b + 1e-300, where);
        }
    }

    /**
     * The delta lobes of a dielectric: the same fraction passes an interface in both directions; radiance changes by the
     * square of the relative index, and f(wo, wi)/η_o² = f(wi, wo)/η_i².
     */
    @ParameterizedTest
    @CsvSource({"1.5, 1", "1, 1.33", "2.4, 1.5", "1.2, 1.2"})
    void refractionIsAdjoint(double intIor, double extIor) {
        Bsdf bsdf = new Dielectric(intIor, extIor, BsdfCases.white(), ConstantTexture.grey(0.8));
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        int refractions = 0;
        for (int i = 0; i < 20_000; i++) {
            double z = 2 * random.nextDouble() - 1;
            double x = Math.sqrt(1 - z * z);
            double w = random.nextDouble();
            assertTrue(bsdf.sample(point, x, 0, z, 0, 0, w, TransportMode.RADIANCE, sample));
            if (sample.wiZ * z > 0) {
                assertEquals(1, sample.weight.r);
                continue;
            }
            refractions++;
            double etaOut = z > 0 ? extIor : intIor;
            double etaIn = z > 0 ? intIor : extIor;
            assertEquals(etaOut / etaIn, sample.eta, 1e-15);
            assertEquals(etaOut * x, -etaIn * sample.wiX, 1e-14, "Snell");
            double wiX = sample.wiX;
            double wiZ = sample.wiZ;
            double probability = sample.density;
            double radiance = sample.density * sample.weight.r;
            assertTrue(bsdf.sample(point, x, 0, z, 0, 0, w, TransportMode.IMPORTANCE, sample));
            double importance = sample.density * sample.weight.r;
            assertEquals(probability, sample.density);
            assertEquals(0.8 * probability, importance, 1e-14);
            assertTrue(bsdf.sample(point, wiX, 0, wiZ, 0, 0, 1 - 0x1p-53, TransportMode.RADIANCE, sample));
            assertEquals(x, sample.wiX, 1e-9);
            assertEquals(1, sample.eta * etaOut / etaIn, 1e-14);
            // At grazing angles the way back starts from a rounded direction, and F is steep there.
            assertEquals(probability, sample.density, 1e-9 + 1e-13 / Math.abs(wiZ * z));
            double reverse = sample.density * sample.weight.r;
            double invariant = radiance * etaIn * etaIn / (etaOut * etaOut);
            assertEquals(invariant, reverse * etaOut * etaOut / (etaIn * etaIn), 1e-9 + 1e-13 / Math.abs(wiZ * z));
            assertEquals(invariant, importance, 1e-12);
        }
        assertTrue(refractions > 5000);
    }
}
