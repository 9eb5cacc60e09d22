package org.daybreak.core.color;

/** The transfer function of sRGB, with the constants of IEC 61966-2-1, both ways. */
public final class ColorSpaces {
    private static final double[] LINEAR_OF_BYTE = linearOfByte();

    private ColorSpaces() {}

    /**
     * Linear value of an sRGB-encoded value; [0, 1] maps onto [0, 1].
     *
     * @param encoded encoded value; negative values continue the linear part
     */
    public static double srgbToLinear(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }

    /**
     * sRGB encoding of a linear value; [0, 1] maps onto [0, 1].
     *
     * @param linear linear value; negative values continue the linear part
     */
    public static double linearToSrgb(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
    }

    /**
     * Linear value of an 8-bit sRGB code, from a table.
     *
     * @param code 0 … 255
     * @throws IndexOutOfBoundsException if the code is outside
     */
    public static double srgbByteToLinear(int code) {
        return LINEAR_OF_BYTE[code];
    }

    /**
     * 8-bit sRGB code of a linear value, rounded to nearest and clamped.
     *
     * @return 0 … 255; 0 for NaN
     */
    public static int linearToSrgbByte(double linear) {
        double code = 255 * linearToSrgb(linear) + 0.5;
        return (int) Math.min(Math.max(code, 0), 255);
    }

    private static double[] linearOfByte() {
        double[] table = new double[256];
        for (int i = 0; i < table.length; i++) {
            table[i] = srgbToLinear(i / 255.0);
        }
        return table;
    }
}
