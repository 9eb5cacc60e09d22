package org.daybreak.exr;

/**
 * Conversion between {@code float} and IEEE 754 binary16 ("half"): 1 sign bit, 5 exponent bits (bias 15), 10 mantissa
 * bits. Each half is a float exactly; floats are rounded to the nearest half, ties to the even one.
 */
public final class Half {
    /** The largest finite half. Floats from 65520 on (half a step above it) become infinite. */
    public static final float MAX_VALUE = 65504f;

    /** The smallest positive normal half, 2<sup>−14</sup>. */
    public static final float MIN_NORMAL = 0x1p-14f;

    /** The smallest positive half, 2<sup>−24</sup>. */
    public static final float MIN_VALUE = 0x1p-24f;

    private static final int FLOAT_INFINITY_BITS = 0x7f800000;

    private Half() {}

    /**
     * Rounds a float to the nearest half, ties to even. Beyond the range it becomes infinite, below it a denormal or a
     * zero; the sign stays. A NaN stays a NaN and keeps its upper payload bits.
     *
     * @param value any float
     * @return the bits of the half
     */
    public static short fromFloat(float value) {
        int bits = Float.floatToRawIntBits(value);
        int sign = (bits >>> 16) & 0x8000;
        int magnitude = bits & 0x7fffffff;
        if (magnitude >= 0x38800000) {
            if (magnitude > FLOAT_INFINITY_BITS) {
                int payload = (magnitude >>> 13) & 0x3ff;
                // Payload bits below the cut would leave an infinity.
                return (short) (sign | 0x7c00 | Math.max(payload, 1));
            }
            if (magnitude >= 0x47800000) {
                return (short) (sign | 0x7c00);
            }
            // Exponent from bias 127 to bias 15. A carry out of the mantissa raises the exponent, up to infinity.
            int rebiased = magnitude - (112 << 23);
            return (short) (sign | ((rebiased + 0xfff + ((rebiased >>> 13) & 1)) >>> 13));
        }
        // Up to and including 2^-25, half of the smallest half, all goes to zero (the tie to the even zero).
        if (magnitude <= 0x33000000) {
            return (short) sign;
        }
        int shift = 126 - (magnitude >>> 23);
        int mantissa = (magnitude & 0x7fffff) | 0x800000;
        int quotient = mantissa >>> shift;
        int remainder = mantissa & ((1 << shift) - 1);
        int tie = 1 << (shift - 1);
        if (remainder > tie || (remainder == tie && (quotient & 1) != 0)) {
            quotient++;
        }
        return (short) (sign | quotient);
    }

    /**
     * Returns the float that equals a half. A NaN keeps its payload.
     *
     * @param half the bits of the half
     * @return the same value
     */
    public static float toFloat(short half) {
        int sign = (half & 0x8000) << 16;
        int exponent = half & 0x7c00;
        int mantissa = half & 0x3ff;
        if (exponent == 0) {
            float magnitude = (float) mantissa * MIN_VALUE;
            return sign != 0 ? -magnitude : magnitude;
        }
        int rebias = exponent == 0x7c00 ? FLOAT_INFINITY_BITS : (exponent << 13) + (112 << 23);
        return Float.intBitsToFloat(sign | rebias | (mantissa << 13));
    }
}
