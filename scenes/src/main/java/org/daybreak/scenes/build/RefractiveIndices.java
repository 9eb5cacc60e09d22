package org.daybreak.scenes.build;

import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;

/** Refractive indices of substances by name: visible light, room temperature; the names and values of Mitsuba. */
final class RefractiveIndices {
    private static final Map<String, Double> BY_NAME = new TreeMap<>(Map.ofEntries(
            Map.entry("vacuum", 1.0),
            Map.entry("helium", 1.000036),
            Map.entry("hydrogen", 1.000132),
            Map.entry("air", 1.000277),
            Map.entry("carbon dioxide", 1.00045),
            Map.entry("water", 1.3330),
            Map.entry("acetone", 1.36),
            Map.entry("ethanol", 1.361),
            Map.entry("carbon tetrachloride", 1.461),
            Map.entry("glycerol", 1.4729),
            Map.entry("benzene", 1.501),
            Map.entry("silicone oil", 1.52045),
            Map.entry("bromine", 1.661),
            Map.entry("water ice", 1.31),
            Map.entry("fused quartz", 1.458),
            Map.entry("pyrex", 1.470),
            Map.entry("acrylic glass", 1.49),
            Map.entry("polypropylene", 1.49),
            Map.entry("bk7", 1.5046),
            Map.entry("sodium chloride", 1.544),
            Map.entry("amber", 1.55),
            Map.entry("pet", 1.5750),
            Map.entry("diamond", 2.419)));

    private RefractiveIndices() {}

    static OptionalDouble of(String name) {
        Double value = BY_NAME.get(name.strip().toLowerCase(Locale.ROOT));
        return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    static Set<String> names() {
        return BY_NAME.keySet();
    }
}
