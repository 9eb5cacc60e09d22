package org.daybreak.exr;

import java.io.ByteArrayOutputStream;
import org.jspecify.annotations.Nullable;

/** The scan lines of {@link RadianceHdr}: pixels of three mantissas and an exponent, packed in one of three ways. */
final class RgbeScanLine {
    /** The new encoding exists for these lengths only. */
    private static final int MIN_PACKED_LENGTH = 8;

    private static final int MAX_PACKED_LENGTH = 0x7fff;
    private static final int MAX_STRETCH = 128;
    private static final int MAX_RUN = 127;
    private static final int MIN_RUN = 4;
    private static final int BIAS = 128;
    private static final String WHAT = "a scan line";

    private static final float[] UNITS = new float[256];

    static {
        for (int exponent = 1; exponent < UNITS.length; exponent++) {
            UNITS[exponent] = Math.scalb(1f, exponent - BIAS - Byte.SIZE);
        }
    }

    private RgbeScanLine() {}

    /** What a mantissa is multiplied by. */
    static float unit(int exponent) {
        return UNITS[exponent];
    }

    /** Reads a scan line of {@code length} pixels, four bytes each. */
    static void read(ImageSource source, byte[] rgbe, int length) throws ImageFileException {
        walk(source, rgbe, length);
    }

    /** Checks a scan line without keeping it. */
    static void skip(ImageSource source, int length) throws ImageFileException {
        walk(source, null, length);
    }

    private static void walk(ImageSource source, byte @Nullable [] rgbe, int length) throws ImageFileException {
        long start = source.position();
        if (length >= MIN_PACKED_LENGTH && length <= MAX_PACKED_LENGTH) {
            int first = source.readByte(WHAT);
            int second = source.readByte(WHAT);
            int high = source.readByte(WHAT);
            int low = source.readByte(WHAT);
            if (first == 2 && second == 2 && high < 128) {
                if ((high << 8 | low) != length) {
                    throw source.error("the file is damaged: a scan line has " + (high << 8 | low)
                            + " pixels instead of " + length);
                }
                walkComponents(source, rgbe, length);
                return;
            }
            source.seek(start);
        }
        walkPixels(source, rgbe, length);
    }

    /** The new encoding: all mantissas of the first component, then of the second, … , each in runs and stretches. */
    private static void walkComponents(ImageSource source, byte @Nullable [] rgbe, int length)
            throws ImageFileException {
        for (int component = 0; component < 4; component++) {
            int x = 0;
            while (x < length) {
                int code = source.readByte(WHAT);
                boolean run = code > MAX_STRETCH;
                int count = run ? code - MAX_STRETCH : code;
                if (count == 0 || count > length - x) {
                    throw source.error("the file is damaged: a run does not fit its scan line");
                }
                int value = run ? source.readByte(WHAT) : 0;
                for (int i = 0; i < count; i++, x++) {
                    int now = run ? value : source.readByte(WHAT);
                    if (rgbe != null) {
                        rgbe[4 * x + component] = (byte) now;
                    }
                }
            }
        }
    }

    /**
     * Flat or old encoding: pixel by pixel. The mantissas (1, 1, 1) repeat the pixel before as often as the fourth byte
     * says; of several of these in sequence, each counts 256 times as much as the one before.
     */
    private static void walkPixels(ImageSource source, byte @Nullable [] rgbe, int length) throws ImageFileException {
        int x = 0;
        int shift = 0;
        byte[] before = new byte[4];
        while (x < length) {
            int r = source.readByte(WHAT);
            int g = source.readByte(WHAT);
            int b = source.readByte(WHAT);
            int e = source.readByte(WHAT);
            if (r != 1 || g != 1 || b != 1) {
                before[0] = (byte) r;
                before[1] = (byte) g;
                before[2] = (byte) b;
                before[3] = (byte) e;
                put(before, rgbe, x, 1);
                x++;
                shift = 0;
                continue;
            }
            // Also ends a sequence of counts of 0, which would go on for ever.
            if (x == 0 || shift > 24 || (long) e << shift > length - x) {
                throw source.error("the file is damaged: a run does not fit its scan line");
            }
            put(before, rgbe, x, e << shift);
            x += e << shift;
            shift += 8;
        }
    }

    private static void put(byte[] pixel, byte @Nullable [] rgbe, int x, int count) {
        if (rgbe == null) {
            return;
        }
        for (int i = x; i < x + count; i++) {
            System.arraycopy(pixel, 0, rgbe, 4 * i, 4);
        }
    }

    /** Rounds a pixel to the nearest mantissas for the exponent of its largest component. */
    static void encode(float[] samples, int at, byte[] rgbe, int out) {
        float r = clamp(samples[at]);
        float g = clamp(samples[at + 1]);
        float b = clamp(samples[at + 2]);
        float largest = Math.max(r, Math.max(g, b));
        // The largest component is in [2^(exponent - 1), 2^exponent), or smaller than all that the format has exponents
        // for.
        int exponent = Math.max(Math.getExponent((double) largest) + 1, 1 - BIAS);
        if (Math.rint(Math.scalb((double) largest, Byte.SIZE - exponent)) > 255) {
            exponent++;
        }
        double scale = Math.scalb(1.0, Byte.SIZE - exponent);
        int red = (int) Math.rint(r * scale);
        int green = (int) Math.rint(g * scale);
        int blue = (int) Math.rint(b * scale);
        boolean black = (red | green | blue) == 0;
        rgbe[out] = (byte) red;
        rgbe[out + 1] = (byte) green;
        rgbe[out + 2] = (byte) blue;
        rgbe[out + 3] = (byte) (black ? 0 : exponent + BIAS);
    }

    private static float clamp(float value) {
        return value > 0 ? Math.min(value, 0x1.FEp126f) : 0;
    }

    /** Packs a scan line, or leaves it flat if its length does not allow that. */
    static void write(byte[] rgbe, int length, ByteArrayOutputStream out) {
        if (length < MIN_PACKED_LENGTH || length > MAX_PACKED_LENGTH) {
            writeFlat(rgbe, length, out);
            return;
        }
        out.write(2);
        out.write(2);
        out.write(length >> 8);
        out.write(length);
        for (int component = 0; component < 4; component++) {
            int x = 0;
            while (x < length) {
                int run = runLength(rgbe, component, x, length);
                if (run >= MIN_RUN) {
                    out.write(MAX_STRETCH + run);
                    out.write(rgbe[4 * x + component]);
                    x += run;
                    continue;
                }
                int end = x + run;
                while (end < length && end - x < MAX_STRETCH && runLength(rgbe, component, end, length) < MIN_RUN) {
                    end++;
                }
                end = Math.min(end, x + MAX_STRETCH);
                out.write(end - x);
                for (; x < end; x++) {
                    out.write(rgbe[4 * x + component]);
                }
            }
        }
    }

    private static int runLength(byte[] rgbe, int component, int start, int end) {
        int limit = Math.min(end, start + MAX_RUN);
        int i = start + 1;
        while (i < limit && rgbe[4 * i + component] == rgbe[4 * start + component]) {
            i++;
        }
        return i - start;
    }

    /**
     * Writes pixel by pixel. The mantissas (1, 1, 1), which would be taken for a repetition, come with the least exponent
     * only and stand for 2<sup>−135</sup> there, which is written as black.
     */
    private static void writeFlat(byte[] rgbe, int length, ByteArrayOutputStream out) {
        for (int at = 0; at < 4 * length; at += 4) {
            boolean marker = rgbe[at] == 1 && rgbe[at + 1] == 1 && rgbe[at + 2] == 1;
            for (int c = 0; c < 4; c++) {
                out.write(marker ? 0 : rgbe[at + c]);
            }
        }
    }
}
