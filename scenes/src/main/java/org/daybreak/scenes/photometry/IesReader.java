package org.daybreak.scenes.photometry;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.daybreak.core.light.PhotometricProfile;

/**
 * Reads photometric files of the Illuminating Engineering Society (ANSI/IESNA LM-63-1995 and -2002, and files of 1986 and 1991,
 * which differ in the header only). Type C photometry; TILT=NONE, or TILT=INCLUDE, which is read over, since a luminaire is
 * used as it was measured. The lamp's output, multiplier and ballast factor are applied.
 */
public final class IesReader {
    private static final long LARGEST_FILE = 1 << 24;
    private static final int MOST_VALUES = 1 << 20;

    private final BufferedReader lines;
    private int line;
    private String[] words = {};
    private int next;

    private IesReader(BufferedReader lines) {
        this.lines = lines;
    }

    /**
     * Reads a file.
     *
     * @throws IOException if it cannot be read or is no such file; the message tells the line and what is wrong
     */
    public static PhotometricProfile read(Path file) throws IOException {
        if (Files.size(file) > LARGEST_FILE) {
            throw new IOException("the file is larger than " + LARGEST_FILE + " bytes");
        }
        return parse(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1));
    }

    /** Reads the content of a file; errors as of {@link #read}. */
    public static PhotometricProfile parse(String text) throws IOException {
        return new IesReader(new BufferedReader(new StringReader(text))).parse();
    }

    private PhotometricProfile parse() throws IOException {
        readHeader();
        integer("number of lamps", 1, 1_000_000);
        number("lumens per lamp");
        double multiplier = number("candela multiplier");
        int verticalCount = integer("number of vertical angles", 1, MOST_VALUES);
        int horizontalCount = integer("number of horizontal angles", 1, MOST_VALUES);
        int type = integer("photometric type", 1, 3);
        if (type != 1) {
            throw error("type " + (type == 2 ? 'B' : 'A') + " photometry is not supported, only type C");
        }
        integer("units type", 1, 2);
        number("width");
        number("length");
        number("height");
        double ballast = number("ballast factor");
        double futureUse = number("ballast-lamp photometric factor");
        number("input watts");
        if ((long) verticalCount * horizontalCount > MOST_VALUES) {
            throw error("there are more than " + MOST_VALUES + " candela values");
        }
        double[] vertical = numbers("vertical angle", verticalCount);
        double[] horizontal = numbers("horizontal angle", horizontalCount);
        double[] candela = numbers("candela value", verticalCount * horizontalCount);
        // Files of 1986 to 1995 may have 0 for what is now the second factor.
        double factor = multiplier * ballast * (futureUse > 0 ? futureUse : 1);
        for (int i = 0; i < candela.length; i++) {
            candela[i] *= factor;
        }
        try {
            return new PhotometricProfile(vertical, horizontal, candela);
        } catch (IllegalArgumentException e) {
            throw error(String.valueOf(e.getMessage()), e);
        }
    }

    /** Reads up to the line TILT=…, and what follows it if it is INCLUDE. */
    private void readHeader() throws IOException {
        String text;
        do {
            text = lines.readLine();
            line++;
            if (text == null) {
                throw error("there is no line TILT=: this is no IES file");
            }
            text = text.trim();
        } while (!text.toUpperCase(Locale.ROOT).startsWith("TILT="));
        String tilt = text.substring(5).trim().toUpperCase(Locale.ROOT);
        if (tilt.equals("INCLUDE")) {
            integer("lamp to luminaire geometry", 1, 3);
            int count = integer("number of tilt angles", 1, MOST_VALUES);
            numbers("tilt angle", count);
            numbers("tilt factor", count);
        } else if (!tilt.equals("NONE")) {
            throw error("TILT must be NONE or INCLUDE but is '" + tilt + "'");
        }
    }

    private double[] numbers(String what, int count) throws IOException {
        double[] values = new double[count];
        for (int i = 0; i < count; i++) {
            values[i] = number(what);
        }
        return values;
    }

    private int integer(String what, int smallest, int largest) throws IOException {
        double value = number(what);
        if (!(value >= smallest && value <= largest) || value != Math.rint(value)) {
            throw error(
                    "the " + what + " must be a whole number from " + smallest + " to " + largest + " but is " + value);
        }
        return (int) value;
    }

    private double number(String what) throws IOException {
        while (next == words.length) {
            String text = lines.readLine();
            line++;
            if (text == null) {
                throw error("the file ends where a " + what + " is expected");
            }
            String trimmed = text.replace(',', ' ').trim();
            words = trimmed.isEmpty() ? new String[0] : trimmed.split("\\s+", -1);
            next = 0;
        }
        String word = words[next++];
        try {
            double value = Double.parseDouble(word);
            if (Double.isFinite(value) && !word.endsWith("f") && !word.endsWith("d")) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw error("'" + word + "' is no " + what, e);
        }
        throw error("'" + word + "' is no " + what);
    }

    private IOException error(String message) {
        return new IOException("line " + line + ": " + message);
    }

    private IOException error(String message, Exception cause) {
        return new IOException("line " + line + ": " + message, cause);
    }
}
