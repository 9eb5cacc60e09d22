package org.daybreak.exr;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads and writes Radiance HDR files (RGBE, {@code .hdr} or {@code .pic}). A pixel is three 8-bit mantissas m and one
 * shared exponent E; a component is m · 2<sup>E − 136</sup>, which floats hold exactly, and 0 where E is 0. (Radiance
 * itself takes m + ½; like most other programs this class does not, so that black stays black and what was read is
 * written back to the same values.) Nothing is scaled or tone-mapped: {@code EXPOSURE} and {@code COLORCORR} are
 * reported, not applied.
 *
 * <p>All three encodings of scan lines are read — flat, the old one with repeated pixels and the new one with runs in
 * each component — and all eight orders of pixels; {@code -Y … +X …} and the new encoding are written (flat where the
 * format does not allow it, below 8 and above 32767 columns). When written, components are rounded to the nearest
 * mantissa, ties to even; negative ones and NaN become 0, and what is above the range the largest value,
 * 255 · 2<sup>119</sup>.
 *
 * @see <a href="https://radsite.lbl.gov/radiance/refer/filefmts.pdf">Radiance file formats</a>
 */
public final class RadianceHdr {
    static final String FORMAT = "FORMAT=";
    static final String EXPOSURE = "EXPOSURE=";
    static final String COLOR_CORRECTION = "COLORCORR=";

    private static final int MAX_HEADER_BYTES = 1 << 20;
    private static final Pattern RESOLUTION =
            Pattern.compile("([+-])([XY]) +([0-9]{1,10}) +([+-])([XY]) +([0-9]{1,10})");

    private RadianceHdr() {}

    /**
     * Reads a file.
     *
     * @param file file to read
     * @return the image
     * @throws ImageFileException if the file cannot be read, is not Radiance HDR, is damaged, or too large for the heap
     */
    public static HdrImage read(Path file) throws ImageFileException {
        try (ImageSource source = ImageSource.open(file)) {
            return read(source);
        }
    }

    /**
     * Reads a file that is in memory.
     *
     * @param name what errors are to call the file
     * @param bytes content of the file
     * @return the image
     * @throws ImageFileException as {@link #read(Path)}
     */
    public static HdrImage read(String name, byte[] bytes) throws ImageFileException {
        return read(ImageSource.of(name, bytes));
    }

    private static HdrImage read(ImageSource source) throws ImageFileException {
        try {
            return readImage(source);
        } catch (OutOfMemoryError e) {
            throw source.error("the image is too large for the Java heap", e);
        }
    }

    private static HdrImage readImage(ImageSource source) throws ImageFileException {
        if (source.readByte("the header") != '#' || source.readByte("the header") != '?') {
            throw source.error("is not a Radiance HDR file");
        }
        line(source);
        HdrImage.ColorSpace colorSpace = HdrImage.ColorSpace.RGB;
        double exposure = 1;
        double[] correction = {1, 1, 1};
        List<String> others = new ArrayList<>();
        for (String line = line(source); !line.isEmpty(); line = line(source)) {
            if (line.startsWith(FORMAT)) {
                colorSpace = colorSpace(source, line);
            } else if (line.startsWith(EXPOSURE)) {
                exposure *= factors(source, line, 1)[0];
            } else if (line.startsWith(COLOR_CORRECTION)) {
                double[] factors = factors(source, line, 3);
                for (int i = 0; i < 3; i++) {
                    correction[i] *= factors[i];
                }
            } else if (!line.startsWith("#?")) {
                others.add(line);
            }
        }
        Resolution resolution = resolution(source, line(source));
        float[] samples = pixels(source, resolution);
        try {
            return new HdrImage(
                    resolution.width(),
                    resolution.height(),
                    samples,
                    colorSpace,
                    exposure,
                    List.of(correction[0], correction[1], correction[2]),
                    others);
        } catch (IllegalArgumentException e) {
            throw source.error("the header is damaged: " + e.getMessage(), e);
        }
    }

    /** Reads a line of the header without its end. */
    private static String line(ImageSource source) throws ImageFileException {
        StringBuilder line = new StringBuilder();
        while (true) {
            int value = source.readByte("the header");
            if (value == '\n') {
                int last = line.length() - 1;
                // Some programs end lines with both control characters.
                return last >= 0 && line.charAt(last) == '\r' ? line.substring(0, last) : line.toString();
            }
            if (source.position() > MAX_HEADER_BYTES || value == 0) {
                throw source.error("the header is damaged: it has no end");
            }
            line.append((char) value);
        }
    }

    private static HdrImage.ColorSpace colorSpace(ImageSource source, String line) throws ImageFileException {
        String format = line.substring(FORMAT.length()).strip();
        for (HdrImage.ColorSpace known : HdrImage.ColorSpace.values()) {
            if (known.format().equals(format)) {
                return known;
            }
        }
        throw source.error("the format '" + format + "' is not supported");
    }

    private static double[] factors(ImageSource source, String line, int count) throws ImageFileException {
        String[] words = line.substring(line.indexOf('=') + 1).strip().split("\\s+", -1);
        double[] factors = new double[count];
        try {
            for (int i = 0; i < count; i++) {
                factors[i] = i < words.length ? Double.parseDouble(words[i]) : Double.NaN;
                if (!(factors[i] > 0 && factors[i] <= Double.MAX_VALUE)) {
                    throw source.error("the header is damaged: '" + line + "' does not give " + count + " factors");
                }
            }
        } catch (NumberFormatException e) {
            throw source.error("the header is damaged: '" + line + "' does not give " + count + " factors", e);
        }
        return factors;
    }

    /**
     * The order of pixels.
     *
     * @param rowsFirst true if a scan line is a row, false if it is a column
     * @param fromBottom true if rows are counted from the bottom
     * @param fromRight true if columns are counted from the right
     */
    private record Resolution(int width, int height, boolean rowsFirst, boolean fromBottom, boolean fromRight) {
        int scanLines() {
            return rowsFirst ? height : width;
        }

        int scanLineLength() {
            return rowsFirst ? width : height;
        }

        /** The index of a pixel in an image that runs from top to bottom. */
        int index(int scanLine, int place) {
            int row = rowsFirst ? scanLine : place;
            int column = rowsFirst ? place : scanLine;
            return (fromBottom ? height - 1 - row : row) * width + (fromRight ? width - 1 - column : column);
        }
    }

    private static Resolution resolution(ImageSource source, String line) throws ImageFileException {
        Matcher words = RESOLUTION.matcher(line.strip());
        if (!words.matches() || words.group(2).equals(words.group(5))) {
            throw source.error("the header is damaged: '" + line + "' is not a resolution");
        }
        boolean rowsFirst = words.group(2).equals("Y");
        long first = Long.parseLong(words.group(3));
        long second = Long.parseLong(words.group(6));
        long width = rowsFirst ? second : first;
        long height = rowsFirst ? first : second;
        if (width < 1 || height < 1) {
            throw source.error("the header is damaged: the image has " + width + " x " + height + " pixels");
        }
        if (width > Integer.MAX_VALUE / 4 || height > (Integer.MAX_VALUE - 8) / 3 / width) {
            throw source.error("an image of " + width + " x " + height + " pixels is too large");
        }
        // Y runs upwards in this format.
        boolean fromBottom = words.group(rowsFirst ? 1 : 4).equals("+");
        boolean fromRight = words.group(rowsFirst ? 4 : 1).equals("-");
        return new Resolution((int) width, (int) height, rowsFirst, fromBottom, fromRight);
    }

    private static float[] pixels(ImageSource source, Resolution resolution) throws ImageFileException {
        int length = resolution.scanLineLength();
        long start = source.position();
        // A walk without memory first: a few bytes may claim to stand for any number of pixels.
        for (int i = 0; i < resolution.scanLines(); i++) {
            RgbeScanLine.skip(source, length);
        }
        source.seek(start);
        float[] samples = source.newFloats(3L * resolution.width() * resolution.height());
        byte[] rgbe = source.newBytes(4L * length);
        for (int i = 0; i < resolution.scanLines(); i++) {
            RgbeScanLine.read(source, rgbe, length);
            for (int j = 0; j < length; j++) {
                float unit = RgbeScanLine.unit(rgbe[4 * j + 3] & 0xff);
                int at = 3 * resolution.index(i, j);
                for (int c = 0; c < 3; c++) {
                    samples[at + c] = (rgbe[4 * j + c] & 0xff) * unit;
                }
            }
        }
        return samples;
    }

    /**
     * Writes a file.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param image image to write
     * @throws ImageFileException if the file cannot be written
     */
    public static void write(Path file, HdrImage image) throws ImageFileException {
        AtomicFiles.write(file, target -> write(new FileSink(target), image));
    }

    /**
     * Writes to memory.
     *
     * @param name what errors are to call the file
     * @param image image to write
     * @return content of the file
     * @throws ImageFileException if the file does not fit an array
     */
    public static byte[] toBytes(String name, HdrImage image) throws ImageFileException {
        MemorySink sink = new MemorySink();
        try {
            write(sink, image);
            return sink.toByteArray();
        } catch (IOException e) {
            throw new ImageFileException(name, "cannot be written: " + e.getMessage(), e);
        }
    }

    private static void write(ByteSink sink, HdrImage image) throws IOException {
        byte[] head = head(image).getBytes(StandardCharsets.ISO_8859_1);
        sink.write(head, 0, head.length);
        byte[] rgbe = new byte[Math.multiplyExact(4, image.width())];
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                RgbeScanLine.encode(image.samples(), 3 * (y * image.width() + x), rgbe, 4 * x);
            }
            packed.reset();
            RgbeScanLine.write(rgbe, image.width(), packed);
            byte[] line = packed.toByteArray();
            sink.write(line, 0, line.length);
        }
    }

    private static String head(HdrImage image) {
        StringBuilder head = new StringBuilder("#?RADIANCE\n");
        for (String line : image.header()) {
            head.append(line).append('\n');
        }
        if (image.exposure() != 1) {
            head.append(EXPOSURE).append(image.exposure()).append('\n');
        }
        List<Double> correction = image.colorCorrection();
        if (!correction.equals(List.of(1.0, 1.0, 1.0))) {
            head.append(COLOR_CORRECTION)
                    .append(correction.get(0))
                    .append(' ')
                    .append(correction.get(1))
                    .append(' ')
                    .append(correction.get(2))
                    .append('\n');
        }
        head.append(FORMAT).append(image.colorSpace().format()).append("\n\n");
        return head.append("-Y ")
                .append(image.height())
                .append(" +X ")
                .append(image.width())
                .append('\n')
                .toString();
    }
}
