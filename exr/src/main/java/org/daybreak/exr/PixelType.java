package org.daybreak.exr;

/** How one sample of a channel is stored. The order of the constants is that of the codes in the file. */
public enum PixelType {
    /** Unsigned 32-bit integer, held in a Java {@code int} with the same bits. */
    UINT(4),
    /** 16-bit floating point (IEEE 754 binary16), held in memory as {@code float}. */
    HALF(2),
    /** 32-bit floating point (IEEE 754 binary32). */
    FLOAT(4);

    private final int byteCount;

    PixelType(int byteCount) {
        this.byteCount = byteCount;
    }

    /**
     * Returns the size of one stored sample.
     *
     * @return bytes per sample in the file
     */
    public int byteCount() {
        return byteCount;
    }
}
