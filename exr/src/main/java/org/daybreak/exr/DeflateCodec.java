package org.daybreak.exr;

import java.io.IOException;
import java.util.zip.Deflater;

/** The codec of {@link Compression#ZIPS} and {@link Compression#ZIP}: {@link BytePredictor}, then deflate. */
final class DeflateCodec implements ChunkCodec {
    private final Deflater deflater;
    private final Inflation inflation = new Inflation();
    private byte[] differences = new byte[0];

    DeflateCodec(int level) {
        deflater = new Deflater(level);
    }

    @Override
    public int pack(byte[] raw, int rawLength, byte[] packed, int offset) {
        byte[] space = workSpace(rawLength);
        BytePredictor.encode(raw, space, rawLength);
        deflater.reset();
        deflater.setInput(space, 0, rawLength);
        deflater.finish();
        int length = deflater.deflate(packed, offset, rawLength);
        return deflater.finished() && length < rawLength ? length : NOT_SMALLER;
    }

    @Override
    public void unpack(byte[] packed, int packedLength, byte[] raw, int rawLength, int width, int height)
            throws IOException {
        byte[] space = workSpace(rawLength);
        inflation.inflate(packed, packedLength, space, rawLength);
        BytePredictor.decode(space, raw, rawLength);
    }

    @Override
    public void close() {
        deflater.end();
        inflation.close();
    }

    private byte[] workSpace(int length) {
        if (differences.length < length) {
            differences = new byte[length];
        }
        return differences;
    }
}
