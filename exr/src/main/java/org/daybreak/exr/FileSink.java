package org.daybreak.exr;

import java.io.IOException;
import java.io.RandomAccessFile;

/** Writes to a file. */
final class FileSink implements ByteSink {
    private final RandomAccessFile file;

    FileSink(RandomAccessFile file) {
        this.file = file;
    }

    @Override
    public void write(byte[] bytes, int offset, int count) throws IOException {
        file.write(bytes, offset, count);
    }

    @Override
    public void patch(long place, byte[] bytes) throws IOException {
        file.seek(place);
        file.write(bytes);
    }
}
