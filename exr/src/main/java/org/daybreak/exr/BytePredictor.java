package org.daybreak.exr;

/**
 * What RLE, ZIPS and ZIP do to bytes before they pack them: the even bytes are moved to the first half and the odd ones
 * to the second, and each byte is replaced by its difference from the byte before, plus 128. Bytes of like meaning
 * become neighbours and smooth pictures become runs.
 *
 * @see <a href="https://openexr.com/en/latest/OpenEXRFileLayout.html">OpenEXR file layout</a>
 */
final class BytePredictor {
    private BytePredictor() {}

    /** Sorts and takes differences. */
    static void encode(byte[] from, byte[] to, int length) {
        if (length == 0) {
            return;
        }
        int odd = (length + 1) / 2;
        int pairs = length / 2;
        int even = from[0];
        to[0] = (byte) even;
        for (int i = 1; i < odd; i++) {
            int next = from[2 * i];
            to[i] = (byte) (next - even + 128);
            even = next;
        }
        // The first odd byte follows the last even one.
        int before = even;
        for (int i = 0; i < pairs; i++) {
            int next = from[2 * i + 1];
            to[odd + i] = (byte) (next - before + 128);
            before = next;
        }
    }

    /** Takes sums and sorts back. */
    static void decode(byte[] from, byte[] to, int length) {
        if (length == 0) {
            return;
        }
        int odd = (length + 1) / 2;
        int pairs = length / 2;
        int value = from[0];
        to[0] = (byte) value;
        for (int i = 1; i < odd; i++) {
            value += from[i] - 128;
            to[2 * i] = (byte) value;
        }
        for (int i = 0; i < pairs; i++) {
            value += from[odd + i] - 128;
            to[2 * i + 1] = (byte) value;
        }
    }
}
