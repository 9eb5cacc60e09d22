package org.daybreak.core.render;

import java.util.List;
import org.daybreak.core.film.FilmImage;

/**
 * Images that a renderer makes besides the film's, for people who study how it works: tables of images of one size. Immutable.
 *
 * @param rows titles of the rows, from the top; the same for all blocks
 * @param cells the images. Those of one block make a table; blocks come in the order of their first images.
 */
public record ImageSheet(List<String> rows, List<Cell> cells) {
    /** Copies the lists and checks the numbers of the rows. */
    public ImageSheet {
        rows = List.copyOf(rows);
        cells = List.copyOf(cells);
        for (Cell cell : cells) {
            if (cell.row < 0 || cell.row >= rows.size() || cell.column < 0) {
                throw new IllegalArgumentException("there is no cell (" + cell.row + ", " + cell.column + ")");
            }
        }
    }

    /**
     * An image in its place.
     *
     * @param block name of the table, a word: {@code weighted}
     * @param name name of the image within the block, a word: {@code s1t2}
     * @param label the same for people: {@code s=1 t=2}
     * @param row from 0
     * @param column from 0
     * @param image linear values in channels {@code R}, {@code G}, {@code B}
     */
    public record Cell(String block, String name, String label, int row, int column, FilmImage image) {}
}
