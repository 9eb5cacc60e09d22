package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class HalfTest {
    /** The value of a finite half by the definition in IEEE 754; exact, as doubles hold every half. */
    private static double value(int half) {
        int exponent = (half >> 10) & 31;
        int mantissa = half & 0x3ff;
        double magnitude =
                exponent == 0 ? Math.scalb((double) mantissa, -24) : Math.scalb(1024.0 + mantissa, exponent - 25);
        return (half & 0x8000) != 0 ? -magnitude : magnitude;
    }

    @Test
    void everyHalfHasTheValueOfItsDefinition() {
        for (int half = 0; half < 1 << 16; half++) {
            float got = Half.toFloat((short) half);
            boolean negative = (half & 0x8000) != 0;
            if ((half & 0x7fff) == 0x7c00) {
                assertEquals(negative ? Float.NEGATIVE_INFINITY : Float.POSITIVE_INFINITY, got);
            } else if ((half & 0x7fff) > 0x7c00) {
                assertTrue(Float.isNaN(got));
            } else {
                assertEquals(
                        Float.floatToRawIntBits((float) value(half)), Float.floatToRawIntBits(got), "half " + half);
            }
        }
    }

    @Test
    void everyHalfComesBackFromItsFloat() {
        for (int half = 0; half < 1 << 16; half++) {
            assertEquals((short) half, Half.fromFloat(Half.toFloat((short) half)), "half " + half);
        }
    }

    @Test
    void tiesBetweenNeighboursGoToTheEvenOneAndAnythingBesidesToTheNearest() {
        for (int half = 0; half < 0x7c00; half++) {
            // The step above the largest finite half ends at 65536, which stands for infinity.
            double low = value(half);
            double high = half == 0x7bff ? 65536 : value(half + 1);
            // Exact: one bit more than a half's mantissa.
            float tie = (float) ((low + high) / 2);
            assertEquals((low + high) / 2, tie);
            int even = (half & 1) == 0 ? half : half + 1;
            assertConversion(half, Math.nextDown(tie));
            assertConversion(even, tie);
            assertConversion(half + 1, Math.nextUp(tie));
        }
    }

    private static void assertConversion(int half, float value) {
        assertEquals(half, Half.fromFloat(value) & 0xffff, "float " + value);
        assertEquals(half | 0x8000, Half.fromFloat(-value) & 0xffff, "float " + -value);
    }

    @Test
    void floatsOfEveryExponentAreRoundedToTheNearestHalf() {
        SplittableRandom random = new SplittableRandom(1);
        for (int exponent = 0; exponent < 255; exponent++) {
            for (int i = 0; i < 2000; i++) {
                float value = Float.intBitsToFloat((exponent << 23) | random.nextInt(1 << 23));
                int half = Half.fromFloat(value) & 0xffff;
                if (value >= 65520) {
                    assertEquals(0x7c00, half);
                    continue;
                }
                double error = Math.abs(value(half) - value);
                double errorBelow = half == 0 ? error : Math.abs(value(half - 1) - value);
                double errorAbove = half == 0x7bff ? error : Math.abs(value(half + 1) - value);
                assertTrue(error <= errorBelow && error <= errorAbove, "float " + value);
            }
        }
    }

    @Test
    void specialValuesStaySpecial() {
        assertEquals((short) 0x7c00, Half.fromFloat(Float.POSITIVE_INFINITY));
        assertEquals((short) 0xfc00, Half.fromFloat(Float.NEGATIVE_INFINITY));
        assertEquals((short) 0x7c00, Half.fromFloat(Float.MAX_VALUE));
        assertEquals((short) 0x7bff, Half.fromFloat(Half.MAX_VALUE));
        assertEquals((short) 0x8000, Half.fromFloat(-0f));
        assertEquals((short) 0, Half.fromFloat(Float.MIN_VALUE));
        assertEquals((short) 1, Half.fromFloat(Half.MIN_VALUE));
        assertEquals((short) 0x400, Half.fromFloat(Half.MIN_NORMAL));
        assertTrue(Float.isNaN(Half.toFloat(Half.fromFloat(Float.NaN))));
        // A payload in the lower bits alone must not be cut to an infinity.
        assertEquals((short) 0x7c01, Half.fromFloat(Float.intBitsToFloat(0x7f800001)));
    }
}
