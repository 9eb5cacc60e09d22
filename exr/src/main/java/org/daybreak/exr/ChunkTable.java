package org.daybreak.exr;

import java.util.Arrays;
import java.util.List;

/** Where the chunks of a file are: the tables of offsets, and what stands at the head of each chunk. */
final class ChunkTable {
    private static final String HEAD = "the head of a chunk";

    private final ImageSource source;
    private final List<ChunkLayout> layouts;
    private final boolean multipart;
    private final long[][] offsets;

    private ChunkTable(ImageSource source, List<ChunkLayout> layouts, boolean multipart) {
        this.source = source;
        this.layouts = layouts;
        this.multipart = multipart;
        this.offsets = new long[layouts.size()][];
    }

    /**
     * Reads the tables; the source stands at the first one. A table that was never filled in (the writer was stopped) is
     * recovered from the chunks themselves.
     *
     * @param layouts of all parts
     * @param multipart true if each chunk names its part
     */
    static ChunkTable read(ImageSource source, List<ChunkLayout> layouts, boolean multipart) throws ImageFileException {
        ChunkTable table = new ChunkTable(source, layouts, multipart);
        long leastBytes = 0;
        for (ChunkLayout layout : layouts) {
            leastBytes += (long) layout.chunkCount() * (Long.BYTES + headBytes(layout, multipart));
        }
        if (leastBytes > source.remaining()) {
            throw source.error("the file is truncated or its header damaged: " + source.length()
                    + " bytes cannot hold its chunks, which take at least " + leastBytes);
        }
        boolean complete = true;
        for (int part = 0; part < layouts.size(); part++) {
            table.offsets[part] = new long[layouts.get(part).chunkCount()];
            for (int i = 0; i < table.offsets[part].length; i++) {
                long offset = source.readLong("the table of chunk offsets");
                table.offsets[part][i] = offset;
                complete &= offset != 0;
            }
        }
        if (complete) {
            table.check(source.position());
        } else {
            table.recover();
        }
        return table;
    }

    /** Bytes in front of those of a chunk: part, place and number of packed bytes. */
    static int headBytes(ChunkLayout layout, boolean multipart) {
        return (multipart ? Integer.BYTES : 0) + (layout.isTiled() ? 5 : 2) * Integer.BYTES;
    }

    private void check(long firstChunk) throws ImageFileException {
        for (int part = 0; part < offsets.length; part++) {
            ChunkLayout layout = layouts.get(part);
            long last = source.length() - headBytes(layout, multipart);
            for (int i = 0; i < offsets[part].length; i++) {
                long offset = offsets[part][i];
                if (offset < firstChunk || offset > last) {
                    throw source.error("the file is truncated or damaged: " + describe(part, i)
                            + " should start at byte " + Long.toUnsignedString(offset) + " of " + source.length());
                }
            }
        }
    }

    /** Walks from chunk to chunk; the source stands at the first one. */
    private void recover() throws ImageFileException {
        for (long[] table : offsets) {
            Arrays.fill(table, 0);
        }
        while (source.remaining() >= Integer.BYTES) {
            long start = source.position();
            int part = multipart ? source.readInt(HEAD) : 0;
            if (part < 0 || part >= offsets.length) {
                break;
            }
            ChunkLayout layout = layouts.get(part);
            int headBytes = headBytes(layout, multipart);
            if (source.length() - start < headBytes) {
                break;
            }
            int chunk = readPlace(layout);
            int size = source.readInt(HEAD);
            if (chunk < 0 || size < 0 || size > source.remaining()) {
                break;
            }
            offsets[part][chunk] = start;
            source.seek(start + headBytes + size);
        }
        for (int part = 0; part < offsets.length; part++) {
            for (int i = 0; i < offsets[part].length; i++) {
                if (offsets[part][i] == 0) {
                    throw source.error("the file is incomplete: " + describe(part, i) + " is missing");
                }
            }
        }
    }

    /** Reads which chunk this is; −1 if there is none such. */
    private int readPlace(ChunkLayout layout) throws ImageFileException {
        if (!layout.isTiled()) {
            return layout.chunkOfFirstRow(source.readInt(HEAD));
        }
        int column = source.readInt(HEAD);
        int row = source.readInt(HEAD);
        int xLevel = source.readInt(HEAD);
        int yLevel = source.readInt(HEAD);
        return layout.chunkOfTile(column, row, xLevel, yLevel);
    }

    /** Reads the head of a chunk, checks it, and returns the number of packed bytes; the source stands at them. */
    int open(int part, int chunk) throws ImageFileException {
        ChunkLayout layout = layouts.get(part);
        source.seek(offsets[part][chunk]);
        int foundPart = multipart ? source.readInt(HEAD) : 0;
        int found = foundPart == part ? readPlace(layout) : -1;
        if (found != chunk) {
            throw source.error("the file is damaged: " + describe(part, chunk) + " says that it is "
                    + (found < 0 ? "another one" : layout.describe(found)));
        }
        int packedLength = source.readInt(HEAD);
        int rawLength = layout.rawLength(chunk);
        if (packedLength < 0 || packedLength > rawLength) {
            throw source.error("the file is damaged: " + describe(part, chunk) + " claims "
                    + Integer.toUnsignedString(packedLength) + " bytes instead of at most " + rawLength);
        }
        if (packedLength > source.remaining()) {
            throw source.error("the file is truncated: it ends within " + describe(part, chunk));
        }
        return packedLength;
    }

    /** Names a chunk in an error. */
    String describe(int part, int chunk) {
        String what = layouts.get(part).describe(chunk);
        return multipart ? what + " of part " + part : what;
    }
}
