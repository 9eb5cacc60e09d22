package org.daybreak.exr;

import java.io.IOException;
import java.util.zip.Deflater;
import org.jspecify.annotations.Nullable;

/** The codec of {@link Compression#ZIPS} and {@link Compression#ZIP}: {@link BytePredictor}, then deflate. */
final class DeflateCodec implements ChunkCodec {
    /** Up to this level {@link FastDeflate} is used, above it the JDK. */
    static final int MAX_FAST_LEVEL = 4;

    private final @Nullable Deflater deflater;
    /** Made when the first chunk is packed: readers have no use for it. */
    private @Nullable FastDeflate fastDeflate;

    private final Inflation inflation = new Inflation();
    private byte[] differences = new byte[0];

    DeflateCodec(int level) {
        deflater = level > MAX_FAST_LEVEL ? new Deflater(level) : null;
    }

    @Override
    public int pack(byte[] raw, int rawLength, byte[] packed, int offset) {
        byte[] space = workSpace(rawLength);
        BytePredictor.encode(raw, space, rawLength);
        if (deflater == null) {
            if (fastDeflate == null) {
                fastDeflate = new FastDeflate();
            }
            int length = fastDeflate.deflate(space, rawLength, packed, offset);
            return length < 0 ? NOT_SMALLER : length;
        }
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
        if (deflater != null) {
            deflater.end();
        }
        inflation.close();
    }

    private byte[] workSpace(int length) {
        if (differences.length < length) {
            differences = new byte[length];
        }
        return differences;
    }
}
