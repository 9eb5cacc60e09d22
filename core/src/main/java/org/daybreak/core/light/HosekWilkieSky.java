package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;

/**
 * Hosek and Wilkie, “An Analytic Model for Full Spectral Sky-Dome Radiance”, SIGGRAPH 2012, in its RGB form, and the sun of
 * “Adding a Solar Radiance Function to the Hosek Skylight Model”, IEEE CG&A 33(3), 2013.
 */
final class HosekWilkieSky implements SkyModel {
    /** The integral of the CIE 1931 ȳ curve in nanometres: what turns the data's RGB into a mean over wavelengths. */
    static final double Y_INTEGRAL = 106.75025939941406;

    /** Half the angle under which the data see the sun, in radians. */
    static final double SUN_HALF_ANGLE = Math.toRadians(0.5 * 0.5358);

    /** Factor of the sun's RGB data to the units of the sky's. */
    private static final double SUN_UNITS = 467.069280386;

    /** Binomial coefficients of a Bézier curve of degree 5. */
    private static final double[] BINOMIALS = {1, 5, 10, 10, 5, 1};

    /** Nine parameters and the mean radiance for each channel. */
    private final double[][] channels = new double[3][HosekWilkieData.PARAMETERS + 1];

    HosekWilkieSky(double turbidity, double[] albedo, double sunZenithAngle) {
        HosekWilkieData data = HosekWilkieData.load();
        double elevation = Math.max(0, Math.PI / 2 - sunZenithAngle);
        double x = Math.cbrt(elevation / (Math.PI / 2));
        int low = Math.min((int) turbidity, HosekWilkieData.TURBIDITIES - 1) - 1;
        double blend = turbidity - 1 - low;
        for (int t = 0; t < 2; t++) {
            for (int a = 0; a < 2; a++) {
                for (int p = 0; p < HosekWilkieData.CONTROL_POINTS; p++) {
                    double bernstein = BINOMIALS[p] * Math.pow(x, p) * Math.pow(1 - x, 5 - p);
                    double weight = bernstein * (t == 0 ? 1 - blend : blend);
                    for (int c = 0; c < 3; c++) {
                        double w = weight * (a == 0 ? 1 - albedo[c] : albedo[c]);
                        for (int k = 0; k < HosekWilkieData.PARAMETERS; k++) {
                            channels[c][k] += w * data.parameter(low + t, a, p, c, k);
                        }
                        channels[c][HosekWilkieData.PARAMETERS] += w * data.radiance(low + t, a, p, c);
                    }
                }
            }
        }
    }

    @Override
    public void radiance(double cosTheta, double gamma, Spectrum out) {
        out.set(channel(0, cosTheta, gamma), channel(1, cosTheta, gamma), channel(2, cosTheta, gamma));
    }

    /** Equations 8 and 9 of the paper. */
    private double channel(int c, double cosTheta, double gamma) {
        double[] p = channels[c];
        double cosGamma = Math.cos(gamma);
        double squared = cosGamma * cosGamma;
        double anisotropy = 1 + p[8] * p[8] - 2 * p[8] * cosGamma;
        double chi = (1 + squared) / (anisotropy * Math.sqrt(anisotropy));
        double first = 1 + p[0] * Math.exp(p[1] / (cosTheta + 0.01));
        double second = p[2] + p[3] * Math.exp(p[4] * gamma) + p[5] * squared + p[6] * chi + p[7] * Math.sqrt(cosTheta);
        return Math.max(0, first * second * p[9] / Y_INTEGRAL);
    }

    /**
     * Mean radiance over the sun's disk, in the units of {@link SkyModel}; by quadrature over rings and azimuths of the
     * data's disk, what is below the horizon being black. The rings have equal steps of cos ψ, in which the darkening of the
     * limb is a polynomial, and so the weight 2 cos ψ.
     */
    static Spectrum meanSunRadiance(double turbidity, double sunZenithAngle) {
        HosekWilkieData data = HosekWilkieData.load();
        double elevation = Math.PI / 2 - sunZenithAngle;
        int low = Math.min((int) turbidity, HosekWilkieData.TURBIDITIES - 1) - 1;
        double blend = turbidity - 1 - low;
        double[] sum = new double[3];
        int rings = 64;
        int azimuths = 16;
        for (int i = 0; i < rings; i++) {
            double cosPsi = (i + 0.5) / rings;
            double radius = Math.sqrt(1 - cosPsi * cosPsi);
            for (int j = 0; j < azimuths; j++) {
                double azimuth = 2 * Math.PI * (j + 0.5) / azimuths;
                double e = elevation + SUN_HALF_ANGLE * radius * Math.sin(azimuth);
                if (e < 0) {
                    continue;
                }
                int segment = (int)
                        Math.min(HosekWilkieData.SEGMENTS - 1, Math.cbrt(2 * e / Math.PI) * HosekWilkieData.SEGMENTS);
                double start = Math.PI / 2 * Math.pow((double) segment / HosekWilkieData.SEGMENTS, 3);
                for (int c = 0; c < 3; c++) {
                    double value = (1 - blend) * sun(data, low, segment, c, e - start, cosPsi)
                            + blend * sun(data, low + 1, segment, c, e - start, cosPsi);
                    sum[c] += 2 * cosPsi * value;
                }
            }
        }
        double scale = SUN_UNITS / (Y_INTEGRAL * rings * azimuths);
        return new Spectrum(Math.max(0, scale * sum[0]), Math.max(0, scale * sum[1]), Math.max(0, scale * sum[2]));
    }

    private static double sun(HosekWilkieData data, int turbidity, int segment, int channel, double x, double cosPsi) {
        double sum = 0;
        for (int k = HosekWilkieData.POWERS - 1; k >= 0; k--) {
            double darkening = 0;
            for (int j = HosekWilkieData.DARKENING - 1; j >= 0; j--) {
                darkening = darkening * cosPsi + data.sun(turbidity, segment, channel, k, j);
            }
            sum = sum * x + darkening;
        }
        return sum;
    }
}
