package org.daybreak.exr;

import java.io.Closeable;
import java.io.EOFException;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * An image opened for reading at any place: a file, or bytes in memory. The length is known, so every claim of a header
 * can be held against it before memory is taken.
 *
 * <p>Uses {@link RandomAccessFile} because a file channel would be closed under a thread that is interrupted.
 */
final class ImageSource implements Closeable {
    private static final int BUFFER_BYTES = 8192;

    private final String name;
    /** Null for bytes in memory: then the buffer holds all of them. */
    private final @Nullable RandomAccessFile file;

    private final long length;
    private final byte[] buffer;
    /** Place in the file of the first byte of the buffer. */
    private long bufferStart;

    private int bufferLength;
    private long position;

    private ImageSource(String name, @Nullable RandomAccessFile file, long length, byte[] buffer, int bufferLength) {
        this.name = name;
        this.file = file;
        this.length = length;
        this.buffer = buffer;
        this.bufferLength = bufferLength;
    }

    /** Reads from memory; the name stands in errors. The array is not copied. */
    static ImageSource of(String name, byte[] bytes) {
        return new ImageSource(name, null, bytes.length, bytes, bytes.length);
    }

    /** Opens a regular file or says why that is not possible. */
    static ImageSource open(Path path) throws ImageFileException {
        if (Files.isDirectory(path)) {
            throw new ImageFileException(path, "is a directory, not an image file");
        }
        if (!Files.exists(path)) {
            throw new ImageFileException(path, "no such file");
        }
        // A pipe or device would block or never end, and has no length to check against.
        if (!Files.isRegularFile(path)) {
            throw new ImageFileException(path, "is not a regular file");
        }
        if (!Files.isReadable(path)) {
            throw new ImageFileException(path, "permission to read is denied");
        }
        try {
            RandomAccessFile file = new RandomAccessFile(path.toFile(), "r");
            try {
                return new ImageSource(path.toString(), file, file.length(), new byte[BUFFER_BYTES], 0);
            } catch (IOException e) {
                file.close();
                throw e;
            }
        } catch (FileNotFoundException e) {
            throw new ImageFileException(path, "cannot be opened: " + e.getMessage(), e);
        } catch (IOException e) {
            throw new ImageFileException(path, "cannot be read: " + e.getMessage(), e);
        } catch (UnsupportedOperationException e) {
            throw new ImageFileException(path, "is not in the default file system", e);
        }
    }

    String name() {
        return name;
    }

    long length() {
        return length;
    }

    long position() {
        return position;
    }

    long remaining() {
        return length - position;
    }

    void seek(long newPosition) {
        position = newPosition;
    }

    /** An error that names this file. */
    ImageFileException error(String reason) {
        return new ImageFileException(name, reason);
    }

    /** An error that names this file. */
    ImageFileException error(String reason, Throwable cause) {
        return new ImageFileException(name, reason, cause);
    }

    int readByte(String what) throws ImageFileException {
        if (position < bufferStart || position >= bufferStart + bufferLength) {
            if (remaining() < 1) {
                throw truncated(what);
            }
            bufferLength = 0;
            bufferStart = position;
            int wanted = (int) Math.min(BUFFER_BYTES, remaining());
            readAt(position, buffer, 0, wanted, what);
            bufferLength = wanted;
        }
        int value = buffer[(int) (position - bufferStart)] & 0xff;
        position++;
        return value;
    }

    long readLong(String what) throws ImageFileException {
        long low = Integer.toUnsignedLong(readInt(what));
        return low | (long) readInt(what) << 32;
    }

    int readInt(String what) throws ImageFileException {
        int value = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            value |= readByte(what) << shift;
        }
        return value;
    }

    /** Reads bytes up to a NUL, which is taken but not returned. */
    byte[] readNulTerminated(int maxLength, String what) throws ImageFileException {
        byte[] bytes = new byte[maxLength];
        for (int i = 0; i <= maxLength; i++) {
            int value = readByte(what);
            if (value == 0) {
                return Arrays.copyOf(bytes, i);
            }
            if (i < maxLength) {
                bytes[i] = (byte) value;
            }
        }
        throw error("the header is damaged: " + what + " is longer than " + maxLength + " bytes");
    }

    /** Reads bytes; the caller has checked that {@code count} is sensible, but not that the file holds them. */
    byte[] readBytes(int count, String what) throws ImageFileException {
        if (count > remaining()) {
            throw truncated(what);
        }
        byte[] bytes = newBytes(count);
        read(bytes, 0, count, what);
        return bytes;
    }

    void read(byte[] into, int offset, int count, String what) throws ImageFileException {
        if (count > remaining()) {
            throw truncated(what);
        }
        long buffered = bufferStart + bufferLength - position;
        int ready = 0;
        if (position >= bufferStart && buffered > 0) {
            ready = (int) Math.min(buffered, count);
            System.arraycopy(buffer, (int) (position - bufferStart), into, offset, ready);
        }
        readAt(position + ready, into, offset + ready, count - ready, what);
        position += count;
    }

    private void readAt(long place, byte[] into, int offset, int count, String what) throws ImageFileException {
        if (file == null || count == 0) {
            return;
        }
        try {
            file.seek(place);
            file.readFully(into, offset, count);
        } catch (EOFException e) {
            throw truncated(what);
        } catch (IOException e) {
            throw error("cannot be read: " + e.getMessage(), e);
        }
    }

    /** Allocates, or says that the heap is too small for this file. */
    byte[] newBytes(long count) throws ImageFileException {
        checkAllocation(count, Byte.BYTES);
        try {
            return new byte[(int) count];
        } catch (OutOfMemoryError e) {
            throw tooLarge(count * Byte.BYTES);
        }
    }

    /** Allocates, or says that the heap is too small for this file. */
    float[] newFloats(long count) throws ImageFileException {
        checkAllocation(count, Float.BYTES);
        try {
            return new float[(int) count];
        } catch (OutOfMemoryError e) {
            throw tooLarge(count * Float.BYTES);
        }
    }

    /** Allocates, or says that the heap is too small for this file. */
    int[] newInts(long count) throws ImageFileException {
        checkAllocation(count, Integer.BYTES);
        try {
            return new int[(int) count];
        } catch (OutOfMemoryError e) {
            throw tooLarge(count * Integer.BYTES);
        }
    }

    private void checkAllocation(long count, long elementBytes) throws ImageFileException {
        if (count > Integer.MAX_VALUE - 8) {
            throw error("the image is too large: " + count + " elements do not fit one array");
        }
        if (count * elementBytes > Runtime.getRuntime().maxMemory()) {
            throw tooLarge(count * elementBytes);
        }
    }

    private ImageFileException tooLarge(long bytes) {
        return error("the image is too large for the Java heap, which cannot give another " + bytes + " bytes");
    }

    private ImageFileException truncated(String what) {
        return error(length == 0 ? "the file is empty" : "the file is truncated: it ends within " + what);
    }

    @Override
    public void close() throws ImageFileException {
        if (file == null) {
            return;
        }
        try {
            file.close();
        } catch (IOException e) {
            throw error("cannot be closed: " + e.getMessage(), e);
        }
    }
}
