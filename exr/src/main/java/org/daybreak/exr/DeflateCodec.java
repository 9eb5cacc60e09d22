package org.daybreak.exr;

import java.io.IOException;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;

/**
 * The codec of {@link Compression#ZIPS} and {@link Compression#ZIP}. Before deflating, the even bytes are moved to the
 * first half and the odd ones to the second, and each byte is replaced by its difference from the byte before, plus
 * 128: bytes of like meaning become neighbours and smooth pictures become runs.
 *
 * @see <a href="https://openexr.com/en/latest/OpenEXRFileLayout.html">OpenEXR file layout</a>
 */
final class DeflateCodec implements ChunkCodec {
    /** No deflate stream expands more than this: at best two bits stand for 258 bytes. */
    private static final long MAX_EXPANSION = 1032;

    private final Deflater deflater;
    private final Inflater inflater = new Inflater();
    private final byte[] surplus = new byte[1];
    private byte[] predicted = new byte[0];

    DeflateCodec(int level) {
        deflater = new Deflater(level);
    }

    @Override
    public int pack(byte[] raw, int rawLength, byte[] packed, int offset) {
        byte[] differences = workSpace(rawLength);
        split(raw, differences, rawLength);
        encodeDifferences(differences, rawLength);
        deflater.reset();
        deflater.setInput(differences, 0, rawLength);
        deflater.finish();
        int length = deflater.deflate(packed, offset, rawLength);
        return deflater.finished() && length < rawLength ? length : NOT_SMALLER;
    }

    @Override
    public void unpack(byte[] packed, int offset, int packedLength, byte[] raw, int rawLength) throws IOException {
        byte[] differences = workSpace(rawLength);
        inflater.reset();
        inflater.setInput(packed, offset, packedLength);
        try {
            int length = inflater.inflate(differences, 0, rawLength);
            // One more step reads the checksum behind the last byte and finds out whether there are too many bytes.
            if (length != rawLength || (!inflater.finished() && inflater.inflate(surplus) != 0)) {
                throw new IOException("a deflated chunk does not hold its " + rawLength + " bytes");
            }
        } catch (DataFormatException e) {
            throw new IOException("a deflated chunk is damaged", e);
        }
        if (!inflater.finished()) {
            throw new IOException("a deflated chunk ends early");
        }
        decodeDifferences(differences, rawLength);
        join(differences, raw, rawLength);
    }

    @Override
    public long maxRawLength(long packedLength) {
        return Math.multiplyExact(packedLength, MAX_EXPANSION);
    }

    @Override
    public void close() {
        deflater.end();
        inflater.end();
    }

    private byte[] workSpace(int length) {
        if (predicted.length < length) {
            predicted = new byte[length];
        }
        return predicted;
    }

    private static void split(byte[] from, byte[] to, int length) {
        int odd = (length + 1) / 2;
        int pairs = length / 2;
        for (int i = 0; i < pairs; i++) {
            to[i] = from[2 * i];
            to[odd + i] = from[2 * i + 1];
        }
        if (odd > pairs) {
            to[pairs] = from[length - 1];
        }
    }

    private static void join(byte[] from, byte[] to, int length) {
        int odd = (length + 1) / 2;
        int pairs = length / 2;
        for (int i = 0; i < pairs; i++) {
            to[2 * i] = from[i];
            to[2 * i + 1] = from[odd + i];
        }
        if (odd > pairs) {
            to[length - 1] = from[pairs];
        }
    }

    /** Runs backwards so that each byte meets its unchanged left neighbour. */
    private static void encodeDifferences(byte[] bytes, int length) {
        for (int i = length - 1; i > 0; i--) {
            bytes[i] = (byte) (bytes[i] - bytes[i - 1] + 128);
        }
    }

    private static void decodeDifferences(byte[] bytes, int length) {
        byte value = length > 0 ? bytes[0] : 0;
        for (int i = 1; i < length; i++) {
            value = (byte) (value + bytes[i] - 128);
            bytes[i] = value;
        }
    }
}
