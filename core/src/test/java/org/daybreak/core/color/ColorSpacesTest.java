package org.daybreak.core.color;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ColorSpacesTest {
    @Test
    void knownValues() {
        assertEquals(0, ColorSpaces.srgbToLinear(0));
        assertEquals(1, ColorSpaces.srgbToLinear(1));
        assertEquals(1, ColorSpaces.linearToSrgb(1), 1e-15);
        // Published: sRGB 0.5 is 21.404 % linear; 18 % grey is code 118 (0.4613).
        assertEquals(0.21404114, ColorSpaces.srgbToLinear(0.5), 1e-8);
        assertEquals(0.46135613, ColorSpaces.linearToSrgb(0.18), 1e-8);
        assertEquals(118, ColorSpaces.linearToSrgbByte(0.18));
        assertEquals(0.0031308, ColorSpaces.srgbToLinear(0.04045), 1e-7);
    }

    @Test
    void bothWaysAreInverse() {
        for (int i = 0; i <= 10_000; i++) {
            double linear = i / 10_000.0;
            // 1e-7: the two branches of the standard do not quite meet at its rounded thresholds.
            assertEquals(linear, ColorSpaces.srgbToLinear(ColorSpaces.linearToSrgb(linear)), 1e-7);
        }
    }

    @Test
    void bytesRoundTripAndIncrease() {
        for (int code = 0; code < 256; code++) {
            assertEquals(code, ColorSpaces.linearToSrgbByte(ColorSpaces.srgbByteToLinear(code)));
            if (code > 0) {
                assertTrue(ColorSpaces.srgbByteToLinear(code) > ColorSpaces.srgbByteToLinear(code - 1));
            }
        }
        assertThrows(IndexOutOfBoundsException.class, () -> ColorSpaces.srgbByteToLinear(256));
    }

    @Test
    void bytesAreClamped() {
        assertEquals(0, ColorSpaces.linearToSrgbByte(-3));
        assertEquals(255, ColorSpaces.linearToSrgbByte(7));
        assertEquals(255, ColorSpaces.linearToSrgbByte(Double.POSITIVE_INFINITY));
        assertEquals(0, ColorSpaces.linearToSrgbByte(Double.NaN));
    }
}
