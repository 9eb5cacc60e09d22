package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.DirectionDensity;
import org.daybreak.core.testing.DirectionSampler;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WarpsTest {
    /** False-alarm rate of each statistical assertion. */
    private static final double SIGNIFICANCE = 1e-4;

    private static final double LAST = Math.nextDown(1.0);

    @Test
    void concentricDisk() {
        ChiSquareTest.ofPoints(
                        "concentric disk",
                        (u, v, w, dest) -> {
                            Warps.toConcentricDisk(u, v, dest);
                            return true;
                        },
                        Warps::toConcentricDiskPdf,
                        -1.1,
                        1.1,
                        -1.1,
                        1.1)
                .assertAgrees(SIGNIFICANCE);
    }

    @Test
    void triangle() {
        ChiSquareTest.ofPoints(
                        "triangle",
                        (u, v, w, dest) -> {
                            Warps.toTriangle(u, v, dest);
                            return true;
                        },
                        Warps::toTrianglePdf,
                        0,
                        1.01,
                        0,
                        1.02)
                .assertAgrees(SIGNIFICANCE);
    }

    @Test
    void tent() {
        ChiSquareTest.ofPoints(
                        "tent",
                        (u, v, w, dest) -> {
                            dest[0] = Warps.toTent(u);
                            dest[1] = Warps.toTent(v);
                            return true;
                        },
                        (x, y) -> Warps.toTentPdf(x) * Warps.toTentPdf(y),
                        -1.2,
                        1.2,
                        -1.2,
                        1.2)
                .assertAgrees(SIGNIFICANCE);
        assertEquals(-1, Warps.toTent(0));
        assertEquals(0, Warps.toTent(0.5));
        assertTrue(Warps.toTent(LAST) < 1);
    }

    @Test
    void cosineHemisphere() {
        assertAgrees("cosine hemisphere", 1, Warps::toCosineHemisphere, (x, y, z) -> Warps.toCosineHemispherePdf(z));
    }

    @Test
    void uniformSphere() {
        assertAgrees("uniform sphere", 2, Warps::toUniformSphere, (x, y, z) -> Warps.toUniformSpherePdf());
    }

    @Test
    void uniformHemisphere() {
        assertAgrees("uniform hemisphere", 3, Warps::toUniformHemisphere, (x, y, z) -> Warps.toUniformHemispherePdf(z));
    }

    @ParameterizedTest
    @ValueSource(doubles = {2, 1.5, 0.7, 0.05})
    void uniformCone(double oneMinusCosMax) {
        assertAgrees(
                "uniform cone",
                4,
                (u, v, dest) -> Warps.toUniformCone(u, v, oneMinusCosMax, dest),
                (x, y, z) -> Warps.toUniformConePdf(1 - z, oneMinusCosMax));
    }

    @Test
    void narrowConesKeepTheirShape() {
        // The cone of a sphere of radius 1 at distance 1e9: its half angle is 1e-9, and 1 − cos would be 0 in double.
        double oneMinusCosMax = 5e-19;
        double[] d = new double[3];
        Moments squaredSine = new Moments();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        for (int i = 0; i < 10_000; i++) {
            Warps.toUniformCone(random.nextDouble(), random.nextDouble(), oneMinusCosMax, d);
            squaredSine.add((d[0] * d[0] + d[1] * d[1]) * 1e18);
        }
        // Uniform in [0, 1].
        ZTest.assertNotRejected("squared sine", ZTest.oneSample(squaredSine, 0.5), SIGNIFICANCE);
    }

    @Test
    void momentsAreThoseOfTheShapes() {
        Moments cosine = new Moments();
        Moments height = new Moments();
        Moments squaredRadius = new Moments();
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        double[] p = new double[3];
        for (int i = 0; i < 100_000; i++) {
            Warps.toCosineHemisphere(random.nextDouble(), random.nextDouble(), p);
            cosine.add(p[2]);
            Warps.toUniformHemisphere(random.nextDouble(), random.nextDouble(), p);
            height.add(p[2]);
            Warps.toConcentricDisk(random.nextDouble(), random.nextDouble(), p);
            squaredRadius.add(p[0] * p[0] + p[1] * p[1]);
        }
        double[] pValues = {
            ZTest.oneSample(cosine, 2.0 / 3), ZTest.oneSample(height, 0.5), ZTest.oneSample(squaredRadius, 0.5)
        };
        ZTest.assertNoneRejected("moments", pValues, SIGNIFICANCE);
    }

    @Test
    void cornersAndCentreOfTheSquareAreFine() {
        double[] ends = {0, 0.5, LAST};
        double[] d = new double[3];
        for (double u : ends) {
            for (double v : ends) {
                Warps.toConcentricDisk(u, v, d);
                assertTrue(d[0] * d[0] + d[1] * d[1] <= 1 + 1e-15);
                Warps.toCosineHemisphere(u, v, d);
                assertTrue(Warps.toCosineHemispherePdf(d[2]) > 0);
                assertUnit(d);
                Warps.toUniformSphere(u, v, d);
                assertUnit(d);
                Warps.toUniformHemisphere(u, v, d);
                assertTrue(Warps.toUniformHemispherePdf(d[2]) > 0);
                assertUnit(d);
                Warps.toTriangle(u, v, d);
                assertTrue(Warps.toTrianglePdf(d[0], d[1]) > 0);
            }
        }
        Warps.toConcentricDisk(0.5, 0.5, d);
        assertArrayEquals(new double[] {0, 0}, new double[] {d[0], d[1]});
    }

    private static void assertUnit(double[] d) {
        assertEquals(1, d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1e-14);
    }

    private interface Warp {
        void map(double u, double v, double[] dest);
    }

    private static void assertAgrees(String name, long seed, Warp warp, DirectionDensity density) {
        DirectionSampler sampler = (u, v, w, dest) -> {
            warp.map(u, v, dest);
            return true;
        };
        ChiSquareTest.ofDirections(name, sampler, density).seed(seed).assertAgrees(SIGNIFICANCE);
    }
}
