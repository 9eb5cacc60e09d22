package org.daybreak.exr;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import org.jspecify.annotations.Nullable;

/**
 * Writes OpenEXR scanline images, rows in increasing order. The bytes of the file depend on the image, the compression
 * and the level alone (and on the JDK's deflate), not on the number of threads.
 */
public final class ExrWriter {
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
     * Writes an image. Compression and line order of the image's header are not used; the attributes are.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param image image to write; its arrays must not change meanwhile
     * @param options compression and threads
     * @throws ImageFileException if the file cannot be written, or a chunk of rows would hold 2 GiB
     */
    public static void write(Path file, ExrImage image, ExrWriteOptions options) throws ImageFileException {
        ChunkLayout layout = ChunkLayout.of(file, image.header(), options.compression());
        AtomicFiles.write(file, target -> write(target, image, layout, options));
    }

    private static void write(RandomAccessFile file, ExrImage image, ChunkLayout layout, ExrWriteOptions options)
            throws IOException {
        byte[] header = HeaderWriter.write(image.header(), options.compression());
        file.write(header);
        // Holds the place of the offsets, which are known when all chunks are packed.
        ByteBuffer offsets = ByteBuffer.allocate(Math.multiplyExact(layout.chunkCount(), Long.BYTES))
                .order(ByteOrder.LITTLE_ENDIAN);
        file.write(offsets.array());
        writeChunks(file, image, layout, options, offsets);
        file.seek(header.length);
        file.write(offsets.array());
    }

    private static void writeChunks(
            RandomAccessFile file, ExrImage image, ChunkLayout layout, ExrWriteOptions options, ByteBuffer offsets)
            throws IOException {
        long offset = file.getFilePointer();
        int count = layout.chunkCount();
        ChunkWorkers workers = new ChunkWorkers(options.threads(), layout);
        Slot[] slots = new Slot[workers.slotCount()];
        try {
            for (int i = 0; i < slots.length; i++) {
                slots[i] = new Slot(layout, image, options);
            }
            // A slot's chunk is written, in order, just before the slot takes its next one.
            for (int chunk = 0; chunk < count + slots.length; chunk++) {
                Slot slot = slots[chunk % slots.length];
                if (slot.task != null) {
                    ChunkWorkers.await(slot.task);
                    slot.task = null;
                    file.write(slot.packed, 0, slot.packedLength);
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
    }

    /** Buffers and codec for one chunk under way. */
    private static final class Slot implements Callable<@Nullable Void> {
        private final ChunkLayout layout;
        private final ExrImage image;
        private final ChunkCodec codec;
        private final byte[] raw;
        /** Head of the chunk, then its bytes. */
        private final byte[] packed;

        private int packedLength;
        private int chunk;
        private @Nullable FutureTask<@Nullable Void> task;

        Slot(ChunkLayout layout, ExrImage image, ExrWriteOptions options) {
            this.layout = layout;
            this.image = image;
            raw = new byte[layout.maxRawLength()];
            packed = new byte[ExrReader.CHUNK_HEAD_BYTES + raw.length];
            codec = options.compression().openCodec(options.deflateLevel());
        }

        @Override
        public @Nullable Void call() {
            int rawLength = layout.rawLength(chunk);
            layout.gather(image, chunk, raw);
            int length = codec.pack(raw, rawLength, packed, ExrReader.CHUNK_HEAD_BYTES);
            if (length == ChunkCodec.NOT_SMALLER) {
                System.arraycopy(raw, 0, packed, ExrReader.CHUNK_HEAD_BYTES, rawLength);
                length = rawLength;
            }
            ByteBuffer.wrap(packed)
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .putInt(layout.firstRow(chunk))
                    .putInt(length);
            packedLength = ExrReader.CHUNK_HEAD_BYTES + length;
            return null;
        }
    }
}
