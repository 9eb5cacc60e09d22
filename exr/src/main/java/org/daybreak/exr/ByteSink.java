package org.daybreak.exr;

import java.io.IOException;

/** Takes the bytes of a file in order; some of them may be replaced at the end. */
interface ByteSink {
    /** Appends bytes. */
    void write(byte[] bytes, int offset, int count) throws IOException;

    /** Replaces bytes that were written. Nothing may be appended afterwards. */
    void patch(long place, byte[] bytes) throws IOException;
}
