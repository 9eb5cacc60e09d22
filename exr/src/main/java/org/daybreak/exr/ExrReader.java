package org.daybreak.exr;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import org.jspecify.annotations.Nullable;

/**
 * Reads OpenEXR images: one or several parts, scan lines or tiles with all their levels, compression NONE, RLE, ZIPS,
 * ZIP, PIZ or PXR24, channels of type HALF, FLOAT or UINT, chunks stored in any order. What is not supported — deep
 * images, the other compressions, subsampled channels — is refused by name.
 *
 * <p>Sizes that a file claims are held against its length before memory is taken. A table of chunk offsets that was
 * never filled in (the writer was stopped) is recovered from the chunks themselves. Any bytes give an image or an
 * {@link ImageFileException}, and no other exception.
 */
public final class ExrReader {
    private ExrReader() {}

    /**
     * Reads the header of the first part only. Compressions that cannot be unpacked are no error here.
     *
     * @param file file to read
     * @return the header
     * @throws ImageFileException if the file cannot be read, or its header is damaged or of an unsupported kind
     */
    public static ExrHeader readHeader(Path file) throws ImageFileException {
        return readHeaders(file).get(0);
    }

    /**
     * Reads the headers of all parts. Compressions that cannot be unpacked are no error here.
     *
     * @param file file to read
     * @return the headers in file order, at least one
     * @throws ImageFileException if the file cannot be read, or a header is damaged or of an unsupported kind
     */
    public static List<ExrHeader> readHeaders(Path file) throws ImageFileException {
        try (ImageSource source = ImageSource.open(file)) {
            return List.copyOf(HeaderParser.parse(source).parts());
        }
    }

    /**
     * Reads the headers of all parts of a file that is in memory.
     *
     * @param name what errors are to call the file
     * @param bytes content of the file
     * @return the headers in file order, at least one
     * @throws ImageFileException as {@link #readHeaders(Path)}
     */
    public static List<ExrHeader> readHeaders(String name, byte[] bytes) throws ImageFileException {
        return List.copyOf(HeaderParser.parse(ImageSource.of(name, bytes)).parts());
    }

    /**
     * Reads the image of a file, on as many threads as there are processors. Of a file with several parts it is the
     * first one.
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
     * Reads the image of a file. Of a file with several parts it is the first one.
     *
     * @param file file to read
     * @param threads most threads to use, at least 1; has no influence on the result
     * @return header and samples of all channels
     * @throws ImageFileException as {@link #read(Path)}
     * @throws IllegalArgumentException if the number of threads is below 1
     */
    public static ExrImage read(Path file, int threads) throws ImageFileException {
        try (ImageSource source = ImageSource.open(file)) {
            return read(source, threads, true).get(0);
        }
    }

    /**
     * Reads all parts of a file, on as many threads as there are processors.
     *
     * @param file file to read
     * @return the parts in file order, at least one; those of a file with several parts have names
     * @throws ImageFileException as {@link #read(Path)}
     */
    public static List<ExrImage> readParts(Path file) throws ImageFileException {
        return readParts(file, Runtime.getRuntime().availableProcessors());
    }

    /**
     * Reads all parts of a file.
     *
     * @param file file to read
     * @param threads most threads to use, at least 1; has no influence on the result
     * @return the parts in file order, at least one; those of a file with several parts have names
     * @throws ImageFileException as {@link #read(Path)}
     * @throws IllegalArgumentException if the number of threads is below 1
     */
    public static List<ExrImage> readParts(Path file, int threads) throws ImageFileException {
        try (ImageSource source = ImageSource.open(file)) {
            return read(source, threads, false);
        }
    }

    /**
     * Reads all parts of a file that is in memory.
     *
     * @param name what errors are to call the file
     * @param bytes content of the file
     * @param threads most threads to use, at least 1; has no influence on the result
     * @return the parts in file order, at least one
     * @throws ImageFileException as {@link #read(Path)}
     * @throws IllegalArgumentException if the number of threads is below 1
     */
    public static List<ExrImage> readParts(String name, byte[] bytes, int threads) throws ImageFileException {
        return read(ImageSource.of(name, bytes), threads, false);
    }

    private static List<ExrImage> read(ImageSource source, int threads, boolean firstOnly) throws ImageFileException {
        if (threads < 1) {
            throw new IllegalArgumentException("the number of threads must be at least 1, not " + threads);
        }
        try {
            return readImages(source, threads, firstOnly);
        } catch (OutOfMemoryError e) {
            // Caught here, where nothing refers to the image any more, so that there is room for the message.
            throw source.error("the image is too large for the Java heap", e);
        }
    }

    private static List<ExrImage> readImages(ImageSource source, int threads, boolean firstOnly)
            throws ImageFileException {
        HeaderParser.Headers headers = HeaderParser.parse(source);
        List<ChunkLayout> layouts = new ArrayList<>();
        for (int part = 0; part < headers.parts().size(); part++) {
            ExrHeader header = headers.parts().get(part);
            ChunkLayout layout = ChunkLayout.of(source.name(), header, header.compression());
            int claimed = headers.chunkCounts().get(part);
            if (headers.multipart() && claimed != layout.chunkCount()) {
                throw source.error("the header is damaged: part " + part + " claims "
                        + Integer.toUnsignedString(claimed) + " chunks instead of " + layout.chunkCount());
            }
            layouts.add(layout);
        }
        List<ExrHeader> wanted = firstOnly ? headers.parts().subList(0, 1) : headers.parts();
        checkSize(source, wanted, layouts);
        ChunkTable table = ChunkTable.read(source, layouts, headers.multipart());
        List<ExrImage> images = new ArrayList<>();
        for (int part = 0; part < wanted.size(); part++) {
            ExrImage image = allocate(source, wanted.get(part), layouts.get(part));
            readChunks(new PartReader(source, table, part, layouts.get(part), image), threads);
            images.add(image);
        }
        return List.copyOf(images);
    }

    /** Refuses what cannot be unpacked, and claims that the rest of the file cannot meet, however well it is packed. */
    private static void checkSize(ImageSource source, List<ExrHeader> parts, List<ChunkLayout> layouts)
            throws ImageFileException {
        double neededFileBytes = 0;
        double neededHeapBytes = 0;
        for (int part = 0; part < parts.size(); part++) {
            ExrHeader header = parts.get(part);
            ChunkLayout layout = layouts.get(part);
            if (!header.compression().isReadable()) {
                throw source.error(header.compression().notSupported());
            }
            neededFileBytes += (double) layout.rawBytes() / header.compression().maxExpansion();
            // Each sample is held in four bytes.
            neededHeapBytes += 4.0 * layout.pixelCount() * header.channels().size()
                    + (double) ChunkWorkers.BUFFERS_PER_SLOT * layout.maxRawLength();
            if (neededFileBytes > source.remaining()) {
                throw source.error("the file is truncated or its header damaged: " + source.length()
                        + " bytes cannot hold " + header.width() + " x " + header.height() + " pixels");
            }
        }
        long heapBytes = Runtime.getRuntime().maxMemory();
        if (neededHeapBytes > heapBytes) {
            throw source.error(String.format(
                    Locale.ROOT,
                    "the image is too large for the Java heap: it needs %.0f MB of %d MB",
                    neededHeapBytes / 1e6,
                    heapBytes / 1_000_000));
        }
    }

    private static ExrImage allocate(ImageSource source, ExrHeader header, ChunkLayout layout)
            throws ImageFileException {
        List<ExrLevel> levels = new ArrayList<>();
        for (ChunkLayout.Grid grid : layout.grids()) {
            Map<String, float[]> samples = new HashMap<>();
            Map<String, int[]> uintSamples = new HashMap<>();
            long pixels = (long) grid.width() * grid.height();
            for (ExrChannel channel : header.channels()) {
                if (channel.type() == PixelType.UINT) {
                    uintSamples.put(channel.name(), source.newInts(pixels));
                } else {
                    samples.put(channel.name(), source.newFloats(pixels));
                }
            }
            levels.add(new ExrLevel(grid.width(), grid.height(), samples, uintSamples));
        }
        return new ExrImage(header, levels);
    }

    private static void readChunks(PartReader part, int threads) throws ImageFileException {
        ChunkWorkers workers = new ChunkWorkers(threads, part.layout);
        Slot[] slots = new Slot[workers.slotCount()];
        try {
            for (int i = 0; i < slots.length; i++) {
                slots[i] = new Slot(part);
            }
            for (int chunk = 0; chunk < part.layout.chunkCount(); chunk++) {
                Slot slot = slots[chunk % slots.length];
                slot.await();
                slot.load(chunk);
                slot.task = workers.start(slot);
            }
            for (Slot slot : slots) {
                slot.await();
            }
        } catch (ImageFileException e) {
            throw e;
        } catch (IOException e) {
            throw part.source.error("cannot be read: " + e.getMessage(), e);
        } finally {
            workers.close();
            for (Slot slot : slots) {
                if (slot != null) {
                    slot.codec.close();
                }
            }
        }
    }

    /** What the chunks of a part have in common. */
    private static final class PartReader {
        private final ImageSource source;
        private final ChunkTable table;
        private final int part;
        private final ChunkLayout layout;
        private final ExrHeader header;
        private final ChunkPixels pixels;

        PartReader(ImageSource source, ChunkTable table, int part, ChunkLayout layout, ExrImage image) {
            this.source = source;
            this.table = table;
            this.part = part;
            this.layout = layout;
            this.header = image.header();
            this.pixels = new ChunkPixels(layout, image);
        }
    }

    /** Buffers and codec for one chunk under way. */
    private static final class Slot implements Callable<@Nullable Void> {
        private final PartReader part;
        private final ChunkCodec codec;
        private final byte[] raw;
        private byte[] packed = new byte[0];
        private int packedLength;
        private int chunk;
        private @Nullable FutureTask<@Nullable Void> task;

        Slot(PartReader part) throws ImageFileException {
            this.part = part;
            raw = part.source.newBytes(part.layout.maxRawLength());
            codec = part.header.compression().openCodec(1, part.header.channels());
        }

        void await() throws IOException {
            if (task != null) {
                ChunkWorkers.await(task);
                task = null;
            }
        }

        /** Reads the bytes of a chunk; a chunk that is stored raw goes to its buffer at once. */
        void load(int newChunk) throws ImageFileException {
            chunk = newChunk;
            packedLength = part.table.open(part.part, chunk);
            if (packedLength == part.layout.rawLength(chunk)) {
                part.source.read(raw, 0, packedLength, what());
            } else {
                if (packed.length < packedLength) {
                    packed = part.source.newBytes(packedLength);
                }
                part.source.read(packed, 0, packedLength, what());
            }
        }

        @Override
        public @Nullable Void call() throws ImageFileException {
            int rawLength = part.layout.rawLength(chunk);
            if (packedLength != rawLength) {
                try {
                    codec.unpack(
                            packed, packedLength, raw, rawLength, part.layout.width(chunk), part.layout.height(chunk));
                } catch (IOException e) {
                    throw part.source.error("the file is damaged in " + what() + ": " + e.getMessage(), e);
                }
            }
            part.pixels.scatter(raw, chunk);
            return null;
        }

        private String what() {
            return part.table.describe(part.part, chunk);
        }
    }
}
