package org.daybreak.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.List;

/**
 * How the rows of an image are cut into chunks and laid out in them: row after row, in each row channel after channel,
 * in each channel the samples from left to right, little endian.
 */
final class ChunkLayout {
    private final List<ExrChannel> channels;
    private final int firstRow;
    private final int width;
    private final int height;
    private final int linesPerChunk;
    private final int bytesPerLine;

    private ChunkLayout(ExrHeader header, Compression compression, int bytesPerLine) {
        this.channels = header.channels();
        this.firstRow = header.dataWindow().yMin();
        this.width = Math.toIntExact(header.width());
        this.height = Math.toIntExact(header.height());
        this.linesPerChunk = compression.linesPerChunk();
        this.bytesPerLine = bytesPerLine;
    }

    /**
     * Lays an image out.
     *
     * @param file for the error
     * @throws ImageFileException if a channel does not fit an array or a chunk does not fit its length field
     */
    static ChunkLayout of(Path file, ExrHeader header, Compression compression) throws ImageFileException {
        long width = header.width();
        long height = header.height();
        // Both are below 2^33, so the product is only formed when it cannot wrap.
        if (width > Integer.MAX_VALUE - 8 || height > (Integer.MAX_VALUE - 8) / width) {
            throw new ImageFileException(file, "an image of " + width + " x " + height + " pixels is too large");
        }
        long bytesPerPixel = 0;
        for (ExrChannel channel : header.channels()) {
            bytesPerPixel += channel.type().byteCount();
        }
        long lines = Math.min(compression.linesPerChunk(), height);
        long chunkBytes = bytesPerPixel * width * lines;
        if (chunkBytes > Integer.MAX_VALUE - 64) {
            throw new ImageFileException(
                    file,
                    "rows of " + width + " pixels of " + bytesPerPixel + " bytes are too large: a chunk would hold "
                            + chunkBytes + " bytes");
        }
        return new ChunkLayout(header, compression, (int) (bytesPerPixel * width));
    }

    int chunkCount() {
        return (height - 1) / linesPerChunk + 1;
    }

    int pixelCount() {
        return width * height;
    }

    /** Bytes of all rows together, unpacked. */
    long rawBytes() {
        return (long) bytesPerLine * height;
    }

    /** Bytes of the largest chunk, unpacked. */
    int maxRawLength() {
        return rawLength(0);
    }

    /** Bytes of a chunk, unpacked. */
    int rawLength(int chunk) {
        return bytesPerLine * lineCount(chunk);
    }

    /** The number of the first row of a chunk, counted as the data window counts. */
    int firstRow(int chunk) {
        return firstRow + chunk * linesPerChunk;
    }

    /** The chunk whose first row has the given number, or −1. */
    int chunkOfFirstRow(int row) {
        long distance = (long) row - firstRow;
        return distance >= 0 && distance < height && distance % linesPerChunk == 0
                ? (int) (distance / linesPerChunk)
                : -1;
    }

    private int lineCount(int chunk) {
        return Math.min(linesPerChunk, height - chunk * linesPerChunk);
    }

    /** Copies the samples of a chunk from the image into {@code raw}. */
    void gather(ExrImage image, int chunk, byte[] raw) {
        ByteBuffer bytes = ByteBuffer.wrap(raw).order(ByteOrder.LITTLE_ENDIAN);
        int place = 0;
        int lines = lineCount(chunk);
        for (int line = 0; line < lines; line++) {
            int start = (chunk * linesPerChunk + line) * width;
            for (ExrChannel channel : channels) {
                bytes.position(place);
                switch (channel.type()) {
                    case UINT -> bytes.asIntBuffer().put(image.uintSamples(channel.name()), start, width);
                    case FLOAT -> bytes.asFloatBuffer().put(image.samples(channel.name()), start, width);
                    case HALF -> putHalves(image.samples(channel.name()), start, width, raw, place);
                    default -> throw new AssertionError(channel.type());
                }
                place += width * channel.type().byteCount();
            }
        }
    }

    /** Copies the samples of a chunk from {@code raw} into the image. */
    void scatter(byte[] raw, int chunk, ExrImage image) {
        ByteBuffer bytes = ByteBuffer.wrap(raw).order(ByteOrder.LITTLE_ENDIAN);
        int place = 0;
        int lines = lineCount(chunk);
        for (int line = 0; line < lines; line++) {
            int start = (chunk * linesPerChunk + line) * width;
            for (ExrChannel channel : channels) {
                bytes.position(place);
                switch (channel.type()) {
                    case UINT -> bytes.asIntBuffer().get(image.uintSamples(channel.name()), start, width);
                    case FLOAT -> bytes.asFloatBuffer().get(image.samples(channel.name()), start, width);
                    case HALF -> getHalves(raw, place, image.samples(channel.name()), start, width);
                    default -> throw new AssertionError(channel.type());
                }
                place += width * channel.type().byteCount();
            }
        }
    }

    private static void putHalves(float[] samples, int start, int count, byte[] raw, int place) {
        for (int i = 0; i < count; i++) {
            int half = Half.fromFloat(samples[start + i]);
            raw[place + 2 * i] = (byte) half;
            raw[place + 2 * i + 1] = (byte) (half >> 8);
        }
    }

    private static void getHalves(byte[] raw, int place, float[] samples, int start, int count) {
        for (int i = 0; i < count; i++) {
            int low = raw[place + 2 * i] & 0xff;
            samples[start + i] = Half.toFloat((short) (low | (raw[place + 2 * i + 1] << 8)));
        }
    }
}
