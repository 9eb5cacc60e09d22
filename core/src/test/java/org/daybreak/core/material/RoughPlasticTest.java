package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import org.daybreak.core.color.Spectrum;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The energy balance of rough plastic, by quadrature. No statistics. */
class RoughPlasticTest {
    /**
     * Furnace, seen along the normal: what returns of a constant surrounding of radiance 1, for a diffuse reflectance of
     * 0.9 under GGX with α = 0.12. The value is E + 0.9·T, with E the light that the coating reflects (Mitsuba 3
     * measures 0.09482 and 0.03945) and T what it lets through; R_int cancels, as no energy is lost inside.
     */
    @ParameterizedTest
    @CsvSource({"1.9, 0.09482, 0.9070", "1.5, 0.03945, 0.9024"})
    void furnace(double ior, double specular, double total) {
        Texture white = BsdfCases.white();
        Bsdf black = new RoughPlastic(Microfacet.Kind.GGX, 0.12, ior, 1, ConstantTexture.grey(0), white, false);
        assertEquals(specular, reflected(black, 1, 128), 5e-5);
        Bsdf grey = new RoughPlastic(Microfacet.Kind.GGX, 0.12, ior, 1, ConstantTexture.grey(0.9), white, false);
        assertEquals(total, reflected(grey, 1, 128), 1e-4);
    }

    /** A white base returns all that enters: only light scattered more than once between facets is missing. */
    @ParameterizedTest
    @EnumSource
    void whiteLosesOnlyMultipleScattering(Microfacet.Kind kind) {
        Texture white = BsdfCases.white();
        for (double ior : new double[] {1.1, 1.5, 2.4}) {
            for (double alpha : new double[] {0.01, 0.1, 0.4, 1}) {
                Bsdf plastic = new RoughPlastic(kind, alpha, ior, 1, white, white, false);
                for (double cosine : new double[] {1, 0.7, 0.3, 0.1, 0.03}) {
                    double energy = reflected(plastic, cosine, 64);
                    String where = String.format(Locale.ROOT, "ior %s, alpha %s, cosine %s", ior, alpha, cosine);
                    // The table of T, linear between its entries, is off by up to 2e-4.
                    assertTrue(energy <= 1 + 3e-4, where + ": " + energy);
                    if (alpha <= 0.1 && cosine >= 0.7) {
                        assertTrue(energy >= 0.99, where + ": " + energy);
                    }
                }
            }
        }
    }

    /** Diffuse transmittance is the same in both directions per solid angle times η²: reciprocity of the interface. */
    @ParameterizedTest
    @EnumSource
    void transmittanceIsReciprocal(Microfacet.Kind kind) {
        for (double alpha : new double[] {0.05, 0.12, 0.5}) {
            for (double eta : new double[] {1.3, 1.5, 1.9}) {
                double inwards = new RoughTransmittance(kind, alpha, eta).hemispherical();
                double outwards = new RoughTransmittance(kind, alpha, 1 / eta).hemispherical();
                assertEquals(inwards, outwards * eta * eta, 1e-3 * inwards, kind + " " + alpha + " " + eta);
            }
        }
    }

    @Test
    void smoothCoatingIsTheLimit() {
        Bsdf smooth = new Plastic(1.5, 1, BsdfCases.base(), BsdfCases.white(), true);
        Bsdf rough =
                new RoughPlastic(Microfacet.Kind.BECKMANN, 0.002, 1.5, 1, BsdfCases.base(), BsdfCases.white(), true);
        Spectrum expected = new Spectrum();
        Spectrum actual = new Spectrum();
        for (double cosine : new double[] {1, 0.8, 0.5, 0.2}) {
            // Away from the mirror direction only the base is seen.
            double sine = Math.sqrt(1 - cosine * cosine);
            smooth.evaluate(BsdfCases.point(), sine, 0, cosine, 0.6, 0.64, 0.48, TransportMode.RADIANCE, expected);
            rough.evaluate(BsdfCases.point(), sine, 0, cosine, 0.6, 0.64, 0.48, TransportMode.RADIANCE, actual);
            assertEquals(expected.r, actual.r, 5e-4 * expected.r, "cosine " + cosine);
            assertEquals(expected.b, actual.b, 5e-4 * expected.b, "cosine " + cosine);
        }
    }

    @Test
    void tablesAreTheIntegrals() {
        double[] nodes = GaussLegendre.nodes(120);
        double[] weights = GaussLegendre.weights(nodes);
        for (Microfacet.Kind kind : Microfacet.Kind.values()) {
            for (double alpha : new double[] {0.01, 0.12, 0.5, 1}) {
                RoughTransmittance table = new RoughTransmittance(kind, alpha, 1.5);
                for (double cosine : new double[] {0.003, 0.05, 0.123, 0.4, 0.77, 1}) {
                    double expected = RoughTransmittance.directional(kind, alpha, 1.5, cosine, nodes, weights);
                    assertEquals(expected, table.at(cosine), 2e-4, kind + " " + alpha + " " + cosine);
                }
            }
        }
    }

    /** ∫ f cos over the hemisphere, by quadrature over half vectors for the coating and cosines for the base. */
    private static double reflected(Bsdf plastic, double woZ, int nodeCount) {
        // The two lobes need different nodes; the sampling routine supplies both, with its own weights.
        double woX = Math.sqrt(1 - woZ * woZ);
        BsdfSample sample = new BsdfSample();
        double[] nodes = GaussLegendre.nodes(nodeCount);
        double[] weights = GaussLegendre.weights(nodes);
        double split = probabilityOfDiffuse(plastic, woX, woZ);
        double sum = 0;
        for (int i = 0; i < nodes.length; i++) {
            double u = 0.5 * (1 - Math.cos(Math.PI * nodes[i]));
            double du = weights[i] * 0.5 * Math.PI * Math.sin(Math.PI * nodes[i]);
            for (int j = 0; j < nodes.length; j++) {
                double v = 0.5 * (1 - Math.cos(Math.PI * nodes[j]));
                double dv = weights[j] * 0.5 * Math.PI * Math.sin(Math.PI * nodes[j]);
                for (int lobe = 0; lobe < 2; lobe++) {
                    double w = lobe == 0 ? 0 : 1 - 0x1p-53;
                    double dw = lobe == 0 ? split : 1 - split;
                    if (dw > 0
                            && plastic.sample(
                                    BsdfCases.point(), woX, 0, woZ, u, v, w, TransportMode.RADIANCE, sample)) {
                        sum += du * dv * dw * sample.weight.r;
                    }
                }
            }
        }
        return sum;
    }

    private static double probabilityOfDiffuse(Bsdf plastic, double woX, double woZ) {
        // The lobe number at which the direction drawn from fixed (u, v) changes.
        BsdfSample sample = new BsdfSample();
        double low = 0;
        double high = 1;
        plastic.sample(BsdfCases.point(), woX, 0, woZ, 0.3, 0.4, 0, TransportMode.RADIANCE, sample);
        double first = sample.wiX;
        plastic.sample(BsdfCases.point(), woX, 0, woZ, 0.3, 0.4, 1 - 0x1p-53, TransportMode.RADIANCE, sample);
        if (sample.wiX == first) {
            return 0;
        }
        for (int i = 0; i < 53; i++) {
            double middle = 0.5 * (low + high);
            plastic.sample(BsdfCases.point(), woX, 0, woZ, 0.3, 0.4, middle, TransportMode.RADIANCE, sample);
            if (sample.wiX == first) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }
}
