package org.daybreak.exr;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How the chunks of an OpenEXR file are packed. All methods that the file format knows are listed so that a file can be
 * refused by name; {@link #isReadable()} and {@link #isWritable()} tell what is supported.
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
     * Tells whether {@link ExrReader} can unpack this method.
     *
     * @return true for NONE, RLE, ZIPS, ZIP, PIZ and PXR24
     */
    public boolean isReadable() {
        return isWritable() || this == PIZ || this == PXR24;
    }

    /**
     * Tells whether {@link ExrWriter} can pack with this method; then it can also be read.
     *
     * @return true for NONE, RLE, ZIPS and ZIP
     */
    public boolean isWritable() {
        return this == NONE || this == RLE || this == ZIPS || this == ZIP;
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
     * @param channels the channels of a part
     * @throws UnsupportedOperationException if the method cannot be read
     */
    ChunkCodec openCodec(int deflateLevel, List<ExrChannel> channels) {
        return switch (this) {
            case NONE -> new RawCodec();
            case RLE -> new RleCodec();
            case ZIPS, ZIP -> new DeflateCodec(deflateLevel);
            case PIZ -> new PizCodec(channels);
            case PXR24 -> new Pxr24Codec(channels);
            default -> throw new UnsupportedOperationException(notSupported());
        };
    }

    /** An upper bound of the raw bytes that one packed byte can stand for. */
    int maxExpansion() {
        return switch (this) {
            case NONE -> 1;
            case RLE -> 64;
            // At best two bits stand for 258 bytes.
            case ZIPS, ZIP -> 1032;
            // At best ten bits stand for 256 words of two bytes.
            case PIZ -> 410;
            // As ZIP, and every third byte may be followed by one that is not stored.
            case PXR24 -> 1376;
            default -> throw new UnsupportedOperationException(notSupported());
        };
    }

    /** The reason given when a file asks for a method that is not supported. */
    String notSupported() {
        return "compression " + name() + " is not supported";
    }

    /** The reason given when a caller asks for a method that is not written. */
    String notWritable() {
        return isReadable() ? "compression " + name() + " can be read, but not written" : notSupported();
    }
}
