package org.daybreak.exr;

import java.util.ArrayList;
import java.util.List;

/**
 * How one part is cut into chunks: bands of rows, or tiles of each level. Both are rectangles on a grid; a band is as
 * wide as the image. Chunks are numbered as the table of offsets lists them, whatever the line order: level by level, in
 * each row by row, in each from left to right.
 */
final class ChunkLayout {
    /**
     * The chunks of one level.
     *
     * @param xLevel binary logarithm of the horizontal reduction
     * @param yLevel binary logarithm of the vertical reduction
     * @param width columns of the level
     * @param height rows of the level
     * @param columns chunks side by side
     * @param firstChunk number of its first chunk
     */
    record Grid(int xLevel, int yLevel, int width, int height, int columns, int firstChunk) {}

    private final boolean tiled;
    private final int firstRow;
    private final int chunkWidth;
    private final int chunkHeight;
    private final int bytesPerPixel;
    private final int chunkCount;
    private final long pixelCount;
    private final List<Grid> grids;

    private ChunkLayout(
            ExrHeader header,
            long chunkWidth,
            long chunkHeight,
            int bytesPerPixel,
            long chunkCount,
            long pixelCount,
            List<Grid> grids) {
        this.tiled = header.tiles() != null;
        this.firstRow = header.dataWindow().yMin();
        this.chunkWidth = (int) chunkWidth;
        this.chunkHeight = (int) chunkHeight;
        this.bytesPerPixel = bytesPerPixel;
        this.chunkCount = (int) chunkCount;
        this.pixelCount = pixelCount;
        this.grids = grids;
    }

    /**
     * Lays a part out.
     *
     * @param file for the error
     * @throws ImageFileException if a channel does not fit an array or a chunk does not fit its length field
     */
    static ChunkLayout of(String file, ExrHeader header, Compression compression) throws ImageFileException {
        long width = header.width();
        long height = header.height();
        // Both are below 2^33, so the product is only formed when it cannot wrap.
        if (width > Integer.MAX_VALUE - 8 || height > (Integer.MAX_VALUE - 8) / width) {
            throw new ImageFileException(file, "an image of " + width + " x " + height + " pixels is too large");
        }
        int bytesPerPixel = 0;
        for (ExrChannel channel : header.channels()) {
            bytesPerPixel += channel.type().byteCount();
        }
        TileDescription tiles = header.tiles();
        long chunkWidth = tiles == null ? width : Math.min(tiles.width(), width);
        long chunkHeight = Math.min(tiles == null ? compression.linesPerChunk() : tiles.height(), height);
        // Divided, as the product may not fit a long; the width is at least 1.
        if (chunkHeight > (Integer.MAX_VALUE - 64) / chunkWidth / bytesPerPixel) {
            throw new ImageFileException(
                    file,
                    "chunks of " + chunkWidth + " x " + chunkHeight + " pixels of " + bytesPerPixel
                            + " bytes are too large");
        }
        List<Grid> grids = new ArrayList<>();
        long chunkCount = 0;
        long pixelCount = 0;
        int xLevels = tiles == null ? 1 : tiles.xLevels(width, height);
        int yLevels = tiles == null ? 1 : tiles.yLevels(width, height);
        boolean mipmap = tiles != null && tiles.mode() == TileDescription.LevelMode.MIPMAP;
        for (int y = 0; y < yLevels; y++) {
            for (int x = mipmap ? y : 0; x < (mipmap ? y + 1 : xLevels); x++) {
                long levelWidth = tiles == null ? width : tiles.levelSize(width, x);
                long levelHeight = tiles == null ? height : tiles.levelSize(height, y);
                long columns = (levelWidth - 1) / chunkWidth + 1;
                long rows = (levelHeight - 1) / chunkHeight + 1;
                grids.add(new Grid(x, y, (int) levelWidth, (int) levelHeight, (int) columns, (int) chunkCount));
                chunkCount += columns * rows;
                pixelCount += levelWidth * levelHeight;
                if (chunkCount > Integer.MAX_VALUE / Long.BYTES) {
                    throw new ImageFileException(file, "an image of more than " + chunkCount + " tiles is too large");
                }
            }
        }
        return new ChunkLayout(
                header, chunkWidth, chunkHeight, bytesPerPixel, chunkCount, pixelCount, List.copyOf(grids));
    }

    /** True for tiles: each chunk then names its column, row and level, and else its first row. */
    boolean isTiled() {
        return tiled;
    }

    int chunkCount() {
        return chunkCount;
    }

    /** The levels in the order of the file. */
    List<Grid> grids() {
        return grids;
    }

    /** Pixels of all levels together. */
    long pixelCount() {
        return pixelCount;
    }

    /** Bytes of all chunks together, unpacked. */
    long rawBytes() {
        return pixelCount * bytesPerPixel;
    }

    /** Bytes of the largest chunk, unpacked. */
    int maxRawLength() {
        return chunkWidth * chunkHeight * bytesPerPixel;
    }

    /** Bytes of a chunk, unpacked. */
    int rawLength(int chunk) {
        return width(chunk) * height(chunk) * bytesPerPixel;
    }

    /** The place in {@link #grids()} of a chunk's level. */
    int gridIndex(int chunk) {
        // Most chunks belong to the first level.
        int index = 0;
        while (index + 1 < grids.size() && grids.get(index + 1).firstChunk() <= chunk) {
            index++;
        }
        return index;
    }

    private Grid grid(int chunk) {
        return grids.get(gridIndex(chunk));
    }

    /** The number of a chunk's column in the grid of its level. */
    int column(int chunk) {
        Grid grid = grid(chunk);
        return (chunk - grid.firstChunk()) % grid.columns();
    }

    /** The number of a chunk's row in the grid of its level. */
    int row(int chunk) {
        Grid grid = grid(chunk);
        return (chunk - grid.firstChunk()) / grid.columns();
    }

    /** The left column of a chunk within its level. */
    int left(int chunk) {
        return column(chunk) * chunkWidth;
    }

    /** The top row of a chunk within its level. */
    int top(int chunk) {
        return row(chunk) * chunkHeight;
    }

    /** Columns of a chunk. */
    int width(int chunk) {
        return Math.min(chunkWidth, grid(chunk).width() - left(chunk));
    }

    /** Rows of a chunk. */
    int height(int chunk) {
        return Math.min(chunkHeight, grid(chunk).height() - top(chunk));
    }

    /** The number that a band of rows has in the file: its first row, counted as the data window counts. */
    int firstRow(int chunk) {
        return firstRow + top(chunk);
    }

    /** The band whose first row has the given number, or −1. */
    int chunkOfFirstRow(int row) {
        long distance = (long) row - firstRow;
        return distance >= 0 && distance < grids.get(0).height() && distance % chunkHeight == 0
                ? (int) (distance / chunkHeight)
                : -1;
    }

    /** The tile at the given place, or −1. */
    int chunkOfTile(int column, int row, int xLevel, int yLevel) {
        for (int i = 0; i < grids.size(); i++) {
            Grid grid = grids.get(i);
            if (grid.xLevel() == xLevel && grid.yLevel() == yLevel) {
                int next = i + 1 < grids.size() ? grids.get(i + 1).firstChunk() : chunkCount;
                int rows = (next - grid.firstChunk()) / grid.columns();
                return column >= 0 && column < grid.columns() && row >= 0 && row < rows
                        ? grid.firstChunk() + row * grid.columns() + column
                        : -1;
            }
        }
        return -1;
    }

    /** Names a chunk in an error. */
    String describe(int chunk) {
        if (!tiled) {
            return "the chunk of row " + firstRow(chunk);
        }
        Grid grid = grid(chunk);
        return "tile (" + column(chunk) + ", " + row(chunk) + ") of level (" + grid.xLevel() + ", " + grid.yLevel()
                + ")";
    }
}
