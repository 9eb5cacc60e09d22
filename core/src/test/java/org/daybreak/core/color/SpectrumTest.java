package org.daybreak.core.color;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SpectrumTest {
    private final Spectrum s = new Spectrum(1, 2, 3);

    @Test
    void arithmetic() {
        s.add(new Spectrum(10, 20, 30));
        assertComponents(11, 22, 33);
        s.addScaled(new Spectrum(1, 2, 3), -1);
        assertComponents(10, 20, 30);
        s.mul(new Spectrum(2, 0.5, 0));
        assertComponents(20, 10, 0);
        s.scale(0.5);
        assertComponents(10, 5, 0);
        s.addProduct(new Spectrum(1, 2, 3), new Spectrum(4, 5, 6), 2);
        assertComponents(18, 25, 36);
        s.set(7);
        assertComponents(7, 7, 7);
        s.set(new Spectrum(3, 2, 1));
        assertComponents(3, 2, 1);
        s.setZero();
        assertTrue(s.isBlack());
    }

    @Test
    void luminanceOfWhiteIsOne() {
        assertEquals(1, Spectrum.luminance(1, 1, 1), 1e-15);
        assertEquals(0.715160, new Spectrum(0, 1, 0).luminance());
    }

    @Test
    void predicates() {
        assertFalse(s.isBlack());
        assertFalse(new Spectrum(0, 0, 1e-300).isBlack());
        assertTrue(s.isFinite());
        assertFalse(new Spectrum(0, Double.NaN, 0).isFinite());
        assertFalse(new Spectrum(0, 0, Double.POSITIVE_INFINITY).isFinite());
        assertEquals(3, s.max());
        assertEquals(9, new Spectrum(9, 2, 3).max());
    }

    @Test
    void copyIsIndependent() {
        Spectrum copy = s.copy();
        assertNotSame(s, copy);
        copy.set(9, 9, 9);
        assertComponents(1, 2, 3);
    }

    private void assertComponents(double r, double g, double b) {
        assertEquals(r, s.r);
        assertEquals(g, s.g);
        assertEquals(b, s.b);
    }
}
