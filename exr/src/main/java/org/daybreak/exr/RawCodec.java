package org.daybreak.exr;

import java.io.IOException;

/** The codec of {@link Compression#NONE}: no chunk ever shrinks, so all are stored raw. */
final class RawCodec implements ChunkCodec {
    @Override
    public int pack(byte[] raw, int rawLength, byte[] packed, int offset) {
        return NOT_SMALLER;
    }

    @Override
    public void unpack(byte[] packed, int packedLength, byte[] raw, int rawLength, int width, int height)
            throws IOException {
        throw new IOException("a chunk holds " + packedLength + " bytes instead of " + rawLength);
    }

    @Override
    public void close() {
        // Holds no resources.
    }
}
