package org.daybreak.scenes.build;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Objects;
import org.daybreak.core.material.Fresnel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MetalsTest {
    /**
     * Reflectance along the normal against that of Mitsuba 3.9.1 (scalar_rgb), whose indices come from other measurements.
     * The last column is the tolerance.
     */
    @ParameterizedTest
    @CsvSource({
        "Ag, 0.155276, 0.116728, 0.138388, 4.82835, 3.12222, 2.1469, 0.07",
        "Al, 1.6575, 0.880405, 0.521244, 9.22381, 6.2695, 4.837, 0.01",
        "Au, 0.143036, 0.375307, 1.44205, 3.983, 2.38556, 1.60336, 0.07",
        "Cr, 4.3697, 2.9165, 1.6549, 5.2065, 4.2313, 3.7547, 0.17",
        "Cu, 0.201005, 0.92375, 1.10222, 3.91326, 2.45305, 2.14209, 0.02",
        "Ni_palik, 2.3673, 1.6634, 1.4671, 4.4988, 3.0502, 2.3454, 0.04",
        "V_palik, 4.2776, 3.5129, 2.7611, 3.4913, 2.8895, 3.1115, 0.01"
    })
    void reflectanceIsNearMitsubas(
            String name, double er, double eg, double eb, double kr, double kg, double kb, double tolerance) {
        Metals.ComplexIndex index = Objects.requireNonNull(Metals.of(name));
        assertEquals(Fresnel.conductor(1, er, kr), Fresnel.conductor(1, index.eta().r, index.k().r), tolerance);
        assertEquals(Fresnel.conductor(1, eg, kg), Fresnel.conductor(1, index.eta().g, index.k().g), tolerance);
        assertEquals(Fresnel.conductor(1, eb, kb), Fresnel.conductor(1, index.eta().b, index.k().b), tolerance);
    }

    @Test
    void unknownMetals() {
        assertNull(Metals.of("Unobtainium"));
        assertTrue(Metals.names().contains("Au"));
    }
}
