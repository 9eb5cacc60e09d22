package org.daybreak.scenes.mitsuba;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.color.SpectralColors;
import org.daybreak.core.render.NearestName;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.mitsuba.Numbers.FormatException;

/**
 * Parses spectra. Those by wavelength are converted to linear RGB by {@link SpectralColors}, as Mitsuba's RGB mode does: what
 * is 1 at all wavelengths is white on a surface and as light that of illuminant E. In the dialect of Mitsuba 0.6 a
 * single number and three of them are RGB everywhere.
 */
final class Spectra {
    private static final List<String> TYPES = List.of("blackbody", "d65", "irregular", "regular", "uniform");

    /** Files of measured spectra have some hundred lines; a larger file is none. */
    private static final long LARGEST_FILE = 1 << 20;

    private Spectra() {}

    /** A spectrum in an attribute: a number, wavelengths with values, or a file of them. */
    static Value ofAttributes(
            Map<String, String> attributes, SourceLocation location, MitsubaReader reader, boolean old)
            throws FormatException {
        String file = attributes.get("filename");
        String value = attributes.get("value");
        if ((file == null) == (value == null)) {
            throw new FormatException("<spectrum> needs one of the attributes 'value' and 'filename'");
        }
        if (value == null) {
            return fromFile(file == null ? "" : file, location, reader);
        }
        if (value.contains(":")) {
            return sampled(pairs(value));
        }
        if (!old) {
            return new Value.FlatSpectrum(Numbers.real(value));
        }
        return Numbers.linearColor(value);
    }

    /** Light of a black body. The temperature may carry the unit K. */
    static Value blackbody(Map<String, String> attributes) throws FormatException {
        String temperature = attributes.getOrDefault("temperature", "").strip();
        boolean unit = temperature.endsWith("K") || temperature.endsWith("k");
        return blackbody(
                Numbers.real(unit ? temperature.substring(0, temperature.length() - 1) : temperature),
                Numbers.real(attributes.getOrDefault("scale", "1")));
    }

    private static Value blackbody(double kelvin, double scale) throws FormatException {
        if (!(kelvin > 0)) {
            throw new FormatException("the temperature of a black body must be positive but is " + kelvin);
        }
        double[] rgb = SpectralColors.blackbody(kelvin);
        return new Value.Color(scale * rgb[0], scale * rgb[1], scale * rgb[2]);
    }

    /** A spectrum that is written as an object of one of Mitsuba 3's types. */
    static Value ofObject(String type, List<PropertyDescription> properties, MitsubaReader reader)
            throws FormatException {
        Map<String, PropertyDescription> byName = new HashMap<>();
        for (PropertyDescription p : properties) {
            byName.put(p.name(), p);
        }
        Value result = switch (type) {
            case "uniform" -> new Value.FlatSpectrum(number(byName, "value", 1));
            // Its colour is the white of RGB.
            case "d65" -> grey(number(byName, "scale", 1));
            case "blackbody" -> blackbody(number(byName, "temperature", 5000), number(byName, "scale", 1));
            case "irregular" -> sampled(new double[][] {list(byName, "wavelengths"), list(byName, "values")});
            case "regular" -> {
                double from = number(byName, "wavelength_min", CIE_FIRST);
                double to = number(byName, "wavelength_max", CIE_LAST);
                double[] values = list(byName, "values");
                double[] wavelengths = new double[values.length];
                for (int i = 0; i < values.length; i++) {
                    wavelengths[i] = from + (to - from) * i / Math.max(1, values.length - 1);
                }
                yield sampled(new double[][] {wavelengths, values});
            }
            default ->
                throw new FormatException(
                        "spectrum type '" + type + "' is not supported" + NearestName.hint(type, TYPES));
        };
        for (PropertyDescription left : byName.values()) {
            reader.problems()
                    .error(left.location(), "<spectrum type=\"" + type + "\"> has no property '" + left.name() + "'");
        }
        return result;
    }

    private static final double CIE_FIRST = 360;
    private static final double CIE_LAST = 830;

    private static Value.Color grey(double value) {
        return new Value.Color(value, value, value);
    }

    private static double number(Map<String, PropertyDescription> properties, String name, double otherwise)
            throws FormatException {
        PropertyDescription p = properties.remove(name);
        if (p == null) {
            return otherwise;
        }
        if (p.value() instanceof Value.RealNumber r) {
            return r.value();
        }
        if (p.value() instanceof Value.WholeNumber n) {
            return n.value();
        }
        throw new FormatException(
                "'" + name + "' must be a float but is " + p.value().description());
    }

    private static double[] list(Map<String, PropertyDescription> properties, String name) throws FormatException {
        PropertyDescription p = properties.remove(name);
        if (p == null || !(p.value() instanceof Value.Text text)) {
            throw new FormatException("'" + name + "' must be given as a string of numbers");
        }
        return Numbers.list(text.value());
    }

    /** Parses {@code 400:0.1, 500:0.2}. */
    private static double[][] pairs(String text) throws FormatException {
        String[] words = text.strip().split("[\\s,]+", -1);
        List<double[]> pairs = new ArrayList<>();
        for (String word : words) {
            int colon = word.indexOf(':');
            if (colon < 0) {
                throw new FormatException("'" + Numbers.shortened(word) + "' is not of the form wavelength:value");
            }
            pairs.add(new double[] {Numbers.real(word.substring(0, colon)), Numbers.real(word.substring(colon + 1))});
        }
        return columns(pairs);
    }

    private static Value fromFile(String name, SourceLocation location, MitsubaReader reader) throws FormatException {
        Path file = reader.resolve(name, location);
        String text;
        try {
            if (file == null || Files.size(file) > LARGEST_FILE) {
                throw new FormatException("'" + name + "' is no file of a spectrum");
            }
            text = Files.readString(file, StandardCharsets.ISO_8859_1);
        } catch (IOException e) {
            throw new FormatException("cannot read the spectrum " + file + ": " + e);
        }
        List<double[]> pairs = new ArrayList<>();
        int line = 0;
        for (String l : text.split("\n", -1)) {
            line++;
            String content = l.strip();
            if (content.isEmpty() || content.startsWith("#")) {
                continue;
            }
            double[] pair = Numbers.list(content);
            if (pair.length != 2) {
                throw new FormatException(file + ":" + line + ": expected a wavelength and a value");
            }
            pairs.add(pair);
        }
        return sampled(columns(pairs));
    }

    private static double[][] columns(List<double[]> pairs) {
        double[][] columns = new double[2][pairs.size()];
        for (int i = 0; i < pairs.size(); i++) {
            columns[0][i] = pairs.get(i)[0];
            columns[1][i] = pairs.get(i)[1];
        }
        return columns;
    }

    private static Value sampled(double[][] columns) throws FormatException {
        double[] wavelengths = columns[0];
        double[] values = columns[1];
        if (wavelengths.length != values.length || values.length < 2) {
            throw new FormatException("a spectrum needs as many values as wavelengths and at least 2 but has "
                    + wavelengths.length + " wavelengths and " + values.length + " values");
        }
        for (int i = 0; i < values.length; i++) {
            if (i > 0 && !(wavelengths[i] > wavelengths[i - 1])) {
                throw new FormatException("the wavelengths of a spectrum must ascend but " + wavelengths[i]
                        + " follows " + wavelengths[i - 1]);
            }
            if (values[i] < 0) {
                throw new FormatException(
                        "a spectrum must not be negative but is " + values[i] + " at " + wavelengths[i] + " nm");
            }
        }
        return new Value.SampledSpectrum(
                color(SpectralColors.reflectance(wavelengths, values)),
                color(SpectralColors.emission(wavelengths, values)));
    }

    private static Value.Color color(double[] rgb) {
        return new Value.Color(rgb[0], rgb[1], rgb[2]);
    }
}
