package org.daybreak.tracing;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.RenderPart;

/**
 * The tiles of a film's sample area, and which of them a part of the render works on. Immutable.
 *
 * <p>A part owns consecutive tiles. To have the pixels of its tiles as they are in the whole image, bit for bit, it also takes
 * the samples of other tiles that reach into them by the filter, tile by tile in the order of the whole image: a pixel's
 * sums are made from the same numbers in the same order. If samples depend on those before them in the tile, these are taken
 * as well.
 *
 * <p>For algorithms that splat, consecutive tiles make up lanes, whose splats are added up apart; a part owns whole lanes. A
 * lane takes as much memory as an image, so there are {@value #MOST_LANES} of images of up to a million pixels, and
 * {@value #LEAST_LANES} of very large ones.
 */
final class TileGrid {
    private static final int TILE_SIZE = 32;
    private static final int MOST_LANES = 16;
    private static final int LEAST_LANES = 4;

    /** So many pixels all lanes together have, where that leaves enough of them. */
    private static final long PIXELS_OF_LANES = 1L << 24;

    private final FilmSettings.Crop area;
    private final FilmSettings.Crop crop;
    private final int border;
    private final int columns;
    private final int rows;
    private final long count;
    private final long lanes;
    private final long from;
    private final long end;
    private final boolean fromTheirStart;
    private final List<FilmSettings.Crop> tiles = new ArrayList<>();
    private final List<Boolean> owned = new ArrayList<>();
    private final List<Integer> laneOf = new ArrayList<>();
    private final List<FilmSettings.Crop> regions = new ArrayList<>();
    private long pixels;

    /**
     * Finds the tiles.
     *
     * @param splats whether the algorithm splats
     * @param learns whether samples depend on those before them in their tile
     * @throws ParameterException if there are more parts than tiles, or lanes
     */
    TileGrid(Film film, RenderPart part, boolean splats, boolean learns) {
        area = film.sampleArea();
        crop = film.settings().crop();
        border = film.filterBorder();
        fromTheirStart = learns;
        columns = (area.width() + TILE_SIZE - 1) / TILE_SIZE;
        rows = (area.height() + TILE_SIZE - 1) / TILE_SIZE;
        count = (long) columns * rows;
        lanes = splats ? lanes() : 1;
        if (splats && part.count() > lanes) {
            throw new ParameterException("splats of an image of " + crop.width() + "x" + crop.height()
                    + " pixels are added up in " + lanes + " lanes: it can be cut into at most so many parts, not "
                    + part.count());
        }
        if (part.count() > count) {
            throw new ParameterException("the image has " + count + " tiles of " + TILE_SIZE + "x" + TILE_SIZE
                    + " pixels: it can be cut into at most so many parts, not " + part.count());
        }
        from = splats ? laneStart(part.first(lanes)) : part.first(count);
        end = splats ? laneStart(part.end(lanes)) : part.end(count);
        int lane = 0;
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                while (laneStart(lane + 1L) <= (long) row * columns + column) {
                    lane++;
                }
                add(column, row, lane);
            }
        }
        findRegions(part);
    }

    private long lanes() {
        long fitting = PIXELS_OF_LANES / ((long) crop.width() * crop.height());
        return Math.min(count, Math.max(LEAST_LANES, Math.min(MOST_LANES, fitting)));
    }

    private long laneStart(long lane) {
        return count * lane / lanes;
    }

    private void add(int column, int row, int lane) {
        FilmSettings.Crop tile = tile(column, row);
        if (isOwned(column, row)) {
            tiles.add(tile);
            owned.add(true);
            laneOf.add(lane);
            pixels += (long) tile.width() * tile.height();
            return;
        }
        int x0 = Integer.MAX_VALUE;
        int y0 = Integer.MAX_VALUE;
        int x1 = Integer.MIN_VALUE;
        int y1 = Integer.MIN_VALUE;
        for (int r = row - 1; r <= row + 1; r++) {
            for (int c = column - 1; c <= column + 1; c++) {
                if (r < 0 || c < 0 || r >= rows || c >= columns || !isOwned(c, r)) {
                    continue;
                }
                FilmSettings.Crop other = tile(c, r);
                int left = Math.max(tile.x(), other.x() - border);
                int top = Math.max(tile.y(), other.y() - border);
                int right = Math.min(tile.x() + tile.width(), other.x() + other.width() + border);
                int bottom = Math.min(tile.y() + tile.height(), other.y() + other.height() + border);
                if (left < right && top < bottom) {
                    x0 = Math.min(x0, left);
                    y0 = Math.min(y0, top);
                    x1 = Math.max(x1, right);
                    y1 = Math.max(y1, bottom);
                }
            }
        }
        if (x0 < x1) {
            tiles.add(
                    fromTheirStart
                            ? new FilmSettings.Crop(tile.x(), tile.y(), tile.width(), y1 - tile.y())
                            : new FilmSettings.Crop(x0, y0, x1 - x0, y1 - y0));
            owned.add(false);
            laneOf.add(lane);
        }
    }

    private boolean isOwned(int column, int row) {
        long index = (long) row * columns + column;
        return index >= from && index < end;
    }

    private FilmSettings.Crop tile(int column, int row) {
        int tx = column * TILE_SIZE;
        int ty = row * TILE_SIZE;
        return new FilmSettings.Crop(
                area.x() + tx,
                area.y() + ty,
                Math.min(TILE_SIZE, area.width() - tx),
                Math.min(TILE_SIZE, area.height() - ty));
    }

    private void findRegions(RenderPart part) {
        if (part.isWhole()) {
            regions.add(crop);
            return;
        }
        for (int i = 0; i < tiles.size(); i++) {
            if (owned.get(i)) {
                FilmSettings.Crop tile = tiles.get(i);
                int left = Math.max(tile.x(), crop.x());
                int top = Math.max(tile.y(), crop.y());
                int right = Math.min(tile.x() + tile.width(), crop.x() + crop.width());
                int bottom = Math.min(tile.y() + tile.height(), crop.y() + crop.height());
                if (left < right && top < bottom) {
                    regions.add(new FilmSettings.Crop(left, top, right - left, bottom - top));
                }
            }
        }
    }

    /** The tile of a pixel of a whole film. */
    static FilmSettings.Crop tileOf(FilmSettings film, int x, int y) {
        int left = x - x % TILE_SIZE;
        int top = y - y % TILE_SIZE;
        return new FilmSettings.Crop(
                left, top, Math.min(TILE_SIZE, film.width() - left), Math.min(TILE_SIZE, film.height() - top));
    }

    /** Number of tiles to work on. */
    int count() {
        return tiles.size();
    }

    /** Describes a tile. */
    void describe(int index, TileUnit unit) {
        FilmSettings.Crop tile = tiles.get(index);
        unit.index = index;
        unit.x = tile.x();
        unit.y = tile.y();
        unit.width = tile.width();
        unit.height = tile.height();
        unit.counted = owned.get(index);
        unit.lane = laneOf.get(index);
    }

    /** Number of pixels, border included, whose samples count. */
    long pixels() {
        return pixels;
    }

    /** The pixels of the crop that are finished by this part. */
    List<FilmSettings.Crop> regions() {
        return List.copyOf(regions);
    }
}
