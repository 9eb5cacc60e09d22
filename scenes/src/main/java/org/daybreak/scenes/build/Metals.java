package org.daybreak.scenes.build;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.daybreak.core.color.Spectrum;
import org.jspecify.annotations.Nullable;

/**
 * Complex refractive indices of metals by chemical symbol, as linear RGB. Measured values of Johnson and Christy (Phys. Rev. B
 * 6, 4370, 1972, and 9, 5056, 1974) and, for aluminium, Rakić (Appl. Opt. 34, 4755, 1995), as collected, in the public
 * domain (CC0), by refractiveindex.info; linear between the measurements from 380 to 780 nm, weighted by the CIE 1931
 * colour matching functions, XYZ divided by ∫ȳ, and taken to RGB.
 *
 * <p>The conversion is Mitsuba's, and like there an index of 1 at all wavelengths becomes the colour of illuminant E: red is
 * some 20 % too high, green and blue 5 to 9 % too low. Mitsuba's measurements are others: reflectances along the normal
 * differ by up to 0.07, those of chromium by up to 0.17.
 */
final class Metals {
    /** A complex refractive index. The spectra must not be changed. */
    record ComplexIndex(Spectrum eta, Spectrum k) {}

    private static final Map<String, ComplexIndex> BY_NAME = new TreeMap<>(Map.ofEntries(
            Map.entry("Ag", index(0.0666, 0.0519, 0.0389, 5.1837, 3.3534, 2.3049)),
            Map.entry("Al", index(1.7447, 0.9331, 0.5326, 9.1197, 6.2185, 4.8250)),
            Map.entry("Au", index(0.1263, 0.4663, 1.3430, 4.2397, 2.2093, 1.6460)),
            Map.entry("Co", index(2.6890, 1.9301, 1.5444, 5.0426, 3.5985, 2.9222)),
            Map.entry("Cr", index(3.8848, 2.9546, 2.0513, 3.9668, 3.1655, 2.8305)),
            Map.entry("Cu", index(0.2815, 0.9869, 1.1799, 3.9226, 2.4600, 2.1394)),
            Map.entry("Fe", index(3.5145, 2.7698, 2.3018, 3.6950, 2.7861, 2.4930)),
            Map.entry("Ni", index(2.4232, 1.8044, 1.5635, 4.9730, 3.3846, 2.6033)),
            Map.entry("Ni_palik", index(2.4232, 1.8044, 1.5635, 4.9730, 3.3846, 2.6033)),
            Map.entry("Pd", index(2.1381, 1.5374, 1.2592, 5.1871, 3.6143, 2.8956)),
            Map.entry("Ti", index(3.2754, 2.3798, 2.0247, 4.5724, 3.2245, 2.7278)),
            Map.entry("V", index(4.2117, 3.7588, 3.2748, 3.6021, 2.9185, 3.1646)),
            Map.entry("V_palik", index(4.2117, 3.7588, 3.2748, 3.6021, 2.9185, 3.1646))));

    private Metals() {}

    private static ComplexIndex index(double er, double eg, double eb, double kr, double kg, double kb) {
        return new ComplexIndex(new Spectrum(er, eg, eb), new Spectrum(kr, kg, kb));
    }

    /** The index of a metal, or null if there is none of that name. */
    static @Nullable ComplexIndex of(String name) {
        return BY_NAME.get(name);
    }

    static Set<String> names() {
        return BY_NAME.keySet();
    }
}
