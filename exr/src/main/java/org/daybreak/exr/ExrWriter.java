package org.daybreak.exr;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import org.jspecify.annotations.Nullable;

/**
 * Writes OpenEXR images: one or several parts, each in scan lines or, if its header says so, in tiles with all levels;
 * chunks in increasing order. The bytes of the file depend on the images, the compression and the level alone (and on the
 * JDK's deflate), not on the number of threads.
 */
public final class ExrWriter {
    /** Attributes that all parts of a file must agree on, as they speak of the whole picture. */
    private static final List<String> SHARED = List.of("chromaticities", "timeCode");

    private ExrWriter() {}

    /**
     * Writes an image with {@link ExrWriteOptions#defaults()}.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param image image to write
     * @throws ImageFileException if the file cannot be written
     */
    public static void write(Path file, ExrImage image) throws ImageFileException {
        write(file, image, ExrWriteOptions.defaults());
    }

    /**
     * Writes an image. Compression and line order of the image's header are not used; tiles and attributes are.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param image image to write; its arrays must not change meanwhile
     * @param options compression and threads
     * @throws ImageFileException if the file cannot be written, or a chunk would hold 2 GiB
     */
    public static void write(Path file, ExrImage image, ExrWriteOptions options) throws ImageFileException {
        writeParts(file, List.of(image), options);
    }

    /**
     * Writes images as the parts of one file.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param parts images to write, as {@link #write(Path, ExrImage, ExrWriteOptions)} does; at least one. If there are
     *     several, each needs a {@linkplain ExrImage.Builder#name name} of its own
     * @param options compression and threads
     * @throws ImageFileException if the file cannot be written, or a chunk would hold 2 GiB
     * @throws IllegalArgumentException if there is no part, a name is missing or taken, or parts differ in display
     *     window, pixel aspect ratio, chromaticities or time code, which the format wants to be the same
     */
    public static void writeParts(Path file, List<ExrImage> parts, ExrWriteOptions options) throws ImageFileException {
        List<ChunkLayout> layouts = layOut(file.toString(), parts, options);
        AtomicFiles.write(file, target -> write(new FileSink(target), parts, layouts, options));
    }

    /**
     * Writes images to memory, as the parts of one file.
     *
     * @param name what errors are to call the file
     * @param parts images to write
     * @param options compression and threads
     * @return content of the file
     * @throws ImageFileException if the file does not fit an array, or a chunk would hold 2 GiB
     * @throws IllegalArgumentException as {@link #writeParts(Path, List, ExrWriteOptions)}
     */
    public static byte[] toBytes(String name, List<ExrImage> parts, ExrWriteOptions options) throws ImageFileException {
        List<ChunkLayout> layouts = layOut(name, parts, options);
        MemorySink sink = new MemorySink();
        try {
            write(sink, parts, layouts, options);
            return sink.toByteArray();
        } catch (IOException e) {
            throw new ImageFileException(name, "cannot be written: " + e.getMessage(), e);
        }
    }

    private static List<ChunkLayout> layOut(String name, List<ExrImage> parts, ExrWriteOptions options)
            throws ImageFileException {
        checkParts(parts);
        List<ChunkLayout> layouts = new ArrayList<>();
        for (ExrImage part : parts) {
            layouts.add(ChunkLayout.of(name, part.header(), options.compression()));
        }
        return layouts;
    }

    private static void checkParts(List<ExrImage> parts) {
        if (parts.isEmpty()) {
            throw new IllegalArgumentException("a file needs at least one part");
        }
        if (parts.size() == 1) {
            return;
        }
        ExrHeader first = parts.get(0).header();
        Set<String> names = new HashSet<>();
        for (ExrImage part : parts) {
            ExrHeader header = part.header();
            if (header.name().isEmpty() || !names.add(header.name())) {
                throw new IllegalArgumentException("each part needs a name of its own, not '" + header.name() + "'");
            }
            if (!header.displayWindow().equals(first.displayWindow())
                    || header.pixelAspectRatio() != first.pixelAspectRatio()) {
                throw new IllegalArgumentException("part '" + header.name()
                        + "' has another display window or pixel aspect ratio than the first part");
            }
            for (String shared : SHARED) {
                ExrAttribute value = header.attributes().get(shared);
                ExrAttribute firstValue = first.attributes().get(shared);
                if (value == null ? firstValue != null : !value.equals(firstValue)) {
                    throw new IllegalArgumentException(
                            "part '" + header.name() + "' differs from the first part in '" + shared + "'");
                }
            }
        }
    }

    private static void write(ByteSink sink, List<ExrImage> parts, List<ChunkLayout> layouts, ExrWriteOptions options)
            throws IOException {
        byte[] header = HeaderWriter.write(
                parts.stream().map(ExrImage::header).toList(),
                layouts.stream().map(ChunkLayout::chunkCount).toList(),
                options.compression());
        sink.write(header, 0, header.length);
        int chunks = 0;
        for (ChunkLayout layout : layouts) {
            chunks = Math.addExact(chunks, layout.chunkCount());
        }
        // Holds the place of the offsets, which are known when all chunks are packed.
        ByteBuffer offsets =
                ByteBuffer.allocate(Math.multiplyExact(chunks, Long.BYTES)).order(ByteOrder.LITTLE_ENDIAN);
        sink.write(offsets.array(), 0, offsets.capacity());
        long offset = header.length + (long) offsets.capacity();
        for (int part = 0; part < parts.size(); part++) {
            int number = parts.size() > 1 ? part : -1;
            PartWriter writer = new PartWriter(number, layouts.get(part), parts.get(part), options);
            offset = writeChunks(sink, writer, offsets, offset);
        }
        sink.patch(header.length, offsets.array());
    }

    /** Returns the offset behind the last chunk. */
    private static long writeChunks(ByteSink sink, PartWriter part, ByteBuffer offsets, long start) throws IOException {
        long offset = start;
        int count = part.layout.chunkCount();
        ChunkWorkers workers = new ChunkWorkers(part.options.threads(), part.layout);
        Slot[] slots = new Slot[workers.slotCount()];
        try {
            for (int i = 0; i < slots.length; i++) {
                slots[i] = new Slot(part);
            }
            // A slot's chunk is written, in order, just before the slot takes its next one.
            for (int chunk = 0; chunk < count + slots.length; chunk++) {
                Slot slot = slots[chunk % slots.length];
                if (slot.task != null) {
                    ChunkWorkers.await(slot.task);
                    slot.task = null;
                    sink.write(slot.packed, 0, slot.packedLength);
                    offsets.putLong(offset);
                    offset += slot.packedLength;
                }
                if (chunk < count) {
                    slot.chunk = chunk;
                    slot.task = workers.start(slot);
                }
            }
        } finally {
            workers.close();
            for (Slot slot : slots) {
                if (slot != null) {
                    slot.codec.close();
                }
            }
        }
        return offset;
    }

    /** What the chunks of a part have in common. */
    private static final class PartWriter {
        /** −1 if chunks do not name their part. */
        private final int number;

        private final ChunkLayout layout;
        private final ExrHeader header;
        private final ChunkPixels pixels;
        private final ExrWriteOptions options;
        private final int headBytes;

        PartWriter(int number, ChunkLayout layout, ExrImage image, ExrWriteOptions options) {
            this.number = number;
            this.layout = layout;
            this.header = image.header();
            this.pixels = new ChunkPixels(layout, image);
            this.options = options;
            this.headBytes = ChunkTable.headBytes(layout, number >= 0);
        }

        void putHead(int chunk, int length, byte[] packed) {
            ByteBuffer head = ByteBuffer.wrap(packed).order(ByteOrder.LITTLE_ENDIAN);
            if (number >= 0) {
                head.putInt(number);
            }
            if (layout.isTiled()) {
                ChunkLayout.Grid grid = layout.grids().get(layout.gridIndex(chunk));
                head.putInt(layout.column(chunk)).putInt(layout.row(chunk));
                head.putInt(grid.xLevel()).putInt(grid.yLevel());
            } else {
                head.putInt(layout.firstRow(chunk));
            }
            head.putInt(length);
        }
    }

    /** Buffers and codec for one chunk under way. */
    private static final class Slot implements Callable<@Nullable Void> {
        private final PartWriter part;
        private final ChunkCodec codec;
        private final byte[] raw;
        /** Head of the chunk, then its bytes. */
        private final byte[] packed;

        private int packedLength;
        private int chunk;
        private @Nullable FutureTask<@Nullable Void> task;

        Slot(PartWriter part) {
            this.part = part;
            raw = new byte[part.layout.maxRawLength()];
            packed = new byte[part.headBytes + raw.length];
            codec = part.options.compression().openCodec(part.options.deflateLevel(), part.header.channels());
        }

        @Override
        public @Nullable Void call() {
            int rawLength = part.layout.rawLength(chunk);
            part.pixels.gather(chunk, raw);
            int length = codec.pack(raw, rawLength, packed, part.headBytes);
            if (length == ChunkCodec.NOT_SMALLER) {
                System.arraycopy(raw, 0, packed, part.headBytes, rawLength);
                length = rawLength;
            }
            part.putHead(chunk, length, packed);
            packedLength = part.headBytes + length;
            return null;
        }
    }
}
