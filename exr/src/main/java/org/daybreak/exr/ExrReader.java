package org.daybreak.exr;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import org.jspecify.annotations.Nullable;

/**
 * Reads OpenEXR scanline images: one part, compression NONE, ZIPS or ZIP, channels of type HALF, FLOAT or UINT without
 * subsampling, rows stored in either order. What is not supported is refused by name.
 *
 * <p>Sizes that a file claims are held against its length before memory is taken. A table of chunk offsets that was
 * never filled in (the writer was stopped) is recovered from the chunks themselves.
 */
public final class ExrReader {
    /** First row and byte count before the bytes of each chunk. */
    static final int CHUNK_HEAD_BYTES = 8;

    private ExrReader() {}

    /**
     * Reads the header only. Compressions that cannot be unpacked are no error here.
     *
     * @param file file to read
     * @return the header
     * @throws ImageFileException if the file cannot be read, or its header is damaged or of an unsupported kind
     */
    public static ExrHeader readHeader(Path file) throws ImageFileException {
        try (FileSource source = FileSource.open(file)) {
            return HeaderParser.parse(source);
        }
    }

    /**
     * Reads an image, on as many threads as there are processors.
     *
     * @param file file to read
     * @return header and samples of all channels
     * @throws ImageFileException if the file cannot be read, is damaged, of an unsupported kind, or too large for the
     *     heap
     */
    public static ExrImage read(Path file) throws ImageFileException {
        return read(file, Runtime.getRuntime().availableProcessors());
    }

    /**
     * Reads an image.
     *
     * @param file file to read
     * @param threads most threads to use, at least 1; has no influence on the result
     * @return header and samples of all channels
     * @throws ImageFileException as {@link #read(Path)}
     * @throws IllegalArgumentException if the number of threads is below 1
     */
    public static ExrImage read(Path file, int threads) throws ImageFileException {
        if (threads < 1) {
            throw new IllegalArgumentException("the number of threads must be at least 1, not " + threads);
        }
        try (FileSource source = FileSource.open(file)) {
            return read(source, threads);
        } catch (OutOfMemoryError e) {
            // Caught here, where nothing refers to the image any more, so that there is room for the message.
            throw new ImageFileException(file, "the image is too large for the Java heap", e);
        }
    }

    private static ExrImage read(FileSource source, int threads) throws ImageFileException {
        ExrHeader header = HeaderParser.parse(source);
        if (!header.compression().isSupported()) {
            throw source.error(header.compression().notSupported());
        }
        ChunkLayout layout = ChunkLayout.of(source.path(), header, header.compression());
        checkSize(source, header, layout);
        long[] offsets = readOffsets(source, layout);
        ExrImage image = allocate(source, header, layout);
        readChunks(source, layout, offsets, image, threads);
        return image;
    }

    /** Refuses claims that the rest of the file cannot meet, however well it is packed. */
    private static void checkSize(FileSource source, ExrHeader header, ChunkLayout layout) throws ImageFileException {
        long leastBytes = (long) layout.chunkCount() * (Long.BYTES + CHUNK_HEAD_BYTES);
        long mostRawBytes;
        try (ChunkCodec codec = header.compression().openCodec(1)) {
            mostRawBytes = codec.maxRawLength(source.remaining());
        }
        if (leastBytes > source.remaining() || layout.rawBytes() > mostRawBytes) {
            throw source.error("the file is truncated or its header damaged: " + source.length() + " bytes cannot hold "
                    + header.width() + " x " + header.height() + " pixels");
        }
        // Each sample is held in four bytes.
        double neededBytes = 4.0 * layout.pixelCount() * header.channels().size()
                + (double) ChunkWorkers.BUFFERS_PER_SLOT * layout.maxRawLength();
        long heapBytes = Runtime.getRuntime().maxMemory();
        if (neededBytes > heapBytes) {
            throw source.error(String.format(
                    Locale.ROOT,
                    "the image is too large for the Java heap: it needs %.0f MB of %d MB",
                    neededBytes / 1e6,
                    heapBytes / 1_000_000));
        }
    }

    private static ExrImage allocate(FileSource source, ExrHeader header, ChunkLayout layout)
            throws ImageFileException {
        Map<String, float[]> samples = new HashMap<>();
        Map<String, int[]> uintSamples = new HashMap<>();
        for (ExrChannel channel : header.channels()) {
            if (channel.type() == PixelType.UINT) {
                uintSamples.put(channel.name(), source.newInts(layout.pixelCount()));
            } else {
                samples.put(channel.name(), source.newFloats(layout.pixelCount()));
            }
        }
        return new ExrImage(header, samples, uintSamples);
    }

    private static long[] readOffsets(FileSource source, ChunkLayout layout) throws ImageFileException {
        String what = "the table of chunk offsets";
        long[] offsets = new long[layout.chunkCount()];
        boolean complete = true;
        for (int i = 0; i < offsets.length; i++) {
            long low = Integer.toUnsignedLong(source.readInt(what));
            offsets[i] = low | (long) source.readInt(what) << 32;
            complete &= offsets[i] != 0;
        }
        long firstChunk = source.position();
        if (!complete) {
            return recoverOffsets(source, layout);
        }
        for (int i = 0; i < offsets.length; i++) {
            if (offsets[i] < firstChunk || offsets[i] > source.length() - CHUNK_HEAD_BYTES) {
                throw source.error("the file is truncated or damaged: the chunk of row " + layout.firstRow(i)
                        + " should start at byte " + Long.toUnsignedString(offsets[i]) + " of " + source.length());
            }
        }
        return offsets;
    }

    /** Walks from chunk to chunk; the source stands at the first one. */
    private static long[] recoverOffsets(FileSource source, ChunkLayout layout) throws ImageFileException {
        long[] offsets = new long[layout.chunkCount()];
        String what = "the head of a chunk";
        while (source.remaining() >= CHUNK_HEAD_BYTES) {
            long start = source.position();
            int chunk = layout.chunkOfFirstRow(source.readInt(what));
            int size = source.readInt(what);
            if (chunk < 0 || size < 0 || size > source.remaining()) {
                break;
            }
            offsets[chunk] = start;
            source.seek(start + CHUNK_HEAD_BYTES + size);
        }
        for (int i = 0; i < offsets.length; i++) {
            if (offsets[i] == 0) {
                throw source.error("the file is incomplete: the chunk of row " + layout.firstRow(i) + " is missing");
            }
        }
        return offsets;
    }

    private static void readChunks(FileSource source, ChunkLayout layout, long[] offsets, ExrImage image, int threads)
            throws ImageFileException {
        ChunkWorkers workers = new ChunkWorkers(threads, layout);
        Slot[] slots = new Slot[workers.slotCount()];
        try {
            for (int i = 0; i < slots.length; i++) {
                slots[i] = new Slot(source, layout, image);
            }
            for (int chunk = 0; chunk < offsets.length; chunk++) {
                Slot slot = slots[chunk % slots.length];
                slot.await();
                slot.load(chunk, offsets[chunk]);
                slot.task = workers.start(slot);
            }
            for (Slot slot : slots) {
                slot.await();
            }
        } catch (ImageFileException e) {
            throw e;
        } catch (IOException e) {
            throw new ImageFileException(source.path(), "cannot be read: " + e.getMessage(), e);
        } finally {
            workers.close();
            for (Slot slot : slots) {
                if (slot != null) {
                    slot.codec.close();
                }
            }
        }
    }

    /** Buffers and codec for one chunk under way. */
    private static final class Slot implements Callable<@Nullable Void> {
        private final FileSource source;
        private final ChunkLayout layout;
        private final ExrImage image;
        private final ChunkCodec codec;
        private final byte[] raw;
        private byte[] packed = new byte[0];
        private int packedLength;
        private int chunk;
        private @Nullable FutureTask<@Nullable Void> task;

        Slot(FileSource source, ChunkLayout layout, ExrImage image) throws ImageFileException {
            this.source = source;
            this.layout = layout;
            this.image = image;
            raw = source.newBytes(layout.maxRawLength());
            codec = image.header().compression().openCodec(1);
        }

        void await() throws IOException {
            if (task != null) {
                ChunkWorkers.await(task);
                task = null;
            }
        }

        /** Reads the bytes of a chunk; a chunk that is stored raw goes to its buffer at once. */
        void load(int newChunk, long offset) throws ImageFileException {
            chunk = newChunk;
            source.seek(offset);
            int row = source.readInt(what());
            packedLength = source.readInt(what());
            if (row != layout.firstRow(chunk)) {
                throw source.error("the file is damaged: the chunk of row " + layout.firstRow(chunk)
                        + " says that it starts at row " + row);
            }
            int rawLength = layout.rawLength(chunk);
            if (packedLength < 0 || packedLength > rawLength) {
                throw source.error("the file is damaged: " + what() + " claims "
                        + Integer.toUnsignedString(packedLength) + " bytes instead of at most " + rawLength);
            }
            if (packedLength > source.remaining()) {
                throw source.error("the file is truncated: it ends within " + what());
            }
            if (packedLength == rawLength) {
                source.read(raw, 0, packedLength, what());
            } else {
                if (packed.length < packedLength) {
                    packed = source.newBytes(packedLength);
                }
                source.read(packed, 0, packedLength, what());
            }
        }

        @Override
        public @Nullable Void call() throws ImageFileException {
            int rawLength = layout.rawLength(chunk);
            if (packedLength != rawLength) {
                try {
                    codec.unpack(packed, 0, packedLength, raw, rawLength);
                } catch (IOException e) {
                    throw new ImageFileException(
                            source.path(), "the file is damaged in " + what() + ": " + e.getMessage(), e);
                }
            }
            layout.scatter(raw, chunk, image);
            return null;
        }

        private String what() {
            return "the chunk of row " + layout.firstRow(chunk);
        }
    }
}
