package org.daybreak.exr;

/**
 * How an OpenEXR file is to be written.
 *
 * @param compression NONE, RLE, ZIPS or ZIP
 * @param deflateLevel effort of ZIPS and ZIP, 1 (fast) to 9 (small)
 * @param threads most threads to use, at least 1; has no influence on the bytes of the file
 */
public record ExrWriteOptions(Compression compression, int deflateLevel, int threads) {
    /** The level that the official library uses unless told otherwise. */
    private static final int DEFAULT_DEFLATE_LEVEL = 4;

    /**
     * Checks the options.
     *
     * @throws IllegalArgumentException if the compression cannot be written or a number is out of its range
     */
    public ExrWriteOptions {
        if (!compression.isWritable()) {
            throw new IllegalArgumentException(compression.notWritable());
        }
        if (deflateLevel < 1 || deflateLevel > 9) {
            throw new IllegalArgumentException("the deflate level must be 1 to 9, not " + deflateLevel);
        }
        if (threads < 1) {
            throw new IllegalArgumentException("the number of threads must be at least 1, not " + threads);
        }
    }

    /**
     * Returns ZIP at level 4 on as many threads as there are processors.
     *
     * @return the options
     */
    public static ExrWriteOptions defaults() {
        return new ExrWriteOptions(
                Compression.ZIP, DEFAULT_DEFLATE_LEVEL, Runtime.getRuntime().availableProcessors());
    }

    /**
     * Returns these options with another compression.
     *
     * @param other NONE, RLE, ZIPS or ZIP
     * @return changed options
     * @throws IllegalArgumentException if the compression cannot be written
     */
    public ExrWriteOptions withCompression(Compression other) {
        return new ExrWriteOptions(other, deflateLevel, threads);
    }

    /**
     * Returns these options with another number of threads.
     *
     * @param count most threads to use
     * @return changed options
     * @throws IllegalArgumentException if the number is below 1
     */
    public ExrWriteOptions withThreads(int count) {
        return new ExrWriteOptions(compression, deflateLevel, count);
    }
}
