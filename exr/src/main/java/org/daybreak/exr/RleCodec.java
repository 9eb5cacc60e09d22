package org.daybreak.exr;

import java.io.IOException;
import java.util.Arrays;

/**
 * The codec of {@link Compression#RLE}: {@link BytePredictor}, then run lengths. A signed byte n comes first: if it is
 * negative, −n bytes follow as they are, else one byte follows that stands n + 1 times.
 */
final class RleCodec implements ChunkCodec {
    private static final int MIN_RUN = 3;
    /** Longest run; a stretch of bytes as they are is kept below it. */
    private static final int MAX_RUN = 128;

    private byte[] differences = new byte[0];

    @Override
    public int pack(byte[] raw, int rawLength, byte[] packed, int offset) {
        byte[] bytes = workSpace(rawLength);
        BytePredictor.encode(raw, bytes, rawLength);
        int end = offset + rawLength;
        int out = offset;
        int i = 0;
        while (i < rawLength) {
            int run = runLength(bytes, i, rawLength);
            if (run >= MIN_RUN) {
                if (out + 2 >= end) {
                    return NOT_SMALLER;
                }
                packed[out++] = (byte) (run - 1);
                packed[out++] = bytes[i];
                i += run;
                continue;
            }
            int start = i;
            do {
                i += run;
                run = i < rawLength ? runLength(bytes, i, rawLength) : MIN_RUN;
            } while (run < MIN_RUN && i + run - start < MAX_RUN);
            int count = i - start;
            if (out + 1 + count >= end) {
                return NOT_SMALLER;
            }
            packed[out++] = (byte) -count;
            System.arraycopy(bytes, start, packed, out, count);
            out += count;
        }
        return out - offset;
    }

    private static int runLength(byte[] bytes, int start, int end) {
        int limit = Math.min(end, start + MAX_RUN);
        int i = start + 1;
        while (i < limit && bytes[i] == bytes[start]) {
            i++;
        }
        return i - start;
    }

    @Override
    public void unpack(byte[] packed, int packedLength, byte[] raw, int rawLength, int width, int height)
            throws IOException {
        byte[] bytes = workSpace(rawLength);
        int out = 0;
        int i = 0;
        while (i < packedLength) {
            int count = packed[i++];
            int made = count < 0 ? -count : count + 1;
            int taken = count < 0 ? made : 1;
            if (taken > packedLength - i || made > rawLength - out) {
                throw new IOException("a run does not fit the chunk");
            }
            if (count < 0) {
                System.arraycopy(packed, i, bytes, out, made);
            } else {
                Arrays.fill(bytes, out, out + made, packed[i]);
            }
            i += taken;
            out += made;
        }
        if (out != rawLength) {
            throw new IOException("the runs make " + out + " bytes instead of " + rawLength);
        }
        BytePredictor.decode(bytes, raw, rawLength);
    }

    @Override
    public void close() {
        // Holds no resources.
    }

    private byte[] workSpace(int length) {
        if (differences.length < length) {
            differences = new byte[length];
        }
        return differences;
    }
}
