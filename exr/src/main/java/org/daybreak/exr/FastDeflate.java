package org.daybreak.exr;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.zip.Adler32;

/**
 * Deflates whole chunks to zlib streams (RFC 1950 and 1951), several times as fast as the JDK's {@link
 * java.util.zip.Deflater} on samples of pictures, at somewhat larger sizes: half of their bytes are noise, in which the
 * search for repetitions is given up step by step. Repetitions are of four bytes or more at the last place of the same hash;
 * each block has Huffman codes of its own or is stored. Belongs to one thread at a time; the output depends on the input
 * alone.
 */
final class FastDeflate {
    private static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle LONG = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    private static final int HASH_BITS = 14;
    private static final int MIN_MATCH = 4;
    private static final int MAX_MATCH = 258;
    private static final int MAX_DISTANCE = 1 << 15;
    /** Four bytes from further away than this cost more than they save. */
    private static final int MAX_SHORT_DISTANCE = 1 << 12;
    /** Literals and repetitions in one block. */
    private static final int BLOCK_SYMBOLS = 20_000;
    /** The step of the search grows by one after 2 to this power failures. */
    private static final int FAILURES_PER_STEP_BITS = 5;

    private static final int MAX_STEP = 16;

    private static final int END_OF_BLOCK = 256;
    private static final int LENGTH_SYMBOLS = 257;
    private static final int LITERAL_SYMBOLS = 286;
    private static final int DISTANCE_SYMBOLS = 30;
    private static final int MAX_STORED = 0xffff;
    /** Room for a store of 8 bytes behind the last one, the checksum, and the end of a byte. */
    private static final int SLACK = 16;

    private static final int[] LENGTH_BASE = new int[29];
    private static final int[] LENGTH_EXTRA = new int[29];
    private static final int[] DISTANCE_BASE = new int[DISTANCE_SYMBOLS];
    private static final int[] DISTANCE_EXTRA = new int[DISTANCE_SYMBOLS];
    /** Symbol less 257 of each length. */
    private static final byte[] LENGTH_SYMBOL = new byte[MAX_MATCH + 1];
    /** The order in which lengths of the code of code lengths are written. */
    private static final int[] ORDER = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};

    static {
        int base = 3;
        for (int i = 0; i < 28; i++) {
            LENGTH_EXTRA[i] = i < 8 ? 0 : i / 4 - 1;
            LENGTH_BASE[i] = base;
            for (int j = 0; j < 1 << LENGTH_EXTRA[i]; j++) {
                LENGTH_SYMBOL[Math.min(base++, MAX_MATCH)] = (byte) i;
            }
        }
        LENGTH_BASE[28] = MAX_MATCH;
        LENGTH_SYMBOL[MAX_MATCH] = 28;
        int distance = 1;
        for (int i = 0; i < DISTANCE_SYMBOLS; i++) {
            DISTANCE_EXTRA[i] = i < 4 ? 0 : i / 2 - 1;
            DISTANCE_BASE[i] = distance;
            distance += 1 << DISTANCE_EXTRA[i];
        }
    }

    /** The last place of each hash. */
    private final int[] lastPlace = new int[1 << HASH_BITS];
    /** Added to places in the table, so that those of earlier chunks are below it and need not be cleared. */
    private int base = 1;

    /** Literals before each repetition of the block, and length × 2^16 + distance. */
    private final int[] literalRuns = new int[BLOCK_SYMBOLS + 1];

    private final int[] matches = new int[BLOCK_SYMBOLS + 1];
    private int matchCount;

    private final int[] literalFrequencies = new int[LITERAL_SYMBOLS];
    private final int[] distanceFrequencies = new int[DISTANCE_SYMBOLS];
    private final int[] lengthFrequencies = new int[19];
    private final PrefixCode literalCode = new PrefixCode(LITERAL_SYMBOLS, 15);
    private final PrefixCode distanceCode = new PrefixCode(DISTANCE_SYMBOLS, 15);
    private final PrefixCode lengthCode = new PrefixCode(19, 7);
    /** The code lengths of a block, run lengths packed: symbol + extra bits × 2^8. */
    private final int[] packedLengths = new int[LITERAL_SYMBOLS + DISTANCE_SYMBOLS];

    private int packedLengthCount;

    private byte[] out = new byte[0];
    private int at;
    private long bits;
    private int bitCount;

    /**
     * Deflates {@code in[0 .. length)} to {@code to} from {@code offset} on.
     *
     * @return the number of bytes, or −1 if they are not, or just about not, fewer than {@code length}
     */
    int deflate(byte[] in, int length, byte[] to, int offset) {
        int limit = offset + length - SLACK;
        if (limit < offset + 2) {
            return -1;
        }
        if (base > Integer.MAX_VALUE - length - MAX_DISTANCE) {
            Arrays.fill(lastPlace, 0);
            base = 1;
        }
        out = to;
        at = offset;
        bits = 0;
        bitCount = 0;
        // Deflate with a window of 32 KiB, fast, and a number that makes the two bytes a multiple of 31.
        out[at++] = 0x78;
        out[at++] = 0x5e;
        int start = 0;
        while (start < length) {
            int end = findMatches(in, start, length);
            if (!writeBlock(in, start, end, end == length, limit)) {
                base += length;
                return -1;
            }
            start = end;
        }
        base += length;
        putBits(0, (8 - bitCount) & 7);
        Adler32 checksum = new Adler32();
        checksum.update(in, 0, length);
        int sum = (int) checksum.getValue();
        for (int shift = 24; shift >= 0; shift -= 8) {
            out[at++] = (byte) (sum >>> shift);
        }
        return at - offset;
    }

    /** Fills the block with the literals and repetitions from {@code start} on and returns where it ends. */
    private int findMatches(byte[] in, int start, int length) {
        matchCount = 0;
        int symbols = 0;
        int literalStart = start;
        int failures = 0;
        int place = start;
        int lastStart = length - MIN_MATCH;
        while (place <= lastStart && symbols + place - literalStart < BLOCK_SYMBOLS) {
            int word = (int) INT.get(in, place);
            int hash = (word * 0x9E3779B1) >>> (Integer.SIZE - HASH_BITS);
            int candidate = lastPlace[hash] - base;
            lastPlace[hash] = place + base;
            int distance = place - candidate;
            if (candidate >= 0 && distance <= MAX_DISTANCE && (int) INT.get(in, candidate) == word) {
                int matched = matchLength(in, candidate, place, Math.min(length - place, MAX_MATCH));
                if (matched > MIN_MATCH || distance <= MAX_SHORT_DISTANCE) {
                    literalRuns[matchCount] = place - literalStart;
                    matches[matchCount++] = matched << 16 | distance;
                    symbols += place - literalStart + 1;
                    place += matched;
                    literalStart = place;
                    failures = 0;
                    continue;
                }
            }
            place += Math.min(1 + (failures++ >> FAILURES_PER_STEP_BITS), MAX_STEP);
        }
        // What is too near to the end for a search is literals.
        int blockEnd = place > lastStart ? length : place;
        literalRuns[matchCount] = blockEnd - literalStart;
        return blockEnd;
    }

    private static int matchLength(byte[] in, int candidate, int place, int most) {
        int length = MIN_MATCH;
        while (length + Long.BYTES <= most) {
            long difference = (long) LONG.get(in, candidate + length) ^ (long) LONG.get(in, place + length);
            if (difference != 0) {
                return length + (Long.numberOfTrailingZeros(difference) >> 3);
            }
            length += Long.BYTES;
        }
        while (length < most && in[candidate + length] == in[place + length]) {
            length++;
        }
        return length;
    }

    /** Writes the block in its cheaper form; returns false if there is no room. */
    private boolean writeBlock(byte[] in, int start, int end, boolean last, int limit) {
        countFrequencies(in, start);
        literalCode.build(literalFrequencies);
        distanceCode.build(distanceFrequencies);
        packLengths();
        lengthCode.build(lengthFrequencies);
        long codedBits = codedBits();
        long storedBytes = end - start + 5L * ((end - start) / MAX_STORED + 1) + 1;
        long bytes = Math.min(codedBits / 8 + 2, storedBytes);
        if (bytes > limit - at) {
            return false;
        }
        if (codedBits / 8 < storedBytes) {
            putBits(last ? 5 : 4, 3);
            writeCodes();
            writeSymbols(in, start);
        } else {
            writeStored(in, start, end, last);
        }
        return true;
    }

    private void countFrequencies(byte[] in, int start) {
        Arrays.fill(literalFrequencies, 0);
        Arrays.fill(distanceFrequencies, 0);
        int place = start;
        for (int i = 0; i <= matchCount; i++) {
            int runEnd = place + literalRuns[i];
            for (; place < runEnd; place++) {
                literalFrequencies[in[place] & 0xff]++;
            }
            if (i < matchCount) {
                int match = matches[i];
                literalFrequencies[LENGTH_SYMBOLS + LENGTH_SYMBOL[match >>> 16]]++;
                distanceFrequencies[distanceSymbol(match & 0xffff)]++;
                place += match >>> 16;
            }
        }
        literalFrequencies[END_OF_BLOCK] = 1;
    }

    private static int distanceSymbol(int distance) {
        int less = distance - 1;
        if (less < 4) {
            return less;
        }
        int power = Integer.SIZE - 1 - Integer.numberOfLeadingZeros(less);
        return 2 * power + (less >>> (power - 1) & 1);
    }

    /** Packs the lengths of both codes: 16 repeats the last one 3 to 6 times, 17 and 18 stand for 3 to 138 zeros. */
    private void packLengths() {
        Arrays.fill(lengthFrequencies, 0);
        packedLengthCount = 0;
        int all = LITERAL_SYMBOLS + DISTANCE_SYMBOLS;
        int i = 0;
        while (i < all) {
            int length = codeLength(i);
            int run = 1;
            while (i + run < all && codeLength(i + run) == length) {
                run++;
            }
            i += run;
            if (length == 0) {
                while (run >= 11) {
                    int taken = Math.min(run, 138);
                    pack(18, taken - 11);
                    run -= taken;
                }
                if (run >= 3) {
                    pack(17, run - 3);
                    run = 0;
                }
            } else {
                pack(length, 0);
                run--;
                while (run >= 3) {
                    int taken = Math.min(run, 6);
                    pack(16, taken - 3);
                    run -= taken;
                }
            }
            for (; run > 0; run--) {
                pack(length, 0);
            }
        }
    }

    private int codeLength(int i) {
        return i < LITERAL_SYMBOLS ? literalCode.lengths[i] : distanceCode.lengths[i - LITERAL_SYMBOLS];
    }

    private void pack(int symbol, int extra) {
        packedLengths[packedLengthCount++] = symbol | extra << 8;
        lengthFrequencies[symbol]++;
    }

    private static int extraBitsOfLength(int symbol) {
        return switch (symbol) {
            case 16 -> 2;
            case 17 -> 3;
            case 18 -> 7;
            default -> 0;
        };
    }

    private long codedBits() {
        long sum = 3 + 14 + 3 * 19;
        for (int i = 0; i < lengthFrequencies.length; i++) {
            sum += (long) lengthFrequencies[i] * (lengthCode.lengths[i] + extraBitsOfLength(i));
        }
        for (int i = 0; i < LITERAL_SYMBOLS; i++) {
            int extra = i < LENGTH_SYMBOLS ? 0 : LENGTH_EXTRA[i - LENGTH_SYMBOLS];
            sum += (long) literalFrequencies[i] * (literalCode.lengths[i] + extra);
        }
        for (int i = 0; i < DISTANCE_SYMBOLS; i++) {
            sum += (long) distanceFrequencies[i] * (distanceCode.lengths[i] + DISTANCE_EXTRA[i]);
        }
        return sum;
    }

    private void writeCodes() {
        putBits(LITERAL_SYMBOLS - 257, 5);
        putBits(DISTANCE_SYMBOLS - 1, 5);
        putBits(ORDER.length - 4, 4);
        for (int symbol : ORDER) {
            putBits(lengthCode.lengths[symbol], 3);
        }
        for (int i = 0; i < packedLengthCount; i++) {
            int symbol = packedLengths[i] & 0xff;
            int code = lengthCode.codes[symbol];
            putBits(code & 0xffff, code >>> 16);
            putBits(packedLengths[i] >>> 8, extraBitsOfLength(symbol));
        }
    }

    private void writeSymbols(byte[] in, int start) {
        int[] codes = literalCode.codes;
        int[] distanceCodes = distanceCode.codes;
        byte[] to = out;
        int place = start;
        int to0 = at;
        long held = bits;
        int heldCount = bitCount;
        for (int i = 0; i <= matchCount; i++) {
            int runEnd = place + literalRuns[i];
            // Three codes of at most 15 bits fit beside the up to 7 bits that remain.
            for (; place + 2 < runEnd; place += 3) {
                int first = codes[in[place] & 0xff];
                int second = codes[in[place + 1] & 0xff];
                int third = codes[in[place + 2] & 0xff];
                held |= (long) (first & 0xffff) << heldCount;
                heldCount += first >>> 16;
                held |= (long) (second & 0xffff) << heldCount;
                heldCount += second >>> 16;
                held |= (long) (third & 0xffff) << heldCount;
                heldCount += third >>> 16;
                LONG.set(to, to0, held);
                to0 += heldCount >>> 3;
                held >>>= heldCount & ~7;
                heldCount &= 7;
            }
            for (; place < runEnd; place++) {
                int code = codes[in[place] & 0xff];
                held |= (long) (code & 0xffff) << heldCount;
                heldCount += code >>> 16;
            }
            LONG.set(to, to0, held);
            to0 += heldCount >>> 3;
            held >>>= heldCount & ~7;
            heldCount &= 7;
            if (i == matchCount) {
                break;
            }
            int length = matches[i] >>> 16;
            int distance = matches[i] & 0xffff;
            int symbol = LENGTH_SYMBOL[length];
            int code = codes[LENGTH_SYMBOLS + symbol];
            // Together at most 15 + 5 + 15 + 13 bits.
            held |= (long) (code & 0xffff) << heldCount;
            heldCount += code >>> 16;
            held |= (long) (length - LENGTH_BASE[symbol]) << heldCount;
            heldCount += LENGTH_EXTRA[symbol];
            symbol = distanceSymbol(distance);
            code = distanceCodes[symbol];
            held |= (long) (code & 0xffff) << heldCount;
            heldCount += code >>> 16;
            held |= (long) (distance - DISTANCE_BASE[symbol]) << heldCount;
            heldCount += DISTANCE_EXTRA[symbol];
            LONG.set(to, to0, held);
            to0 += heldCount >>> 3;
            held >>>= heldCount & ~7;
            heldCount &= 7;
            place += length;
        }
        at = to0;
        bits = held;
        bitCount = heldCount;
        int end = codes[END_OF_BLOCK];
        putBits(end & 0xffff, end >>> 16);
    }

    private void writeStored(byte[] in, int start, int end, boolean last) {
        int place = start;
        do {
            int count = Math.min(end - place, MAX_STORED);
            putBits(last && place + count == end ? 1 : 0, 3);
            putBits(0, (8 - bitCount) & 7);
            putBits(count, 16);
            putBits(count ^ 0xffff, 16);
            System.arraycopy(in, place, out, at, count);
            at += count;
            place += count;
        } while (place < end);
    }

    /** Appends bits and writes all whole bytes. */
    private void putBits(int value, int count) {
        bits |= (long) value << bitCount;
        bitCount += count;
        while (bitCount >= 8) {
            out[at++] = (byte) bits;
            bits >>>= 8;
            bitCount -= 8;
        }
    }
}
