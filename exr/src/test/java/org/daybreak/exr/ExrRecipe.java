package org.daybreak.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.zip.Deflater;

/**
 * Puts a valid header and table around arbitrary bytes of one chunk, so that these reach the decoders. A recipe is five
 * bytes — compression, pixel types of the channels, columns, rows, flags — and the packed bytes.
 */
final class ExrRecipe {
    private static final List<Compression> READABLE = List.of(
            Compression.NONE, Compression.RLE, Compression.ZIPS, Compression.ZIP, Compression.PIZ, Compression.PXR24);
    private static final Set<Compression> DEFLATING = EnumSet.of(Compression.ZIPS, Compression.ZIP, Compression.PXR24);
    private static final int HEAD = 5;
    private static final int MOST_COLUMNS = 64;
    /** Flag: the bytes are those in front of deflation, of which the decoder would refuse nearly all. */
    private static final int DEFLATE = 1;
    /** Flag: the chunk is a tile. */
    private static final int TILED = 2;

    private ExrRecipe() {}

    /** The file for a recipe; bytes that are missing are zero. */
    static byte[] file(byte[] recipe) {
        byte[] head = Arrays.copyOf(recipe, HEAD);
        Compression compression = READABLE.get((head[0] & 0xff) % READABLE.size());
        List<ExrChannel> channels = channels(head[1] & 7);
        int width = 1 + (head[2] & 0xff) % MOST_COLUMNS;
        boolean tiled = (head[4] & TILED) != 0;
        int height = 1 + (head[3] & 0xff) % (tiled ? MOST_COLUMNS : compression.linesPerChunk());
        byte[] bytes = recipe.length > HEAD ? Arrays.copyOfRange(recipe, HEAD, recipe.length) : new byte[0];
        byte[] packed = (head[4] & DEFLATE) != 0 && DEFLATING.contains(compression)
                ? deflated(Arrays.copyOf(bytes, deflatedLength(compression, channels) * width * height))
                : bytes;
        Box2i window = Box2i.ofSize(width, height);
        TileDescription tiles = tiled
                ? new TileDescription(
                        width, height, TileDescription.LevelMode.ONE_LEVEL, TileDescription.LevelRounding.DOWN)
                : null;
        ExrHeader header = new ExrHeader(
                window, window, compression, LineOrder.INCREASING_Y, 1, new V2f(0, 0), 1, channels, tiles, Map.of());
        byte[] start = HeaderWriter.write(List.of(header), List.of(1), compression);
        int placeBytes = (tiled ? 4 : 1) * Integer.BYTES;
        ByteBuffer out = ByteBuffer.allocate(start.length + Long.BYTES + placeBytes + Integer.BYTES + packed.length)
                .order(ByteOrder.LITTLE_ENDIAN);
        out.put(start).putLong(start.length + Long.BYTES);
        // The first row, or column, row and level of the tile: all 0.
        out.position(out.position() + placeBytes);
        return out.putInt(packed.length).put(packed).array();
    }

    private static List<ExrChannel> channels(int types) {
        List<ExrChannel> channels = new ArrayList<>();
        for (PixelType type : PixelType.values()) {
            if ((types & 1 << type.ordinal()) != 0) {
                channels.add(new ExrChannel(type.name(), type, false));
            }
        }
        if (channels.isEmpty()) {
            channels.add(new ExrChannel("A", PixelType.HALF, true));
            channels.add(new ExrChannel("B", PixelType.HALF, true));
        }
        channels.sort((a, b) -> a.name().compareTo(b.name()));
        return channels;
    }

    /** Bytes of a pixel in front of deflation: PXR24 leaves out one of each float. */
    private static int deflatedLength(Compression compression, List<ExrChannel> channels) {
        int length = 0;
        for (ExrChannel channel : channels) {
            boolean cut = compression == Compression.PXR24 && channel.type() == PixelType.FLOAT;
            length += channel.type().byteCount() - (cut ? 1 : 0);
        }
        return length;
    }

    private static byte[] deflated(byte[] bytes) {
        Deflater deflater = new Deflater(1);
        try {
            deflater.setInput(bytes);
            deflater.finish();
            byte[] out = new byte[bytes.length + 64];
            return Arrays.copyOf(out, deflater.deflate(out));
        } finally {
            deflater.end();
        }
    }
}
