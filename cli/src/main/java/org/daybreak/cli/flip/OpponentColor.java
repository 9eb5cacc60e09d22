package org.daybreak.cli.flip;

/** Conversions between linear RGB and the opponent colour spaces of FLIP (2020, section 4.1). */
final class OpponentColor {
    /** Rows: X, Y, Z of linear Rec. 709 with white D65, from the chromaticities as exact fractions. */
    private static final double[] TO_XYZ = {
        10135552 / 24577794.0, 8788810 / 24577794.0, 4435075 / 24577794.0,
        2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0,
        1425312 / 73733382.0, 8788810 / 73733382.0, 70074185 / 73733382.0
    };

    private static final double[] TO_RGB = inverse(TO_XYZ);
    private static final double WHITE_X = TO_XYZ[0] + TO_XYZ[1] + TO_XYZ[2];
    private static final double WHITE_Z = TO_XYZ[6] + TO_XYZ[7] + TO_XYZ[8];
    private static final double LAB_BEND = 6.0 / 29;

    private OpponentColor() {}

    /** YCxCz of linear RGB: L*a*b* without its cube root. */
    static void toYcxcz(double r, double g, double b, double[] out) {
        double x = (TO_XYZ[0] * r + TO_XYZ[1] * g + TO_XYZ[2] * b) / WHITE_X;
        double y = TO_XYZ[3] * r + TO_XYZ[4] * g + TO_XYZ[5] * b;
        double z = (TO_XYZ[6] * r + TO_XYZ[7] * g + TO_XYZ[8] * b) / WHITE_Z;
        out[0] = 116 * y - 16;
        out[1] = 500 * (x - y);
        out[2] = 200 * (y - z);
    }

    /** Hunt-adjusted L*a*b* of YCxCz, clamped to the RGB cube in between. */
    static void toHuntLab(double luma, double cx, double cz, double[] out) {
        double y = (luma + 16) / 116;
        double x = (y + cx / 500) * WHITE_X;
        double z = (y - cz / 200) * WHITE_Z;
        double r = clamp(TO_RGB[0] * x + TO_RGB[1] * y + TO_RGB[2] * z);
        double g = clamp(TO_RGB[3] * x + TO_RGB[4] * y + TO_RGB[5] * z);
        double b = clamp(TO_RGB[6] * x + TO_RGB[7] * y + TO_RGB[8] * z);
        double fx = curve((TO_XYZ[0] * r + TO_XYZ[1] * g + TO_XYZ[2] * b) / WHITE_X);
        double fy = curve(TO_XYZ[3] * r + TO_XYZ[4] * g + TO_XYZ[5] * b);
        double fz = curve((TO_XYZ[6] * r + TO_XYZ[7] * g + TO_XYZ[8] * b) / WHITE_Z);
        double lightness = 116 * fy - 16;
        out[0] = lightness;
        out[1] = 0.01 * lightness * 500 * (fx - fy);
        out[2] = 0.01 * lightness * 200 * (fy - fz);
    }

    private static double clamp(double value) {
        return Math.max(0, Math.min(1, value));
    }

    private static double curve(double t) {
        return t > LAB_BEND * LAB_BEND * LAB_BEND ? Math.cbrt(t) : t / (3 * LAB_BEND * LAB_BEND) + 4.0 / 29;
    }

    private static double[] inverse(double[] m) {
        double[] cofactors = {
            m[4] * m[8] - m[5] * m[7], m[2] * m[7] - m[1] * m[8], m[1] * m[5] - m[2] * m[4],
            m[5] * m[6] - m[3] * m[8], m[0] * m[8] - m[2] * m[6], m[2] * m[3] - m[0] * m[5],
            m[3] * m[7] - m[4] * m[6], m[1] * m[6] - m[0] * m[7], m[0] * m[4] - m[1] * m[3]
        };
        double determinant = m[0] * cofactors[0] + m[1] * cofactors[3] + m[2] * cofactors[6];
        for (int i = 0; i < cofactors.length; i++) {
            cofactors[i] /= determinant;
        }
        return cofactors;
    }
}
