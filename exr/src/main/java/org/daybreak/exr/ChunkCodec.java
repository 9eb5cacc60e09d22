package org.daybreak.exr;

import java.io.IOException;

/**
 * Packs and unpacks the bytes of one chunk. An instance keeps its work space between calls and belongs to one thread at
 * a time.
 */
interface ChunkCodec extends AutoCloseable {
    /** Returned by {@link #pack} if the packed bytes would not be fewer; the chunk is then stored raw. */
    int NOT_SMALLER = -1;

    /**
     * Packs {@code raw[0 .. rawLength)} to {@code packed} from {@code offset} on, where {@code rawLength} bytes are
     * free.
     *
     * @return the number of packed bytes, below {@code rawLength}, or {@link #NOT_SMALLER}
     * @throws UnsupportedOperationException if the method can only be read
     */
    int pack(byte[] raw, int rawLength, byte[] packed, int offset);

    /**
     * Unpacks {@code packed[0 .. packedLength)} into exactly {@code rawLength} bytes of {@code raw}.
     *
     * @param width columns of the chunk
     * @param height rows of the chunk
     * @throws IOException if the packed bytes do not stand for exactly {@code rawLength} bytes; the message is a reason
     *     without a file name
     */
    void unpack(byte[] packed, int packedLength, byte[] raw, int rawLength, int width, int height) throws IOException;

    @Override
    void close();
}
