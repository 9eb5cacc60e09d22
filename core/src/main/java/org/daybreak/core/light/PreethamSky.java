package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;

/** Preetham, Shirley and Smits, “A Practical Analytic Model for Daylight”, SIGGRAPH 1999, appendix A.2. */
final class PreethamSky implements SkyModel {
    /** Slope and intercept in the turbidity of the five coefficients of Perez' formula, for Y, x and y. */
    private static final double[][] PEREZ = {
        {0.1787, -1.4630, -0.3554, 0.4275, -0.0227, 5.3251, 0.1206, -2.5771, -0.0670, 0.3703},
        {-0.0193, -0.2592, -0.0665, 0.0008, -0.0004, 0.2125, -0.0641, -0.8989, -0.0033, 0.0452},
        {-0.0167, -0.2608, -0.0950, 0.0092, -0.0079, 0.2102, -0.0441, -1.6537, -0.0109, 0.0529}
    };

    /** Coefficients of the zenith's chromaticity x and y: powers 2, 1, 0 of turbidity by powers 3 … 0 of the sun's angle. */
    private static final double[][] ZENITH = {
        {0.00166, -0.00375, 0.00209, 0, -0.02903, 0.06377, -0.03202, 0.00394, 0.11693, -0.21196, 0.06052, 0.25886},
        {0.00275, -0.00610, 0.00317, 0, -0.04214, 0.08970, -0.04153, 0.00516, 0.15346, -0.26756, 0.06670, 0.26688}
    };

    /** Candela per watt and steradian at the peak of the eye's response. */
    private static final double EFFICACY = 683.002;

    private final double[][] perez = new double[3][5];
    /** Zenith values over Perez' formula there. */
    private final double[] scale = new double[3];

    PreethamSky(double turbidity, double sunZenithAngle) {
        double theta = Math.min(sunZenithAngle, Math.PI / 2);
        for (int c = 0; c < 3; c++) {
            for (int k = 0; k < 5; k++) {
                perez[c][k] = PEREZ[c][2 * k] * turbidity + PEREZ[c][2 * k + 1];
            }
        }
        double chi = (4.0 / 9 - turbidity / 120) * (Math.PI - 2 * theta);
        // In kcd/m²; the fit goes below 0 for a low sun in very clear air.
        double luminance = (4.0453 * turbidity - 4.9710) * Math.tan(chi) - 0.2155 * turbidity + 2.4192;
        double perNanometre = 1000 / (EFFICACY * HosekWilkieSky.Y_INTEGRAL);
        scale[0] = Math.max(0, luminance) * perNanometre / perez(0, 1, theta);
        for (int c = 0; c < 2; c++) {
            double value = 0;
            for (int i = 0; i < 3; i++) {
                double[] z = ZENITH[c];
                double row = ((z[4 * i] * theta + z[4 * i + 1]) * theta + z[4 * i + 2]) * theta + z[4 * i + 3];
                value = value * turbidity + row;
            }
            scale[c + 1] = value / perez(c + 1, 1, theta);
        }
    }

    private double perez(int c, double cosTheta, double gamma) {
        double[] p = perez[c];
        double cosGamma = Math.cos(gamma);
        return (1 + p[0] * Math.exp(p[1] / Math.max(cosTheta, 1e-3)))
                * (1 + p[2] * Math.exp(p[3] * gamma) + p[4] * cosGamma * cosGamma);
    }

    @Override
    public void radiance(double cosTheta, double gamma, Spectrum out) {
        double luminance = scale[0] * perez(0, cosTheta, gamma);
        double x = scale[1] * perez(1, cosTheta, gamma);
        double y = scale[2] * perez(2, cosTheta, gamma);
        if (!(luminance > 0) || !(y > 0)) {
            out.setZero();
            return;
        }
        double bigX = luminance * x / y;
        double bigZ = luminance * (1 - x - y) / y;
        // XYZ to linear RGB with the primaries of Rec. 709 and white D65 (IEC 61966-2-1).
        out.set(
                Math.max(0, 3.240479 * bigX - 1.537150 * luminance - 0.498535 * bigZ),
                Math.max(0, -0.969256 * bigX + 1.875991 * luminance + 0.041556 * bigZ),
                Math.max(0, 0.055648 * bigX - 0.204043 * luminance + 1.057311 * bigZ));
    }
}
