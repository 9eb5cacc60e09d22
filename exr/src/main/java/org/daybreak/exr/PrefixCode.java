package org.daybreak.exr;

import java.util.Arrays;

/** A Huffman code of limited length as deflate wants it (RFC 1951, section 3.2.2). Reused from block to block. */
final class PrefixCode {
    private final int maxLength;
    /** Length of each symbol's code, 0 for symbols that do not occur. */
    final byte[] lengths;
    /** Code with its first bit lowest, and length × 2^16, of each symbol. */
    final int[] codes;

    /** Frequency × 2^9 + symbol of the symbols that occur, in increasing order. */
    private final int[] sorted;
    /** Weights, then depths of the inner nodes of the tree. */
    private final int[] inner;

    private final int[] parentOfLeaf;
    private final int[] parentOfInner;
    private final int[] count;
    private final int[] next;

    PrefixCode(int symbols, int maxLength) {
        this.maxLength = maxLength;
        lengths = new byte[symbols];
        codes = new int[symbols];
        sorted = new int[symbols];
        inner = new int[symbols];
        parentOfLeaf = new int[symbols];
        parentOfInner = new int[symbols];
        count = new int[Math.max(symbols, maxLength + 1) + 1];
        next = new int[maxLength + 2];
    }

    /**
     * Makes the code for frequencies, each below 2^22. Two symbols at least get a code, as not all readers take less.
     */
    void build(int[] frequencies) {
        int used = 0;
        for (int symbol = 0; symbol < lengths.length; symbol++) {
            if (frequencies[symbol] > 0) {
                sorted[used++] = frequencies[symbol] << 9 | symbol;
            }
        }
        for (int symbol = 0; used < 2; symbol++) {
            if (frequencies[symbol] == 0) {
                sorted[used++] = 1 << 9 | symbol;
            }
        }
        Arrays.sort(sorted, 0, used);
        countLengths(used);
        limitLengths();
        assign(used);
    }

    /** Huffman's algorithm with two queues: leaves by weight, and inner nodes, which are made in order of weight. */
    private void countLengths(int used) {
        int leaf = 0;
        int node = 0;
        int[] weight = inner;
        int made = 0;
        for (; made < used - 1; made++) {
            int sum = 0;
            for (int child = 0; child < 2; child++) {
                if (leaf < used && (node >= made || sorted[leaf] >>> 9 <= weight[node])) {
                    sum += sorted[leaf] >>> 9;
                    parentOfLeaf[leaf++] = made;
                } else {
                    sum += weight[node];
                    parentOfInner[node++] = made;
                }
            }
            weight[made] = sum;
        }
        // From the root downwards; the place of weights now takes depths.
        int[] depth = inner;
        depth[made - 1] = 0;
        for (int i = made - 2; i >= 0; i--) {
            depth[i] = depth[parentOfInner[i]] + 1;
        }
        Arrays.fill(count, 0);
        for (int i = 0; i < used; i++) {
            count[depth[parentOfLeaf[i]] + 1]++;
        }
    }

    /** Shortens codes that are too long, and lengthens the cheapest others until all fit. */
    private void limitLengths() {
        for (int length = count.length - 1; length > maxLength; length--) {
            count[maxLength] += count[length];
            count[length] = 0;
        }
        long total = 0;
        for (int length = 1; length <= maxLength; length++) {
            total += (long) count[length] << (maxLength - length);
        }
        for (; total > 1L << maxLength; total--) {
            count[maxLength]--;
            int length = maxLength - 1;
            while (count[length] == 0) {
                length--;
            }
            count[length]--;
            count[length + 1] += 2;
        }
    }

    private void assign(int used) {
        Arrays.fill(lengths, (byte) 0);
        int at = 0;
        for (int length = maxLength; length > 0; length--) {
            for (int i = 0; i < count[length]; i++) {
                lengths[sorted[at++] & 511] = (byte) length;
            }
        }
        if (at != used) {
            throw new AssertionError(at + " codes for " + used + " symbols");
        }
        int code = 0;
        for (int length = 1; length <= maxLength; length++) {
            next[length] = code;
            code = (code + count[length]) << 1;
        }
        for (int symbol = 0; symbol < lengths.length; symbol++) {
            int length = lengths[symbol];
            codes[symbol] =
                    length == 0 ? 0 : Integer.reverse(next[length]++) >>> (Integer.SIZE - length) | length << 16;
        }
    }
}
