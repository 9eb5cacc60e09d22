package org.daybreak.scenes.build;

import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/** What values are as colours in linear RGB. */
public final class LinearColors {
    /**
     * Linear sRGB of illuminant E with luminance near 1: what a spectrum that is 1 at all wavelengths is as light. The values
     * are Mitsuba's.
     */
    private static final double[] EQUAL_ENERGY = {1.204795, 0.948291, 0.908916};

    private LinearColors() {}

    /**
     * The colour that a value is where a type is asked for: spectra are other colours as light than on surfaces.
     *
     * @return red, green and blue with the primaries of sRGB; null if the value is no colour
     */
    public static double @Nullable [] of(Value value, ValueType type) {
        boolean emission = type == ValueType.EMISSION || type == ValueType.TEXTURED_EMISSION;
        if (value instanceof Value.Color c) {
            return new double[] {c.r(), c.g(), c.b()};
        }
        if (value instanceof Value.FlatSpectrum s) {
            double v = s.value();
            return emission
                    ? new double[] {v * EQUAL_ENERGY[0], v * EQUAL_ENERGY[1], v * EQUAL_ENERGY[2]}
                    : new double[] {v, v, v};
        }
        if (value instanceof Value.SampledSpectrum s) {
            Value.Color c = emission ? s.light() : s.surface();
            // Saturated reflectances lie outside the primaries: the nearest colour inside stands for them.
            double limit = type == ValueType.REFLECTANCE ? 1 : Double.POSITIVE_INFINITY;
            return new double[] {Math.min(limit, c.r()), Math.min(limit, c.g()), Math.min(limit, c.b())};
        }
        Double n = number(value);
        return n == null ? null : new double[] {n, n, n};
    }

    /** The number that a value is, null if it is none. */
    static @Nullable Double number(Value value) {
        if (value instanceof Value.WholeNumber n) {
            return (double) n.value();
        }
        return value instanceof Value.RealNumber r ? (Double) r.value() : null;
    }
}
