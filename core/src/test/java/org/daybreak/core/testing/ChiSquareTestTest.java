package org.daybreak.core.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.daybreak.core.sampling.Warps;
import org.junit.jupiter.api.Test;

/** The test of the test: its p-values are uniform for a right density, and it finds wrong ones. */
class ChiSquareTestTest {
    private static final DirectionSampler COSINE = (u, v, w, d) -> {
        Warps.toCosineHemisphere(u, v, d);
        return true;
    };

    @Test
    void pValuesOfARightDensityAreUniform() {
        long[] counts = new long[10];
        double[] expected = new double[10];
        for (int seed = 0; seed < 400; seed++) {
            double p = cosine((x, y, z) -> Warps.toCosineHemispherePdf(z))
                    .seed(seed)
                    .cells(11, 7)
                    .samples(20_000)
                    .run()
                    .pValue();
            counts[Math.min((int) (10 * p), 9)]++;
        }
        Arrays.fill(expected, 40);
        // False-alarm rate 1e-4.
        ZTest.assertNotRejected(
                "uniformity",
                ChiSquareTest.compare("p-values", counts, expected).pValue(),
                1e-4);
    }

    @Test
    void wrongDensitiesAreFound() {
        // Four per cent too much on one side, too little on the other: the mass is right. The expected excess of χ² is
        // 200,000 · 0.04² = 320, nine standard deviations.
        assertTrue(cosine((x, y, z) -> Warps.toCosineHemispherePdf(z) * (x > 0 ? 1.04 : 0.96))
                        .run()
                        .pValue()
                < 1e-6);
        assertTrue(cosine((x, y, z) -> Warps.toUniformHemispherePdf(z)).run().pValue() < 1e-6);
    }

    @Test
    void wrongMassIsFound() {
        assertReported("integrates to", cosine((x, y, z) -> 1.01 * Warps.toCosineHemispherePdf(z)));
        assertTrue(
                cosine((x, y, z) -> 0.98 * Warps.toCosineHemispherePdf(z)).run().pValue() < 1e-6);
        assertReported("integrates to", cosine((x, y, z) -> z));
        assertReported("integrates to", cosine((x, y, z) -> x < -0.9 ? -1 : 0.1));
        assertReported("integrates to", cosine((x, y, z) -> x < -0.9 ? Double.NaN : 0.1));
    }

    @Test
    void samplesOfDensityZeroAreFound() {
        assertReported("density 0", cosine((x, y, z) -> x < 0 ? 2 * Warps.toCosineHemispherePdf(z) : 0));
        DirectionSampler stretched = (u, v, w, d) -> {
            Warps.toUniformSphere(u, v, d);
            d[0] *= 1.1;
            return true;
        };
        ChiSquareTest test = ChiSquareTest.ofDirections("not unit", stretched, (x, y, z) -> Warps.toUniformSpherePdf());
        assertThrows(AssertionError.class, test::run);
    }

    @Test
    void rejectedSamplesAreTheMissingMass() {
        DirectionSampler half = (u, v, w, d) -> {
            Warps.toCosineHemisphere(u, v, d);
            return w < 0.5;
        };
        // False-alarm rate 1e-4.
        ChiSquareTest.ofDirections("half", half, (x, y, z) -> 0.5 * Warps.toCosineHemispherePdf(z))
                .assertAgrees(1e-4);
        assertReported(
                "samples rejected",
                ChiSquareTest.ofDirections("half", half, (x, y, z) -> Warps.toCosineHemispherePdf(z)));
        assertTrue(ChiSquareTest.ofDirections("half", half, (x, y, z) -> 0.52 * Warps.toCosineHemispherePdf(z))
                        .run()
                        .pValue()
                < 1e-6);
    }

    @Test
    void narrowLobesAreIntegratedInEqualAngles() {
        // The half angle of the cone is 1°.
        double oneMinusCosMax = 1.523e-4;
        DirectionSampler cone = (u, v, w, d) -> {
            Warps.toUniformCone(u, v, oneMinusCosMax, d);
            return true;
        };
        ChiSquareTest.ofDirections("narrow cone", cone, (x, y, z) -> Warps.toUniformConePdf(1 - z, oneMinusCosMax))
                .equalAngles()
                .cells(31, 501)
                .assertAgrees(1e-4);
    }

    @Test
    void smallExpectationsArePooled() {
        long[] observed = {1, 0, 2, 1, 0, 1, 50, 45};
        double[] expected = {0.9, 0.8, 0.9, 1, 1.1, 0.3, 47, 48};
        ChiSquareTest.Result result = ChiSquareTest.compare("pooled", observed, expected);
        // The first six cells together expect exactly 5.
        assertEquals(2, result.degreesOfFreedom());
        assertEquals(0 + 9.0 / 47 + 9.0 / 48, result.statistic(), 1e-12);
    }

    private static ChiSquareTest cosine(DirectionDensity density) {
        return ChiSquareTest.ofDirections("cosine", COSINE, density);
    }

    private static void assertReported(String part, ChiSquareTest test) {
        ChiSquareTest.Result result = test.run();
        assertEquals(0, result.pValue());
        assertTrue(result.message().contains(part), result.message());
        assertThrows(AssertionError.class, () -> test.assertAgrees(1e-4));
    }
}
