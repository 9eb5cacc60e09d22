package org.daybreak.exr;

/**
 * The transfer curve of sRGB (IEC 61966-2-1): how linear light in [0, 1] is encoded in display values in [0, 1].
 */
public final class SrgbTransfer {
    private SrgbTransfer() {}

    /**
     * Encodes linear light.
     *
     * @param linear linear value; below 0 counts as 0, above 1 as 1, NaN as 0
     * @return 12.92 x up to x = 0.0031308, above that 1.055 x<sup>1/2.4</sup> − 0.055
     */
    public static double encode(double linear) {
        if (!(linear > 0)) {
            return 0;
        }
        if (linear >= 1) {
            return 1;
        }
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055;
    }

    /**
     * Encodes linear light in 8 bits.
     *
     * @param linear linear value, clamped as by {@link #encode}
     * @return the nearest of 0 to 255 to 255 × {@link #encode}
     */
    public static int encode8Bit(double linear) {
        return (int) (255 * encode(linear) + 0.5);
    }

    /**
     * Decodes a display value.
     *
     * @param encoded value in [0, 1]; values outside are clamped, NaN counts as 0
     * @return linear light: v / 12.92 up to v = 0.04045, above that ((v + 0.055) / 1.055)<sup>2.4</sup>
     */
    public static double decode(double encoded) {
        if (!(encoded > 0)) {
            return 0;
        }
        if (encoded >= 1) {
            return 1;
        }
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }
}
