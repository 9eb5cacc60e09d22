package org.daybreak.exr;

import java.io.IOException;
import java.util.Arrays;

/**
 * Decodes the Huffman codes of {@link Compression#PIZ}: canonical codes of up to 58 bits for 16-bit words and one more
 * symbol, which repeats the last word. Belongs to one thread at a time.
 *
 * <p>Layout: smallest and largest symbol, an unused word, the number of bits of the codes, another unused word (32 bits
 * each); code lengths of 6 bits, in which 59 to 62 stand for 2 to 5 symbols without code and 63 for 6 and more, as the
 * next 8 bits say; then, from a whole byte on, the codes. The largest symbol is the one that repeats; its code is
 * followed by 8 bits with the count.
 */
final class HuffmanDecoder {
    private static final int SYMBOLS = (1 << 16) + 1;
    private static final int MAX_CODE_BITS = 58;
    private static final int SHORT_ZERO_RUN = 59;
    private static final int LONG_ZERO_RUN = 63;
    private static final int HEAD_BYTES = 20;
    /** Codes up to this length are found in one look-up. */
    private static final int TABLE_BITS = 12;

    private final byte[] lengths = new byte[SYMBOLS];
    /** Symbols in order of their codes: by length, long ones first as their codes are smaller, then by symbol. */
    private final int[] sorted = new int[SYMBOLS];

    private final long[] firstCode = new long[MAX_CODE_BITS + 2];
    private final int[] firstIndex = new int[MAX_CODE_BITS + 2];
    private final int[] count = new int[MAX_CODE_BITS + 2];
    /** Symbol and length (symbol × 64 + length) for each start of a code, 0 where the code is longer or there is none. */
    private final int[] table = new int[1 << TABLE_BITS];

    private byte[] bytes = new byte[0];
    private int next;
    private int end;
    private long buffer;
    private int buffered;

    /**
     * Decodes exactly as many words as asked for.
     *
     * @throws IOException if the codes are damaged or stand for another number of words
     */
    void decode(byte[] packed, int offset, int length, short[] words, int wordCount) throws IOException {
        if (length < HEAD_BYTES) {
            throw new IOException("the Huffman codes end early");
        }
        bytes = packed;
        int smallest = int32(offset);
        int largest = int32(offset + 4);
        long bits = Integer.toUnsignedLong(int32(offset + 12));
        if (smallest < 0 || largest < smallest || largest >= SYMBOLS) {
            throw new IOException("the Huffman symbols " + smallest + " to " + largest + " are not valid");
        }
        start(offset + HEAD_BYTES, offset + length);
        readLengths(smallest, largest);
        buildTables(smallest, largest);
        // The rest of the last byte of the lengths is not used.
        int codes = next - buffered / Byte.SIZE;
        if (bits > 8L * (end - codes)) {
            throw new IOException("the Huffman codes end early");
        }
        start(codes, codes + (int) ((bits + 7) / 8));
        decodeWords(largest, bits, words, wordCount);
    }

    private int int32(int at) {
        return (bytes[at] & 0xff)
                | (bytes[at + 1] & 0xff) << 8
                | (bytes[at + 2] & 0xff) << 16
                | (bytes[at + 3] & 0xff) << 24;
    }

    private void start(int from, int to) {
        next = from;
        end = to;
        buffer = 0;
        buffered = 0;
    }

    /** Sees to it that at least 57 bits are buffered, or all that are left. New bits enter at the lower end. */
    private void fill() {
        while (buffered <= 56 && next < end) {
            buffer = buffer << 8 | (bytes[next++] & 0xff);
            buffered += 8;
        }
    }

    private int bits(int wanted) throws IOException {
        fill();
        if (buffered < wanted) {
            throw new IOException("the Huffman codes end early");
        }
        buffered -= wanted;
        return (int) (buffer >>> buffered) & ((1 << wanted) - 1);
    }

    private void readLengths(int smallest, int largest) throws IOException {
        Arrays.fill(lengths, (byte) 0);
        int symbol = smallest;
        while (symbol <= largest) {
            int length = bits(6);
            if (length < SHORT_ZERO_RUN) {
                lengths[symbol++] = (byte) length;
                continue;
            }
            int run = length == LONG_ZERO_RUN ? bits(8) + 6 : length - SHORT_ZERO_RUN + 2;
            if (run > largest + 1 - symbol) {
                throw new IOException("the table of Huffman code lengths is damaged");
            }
            symbol += run;
        }
    }

    /** Canonical codes: the longest start at 0; those one bit shorter go on from half of where the longer ones end. */
    private void buildTables(int smallest, int largest) throws IOException {
        Arrays.fill(count, 0);
        for (int symbol = smallest; symbol <= largest; symbol++) {
            count[lengths[symbol]]++;
        }
        long code = 0;
        int index = 0;
        for (int length = MAX_CODE_BITS; length > 0; length--) {
            firstCode[length] = code;
            firstIndex[length] = index;
            index += count[length];
            if (code + count[length] > 1L << length) {
                throw new IOException("the table of Huffman code lengths is damaged");
            }
            code = (code + count[length]) >> 1;
        }
        Arrays.fill(table, 0);
        int[] place = firstIndex.clone();
        for (int symbol = smallest; symbol <= largest; symbol++) {
            int length = lengths[symbol];
            if (length == 0) {
                continue;
            }
            int at = place[length]++;
            sorted[at] = symbol;
            if (length <= TABLE_BITS) {
                long own = firstCode[length] + at - firstIndex[length];
                int from = (int) own << (TABLE_BITS - length);
                Arrays.fill(table, from, from + (1 << (TABLE_BITS - length)), symbol << 6 | length);
            }
        }
    }

    private void decodeWords(int repeat, long bits, short[] words, int wordCount) throws IOException {
        long left = bits;
        int out = 0;
        while (left > 0) {
            fill();
            int entry = table[prefix(TABLE_BITS)];
            int symbol;
            int length;
            if (entry != 0) {
                symbol = entry >>> 6;
                length = entry & 63;
            } else {
                length = longLength();
                symbol = sorted[firstIndex[length] + (int) (wide(length) - firstCode[length])];
            }
            if (length > left) {
                throw new IOException("the Huffman codes end early");
            }
            left -= length;
            drop(length);
            if (symbol != repeat) {
                if (out == wordCount) {
                    throw new IOException("there are more Huffman codes than samples");
                }
                words[out++] = (short) symbol;
                continue;
            }
            if (left < 8 || out == 0) {
                throw new IOException("a Huffman run is damaged");
            }
            int run = bits(8);
            left -= 8;
            if (run > wordCount - out) {
                throw new IOException("there are more Huffman codes than samples");
            }
            Arrays.fill(words, out, out + run, words[out - 1]);
            out += run;
        }
        if (out != wordCount) {
            throw new IOException("there are " + out + " Huffman codes for " + wordCount + " samples");
        }
    }

    /** The next bits without taking them, filled up with zeros at the end; at most 57. */
    private int prefix(int wanted) {
        long value = buffered >= wanted ? buffer >>> (buffered - wanted) : buffer << (wanted - buffered);
        return (int) value & ((1 << wanted) - 1);
    }

    /** The length of the next code, which is longer than the table's. */
    private int longLength() throws IOException {
        for (int length = TABLE_BITS + 1; length <= MAX_CODE_BITS; length++) {
            if (count[length] > 0) {
                long code = wide(length);
                if (code >= firstCode[length] && code - firstCode[length] < count[length]) {
                    return length;
                }
            }
        }
        throw new IOException("there is a Huffman code that stands for nothing");
    }

    /** The next bits without taking them, up to 58: one more than the buffer is sure to hold. */
    private long wide(int wanted) {
        if (wanted <= buffered) {
            return (buffer >>> (buffered - wanted)) & ((1L << wanted) - 1);
        }
        int missing = wanted - buffered;
        long held = buffer & ((1L << buffered) - 1);
        int following = next < end ? bytes[next] & 0xff : 0;
        return held << missing | (missing <= 8 ? following >>> (8 - missing) : (long) following << (missing - 8));
    }

    private void drop(int length) {
        if (length <= buffered) {
            buffered -= length;
            return;
        }
        int missing = length - buffered;
        buffered = 0;
        fill();
        buffered -= missing;
    }
}
