package org.daybreak.exr;

import org.jspecify.annotations.Nullable;

/** How one sample of a channel is stored. */
public enum PixelType {
    /** Unsigned 32-bit integer, held in a Java {@code int} with the same bits. */
    UINT(0, 4),
    /** 16-bit floating point (IEEE 754 binary16), held in memory as {@code float}. */
    HALF(1, 2),
    /** 32-bit floating point (IEEE 754 binary32). */
    FLOAT(2, 4);

    private final int code;
    private final int byteCount;

    PixelType(int code, int byteCount) {
        this.code = code;
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

    /** The number that stands for this type in a channel list. */
    int code() {
        return code;
    }

    /** The type with the given code, or null if the format has none. */
    static @Nullable PixelType ofCode(int code) {
        for (PixelType type : values()) {
            if (type.code == code) {
                return type;
            }
        }
        return null;
    }
}
