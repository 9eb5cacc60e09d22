package org.daybreak.exr;

import org.jspecify.annotations.Nullable;

/**
 * How the chunks of an OpenEXR file are packed. All methods that the file format knows are listed so that a file can be
 * refused by name; {@link #isSupported()} tells which can be read and written.
 */
public enum Compression {
    /** Not packed, one row per chunk. */
    NONE(0, 1),
    /** Run lengths, one row per chunk. */
    RLE(1, 1),
    /** Deflate, one row per chunk. */
    ZIPS(2, 1),
    /** Deflate, 16 rows per chunk. */
    ZIP(3, 16),
    /** Wavelets and Huffman codes, 32 rows per chunk. */
    PIZ(4, 32),
    /** Floats cut to 24 bits, then deflate, 16 rows per chunk. */
    PXR24(5, 16),
    /** Blocks of 4×4 halves at a fixed rate (lossy), 32 rows per chunk. */
    B44(6, 32),
    /** As B44, with flat blocks stored in fewer bytes (lossy), 32 rows per chunk. */
    B44A(7, 32),
    /** Cosine transform (lossy), 32 rows per chunk. */
    DWAA(8, 32),
    /** Cosine transform (lossy), 256 rows per chunk. */
    DWAB(9, 256),
    /** High-throughput JPEG 2000, 256 rows per chunk. */
    HTJ2K256(10, 256),
    /** High-throughput JPEG 2000, 32 rows per chunk. */
    HTJ2K32(11, 32),
    /** JPEG 2000, 256 rows per chunk. */
    LJ2K(12, 256),
    /** Zstandard, 1 row per chunk. */
    ZSTD(13, 1);

    private final int code;
    private final int linesPerChunk;

    Compression(int code, int linesPerChunk) {
        this.code = code;
        this.linesPerChunk = linesPerChunk;
    }

    /**
     * Returns the number that stands for this method in the header of a file.
     *
     * @return the code, 0 to 255
     */
    public int code() {
        return code;
    }

    /**
     * Tells whether {@link ExrReader} and {@link ExrWriter} know this method.
     *
     * @return true if pixels can be read and written
     */
    public boolean isSupported() {
        return this == NONE || this == ZIPS || this == ZIP;
    }

    int linesPerChunk() {
        return linesPerChunk;
    }

    /** The method with the given code, or null if the format has none. */
    static @Nullable Compression ofCode(int code) {
        for (Compression compression : values()) {
            if (compression.code == code) {
                return compression;
            }
        }
        return null;
    }

    /**
     * Opens a codec for one thread.
     *
     * @param deflateLevel level 0 to 9 for the methods that deflate
     * @throws UnsupportedOperationException if the method is not supported
     */
    ChunkCodec openCodec(int deflateLevel) {
        return switch (this) {
            case NONE -> new RawCodec();
            case ZIPS, ZIP -> new DeflateCodec(deflateLevel);
            default -> throw new UnsupportedOperationException(notSupported());
        };
    }

    /** The reason given when a file or a caller asks for a method that is not supported. */
    String notSupported() {
        return "compression " + name() + " is not supported";
    }
}
