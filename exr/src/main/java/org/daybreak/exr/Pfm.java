package org.daybreak.exr;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * Reads and writes PFM (portable float map): {@code PF} (RGB) or {@code Pf} (grey), width, height and a scale in ASCII
 * — its sign gives the byte order, negative for little endian —, one white-space byte, then 32-bit floats in rows from
 * bottom to top.
 *
 * @see <a href="https://www.pauldebevec.com/Research/HDR/PFM/">Paul Debevec's description of PFM</a>
 */
public final class Pfm {
    private static final int MAX_TOKEN_BYTES = 40;

    private Pfm() {}

    /**
     * Reads a file.
     *
     * @param file file to read
     * @return the image, rows from top to bottom
     * @throws ImageFileException if the file cannot be read, is not PFM, or has not exactly the bytes that its size asks
     *     for
     */
    public static PfmImage read(Path file) throws ImageFileException {
        try (ImageSource source = ImageSource.open(file)) {
            return read(source);
        }
    }

    /**
     * Reads a file that is in memory.
     *
     * @param name what errors are to call the file
     * @param bytes content of the file
     * @return the image, rows from top to bottom
     * @throws ImageFileException as {@link #read(Path)}
     */
    public static PfmImage read(String name, byte[] bytes) throws ImageFileException {
        return read(ImageSource.of(name, bytes));
    }

    private static PfmImage read(ImageSource source) throws ImageFileException {
        String magic = token(source);
        if (!magic.equals("PF") && !magic.equals("Pf")) {
            throw source.error("is not a PFM file");
        }
        int components = magic.equals("PF") ? 3 : 1;
        int width = size(source, "width");
        int height = size(source, "height");
        float scale = scale(source);
        // The row alone is below 2^35 bytes; dividing avoids a product beyond 2^63.
        long rowBytes = (long) width * components * Float.BYTES;
        if (source.remaining() / rowBytes != height || source.remaining() % rowBytes != 0) {
            throw source.error("the file is truncated or damaged: " + source.remaining() + " bytes are not " + height
                    + " rows of " + rowBytes + " bytes");
        }
        float[] samples = source.newFloats((long) width * height * components);
        byte[] row = source.newBytes(rowBytes);
        ByteBuffer bytes = ByteBuffer.wrap(row).order(scale < 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        int rowLength = width * components;
        for (int y = height - 1; y >= 0; y--) {
            source.read(row, 0, row.length, "a row");
            bytes.asFloatBuffer().get(samples, y * rowLength, rowLength);
        }
        return new PfmImage(width, height, components, samples, Math.abs(scale));
    }

    /**
     * Writes a file in little endian.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param image image to write
     * @throws ImageFileException if the file cannot be written
     */
    public static void write(Path file, PfmImage image) throws ImageFileException {
        write(file, image, ByteOrder.LITTLE_ENDIAN);
    }

    /**
     * Writes a file.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param image image to write
     * @param order byte order of the samples
     * @throws ImageFileException if the file cannot be written, or a row would hold 2 GiB
     */
    public static void write(Path file, PfmImage image, ByteOrder order) throws ImageFileException {
        int rowLength = image.width() * image.components();
        if ((long) rowLength * Float.BYTES > Integer.MAX_VALUE - 8) {
            throw new ImageFileException(file, "cannot be written: rows of " + image.width() + " pixels are too large");
        }
        AtomicFiles.write(file, target -> write(new FileSink(target), image, order, rowLength));
    }

    /**
     * Writes to memory, in little endian.
     *
     * @param name what errors are to call the file
     * @param image image to write
     * @return content of the file
     * @throws ImageFileException if the file does not fit an array
     */
    public static byte[] toBytes(String name, PfmImage image) throws ImageFileException {
        MemorySink sink = new MemorySink();
        try {
            write(sink, image, ByteOrder.LITTLE_ENDIAN, Math.multiplyExact(image.width(), image.components()));
            return sink.toByteArray();
        } catch (IOException e) {
            throw new ImageFileException(name, "cannot be written: " + e.getMessage(), e);
        }
    }

    private static void write(ByteSink target, PfmImage image, ByteOrder order, int rowLength) throws IOException {
        float scale = order == ByteOrder.LITTLE_ENDIAN ? -image.scale() : image.scale();
        String head = (image.components() == 3 ? "PF" : "Pf") + "\n" + image.width() + " " + image.height() + "\n"
                + scale + "\n";
        byte[] headBytes = head.getBytes(StandardCharsets.US_ASCII);
        target.write(headBytes, 0, headBytes.length);
        byte[] row = new byte[Math.multiplyExact(rowLength, Float.BYTES)];
        ByteBuffer bytes = ByteBuffer.wrap(row).order(order);
        for (int y = image.height() - 1; y >= 0; y--) {
            bytes.asFloatBuffer().put(image.samples(), y * rowLength, rowLength);
            target.write(row, 0, row.length);
        }
    }

    private static int size(ImageSource source, String what) throws ImageFileException {
        String token = token(source);
        try {
            int size = Integer.parseInt(token);
            if (size > 0) {
                return size;
            }
        } catch (NumberFormatException e) {
            throw source.error(notNumber(what, token), e);
        }
        throw source.error(notNumber(what, token));
    }

    private static float scale(ImageSource source) throws ImageFileException {
        String token = token(source);
        float scale;
        try {
            scale = Float.parseFloat(token);
        } catch (NumberFormatException e) {
            throw source.error(notNumber("scale", token), e);
        }
        if (!Float.isFinite(scale) || scale == 0) {
            throw source.error(notNumber("scale", token));
        }
        return scale;
    }

    private static String notNumber(String what, String token) {
        return "the header is damaged: '" + token + "' is not a " + what;
    }

    /** Reads one word and the single white-space byte behind it. */
    private static String token(ImageSource source) throws ImageFileException {
        StringBuilder token = new StringBuilder();
        while (true) {
            int value = source.readByte("the header");
            boolean space = value == ' ' || (value >= '\t' && value <= '\r');
            if (space && token.length() > 0) {
                return token.toString();
            }
            if (!space) {
                if (value < ' ' || value > '~' || token.length() == MAX_TOKEN_BYTES) {
                    throw source.error("is not a PFM file");
                }
                token.append((char) value);
            }
        }
    }
}
