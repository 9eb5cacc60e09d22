package org.daybreak.exr;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;

/**
 * The codec of {@link Compression#PIZ}, for reading only. A chunk is a set of 16-bit words, channel after channel (two
 * for each 32-bit sample): a bit map of the values that occur, by which values are renumbered without gaps; then the
 * words, transformed by {@link Wavelet} and coded as {@link HuffmanDecoder} reads them.
 */
final class PizCodec implements ChunkCodec {
    private static final int BITMAP_BYTES = 1 << 13;

    private final int[] wordsPerSample;
    private final int wordsPerPixel;
    private final HuffmanDecoder huffman = new HuffmanDecoder();
    private final short[] values = new short[1 << 16];
    private short[] words = new short[0];

    PizCodec(List<ExrChannel> channels) {
        wordsPerSample = channels.stream()
                .mapToInt(channel -> channel.type().byteCount() / Short.BYTES)
                .toArray();
        wordsPerPixel = Arrays.stream(wordsPerSample).sum();
    }

    @Override
    public int pack(byte[] raw, int rawLength, byte[] packed, int offset) {
        throw new UnsupportedOperationException(Compression.PIZ.notWritable());
    }

    @Override
    public void unpack(byte[] packed, int packedLength, byte[] raw, int rawLength, int width, int height)
            throws IOException {
        int wordCount = wordsPerPixel * width * height;
        if (words.length < wordCount) {
            words = new short[wordCount];
        }
        if (packedLength < 4) {
            throw new IOException("the bit map ends early");
        }
        int first = int16(packed, 0);
        int last = int16(packed, 2);
        int bitmapBytes = last < first ? 0 : last - first + 1;
        int at = 4 + bitmapBytes;
        if (last >= BITMAP_BYTES || packedLength - 4 < at) {
            throw new IOException("the bit map is damaged");
        }
        int maxValue = readBitmap(packed, first, bitmapBytes);
        int length = int16(packed, at) | int16(packed, at + 2) << 16;
        at += 4;
        if (length < 0 || length > packedLength - at) {
            throw new IOException("the Huffman codes end early");
        }
        huffman.decode(packed, at, length, words, wordCount);
        undoWavelets(width, height, maxValue);
        for (int i = 0; i < wordCount; i++) {
            words[i] = values[words[i] & 0xffff];
        }
        toRows(raw, width, height);
    }

    /** Fills the table of values and returns the largest number that a value has; 0 always is a value. */
    private int readBitmap(byte[] packed, int first, int byteCount) {
        int used = 1;
        values[0] = 0;
        for (int i = 0; i < byteCount; i++) {
            int bits = packed[4 + i];
            for (int bit = 0; bit < 8; bit++) {
                int value = (first + i) * 8 + bit;
                if ((bits >> bit & 1) != 0 && value != 0) {
                    values[used++] = (short) value;
                }
            }
        }
        Arrays.fill(values, used, values.length, (short) 0);
        return used - 1;
    }

    private void undoWavelets(int width, int height, int maxValue) {
        int start = 0;
        for (int size : wordsPerSample) {
            for (int part = 0; part < size; part++) {
                Wavelet.decode(words, start + part, width, size, height, width * size, maxValue);
            }
            start += size * width * height;
        }
    }

    private void toRows(byte[] raw, int width, int height) {
        int start = 0;
        int column = 0;
        int rowBytes = wordsPerPixel * width * Short.BYTES;
        for (int size : wordsPerSample) {
            int rowWords = size * width;
            for (int y = 0; y < height; y++) {
                int out = y * rowBytes + column;
                for (int i = 0; i < rowWords; i++) {
                    int word = words[start + y * rowWords + i];
                    raw[out++] = (byte) word;
                    raw[out++] = (byte) (word >> 8);
                }
            }
            start += rowWords * height;
            column += rowWords * Short.BYTES;
        }
    }

    private static int int16(byte[] bytes, int at) {
        return (bytes[at] & 0xff) | (bytes[at + 1] & 0xff) << 8;
    }

    @Override
    public void close() {
        // Holds no resources.
    }
}
