package org.daybreak.scenes.mesh;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/**
 * A buffered reader of bytes, text tokens and numbers that counts lines. One class for text and binary, as PLY files change
 * from one to the other.
 */
final class ByteSource implements Closeable {
    private static final int CAPACITY = 1 << 16;
    private static final int LONGEST_TOKEN = 1 << 12;

    /** The bits of a double that a float has no room for, and their value half-way between two floats. */
    private static final long FLOAT_TAIL = (1L << 29) - 1;

    private static final long FLOAT_MIDDLE = 1L << 28;

    /** Powers of ten that are exact in double precision. */
    private static final double[] POWERS = powers();

    private final InputStream stream;
    private final byte[] buffer = new byte[CAPACITY];
    private int position;
    private int limit;
    private int line = 1;
    private int tokenStart;
    private int tokenEnd;
    private boolean ended;

    ByteSource(InputStream stream) {
        this.stream = stream;
    }

    @Override
    public void close() throws IOException {
        stream.close();
    }

    /** Line the next byte is on, from 1. */
    int line() {
        return line;
    }

    /** The next byte as 0 to 255 without consuming it, -1 at the end. */
    int peek() throws IOException {
        if (position == limit && !fill(1)) {
            return -1;
        }
        return buffer[position] & 0xff;
    }

    /** Consumes and returns the next byte as 0 to 255, -1 at the end. */
    int next() throws IOException {
        if (position == limit && !fill(1)) {
            return -1;
        }
        int b = buffer[position++] & 0xff;
        if (b == '\n') {
            line++;
        }
        return b;
    }

    /** Skips the rest of the line with its end. */
    void skipLine() throws IOException {
        int b = next();
        while (b != '\n' && b != -1) {
            b = next();
        }
    }

    /** Skips blanks but not line ends, other than those that a backslash joins. Returns the byte that follows. */
    int skipBlanks() throws IOException {
        while (true) {
            while (position < limit && isBlank(buffer[position])) {
                position++;
            }
            int b = peek();
            if (b == '\\' && joinsLines()) {
                skipLine();
            } else if (b == -1 || !isBlank(b)) {
                return b;
            }
        }
    }

    private static boolean isBlank(int b) {
        return b == ' ' || b == '\t' || b == '\r';
    }

    private boolean joinsLines() throws IOException {
        if (limit - position < 3) {
            fill(3);
        }
        int after = position + 1;
        if (after < limit && buffer[after] == '\r') {
            after++;
        }
        return after < limit && buffer[after] == '\n';
    }

    /** Skips blanks and line ends. Returns the byte that follows. */
    int skipSpace() throws IOException {
        while (true) {
            int b = skipBlanks();
            if (b != '\n') {
                return b;
            }
            next();
        }
    }

    /** Finds the token up to the next blank, line end or given byte, in the buffer. It may be empty. */
    private void readToken(int stop) throws IOException {
        if (limit - position < LONGEST_TOKEN) {
            fill(LONGEST_TOKEN);
        }
        int end = position;
        int farthest = Math.min(limit, position + LONGEST_TOKEN);
        while (end < farthest && (buffer[end] > ' ' || buffer[end] < 0) && buffer[end] != stop) {
            end++;
        }
        if (end - position == LONGEST_TOKEN) {
            throw new MeshFormatException(line, "a word is longer than " + (LONGEST_TOKEN - 1) + " characters");
        }
        tokenStart = position;
        tokenEnd = end;
        position = end;
    }

    /** Reads a word. Empty at the end of the line or file. */
    String word() throws IOException {
        readToken(-1);
        return tokenText();
    }

    /** Reads the rest of the line without the blanks around it, and leaves its end. */
    String restOfLine() throws IOException {
        StringBuilder text = new StringBuilder();
        int b = peek();
        while (b != '\n' && b != -1) {
            if (text.length() == LONGEST_TOKEN) {
                throw new MeshFormatException(line, "a name is longer than " + LONGEST_TOKEN + " characters");
            }
            text.append((char) next());
            b = peek();
        }
        return new String(text.toString().strip().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    }

    private String tokenText() {
        return new String(buffer, tokenStart, tokenEnd - tokenStart, StandardCharsets.ISO_8859_1);
    }

    /**
     * Reads a number that is finite in single precision.
     *
     * @param what what the number is, for messages
     * @param index number of the element it belongs to, for messages; none if negative
     */
    float single(String what, long index) throws IOException {
        readToken(-1);
        float value = parseSingle();
        if (Float.isNaN(value)) {
            String name = index < 0 ? what : what + index;
            throw new MeshFormatException(
                    line,
                    tokenStart == tokenEnd
                            ? name + " is missing"
                            : name + " '" + tokenText() + "' is not a finite number in single precision");
        }
        return value;
    }

    /**
     * Reads a whole number that ends at a blank, a line end or a given byte.
     *
     * @param what what the number is, for messages
     */
    long wholeNumber(String what, int stop) throws IOException {
        readToken(stop);
        int i = tokenStart;
        boolean negative = false;
        if (i < tokenEnd && (buffer[i] == '-' || buffer[i] == '+')) {
            negative = buffer[i++] == '-';
        }
        long value = 0;
        int first = i;
        while (i < tokenEnd && buffer[i] >= '0' && buffer[i] <= '9' && i - first < 18) {
            value = 10 * value + buffer[i++] - '0';
        }
        if (i == first || i < tokenEnd) {
            throw new MeshFormatException(
                    line,
                    tokenStart == tokenEnd
                            ? what + " is missing"
                            : what + " '" + tokenText() + "' is not a whole number");
        }
        return negative ? -value : value;
    }

    /**
     * The number in the token, correctly rounded; NaN if it is none or not finite. Up to 18 digits times a power of ten give
     * a double that is off by less than 2 units in its last place. Unless that lies near the middle between two floats, the
     * float nearest to it is the right one.
     */
    private float parseSingle() {
        int i = tokenStart;
        boolean negative = false;
        if (i < tokenEnd && (buffer[i] == '-' || buffer[i] == '+')) {
            negative = buffer[i++] == '-';
        }
        long mantissa = 0;
        int digits = 0;
        int power = 0;
        boolean any = false;
        boolean point = false;
        for (; i < tokenEnd; i++) {
            int c = buffer[i];
            if (c >= '0' && c <= '9') {
                if (digits == 18) {
                    return parseSlowly();
                }
                any = true;
                mantissa = 10 * mantissa + c - '0';
                digits += mantissa == 0 ? 0 : 1;
                power -= point ? 1 : 0;
            } else if (c == '.' && !point) {
                point = true;
            } else {
                break;
            }
        }
        if (!any || i < tokenEnd || power < -22) {
            return parseSlowly();
        }
        double value = mantissa / POWERS[-power];
        long tail = Double.doubleToRawLongBits(value) & FLOAT_TAIL;
        if (Math.abs(tail - FLOAT_MIDDLE) <= 4 || (value < Float.MIN_NORMAL && value > 0) || value > Float.MAX_VALUE) {
            return parseSlowly();
        }
        return (float) (negative ? -value : value);
    }

    private float parseSlowly() {
        for (int i = tokenStart; i < tokenEnd; i++) {
            int c = buffer[i];
            if (!((c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E')) {
                return Float.NaN;
            }
        }
        try {
            float value = Float.parseFloat(tokenText());
            return Float.isInfinite(value) ? Float.NaN : value;
        } catch (NumberFormatException e) {
            return Float.NaN;
        }
    }

    /** The next byte of binary data. */
    int uint8() throws IOException {
        require(1);
        return buffer[position++] & 0xff;
    }

    /** The next two bytes of binary data. */
    int uint16(boolean bigEndian) throws IOException {
        require(2);
        int a = buffer[position++] & 0xff;
        int b = buffer[position++] & 0xff;
        return bigEndian ? (a << 8) | b : (b << 8) | a;
    }

    /** The next four bytes of binary data. */
    int int32(boolean bigEndian) throws IOException {
        require(4);
        int p = position;
        position = p + 4;
        int little = (buffer[p] & 0xff)
                | (buffer[p + 1] & 0xff) << 8
                | (buffer[p + 2] & 0xff) << 16
                | (buffer[p + 3] & 0xff) << 24;
        return bigEndian ? Integer.reverseBytes(little) : little;
    }

    /** The next eight bytes of binary data. */
    long int64(boolean bigEndian) throws IOException {
        long a = int32(bigEndian) & 0xffffffffL;
        long b = int32(bigEndian) & 0xffffffffL;
        return bigEndian ? (a << 32) | b : (b << 32) | a;
    }

    /** Skips bytes of binary data. */
    void skip(long bytes) throws IOException {
        long left = bytes;
        while (left > 0) {
            require(1);
            int step = (int) Math.min(left, limit - position);
            position += step;
            left -= step;
        }
    }

    private void require(int bytes) throws IOException {
        if (limit - position < bytes && !fill(bytes)) {
            throw new MeshFormatException(0, "the file ends in the middle of its data");
        }
    }

    /** Tries to have some bytes in the buffer. */
    private boolean fill(int bytes) throws IOException {
        if (ended) {
            return limit - position >= bytes;
        }
        System.arraycopy(buffer, position, buffer, 0, limit - position);
        limit -= position;
        position = 0;
        while (limit < bytes) {
            int n = stream.read(buffer, limit, CAPACITY - limit);
            if (n < 0) {
                ended = true;
                return false;
            }
            limit += n;
        }
        return true;
    }

    private static double[] powers() {
        double[] p = new double[23];
        p[0] = 1;
        for (int i = 1; i < p.length; i++) {
            p[i] = 10 * p[i - 1];
        }
        return p;
    }
}
