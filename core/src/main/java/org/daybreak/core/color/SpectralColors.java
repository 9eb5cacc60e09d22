package org.daybreak.core.color;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * Conversion of spectra to linear sRGB with the colour-matching functions of the CIE 1931 2° observer.
 *
 * <p>The two conversions differ in their white, as in the RGB mode of Mitsuba 3: a surface that reflects everything is
 * (1, 1, 1), as seen under D65; light of the same power at all wavelengths is that of illuminant E, (1.205, 0.948,
 * 0.909), whose luminance is 1.
 */
public final class SpectralColors {
    private static final double PLANCK = 6.62607015e-34;
    private static final double LIGHT_SPEED = 299_792_458;
    private static final double BOLTZMANN = 1.380649e-23;

    /** hc/k in nm·K. */
    private static final double SECOND_RADIATION_CONSTANT = PLANCK * LIGHT_SPEED / BOLTZMANN * 1e9;

    /** 2hc² in W·nm⁴/(m²·sr): radiance per nm of wavelength is this over λ⁵ (exp(c₂/λT) − 1). */
    private static final double FIRST_RADIATION_CONSTANT = 2 * PLANCK * LIGHT_SPEED * LIGHT_SPEED * 1e36;

    private static final int STEPS_PER_NANOMETRE = 8;

    private SpectralColors() {}

    /**
     * Linear sRGB of a reflectance, transmittance or refractive index: the response under D65, relative to that of a perfect
     * white.
     *
     * @param wavelengths in nm, ascending
     * @param values value at each wavelength; linear between them and 0 outside
     * @return three components, those below 0 raised to 0; they can slightly exceed the largest value
     */
    public static double[] reflectance(double[] wavelengths, double[] values) {
        return convert(x -> interpolate(wavelengths, values, x) * table(CieTables.D65, x), CieTables.D65);
    }

    /**
     * Linear sRGB of a spectral radiance, intensity or irradiance: XYZ with ∫V = 1.
     *
     * @param wavelengths in nm, ascending
     * @param values power per nm at each wavelength; linear between them and 0 outside
     * @return three components, those below 0 raised to 0
     */
    public static double[] emission(double[] wavelengths, double[] values) {
        return convert(x -> interpolate(wavelengths, values, x), null);
    }

    /**
     * Linear sRGB of the radiance of a black body by Planck's law, per nm of wavelength, in W/(m²·sr·nm).
     *
     * @param kelvin temperature, positive
     */
    public static double[] blackbody(double kelvin) {
        return convert(
                x -> FIRST_RADIATION_CONSTANT / (Math.pow(x, 5) * Math.expm1(SECOND_RADIATION_CONSTANT / (x * kelvin))),
                null);
    }

    /** Midpoint rule; spectra may begin and end abruptly, which limits its precision. */
    private static double[] convert(DoubleUnaryOperator spectrum, double @Nullable [] white) {
        double x = 0;
        double y = 0;
        double z = 0;
        double norm = 0;
        int steps = STEPS_PER_NANOMETRE * (CieTables.LAST - CieTables.FIRST);
        for (int i = 0; i < steps; i++) {
            double nm = CieTables.FIRST + (i + 0.5) / STEPS_PER_NANOMETRE;
            double value = spectrum.applyAsDouble(nm);
            double yBar = table(CieTables.Y_BAR, nm);
            x += value * table(CieTables.X_BAR, nm);
            y += value * yBar;
            z += value * table(CieTables.Z_BAR, nm);
            norm += yBar * (white == null ? 1 : table(white, nm));
        }
        return linearSrgb(x / norm, y / norm, z / norm);
    }

    /** The matrix of IEC 61966-2-1 with the digits of ITU-R BT.709 that renderers use. */
    private static double[] linearSrgb(double x, double y, double z) {
        return new double[] {
            Math.max(0, 3.240479 * x - 1.537150 * y - 0.498535 * z),
            Math.max(0, -0.969256 * x + 1.875991 * y + 0.041556 * z),
            Math.max(0, 0.055648 * x - 0.204043 * y + 1.057311 * z)
        };
    }

    private static double table(double[] table, double nm) {
        double at = (nm - CieTables.FIRST) / CieTables.STEP;
        int i = Math.min((int) at, table.length - 2);
        return table[i] + (at - i) * (table[i + 1] - table[i]);
    }

    private static double interpolate(double[] wavelengths, double[] values, double nm) {
        int at = Arrays.binarySearch(wavelengths, nm);
        if (at >= 0) {
            return values[at];
        }
        int above = -at - 1;
        if (above == 0 || above == wavelengths.length) {
            return 0;
        }
        double t = (nm - wavelengths[above - 1]) / (wavelengths[above] - wavelengths[above - 1]);
        return values[above - 1] + t * (values[above] - values[above - 1]);
    }
}
