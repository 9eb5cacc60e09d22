package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Supplier;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Given delta lobes are what sampling draws, and lead back. Exact, no statistics; that lobes are chosen with the
 * probabilities they report is tested in {@link BsdfSamplingTest}.
 */
class BsdfDeltaLobeTest {
    private static final int DIRECTIONS = 20_000;

    /** Directions flatter than this, to any of the normals, are too inaccurate to compare. */
    private static final double LEAST_COSINE = 1e-6;

    private final BsdfSample sample = new BsdfSample();
    private final BsdfSample lobe = new BsdfSample();
    private final BsdfSample back = new BsdfSample();
    private final double[] wo = new double[3];

    static List<BsdfCases.Case> materials() {
        return BsdfCases.all();
    }

    @ParameterizedTest
    @MethodSource("materials")
    void samplesAreReproduced(BsdfCases.Case material) {
        Bsdf bsdf = material.bsdf();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        SurfacePoint point = BsdfCases.point();
        int last = -1;
        for (int i = 0; i < DIRECTIONS; i++) {
            TransportMode mode = i % 2 == 0 ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
            point.u = 4 * random.nextDouble();
            direction(random);
            double u = random.nextDouble();
            double v = random.nextDouble();
            double w = random.nextDouble();
            if (!bsdf.sample(point, wo[0], wo[1], wo[2], u, v, w, mode, sample)) {
                continue;
            }
            if (!sample.delta || sample.passThrough) {
                assertEquals(0, sample.lobe, material.name());
                continue;
            }
            assertTrue(sample.lobe >= 0 && sample.lobe < bsdf.deltaLobes(), material.name());
            boolean found = bsdf.deltaLobe(point, wo[0], wo[1], wo[2], sample.lobe, mode, lobe);
            assertSame(material.name(), sample, found, lobe);
            last = Math.max(last, sample.weight.isBlack() ? -1 : sample.lobe);
        }
        assertEquals(bsdf.deltaLobes() - 1, last, material.name() + ": the last lobe that it draws");
        for (int extra = 0; extra < 3; extra++) {
            int number = bsdf.deltaLobes() + extra;
            assertFalse(bsdf.deltaLobe(point, 0.6, 0, 0.8, number, TransportMode.RADIANCE, lobe), material.name());
            assertFalse(bsdf.deltaLobe(point, 0.6, 0, -0.8, number, TransportMode.RADIANCE, lobe), material.name());
        }
    }

    @ParameterizedTest
    @MethodSource("materials")
    void samplesAreReproducedUnderTiltedNormals(BsdfCases.Case material) {
        Bsdf bsdf = material.bsdf();
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        int drawn = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            TransportMode mode = i % 2 == 0 ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
            SurfacePoint p = ScatteringTest.tiltedPoint(random);
            direction(random);
            double u = random.nextDouble();
            double v = random.nextDouble();
            double w = random.nextDouble();
            if (Scattering.sample(bsdf, p, wo[0], wo[1], wo[2], u, v, w, mode, sample)
                    && sample.delta
                    && !sample.passThrough) {
                boolean found = Scattering.deltaLobe(bsdf, p, wo[0], wo[1], wo[2], sample.lobe, mode, lobe);
                assertSame(material.name(), sample, found, lobe);
                drawn++;
            }
        }
        assertEquals(bsdf.deltaLobes() > 0, drawn > 100, material.name());
    }

    private static void assertSame(String name, BsdfSample sample, boolean found, BsdfSample lobe) {
        Spectrum weight = sample.weight;
        assertEquals(!weight.isBlack(), found, name);
        if (!found) {
            return;
        }
        assertEquals(sample.wiX, lobe.wiX, name);
        assertEquals(sample.wiY, lobe.wiY, name);
        assertEquals(sample.wiZ, lobe.wiZ, name);
        assertEquals(sample.density, lobe.density, 1e-15 * sample.density, name);
        assertEquals(weight.r * sample.density, lobe.weight.r, 1e-14 * lobe.weight.r, name);
        assertEquals(weight.g * sample.density, lobe.weight.g, 1e-14 * lobe.weight.g, name);
        assertEquals(weight.b * sample.density, lobe.weight.b, 1e-14 * lobe.weight.b, name);
        assertEquals(sample.eta, lobe.eta, name);
        assertEquals(sample.lobe, lobe.lobe, name);
        assertTrue(lobe.delta && !lobe.passThrough, name);
    }

    @ParameterizedTest
    @MethodSource("materials")
    void lobesLeadBack(BsdfCases.Case material) {
        RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
        SurfacePoint point = BsdfCases.point();
        int compared = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            point.u = 4 * random.nextDouble();
            direction(random);
            compared += checkReversal(material, point);
        }
        assertEquals(material.bsdf().deltaLobes() > 0, compared > 100, material.name());
    }

    @ParameterizedTest
    @MethodSource("materials")
    void lobesLeadBackUnderTiltedNormals(BsdfCases.Case material) {
        RandomStream random = new RandomStream(4, StreamDomain.SELF_CHECK, 0, 0);
        int compared = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            SurfacePoint p = ScatteringTest.tiltedPoint(random);
            direction(random);
            compared += checkReversal(material, p);
        }
        assertEquals(material.bsdf().deltaLobes() > 0, compared > 100, material.name());
    }

    /**
     * Follows every lobe from wo in RADIANCE and back in IMPORTANCE. Both walks measure the same light:
     * W(wo→wi) dσ(wo) |wo·n_g| = W*(wi→wo) dσ(wi) |wi·n_g|, where Snell's law makes dσ(wi) |wi·n| = eta² dσ(wo) |wo·n| with the
     * normal n that the lobe mirrors or refracts at. With n = n_g this is W(wo→wi) = eta²·W*(wi→wo).
     *
     * @return number of lobes compared
     */
    private int checkReversal(BsdfCases.Case material, SurfacePoint p) {
        Bsdf bsdf = material.bsdf();
        int compared = 0;
        for (int i = 0; i < bsdf.deltaLobes(); i++) {
            if (!Scattering.deltaLobe(bsdf, p, wo[0], wo[1], wo[2], i, TransportMode.RADIANCE, lobe)) {
                continue;
            }
            double eta = lobe.eta;
            double out = Math.abs(p.geometricCosine(wo[0], wo[1], wo[2]));
            double in = Math.abs(p.geometricCosine(lobe.wiX, lobe.wiY, lobe.wiZ));
            // By Snell's law the normal of the lobe lies along eta·wo + wi, which is 0 if the lobe goes straight on.
            double nx = eta * wo[0] + lobe.wiX;
            double ny = eta * wo[1] + lobe.wiY;
            double nz = eta * wo[2] + lobe.wiZ;
            double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
            boolean straight = length < 1e-9;
            double lobeOut = straight ? out : Math.abs(nx * wo[0] + ny * wo[1] + nz * wo[2]) / length;
            double lobeIn = straight ? in : Math.abs(nx * lobe.wiX + ny * lobe.wiY + nz * lobe.wiZ) / length;
            double least = Math.min(Math.min(out, in), Math.min(lobeOut, lobeIn));
            if (least < LEAST_COSINE) {
                continue;
            }
            int number = i;
            Supplier<String> where = () -> material.name() + ", lobe " + number + " from (" + wo[0] + ", " + wo[1]
                    + ", " + wo[2] + ") to (" + lobe.wiX + ", " + lobe.wiY + ", " + lobe.wiZ + ")";
            assertTrue(
                    Scattering.deltaLobe(bsdf, p, lobe.wiX, lobe.wiY, lobe.wiZ, i, TransportMode.IMPORTANCE, back),
                    where);
            // The way back starts from a rounded direction; refraction and F are steep near the horizon.
            double tolerance = 1e-9 + 1e-13 / (least * least);
            assertEquals(wo[0], back.wiX, tolerance, where);
            assertEquals(wo[1], back.wiY, tolerance, where);
            assertEquals(wo[2], back.wiZ, tolerance, where);
            assertEquals(1, eta * back.eta, 1e-14, where);
            double forward = 1 / (eta * eta);
            double backward = lobeOut * in / (out * lobeIn);
            assertEquals(forward * lobe.weight.r, backward * back.weight.r, tolerance, where);
            assertEquals(forward * lobe.weight.g, backward * back.weight.g, tolerance, where);
            assertEquals(forward * lobe.weight.b, backward * back.weight.b, tolerance, where);
            compared++;
        }
        return compared;
    }

    /** Glass of index 1.5, by hand: along the normal F = 0.04; beyond the critical angle, 41.8°, all is reflected. */
    @Test
    void glassHasItsKnownValues() {
        Bsdf glass = new Dielectric(1.5, 1, ConstantTexture.grey(0.5), ConstantTexture.grey(0.25));
        SurfacePoint point = BsdfCases.point();
        assertTrue(glass.deltaLobe(point, 0, 0, 1, 0, TransportMode.RADIANCE, lobe));
        assertEquals(0.02, lobe.weight.g, 1e-15);
        assertEquals(0.04, lobe.density, 1e-15);
        assertEquals(1, lobe.wiZ);
        assertTrue(glass.deltaLobe(point, 0, 0, 1, 1, TransportMode.RADIANCE, lobe));
        assertEquals(0.24 / 2.25, lobe.weight.g, 1e-15);
        assertEquals(0.96, lobe.density, 1e-15);
        assertEquals(1 / 1.5, lobe.eta, 1e-15);
        assertEquals(-1, lobe.wiZ);
        assertTrue(glass.deltaLobe(point, 0, 0, -1, 1, TransportMode.RADIANCE, lobe));
        assertEquals(0.24 * 2.25, lobe.weight.g, 1e-15);
        assertTrue(glass.deltaLobe(point, 0, 0, -1, 1, TransportMode.IMPORTANCE, lobe));
        assertEquals(0.24, lobe.weight.g, 1e-15);
        assertTrue(glass.deltaLobe(point, 0.8, 0, -0.6, 0, TransportMode.RADIANCE, lobe));
        assertEquals(0.5, lobe.weight.g);
        assertEquals(1, lobe.density);
        assertFalse(glass.deltaLobe(point, 0.8, 0, -0.6, 1, TransportMode.RADIANCE, lobe));
    }

    @Test
    void blackAndMissingLobesAreNotFollowed() {
        SurfacePoint point = BsdfCases.point();
        TransportMode mode = TransportMode.RADIANCE;
        Texture black = ConstantTexture.grey(0);
        Texture white = BsdfCases.white();
        Bsdf mirror = Conductor.mirror(white);
        Bsdf bare = new Plastic(1.3, 1.3, white, white, false);
        Bsdf invisible = new Dielectric(1.2, 1.2, white, white);
        assertFalse(Conductor.mirror(black).deltaLobe(point, 0, 0, 1, 0, mode, lobe));
        assertFalse(mirror.deltaLobe(point, 0, 0, -1, 0, mode, lobe));
        assertFalse(bare.deltaLobe(point, 0, 0, 1, 0, mode, lobe), "nothing reflects off no coating");
        assertFalse(new Plastic(1.5, 1, black, black, false).deltaLobe(point, 0, 0, 1, 0, mode, lobe));
        assertFalse(invisible.deltaLobe(point, 0, 0, 1, 0, mode, lobe), "equal indices do not reflect");
        assertTrue(invisible.deltaLobe(point, 0.6, 0, 0.8, 1, mode, lobe));
        assertEquals(-0.8, lobe.wiZ, 1e-15);
        assertFalse(new Mask(black, mirror).deltaLobe(point, 0, 0, 1, 0, mode, lobe));
        assertFalse(new Blend(white, mirror, mirror).deltaLobe(point, 0, 0, 1, 0, mode, lobe));
        assertTrue(new Blend(white, mirror, mirror).deltaLobe(point, 0, 0, 1, 1, mode, lobe));
        assertEquals(0, new NullBsdf().deltaLobes());
    }

    /** Uniform, but every fourth direction within a degree or less of the horizon. */
    private void direction(RandomStream random) {
        double z = 2 * random.nextDouble() - 1;
        if (random.nextInt(4) == 0) {
            z *= Math.pow(10, -2 - 4 * random.nextDouble());
        }
        double phi = 2 * Math.PI * random.nextDouble();
        double sin = Math.sqrt((1 - z) * (1 + z));
        wo[0] = sin * Math.cos(phi);
        wo[1] = sin * Math.sin(phi);
        wo[2] = z;
    }
}
