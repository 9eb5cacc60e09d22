package org.daybreak.exr;

import java.io.IOException;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;

/** Inflates whole chunks; belongs to one thread at a time. */
final class Inflation implements AutoCloseable {
    private final Inflater inflater = new Inflater();
    private final byte[] surplus = new byte[1];

    /** Inflates {@code packed[0 .. packedLength)} to exactly {@code length} bytes, or says what is wrong. */
    void inflate(byte[] packed, int packedLength, byte[] to, int length) throws IOException {
        inflater.reset();
        inflater.setInput(packed, 0, packedLength);
        try {
            int got = inflater.inflate(to, 0, length);
            // One more step reads the checksum behind the last byte and finds out whether there are too many bytes.
            if (got != length || (!inflater.finished() && inflater.inflate(surplus) != 0)) {
                throw new IOException("a deflated chunk does not hold its " + length + " bytes");
            }
        } catch (DataFormatException e) {
            throw new IOException("a deflated chunk is damaged", e);
        }
        if (!inflater.finished()) {
            throw new IOException("a deflated chunk ends early");
        }
    }

    @Override
    public void close() {
        inflater.end();
    }
}
