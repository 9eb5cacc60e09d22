package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.numbers.gamma.Erfc;
import org.apache.commons.numbers.gamma.Erfcx;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Identities of microfacet distributions, by quadrature. No statistics. */
class MicrofacetTest {
    private static final double[] ALPHAS = {0.01, 0.1, 0.5, 1, 2};

    @ParameterizedTest
    @EnumSource
    void facetsCoverTheSurface(Microfacet.Kind kind) {
        for (double alpha : ALPHAS) {
            int n = 200_000;
            double sum = 0;
            for (int i = 0; i < n; i++) {
                // tan θ = α t/(1 − t) spreads the nodes over peak and tail.
                double t = (i + 0.5) / n;
                double tan = alpha * t / (1 - t);
                double cos = 1 / Math.sqrt(1 + tan * tan);
                double sin = tan * cos;
                double dTheta = alpha / ((1 - t) * (1 - t)) * cos * cos;
                sum += 2 * Math.PI * Microfacet.distribution(kind, alpha, sin, 0, cos) * cos * sin * dTheta / n;
            }
            assertEquals(1, sum, 1e-6, "alpha " + alpha);
        }
    }

    /** Visible facets project to the macroscopic area: ∫ D(m) (wo·m)⁺ G₁(wo) dm = cos θ_o. This defines Smith's G₁. */
    @ParameterizedTest
    @EnumSource
    void visibleFacetsProjectToTheSurface(Microfacet.Kind kind) {
        for (double alpha : ALPHAS) {
            for (double cosine : new double[] {1, 0.8, 0.3, 0.05, 0.001}) {
                double sine = Math.sqrt(1 - cosine * cosine);
                int radial = 4000;
                double sum = 0;
                for (int i = 0; i < radial; i++) {
                    double t = (i + 0.5) / radial;
                    double tan = alpha * t / (1 - t);
                    double cos = 1 / Math.sqrt(1 + tan * tan);
                    double sin = tan * cos;
                    double weight =
                            Microfacet.distribution(kind, alpha, sin, 0, cos) * sin * alpha / ((1 - t) * (1 - t));
                    // Exact in azimuth: ∫ (a + b cos φ)⁺ dφ over a full turn.
                    double a = cosine * cos;
                    double b = sine * sin;
                    double edge = a >= b ? Math.PI : Math.acos(-a / b);
                    double projected = 2 * (a * edge + b * Math.sin(edge));
                    sum += weight * cos * cos * projected / radial;
                }
                double masking = Microfacet.maskingOverCosine(kind, alpha, cosine);
                assertEquals(1, sum * masking, 1e-5, "alpha " + alpha + ", cosine " + cosine);
            }
        }
    }

    /**
     * Means over sampled normals equal integrals over the density of visible normals. By quadrature of both, so that
     * errors of a few parts in 10⁴ show, which χ² tests would miss.
     */
    @ParameterizedTest
    @EnumSource
    void sampledNormalsFollowTheVisibleOnes(Microfacet.Kind kind) {
        double[] nodes = GaussLegendre.nodes(200);
        double[] weights = GaussLegendre.weights(nodes);
        BsdfSample normal = new BsdfSample();
        for (double alpha : new double[] {0.05, 0.4, 1}) {
            for (double cosine : new double[] {1, 0.7, 0.2, 0.02}) {
                double woX = Math.sqrt(1 - cosine * cosine) * Math.cos(0.6);
                double woY = Math.sqrt(1 - cosine * cosine) * Math.sin(0.6);
                double masking = Microfacet.maskingOverCosine(kind, alpha, cosine);
                double[] sampled = new double[3];
                double[] integrated = new double[3];
                for (int i = 0; i < nodes.length; i++) {
                    double u = 0.5 * (1 - Math.cos(Math.PI * nodes[i]));
                    double du = weights[i] * 0.5 * Math.PI * Math.sin(Math.PI * nodes[i]);
                    double tan = alpha * nodes[i] / (1 - nodes[i]);
                    double cos = 1 / Math.sqrt(1 + tan * tan);
                    double sin = tan * cos;
                    double solid = weights[i] * sin * cos * cos * alpha / ((1 - nodes[i]) * (1 - nodes[i]));
                    for (int j = 0; j < nodes.length; j++) {
                        double v = 0.5 * (1 - Math.cos(Math.PI * nodes[j]));
                        double dv = weights[j] * 0.5 * Math.PI * Math.sin(Math.PI * nodes[j]);
                        Microfacet.sampleVisibleNormal(kind, alpha, woX, woY, cosine, u, v, normal);
                        addTo(sampled, alpha, normal.wiX, normal.wiY, normal.wiZ, du * dv);
                    }
                    int turns = 600;
                    for (int j = 0; j < turns; j++) {
                        double phi = 2 * Math.PI * (j + 0.5) / turns;
                        double x = sin * Math.cos(phi);
                        double y = sin * Math.sin(phi);
                        double visible = Math.max(0, woX * x + woY * y + cosine * cos)
                                * masking
                                * Microfacet.distribution(kind, alpha, x, y, cos);
                        addTo(integrated, alpha, x, y, cos, visible * solid * 2 * Math.PI / turns);
                    }
                }
                for (int i = 0; i < 3; i++) {
                    assertEquals(integrated[i], sampled[i], 2e-4, "alpha " + alpha + ", cosine " + cosine + ", " + i);
                }
            }
        }
    }

    /** Bounded smooth functions of the slopes: width, and the shift along both axes. */
    private static void addTo(double[] sums, double alpha, double x, double y, double z, double weight) {
        double slopeX = x / (alpha * z);
        double slopeY = y / (alpha * z);
        double bounded = weight / (1 + slopeX * slopeX + slopeY * slopeY);
        sums[0] += bounded;
        sums[1] += bounded * slopeX;
        sums[2] += bounded * slopeX * slopeY;
    }

    @ParameterizedTest
    @EnumSource
    void maskingIsBounded(Microfacet.Kind kind) {
        for (double alpha : new double[] {1e-6, 1e-3, 0.1, 1, 10}) {
            double last = 0;
            for (double cosine : new double[] {0, 1e-300, 1e-20, 1e-5, 0.01, 0.3, 0.8, 1, 1 + 2.3e-16}) {
                double masking = Microfacet.maskingOverCosine(kind, alpha, cosine) * cosine;
                assertTrue(masking >= last && masking <= 1 + 1e-15, alpha + ", " + cosine + ": " + masking);
                last = masking;
            }
            assertEquals(1, last, 1e-15);
        }
    }

    /** Sampled slopes invert the distribution function, also far out and at grazing angles. */
    @Test
    void gaussianSlopesInvertTheirDistribution() {
        for (double theta : new double[] {0, 1e-8, 0.1, 0.7, 1.2, 1.5, 1.5707, Math.PI / 2}) {
            double cos = Math.cos(theta);
            double sin = Math.sin(theta);
            double total = slopesUpTo(cos, sin, sin > 0 ? cos / sin : 30);
            double last = Double.NEGATIVE_INFINITY;
            for (double u : new double[] {0, 1e-16, 1e-12, 1e-6, 0.01, 0.2, 0.5, 0.9, 0.999, 1 - 1e-9, 1 - 0x1p-53}) {
                double slope = Microfacet.visibleSlope(cos, sin, u);
                assertTrue(slope >= last && Math.abs(slope) < 7, theta + ", " + u + ": " + slope);
                last = slope;
                if (u > 0) {
                    assertEquals(u, slopesUpTo(cos, sin, slope) / total, 1e-9 * u + 1e-15, theta + ", " + u);
                }
            }
        }
    }

    private static double slopesUpTo(double cos, double sin, double slope) {
        return 0.5 * (cos * Math.sqrt(Math.PI) * Erfc.value(-slope) + sin * Math.exp(-slope * slope));
    }

    @Test
    void errorFunctionIsAccurate() {
        for (double x = 0; x < 30; x += 0.0137) {
            double expected = Erfcx.value(x);
            assertEquals(expected, ErrorFunction.scaledComplement(x), 3e-15 * expected, "at " + x);
        }
        assertEquals(Erfcx.value(1e9), ErrorFunction.scaledComplement(1e9), 1e-22);
        assertEquals(0, ErrorFunction.scaledComplement(Double.POSITIVE_INFINITY));
        assertEquals(Erfc.value(-1.3), ErrorFunction.complement(-1.3, Math.exp(-1.69)), 1e-14);
    }

    @Test
    void gaussLegendreIsExactForPolynomials() {
        double[] nodes = GaussLegendre.nodes(24);
        double[] weights = GaussLegendre.weights(nodes);
        for (int power = 0; power < 48; power++) {
            double sum = 0;
            for (int i = 0; i < nodes.length; i++) {
                sum += weights[i] * Math.pow(nodes[i], power);
            }
            assertEquals(1.0 / (power + 1), sum, 1e-14, "power " + power);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-9, -0.1, 11, Double.NaN, Double.POSITIVE_INFINITY})
    void roughnessOutOfRangeIsRefused(double alpha) {
        IllegalArgumentException e = assertThrows(
                IllegalArgumentException.class,
                () -> RoughConductor.mirror(Microfacet.Kind.GGX, alpha, BsdfCases.white()));
        assertTrue(e.getMessage().contains("alpha must be between"), e.getMessage());
        assertEquals(alpha >= 0 && alpha < 1, e.getMessage().contains("smooth material"), e.getMessage());
    }
}
