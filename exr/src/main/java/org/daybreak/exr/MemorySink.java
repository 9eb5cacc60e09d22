package org.daybreak.exr;

import java.io.IOException;
import java.util.Arrays;

/** Keeps the bytes in memory. */
final class MemorySink implements ByteSink {
    private static final int MAX_BYTES = Integer.MAX_VALUE - 8;

    private byte[] content = new byte[1 << 13];
    private int length;

    @Override
    public void write(byte[] bytes, int offset, int count) throws IOException {
        if (count > MAX_BYTES - length) {
            throw new IOException("the file does not fit an array");
        }
        if (count > content.length - length) {
            content = Arrays.copyOf(content, (int)
                    Math.min(MAX_BYTES, Math.max(2L * content.length, (long) length + count)));
        }
        System.arraycopy(bytes, offset, content, length, count);
        length += count;
    }

    @Override
    public void patch(long place, byte[] bytes) {
        System.arraycopy(bytes, 0, content, (int) place, bytes.length);
    }

    byte[] toByteArray() {
        return Arrays.copyOf(content, length);
    }
}
