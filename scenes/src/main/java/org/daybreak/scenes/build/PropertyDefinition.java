package org.daybreak.scenes.build;

import java.util.List;
import java.util.Locale;
import org.daybreak.scenes.description.ObjectKind;
import org.jspecify.annotations.Nullable;

/**
 * A property that objects of a type may have: the single definition of its name, type, default, range and documentation.
 *
 * @param name name in files; for nested objects, which are told apart by their kind, the kind
 * @param type kind of value
 * @param defaultValue default as files would write it, null if there is none
 * @param required whether it must be given
 * @param minimum smallest admissible number; for nested objects, smallest number of them
 * @param maximum largest admissible number; for nested objects, largest number of them
 * @param choices admissible words
 * @param kind kind of the nested objects, else null
 * @param doc what it does, units included
 */
public record PropertyDefinition(
        String name,
        ValueType type,
        @Nullable String defaultValue,
        boolean required,
        double minimum,
        double maximum,
        List<String> choices,
        @Nullable ObjectKind kind,
        String doc) {
    /** Copies the choices. */
    public PropertyDefinition {
        choices = List.copyOf(choices);
    }

    static PropertyDefinition value(String name, ValueType type, String defaultValue, String doc) {
        return new PropertyDefinition(
                name,
                type,
                defaultValue,
                false,
                Double.NEGATIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                List.of(),
                null,
                doc);
    }

    static PropertyDefinition optional(String name, ValueType type, String doc) {
        return new PropertyDefinition(
                name, type, null, false, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, List.of(), null, doc);
    }

    static PropertyDefinition choice(String name, @Nullable String defaultValue, List<String> choices, String doc) {
        return new PropertyDefinition(name, ValueType.CHOICE, defaultValue, false, 0, 0, choices, null, doc);
    }

    static PropertyDefinition objects(ObjectKind kind, int minimum, int maximum, String doc) {
        return new PropertyDefinition(
                kind.element(), ValueType.OBJECT, null, minimum > 0, minimum, maximum, List.of(), kind, doc);
    }

    PropertyDefinition between(double smallest, double largest) {
        return new PropertyDefinition(name, type, defaultValue, required, smallest, largest, choices, kind, doc);
    }

    PropertyDefinition positive() {
        return between(Double.MIN_VALUE, Double.POSITIVE_INFINITY);
    }

    PropertyDefinition asRequired() {
        return new PropertyDefinition(name, type, defaultValue, true, minimum, maximum, choices, kind, doc);
    }

    /** What may be given, in words: {@code "a float greater than 0"}. */
    public String values() {
        return switch (type) {
            case INTEGER -> "an integer" + range(true);
            case FLOAT -> "a float" + range(false);
            case BOOLEAN -> "a boolean";
            case STRING -> "a string";
            case CHOICE -> "one of " + String.join(", ", choices);
            case FILE -> "a file name";
            case MESH -> "a mesh";
            case POINT -> "a point";
            case REFRACTIVE_INDEX -> "a float greater than 0 or the name of a substance";
            case COLOR -> "an rgb or a float";
            case REFLECTANCE -> "an rgb, a float or a texture with values from 0 to 1";
            case TEXTURED_NUMBER -> "a float or a texture with values" + range(false);
            case EMISSION -> "an rgb or a float, not negative";
            case TEXTURED_EMISSION -> "an rgb, a float or a texture, not negative";
            case TRANSFORM -> "a transform";
            case OBJECT -> objectCount();
        };
    }

    private String objectCount() {
        String what = "<" + name + ">";
        if (maximum == 1) {
            return minimum == 1 ? "one " + what : "at most one " + what;
        }
        if (minimum == maximum) {
            return "exactly " + (int) minimum + " " + what;
        }
        if (maximum < Integer.MAX_VALUE) {
            return (int) minimum + " to " + (int) maximum + " " + what;
        }
        return minimum == 0 ? "any number of " + what : "at least " + (int) minimum + " " + what;
    }

    private String range(boolean whole) {
        boolean below = minimum > Double.NEGATIVE_INFINITY;
        boolean above = maximum < (whole ? Integer.MAX_VALUE : Double.MAX_VALUE);
        if (minimum == Double.MIN_VALUE) {
            return above ? " greater than 0, at most " + number(maximum, whole) : " greater than 0";
        }
        if (below && above) {
            return " from " + number(minimum, whole) + " to " + number(maximum, whole);
        }
        return below ? ", at least " + number(minimum, whole) : above ? ", at most " + number(maximum, whole) : "";
    }

    private static String number(double value, boolean whole) {
        return whole || value == Math.rint(value) ? String.format(Locale.ROOT, "%.0f", value) : Double.toString(value);
    }
}
