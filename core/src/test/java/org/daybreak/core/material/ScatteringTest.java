package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Frame;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Scattering in world space where the shading normal is tilted against the geometric one. */
class ScatteringTest {
    private final Spectrum value = new Spectrum();
    private final Spectrum other = new Spectrum();
    private final BsdfSample sample = new BsdfSample();
    private final double[] wo = new double[3];
    private final double[] wi = new double[3];

    static List<BsdfCases.Case> materials() {
        return BsdfCases.all();
    }

    /** f > 0 ⇒ density > 0 both ways, and nothing leaks through the surface. */
    @ParameterizedTest
    @MethodSource("materials")
    void whatScattersCanBeSampledUnderTiltedNormals(BsdfCases.Case material) {
        Bsdf bsdf = material.bsdf();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        int scattering = 0;
        for (int i = 0; i < 20_000; i++) {
            SurfacePoint p = tiltedPoint(random);
            direction(random, wo);
            direction(random, wi);
            for (TransportMode mode : TransportMode.values()) {
                double density = Scattering.evaluate(bsdf, p, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], mode, value);
                assertTrue(value.isFinite() && density >= 0 && Double.isFinite(density), material.name());
                assertEquals(
                        density,
                        Scattering.density(bsdf, p, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], mode),
                        1e-12 * density);
                if (value.isBlack()) {
                    continue;
                }
                scattering++;
                assertTrue(density > 0, material.name());
                assertTrue(
                        Scattering.density(bsdf, p, wi[0], wi[1], wi[2], wo[0], wo[1], wo[2], mode) > 0
                                || value.max() < 1e-290,
                        material.name());
                // Each direction is on one side, by either normal; light changes sides only where the material
                // transmits.
                double og = p.geometricCosine(wo[0], wo[1], wo[2]);
                double ig = p.geometricCosine(wi[0], wi[1], wi[2]);
                assertTrue(og * p.localZ(wo[0], wo[1], wo[2]) > 0, material.name() + ": wo is on both sides");
                assertTrue(ig * p.localZ(wi[0], wi[1], wi[2]) > 0, material.name() + ": wi is on both sides");
                assertTrue(bsdf.transmissive() || og * ig > 0, material.name() + ": light leak");
            }
        }
        assertEquals(bsdf.connectable(), scattering > 0);
    }

    /** Exact: the adjoint is the value with the roles of the directions exchanged (Veach 1997, §5.3). */
    @ParameterizedTest
    @MethodSource("materials")
    void importanceModeIsTheAdjointOfRadianceMode(BsdfCases.Case material) {
        Bsdf bsdf = material.bsdf();
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        for (int i = 0; i < 20_000; i++) {
            SurfacePoint p = tiltedPoint(random);
            direction(random, wo);
            direction(random, wi);
            Scattering.evaluate(bsdf, p, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], TransportMode.IMPORTANCE, value);
            Scattering.evaluate(bsdf, p, wi[0], wi[1], wi[2], wo[0], wo[1], wo[2], TransportMode.RADIANCE, other);
            // What a light path carries on, per |wi·n_g| of its geometry term, an eye path the other way carries
            // per |wo·n_g|: f*(wo→wi)|wi·n_g| = f(wi→wo)|wo·n_s| |wi·n_g|/|wo·n_g|.
            double og = Math.abs(p.geometricCosine(wo[0], wo[1], wo[2]));
            double ig = Math.abs(p.geometricCosine(wi[0], wi[1], wi[2]));
            assertEquals(other.r * ig / og, value.r, 1e-10 * value.r + 1e-300, material.name());
            assertEquals(other.g * ig / og, value.g, 1e-10 * value.g + 1e-300, material.name());
            assertEquals(other.b * ig / og, value.b, 1e-10 * value.b + 1e-300, material.name());
        }
    }

    /** Exact: a sample's weight is what {@link Scattering#evaluate} says of its direction; its sides are consistent. */
    @ParameterizedTest
    @MethodSource("materials")
    void samplesAgreeWithEvaluation(BsdfCases.Case material) {
        Bsdf bsdf = material.bsdf();
        RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
        int drawn = 0;
        for (int i = 0; i < 20_000; i++) {
            SurfacePoint p = tiltedPoint(random);
            direction(random, wo);
            TransportMode mode = i % 2 == 0 ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
            double u = random.nextDouble();
            double v = random.nextDouble();
            double w = random.nextDouble();
            if (!Scattering.sample(bsdf, p, wo[0], wo[1], wo[2], u, v, w, mode, sample)) {
                continue;
            }
            drawn++;
            double x = sample.wiX;
            double y = sample.wiY;
            double z = sample.wiZ;
            assertEquals(1, x * x + y * y + z * z, 1e-12);
            assertTrue(sample.weight.isFinite(), material.name());
            if (sample.passThrough) {
                assertEquals(-1, x * wo[0] + y * wo[1] + z * wo[2], 1e-12);
                continue;
            }
            assertTrue(p.localZ(x, y, z) * p.geometricCosine(x, y, z) > 0, material.name());
            if (!sample.delta) {
                double density = Scattering.evaluate(bsdf, p, wo[0], wo[1], wo[2], x, y, z, mode, value);
                // The density of a narrow refracted lobe magnifies the rounding of directions near the critical angle.
                double tolerance = material.name().equals("phong frosted glass") ? 1e-7 : 1e-9;
                assertEquals(density, sample.density, tolerance * density, material.name());
                assertEquals(value.r / density, sample.weight.r, tolerance * sample.weight.r, material.name());
                assertEquals(value.b / density, sample.weight.b, tolerance * sample.weight.b, material.name());
            }
        }
        assertTrue(drawn > 2000, material.name());
    }

    /**
     * The weights of samples integrate what evaluation says, in both modes: the mean weight equals the integral of the
     * value by uniform sampling of the sphere. z-tests; a change of the random numbers raises a false alarm with
     * probability 1e-4 over all materials (Šidák).
     */
    @ParameterizedTest
    @MethodSource("materials")
    void samplingAndEvaluationIntegrateToTheSame(BsdfCases.Case material) {
        Bsdf bsdf = material.bsdf();
        int points = 6;
        double level = Significance.sidak(1e-4, materials().size() * points * 2);
        RandomStream random = new RandomStream(4, StreamDomain.SELF_CHECK, 0, 0);
        for (int i = 0; i < points; i++) {
            SurfacePoint p = tiltedPoint(random);
            direction(random, wo);
            for (TransportMode mode : TransportMode.values()) {
                Moments sampled = new Moments();
                Moments evaluated = new Moments();
                for (int j = 0; j < 20_000; j++) {
                    double u = random.nextDouble();
                    double v = random.nextDouble();
                    double w = random.nextDouble();
                    boolean alive = Scattering.sample(bsdf, p, wo[0], wo[1], wo[2], u, v, w, mode, sample);
                    sampled.add(alive && !sample.delta ? sample.weight.g : 0);
                    direction(random, wi);
                    Scattering.evaluate(bsdf, p, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], mode, value);
                    evaluated.add(4 * Math.PI * value.g);
                }
                String where = material.name() + ", " + mode;
                // A narrow lobe that uniform sampling hits too rarely makes its mean far from normal: leave those out.
                boolean comparable = evaluated.variance() < 400 * evaluated.mean() * evaluated.mean();
                if (sampled.variance() > 0 && comparable) {
                    ZTest.assertNotRejected(where, ZTest.twoSample(sampled, evaluated), level);
                }
            }
        }
    }

    /** A point with a random geometric normal and a shading normal up to 60° off it. */
    static SurfacePoint tiltedPoint(RandomStream random) {
        SurfacePoint p = BsdfCases.point();
        double[] g = new double[3];
        direction(random, g);
        Frame frame = new Frame();
        frame.set(g[0], g[1], g[2]);
        double theta = Math.PI / 3 * random.nextDouble();
        double phi = 2 * Math.PI * random.nextDouble();
        double[] n = new double[3];
        frame.toWorld(Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta), n);
        frame.set(n[0], n[1], n[2]);
        p.gx = g[0];
        p.gy = g[1];
        p.gz = g[2];
        p.sx = frame.sx;
        p.sy = frame.sy;
        p.sz = frame.sz;
        p.tx = frame.tx;
        p.ty = frame.ty;
        p.tz = frame.tz;
        p.nx = frame.nx;
        p.ny = frame.ny;
        p.nz = frame.nz;
        return p;
    }

    private static void direction(RandomStream random, double[] out) {
        double z = 2 * random.nextDouble() - 1;
        double phi = 2 * Math.PI * random.nextDouble();
        double sin = Math.sqrt(1 - z * z);
        out[0] = sin * Math.cos(phi);
        out[1] = sin * Math.sin(phi);
        out[2] = z;
    }
}
