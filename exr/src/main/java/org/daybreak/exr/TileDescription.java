package org.daybreak.exr;

import org.jspecify.annotations.Nullable;

/**
 * How a tiled OpenEXR image is cut into tiles, and which reduced copies (levels) it holds.
 *
 * @param width columns of a tile, at least 1; tiles at the right edge are narrower
 * @param height rows of a tile, at least 1; tiles at the bottom are lower
 * @param mode which levels there are
 * @param rounding how the size of a level is rounded
 */
public record TileDescription(int width, int height, LevelMode mode, LevelRounding rounding) {
    /** Which reduced copies of the image a file holds. */
    public enum LevelMode {
        /** The full image only. */
        ONE_LEVEL,
        /** Level (l, l) is reduced by 2<sup>l</sup> in both directions, down to one pixel. */
        MIPMAP,
        /** Level (x, y) is reduced by 2<sup>x</sup> horizontally and 2<sup>y</sup> vertically, in all combinations. */
        RIPMAP;

        /** The mode with the given code, or null if the format has none. */
        static @Nullable LevelMode ofCode(int code) {
            return code < values().length ? values()[code] : null;
        }
    }

    /** How the size of a level is rounded to a whole number of pixels. */
    public enum LevelRounding {
        /** Down, to at least 1. */
        DOWN,
        /** Up. */
        UP;

        /** The rounding with the given code, or null if the format has none. */
        static @Nullable LevelRounding ofCode(int code) {
            return code < values().length ? values()[code] : null;
        }
    }

    /**
     * Checks the sizes.
     *
     * @throws IllegalArgumentException if a size is below 1
     */
    public TileDescription {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("a tile needs at least one pixel, not " + width + " x " + height);
        }
    }

    /**
     * Describes square tiles without further levels.
     *
     * @param size columns and rows of a tile
     * @return the description
     * @throws IllegalArgumentException if the size is below 1
     */
    public static TileDescription oneLevel(int size) {
        return new TileDescription(size, size, LevelMode.ONE_LEVEL, LevelRounding.DOWN);
    }

    /**
     * Describes square tiles with levels of half, quarter, … the size, rounded down.
     *
     * @param size columns and rows of a tile
     * @return the description
     * @throws IllegalArgumentException if the size is below 1
     */
    public static TileDescription mipmap(int size) {
        return new TileDescription(size, size, LevelMode.MIPMAP, LevelRounding.DOWN);
    }

    /**
     * Returns how many sizes the levels have horizontally.
     *
     * @param imageWidth columns of the image
     * @param imageHeight rows of the image
     * @return the number of values of a level's first number, at least 1
     */
    public int xLevels(long imageWidth, long imageHeight) {
        return switch (mode) {
            case ONE_LEVEL -> 1;
            case MIPMAP -> levels(Math.max(imageWidth, imageHeight));
            case RIPMAP -> levels(imageWidth);
        };
    }

    /**
     * Returns how many sizes the levels have vertically.
     *
     * @param imageWidth columns of the image
     * @param imageHeight rows of the image
     * @return the number of values of a level's second number, at least 1
     */
    public int yLevels(long imageWidth, long imageHeight) {
        return switch (mode) {
            case ONE_LEVEL -> 1;
            case MIPMAP -> levels(Math.max(imageWidth, imageHeight));
            case RIPMAP -> levels(imageHeight);
        };
    }

    /**
     * Returns the number of columns or rows of a level.
     *
     * @param imageSize columns or rows of the image
     * @param level the level's number in that direction
     * @return imageSize / 2<sup>level</sup>, rounded, at least 1
     */
    public long levelSize(long imageSize, int level) {
        long roundUp = rounding == LevelRounding.UP ? (1L << level) - 1 : 0;
        return Math.max((imageSize + roundUp) >> level, 1);
    }

    /** One more than the binary logarithm, rounded. */
    private int levels(long size) {
        int floor = 63 - Long.numberOfLeadingZeros(size);
        return 1 + (rounding == LevelRounding.UP && Long.bitCount(size) > 1 ? floor + 1 : floor);
    }
}
