package org.daybreak.core.render;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * One typed parameter of a renderer or antialiasing method: the single definition from which command-line options,
 * option pages, documentation tables and validation are derived.
 *
 * @param name machine name, lower camel case, as in {@code -P name=value}
 * @param label the label users see, the thesis' wording where it has one
 * @param type kind of value
 * @param defaultValue default, in the form {@link #parse} returns
 * @param minimum smallest admissible number (numbers only)
 * @param maximum largest admissible number (numbers only)
 * @param choices admissible words (choices only)
 * @param doc one or two sentences on what it does, units included
 */
public record Parameter(
        String name,
        String label,
        Type type,
        Object defaultValue,
        double minimum,
        double maximum,
        List<String> choices,
        String doc) {
    /** Kind of a parameter's value and the Java type that carries it. */
    public enum Type {
        /** {@link Integer} */
        INTEGER,
        /** {@link Double} */
        REAL,
        /** {@link Boolean} */
        BOOLEAN,
        /** {@link String}, one of the choices */
        CHOICE,
        /** {@link String}, numbers with commas between them */
        REALS,
        /** {@link String}, the name of a folder that a program writes images into, or empty for none */
        FOLDER
    }

    /** Copies the choices and checks that the default is admissible. */
    public Parameter {
        choices = List.copyOf(choices);
    }

    /** A whole number in {@code [minimum, maximum]}. */
    public static Parameter integer(String name, String label, int defaultValue, int minimum, int maximum, String doc) {
        return new Parameter(name, label, Type.INTEGER, defaultValue, minimum, maximum, List.of(), doc);
    }

    /** A real number in {@code [minimum, maximum]}. */
    public static Parameter real(
            String name, String label, double defaultValue, double minimum, double maximum, String doc) {
        return new Parameter(name, label, Type.REAL, defaultValue, minimum, maximum, List.of(), doc);
    }

    /** One or more real numbers in {@code [minimum, maximum]}, with commas between them. */
    public static Parameter reals(
            String name, String label, String defaultValue, double minimum, double maximum, String doc) {
        return new Parameter(name, label, Type.REALS, defaultValue, minimum, maximum, List.of(), doc);
    }

    /** A switch. */
    public static Parameter flag(String name, String label, boolean defaultValue, String doc) {
        return new Parameter(name, label, Type.BOOLEAN, defaultValue, 0, 1, List.of("true", "false"), doc);
    }

    /** One word out of several. */
    public static Parameter choice(String name, String label, String defaultValue, List<String> choices, String doc) {
        return new Parameter(name, label, Type.CHOICE, defaultValue, 0, 0, choices, doc);
    }

    /**
     * A folder for images besides the film's, none by default. The renderer only learns whether one is given: it hands the images out
     * ({@link RenderReport#sheets()}, under the name of the parameter), and the program that called it writes them. The
     * image does not depend on it.
     */
    public static Parameter folder(String name, String label, String doc) {
        return new Parameter(name, label, Type.FOLDER, "", 0, 0, List.of(), doc);
    }

    /**
     * Parses and validates a value.
     *
     * @throws ParameterException with a message that names parameter, value and what is admissible
     */
    public Object parse(String text) {
        String t = text.trim();
        return switch (type) {
            case INTEGER -> parseInteger(t, text);
            case REAL -> parseReal(t, text);
            case REALS -> parseReals(text);
            case BOOLEAN -> parseFlag(t, text);
            case CHOICE -> {
                if (!choices.contains(t)) {
                    throw invalid(text, null);
                }
                yield t;
            }
            case FOLDER -> {
                if (t.indexOf('\0') >= 0) {
                    throw invalid(text, null);
                }
                yield t;
            }
        };
    }

    private Integer parseInteger(String trimmed, String text) {
        int value;
        try {
            value = Integer.parseInt(trimmed);
        } catch (NumberFormatException e) {
            throw invalid(text, e);
        }
        if (!(value >= minimum && value <= maximum)) {
            throw invalid(text, null);
        }
        return value;
    }

    private String parseReals(String text) {
        List<String> numbers = new ArrayList<>();
        for (String number : text.split(",", -1)) {
            numbers.add(parseReal(number.trim(), text).toString());
        }
        return String.join(",", numbers);
    }

    private Double parseReal(String trimmed, String text) {
        double value;
        try {
            value = Double.parseDouble(trimmed);
        } catch (NumberFormatException e) {
            throw invalid(text, e);
        }
        if (!(value >= minimum && value <= maximum)) {
            throw invalid(text, null);
        }
        return value;
    }

    private Boolean parseFlag(String trimmed, String text) {
        return switch (trimmed.toLowerCase(Locale.ROOT)) {
            case "true" -> true;
            case "false" -> false;
            default -> throw invalid(text, null);
        };
    }

    /** The admissible values in words: {@code "a whole number from 1 to 64"}. */
    public String range() {
        return switch (type) {
            case INTEGER -> "a whole number" + bounds(true);
            case REAL -> "a number" + bounds(false);
            case REALS -> "numbers" + bounds(false) + ", with commas between them";
            case BOOLEAN -> "true or false";
            case CHOICE -> "one of " + String.join(", ", choices);
            case FOLDER -> "the name of a folder";
        };
    }

    private String bounds(boolean whole) {
        boolean noMaximum = maximum >= (whole ? Integer.MAX_VALUE : Double.MAX_VALUE);
        boolean noMinimum = minimum <= (whole ? Integer.MIN_VALUE : -Double.MAX_VALUE);
        if (noMaximum && noMinimum) {
            return "";
        }
        if (noMaximum) {
            return ", at least " + number(minimum, whole);
        }
        return noMinimum
                ? ", at most " + number(maximum, whole)
                : " from " + number(minimum, whole) + " to " + number(maximum, whole);
    }

    private static String number(double value, boolean whole) {
        return whole ? Long.toString((long) value) : Double.toString(value);
    }

    private ParameterException invalid(String text, @org.jspecify.annotations.Nullable Exception cause) {
        return new ParameterException("parameter '" + name + "' is '" + text + "' but must be " + range(), cause);
    }
}
