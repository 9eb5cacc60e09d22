package org.daybreak.cli.partial;

import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.nio.LongBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.CRC32C;
import org.daybreak.core.film.FilmState;
import org.daybreak.exr.AtomicFiles;
import org.daybreak.exr.ImageFileException;

/**
 * Reads and writes partial films. A file is: eight bytes that name the format, the version, the length of the header, the
 * header as JSON in UTF-8, its checksum; then blocks of 64-bit numbers, each followed by its checksum. Integers and numbers
 * are little-endian, checksums are CRC-32C.
 */
public final class PartialFilmFile {
    /** Ending of file names. */
    public static final String ENDING = "daybreak";

    /** Bits 8, line ends and end-of-file marks: what damages texts damages these. */
    private static final byte[] MAGIC = {(byte) 0x89, 'D', 'B', 'F', '\r', '\n', 0x1A, '\n'};

    private static final int VERSION = 2;
    private static final int LARGEST_HEADER = 1 << 28;
    private static final int BUFFER_BYTES = 1 << 20;

    private PartialFilmFile() {}

    /**
     * Writes a file. When this returns, the file survives the end of the process or the machine; when it fails, an older
     * file is as it was.
     *
     * @throws ImageFileException if that fails
     */
    public static void write(Path file, PartialFilm film) throws ImageFileException {
        byte[] header = PartialFilmHeader.encode(film);
        AtomicFiles.writeDurably(file, out -> {
            byte[] bytes = new byte[MAGIC.length + 2 * Integer.BYTES + header.length + Integer.BYTES];
            ByteBuffer start = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
            start.put(MAGIC).putInt(VERSION).putInt(header.length).put(header);
            start.putInt(checksum(bytes, start.position()));
            out.write(bytes);
            Buffer buffer = new Buffer();
            for (long[] values : film.state().position().values()) {
                write(out, buffer, values);
            }
            FilmState state = film.state().film();
            write(out, buffer, state.sums());
            for (double[] splats : PartialFilmHeader.splatBlocks(state).values()) {
                write(out, buffer, splats);
            }
        });
    }

    /**
     * Reads a file.
     *
     * @throws ImageFileException if the file cannot be read, is no partial film, is damaged or has another version
     */
    public static PartialFilm read(Path file) throws ImageFileException {
        if (!Files.exists(file)) {
            throw new ImageFileException(file, "there is no such file");
        }
        try (RandomAccessFile in = new RandomAccessFile(file.toFile(), "r")) {
            PartialFilmHeader header = PartialFilmHeader.decode(readHeader(in));
            long expected = in.getFilePointer();
            for (PartialFilmHeader.Block block : header.blocks()) {
                expected = Math.addExact(
                        expected, Math.addExact(Math.multiplyExact(block.count(), Long.BYTES), Integer.BYTES));
            }
            if (expected != in.length()) {
                throw new IOException("is damaged: it has " + in.length() + " bytes but must have " + expected);
            }
            Buffer buffer = new Buffer();
            Map<String, long[]> position = new LinkedHashMap<>();
            Map<String, double[]> films = new LinkedHashMap<>();
            for (PartialFilmHeader.Block block : header.blocks()) {
                if (block.isPosition()) {
                    position.put(block.key(), readLongs(in, buffer, block));
                } else {
                    films.put(block.name(), readDoubles(in, buffer, block));
                }
            }
            return header.toFilm(position, films);
        } catch (ImageFileException e) {
            throw e;
        } catch (EOFException e) {
            throw new ImageFileException(file, "is damaged: it ends too early", e);
        } catch (IOException e) {
            throw new ImageFileException(file, String.valueOf(e.getMessage()), e);
        } catch (IllegalArgumentException | ArithmeticException e) {
            throw new ImageFileException(file, "is damaged: " + e.getMessage(), e);
        }
    }

    /**
     * The checksums of the film's blocks by name: equal numbers have equal checksums.
     */
    public static Map<String, Integer> checksums(PartialFilm film) {
        Map<String, Integer> sums = new LinkedHashMap<>();
        Buffer buffer = new Buffer();
        sums.put(PartialFilmHeader.SUMS, checksum(buffer, film.state().film().sums()));
        PartialFilmHeader.splatBlocks(film.state().film())
                .forEach((name, values) -> sums.put(name, checksum(buffer, values)));
        return sums;
    }

    private static byte[] readHeader(RandomAccessFile in) throws IOException {
        byte[] start = new byte[MAGIC.length + 2 * Integer.BYTES];
        if (in.length() < start.length) {
            throw new IOException("is no partial film");
        }
        in.readFully(start);
        if (!Arrays.equals(start, 0, MAGIC.length, MAGIC, 0, MAGIC.length)) {
            throw new IOException("is no partial film");
        }
        ByteBuffer numbers = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN);
        int version = numbers.getInt(MAGIC.length);
        if (version != VERSION) {
            throw new IOException("has version " + version + " of the format; this program reads version " + VERSION);
        }
        int length = numbers.getInt(MAGIC.length + Integer.BYTES);
        if (length < 0 || length > LARGEST_HEADER || length > in.length() - start.length - Integer.BYTES) {
            throw new IOException("is damaged: the header would have " + length + " bytes");
        }
        byte[] all = Arrays.copyOf(start, start.length + length);
        in.readFully(all, start.length, length);
        check("the header", readInt(in), checksum(all, all.length));
        return Arrays.copyOfRange(all, start.length, all.length);
    }

    private static int readInt(RandomAccessFile in) throws IOException {
        return Integer.reverseBytes(in.readInt());
    }

    private static void check(String what, int stored, int computed) throws IOException {
        if (stored != computed) {
            throw new IOException("is damaged: the checksum of " + what + " is wrong");
        }
    }

    /** Numbers on their way between arrays and files. */
    private static final class Buffer {
        final byte[] bytes = new byte[BUFFER_BYTES];
        final LongBuffer longs =
                ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asLongBuffer();
        final DoubleBuffer doubles =
                ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asDoubleBuffer();
    }

    private static int checksum(byte[] bytes, int length) {
        CRC32C crc = new CRC32C();
        crc.update(bytes, 0, length);
        return (int) crc.getValue();
    }

    private static int checksum(Buffer buffer, double[] values) {
        CRC32C crc = new CRC32C();
        for (int from = 0; from < values.length; from += BUFFER_BYTES / Double.BYTES) {
            int n = Math.min(BUFFER_BYTES / Double.BYTES, values.length - from);
            buffer.doubles.put(0, values, from, n);
            crc.update(buffer.bytes, 0, n * Double.BYTES);
        }
        return (int) crc.getValue();
    }

    private static void write(RandomAccessFile out, Buffer buffer, double[] values) throws IOException {
        CRC32C crc = new CRC32C();
        for (int from = 0; from < values.length; from += BUFFER_BYTES / Double.BYTES) {
            int n = Math.min(BUFFER_BYTES / Double.BYTES, values.length - from);
            buffer.doubles.put(0, values, from, n);
            crc.update(buffer.bytes, 0, n * Double.BYTES);
            out.write(buffer.bytes, 0, n * Double.BYTES);
        }
        out.writeInt(Integer.reverseBytes((int) crc.getValue()));
    }

    private static void write(RandomAccessFile out, Buffer buffer, long[] values) throws IOException {
        CRC32C crc = new CRC32C();
        for (int from = 0; from < values.length; from += BUFFER_BYTES / Long.BYTES) {
            int n = Math.min(BUFFER_BYTES / Long.BYTES, values.length - from);
            buffer.longs.put(0, values, from, n);
            crc.update(buffer.bytes, 0, n * Long.BYTES);
            out.write(buffer.bytes, 0, n * Long.BYTES);
        }
        out.writeInt(Integer.reverseBytes((int) crc.getValue()));
    }

    private static double[] readDoubles(RandomAccessFile in, Buffer buffer, PartialFilmHeader.Block block)
            throws IOException {
        double[] values = new double[Math.toIntExact(block.count())];
        CRC32C crc = new CRC32C();
        for (int from = 0; from < values.length; from += BUFFER_BYTES / Double.BYTES) {
            int n = Math.min(BUFFER_BYTES / Double.BYTES, values.length - from);
            in.readFully(buffer.bytes, 0, n * Double.BYTES);
            crc.update(buffer.bytes, 0, n * Double.BYTES);
            buffer.doubles.get(0, values, from, n);
        }
        check("'" + block.name() + "'", readInt(in), (int) crc.getValue());
        return values;
    }

    private static long[] readLongs(RandomAccessFile in, Buffer buffer, PartialFilmHeader.Block block)
            throws IOException {
        long[] values = new long[Math.toIntExact(block.count())];
        CRC32C crc = new CRC32C();
        for (int from = 0; from < values.length; from += BUFFER_BYTES / Long.BYTES) {
            int n = Math.min(BUFFER_BYTES / Long.BYTES, values.length - from);
            in.readFully(buffer.bytes, 0, n * Long.BYTES);
            crc.update(buffer.bytes, 0, n * Long.BYTES);
            buffer.longs.get(0, values, from, n);
        }
        check("'" + block.name() + "'", readInt(in), (int) crc.getValue());
        return values;
    }
}
