package org.daybreak.scenes.mitsuba;

import java.util.regex.Pattern;
import org.daybreak.core.color.ColorSpaces;
import org.daybreak.scenes.description.Value;

/** Parses the values of attributes. */
final class Numbers {
    private static final Pattern SEPARATOR = Pattern.compile("[\\s,]+");

    private Numbers() {}

    /** A value that does not follow the rules, with a message fit for users. */
    static final class FormatException extends Exception {
        private static final long serialVersionUID = 1L;

        FormatException(String message) {
            super(message);
        }
    }

    /** A finite number. */
    static double real(String text) throws FormatException {
        String t = text.strip();
        for (int i = 0; i < t.length(); i++) {
            char c = t.charAt(i);
            if (!((c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E')) {
                throw notANumber(text);
            }
        }
        try {
            double value = Double.parseDouble(t);
            if (Double.isInfinite(value)) {
                throw notANumber(text);
            }
            return value;
        } catch (NumberFormatException e) {
            throw notANumber(text);
        }
    }

    private static FormatException notANumber(String text) {
        return new FormatException("'" + shortened(text) + "' is not a finite number");
    }

    /** A whole number. */
    static long whole(String text) throws FormatException {
        try {
            return Long.parseLong(text.strip());
        } catch (NumberFormatException e) {
            throw new FormatException("'" + shortened(text) + "' is not a whole number");
        }
    }

    /** True or false, in any case. */
    static boolean truth(String text) throws FormatException {
        String t = text.strip();
        if (t.equalsIgnoreCase("true")) {
            return true;
        }
        if (t.equalsIgnoreCase("false")) {
            return false;
        }
        throw new FormatException("'" + shortened(text) + "' is neither true nor false");
    }

    /** Numbers separated by blanks or commas. */
    static double[] list(String text) throws FormatException {
        String t = text.strip();
        if (t.isEmpty()) {
            return new double[0];
        }
        String[] words = SEPARATOR.split(t, -1);
        double[] values = new double[words.length];
        for (int i = 0; i < words.length; i++) {
            values[i] = real(words[i]);
        }
        return values;
    }

    /** Exactly three numbers. */
    static double[] three(String text) throws FormatException {
        double[] values = list(text);
        if (values.length != 3) {
            throw new FormatException("'" + shortened(text) + "' must be three numbers");
        }
        return values;
    }

    /** A linear colour: three numbers, one for grey, or {@code #rrggbb} in sRGB. */
    static Value.Color linearColor(String text) throws FormatException {
        if (text.strip().startsWith("#")) {
            return hexColor(text);
        }
        double[] rgb = oneOrThree(text);
        return new Value.Color(rgb[0], rgb[1], rgb[2]);
    }

    /** A colour encoded by the sRGB transfer function: three numbers in [0, 1], one for grey, or {@code #rrggbb}. */
    static Value.Color encodedColor(String text) throws FormatException {
        if (text.strip().startsWith("#")) {
            return hexColor(text);
        }
        double[] rgb = oneOrThree(text);
        for (double value : rgb) {
            if (!(value >= 0 && value <= 1)) {
                throw new FormatException("'" + shortened(text) + "': sRGB values must lie between 0 and 1");
            }
        }
        return new Value.Color(
                ColorSpaces.srgbToLinear(rgb[0]), ColorSpaces.srgbToLinear(rgb[1]), ColorSpaces.srgbToLinear(rgb[2]));
    }

    private static Value.Color hexColor(String text) throws FormatException {
        String t = text.strip();
        try {
            if (t.length() == 7 && t.charAt(1) != '-' && t.charAt(1) != '+') {
                int rgb = Integer.parseInt(t.substring(1), 16);
                return new Value.Color(
                        ColorSpaces.srgbByteToLinear((rgb >> 16) & 0xff),
                        ColorSpaces.srgbByteToLinear((rgb >> 8) & 0xff),
                        ColorSpaces.srgbByteToLinear(rgb & 0xff));
            }
        } catch (NumberFormatException e) {
            throw new FormatException("'" + shortened(text) + "' is not a colour like #ff8000");
        }
        throw new FormatException("'" + shortened(text) + "' is not a colour like #ff8000");
    }

    private static double[] oneOrThree(String text) throws FormatException {
        double[] values = list(text);
        if (values.length == 1) {
            return new double[] {values[0], values[0], values[0]};
        }
        if (values.length != 3) {
            throw new FormatException("'" + shortened(text) + "' must be one or three numbers");
        }
        return values;
    }

    /** A text short enough for a message. */
    static String shortened(String text) {
        return text.length() <= 60 ? text : text.substring(0, 57) + "...";
    }
}
