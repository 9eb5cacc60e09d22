package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FresnelTest {
    @Test
    void normalIncidenceIsTheSquaredRatio() {
        assertEquals(0.04, Fresnel.dielectric(1, 1.5), 1e-15);
        assertEquals(0.04, Fresnel.dielectric(1, 1 / 1.5), 1e-15);
        double eta = 0.2;
        double k = 3.9;
        double expected = ((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k);
        assertEquals(expected, Fresnel.conductor(1, eta, k), 1e-14);
    }

    /** At Brewster's angle, tan θ = η, one polarisation vanishes and the other is ((η² − 1)/(η² + 1))². */
    @ParameterizedTest
    @ValueSource(doubles = {1.33, 1.5, 2.4, 0.7})
    void brewster(double eta) {
        double cosine = 1 / Math.sqrt(1 + eta * eta);
        double amplitude = (eta * eta - 1) / (eta * eta + 1);
        assertEquals(0.5 * amplitude * amplitude, Fresnel.dielectric(cosine, eta), 1e-14);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1.0001, 1.33, 1.5, 2.4, 0.7, 0.999})
    void bothDirectionsReflectTheSame(double eta) {
        for (int i = 1; i <= 100; i++) {
            double cosine = i / 100.0;
            double refracted = Fresnel.refractedCosine(cosine, 1 / eta);
            if (refracted < 0) {
                assertEquals(1, Fresnel.dielectric(cosine, eta));
                assertTrue(eta < 1);
            } else {
                double there = Fresnel.dielectric(cosine, eta);
                assertEquals(there, Fresnel.dielectric(refracted, 1 / eta), 1e-9);
                assertEquals(Math.sqrt(1 - cosine * cosine), eta * Math.sqrt(1 - refracted * refracted), 1e-14);
            }
        }
    }

    @Test
    void totalInternalReflectionBeginsAtTheCriticalAngle() {
        double critical = Math.sqrt(1 - 1 / 2.25);
        assertEquals(1, Fresnel.dielectric(critical - 1e-9, 1 / 1.5));
        assertTrue(Fresnel.dielectric(critical + 1e-9, 1 / 1.5) < 1);
    }

    @Test
    void grazingIsTotalAndEqualMediaDoNotReflect() {
        assertEquals(1, Fresnel.dielectric(0, 1.5));
        assertEquals(1, Fresnel.conductor(0, 0.2, 3));
        for (double cosine : new double[] {0, 1e-300, 0.3, 1}) {
            assertEquals(0, Fresnel.dielectric(cosine, 1));
        }
    }

    @Test
    void conductorWithoutAbsorptionIsADielectric() {
        for (double eta : new double[] {1.2, 1.5, 3, 0.7}) {
            for (int i = 1; i <= 50; i++) {
                assertEquals(Fresnel.dielectric(i / 50.0, eta), Fresnel.conductor(i / 50.0, eta, 0), 1e-12, "at " + i);
            }
        }
    }

    /** The formulas of the complex amplitudes, evaluated with complex numbers. */
    @Test
    void conductorIsTheComplexFormula() {
        for (double eta : new double[] {0.05, 0.2, 1, 2.7}) {
            for (double k : new double[] {0.1, 1, 3.9, 8}) {
                for (int i = 1; i <= 40; i++) {
                    double c = i / 40.0;
                    assertEquals(complexConductor(c, eta, k), Fresnel.conductor(c, eta, k), 1e-12);
                }
            }
        }
    }

    private static double complexConductor(double c, double eta, double k) {
        // n = η + ik, n cos θ_t = √(n² − sin²θ) = a + ib.
        double re = eta * eta - k * k - (1 - c * c);
        double im = 2 * eta * k;
        double modulus = Math.hypot(re, im);
        double a = Math.sqrt((modulus + re) / 2);
        double b = im / (2 * a);
        double perpendicular = ((c - a) * (c - a) + b * b) / ((c + a) * (c + a) + b * b);
        // r_p = (n² c − (a + ib)) / (n² c + (a + ib)).
        double nr = (eta * eta - k * k) * c;
        double ni = 2 * eta * k * c;
        double parallel = ((nr - a) * (nr - a) + (ni - b) * (ni - b)) / ((nr + a) * (nr + a) + (ni + b) * (ni + b));
        return 0.5 * (perpendicular + parallel);
    }

    /** Closed form for η > 1 (Duntley 1942; in Egan and Hilgeman 1973). */
    @ParameterizedTest
    @ValueSource(doubles = {1.1, 1.33, 1.5, 1.9, 2.4, 5})
    void diffuseReflectanceIsTheClosedForm(double n) {
        double n2 = n * n;
        double n4 = n2 * n2;
        double expected = 0.5
                + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1))
                + n2 * (n2 - 1) * (n2 - 1) / Math.pow(n2 + 1, 3) * Math.log((n - 1) / (n + 1))
                - 2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1))
                + 8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * Math.log(n);
        assertEquals(expected, Fresnel.diffuse(n), 1e-12);
        assertEquals(1 - (1 - expected) / n2, Fresnel.diffuse(1 / n), 1e-12);
    }

    @Test
    void diffuseReflectanceVanishesSmoothlyTowardsEqualMedia() {
        assertEquals(0, Fresnel.diffuse(1));
        double last = 0;
        for (double excess = 1e-12; excess < 0.1; excess *= 10) {
            double reflectance = Fresnel.diffuse(1 + excess);
            assertTrue(reflectance > last && reflectance < 2 * excess, excess + ": " + reflectance);
            last = reflectance;
        }
    }

    /** Brute force from inside, where total internal reflection bends the integrand. */
    @Test
    void diffuseReflectanceFromInsideIsItsIntegral() {
        int n = 2_000_000;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double c = (i + 0.5) / n;
            sum += 2 * c * Fresnel.dielectric(c, 1 / 1.5) / n;
        }
        assertEquals(sum, Fresnel.diffuse(1 / 1.5), 1e-7);
    }
}
