package org.daybreak.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.ImageSheet;
import org.daybreak.exr.ImageFileException;
import org.daybreak.exr.PngWriter;

/**
 * Draws the images of an {@link ImageSheet} small and labelled on one page, as in Veach 1997, figure 10.2. All images of a row
 * have the same exposure, in all blocks, so that they can be compared; it is chosen by the sum of the row's images in the first
 * block, and stated.
 */
final class ContactSheet {
    /** Sides of images are made smaller by whole factors until they are at most this long. */
    private static final int LONGEST = 256;

    /** And larger by whole factors as long as they are at most this long. */
    private static final int LONGEST_ENLARGED = 160;

    private static final int DOT = 2;
    private static final int TITLE_DOT = 3;
    private static final int GAP = 8;
    private static final float BACKGROUND = 0.03f;

    /** This share of the pixels of a row's sum that are not black comes out darker than {@link #BRIGHT}. */
    private static final double PERCENTILE = 0.97;

    private static final double BRIGHT = 0.8;

    private final ImageSheet sheet;
    private final Map<String, List<ImageSheet.Cell>> blocks = new LinkedHashMap<>();
    private final int reduction;
    private final int enlargement;
    private final int imageWidth;
    private final int imageHeight;
    private final int cellWidth;
    private final int rowHeight;
    private final int width;
    private final int height;
    private final float[] rgb;

    private ContactSheet(ImageSheet sheet) {
        this.sheet = sheet;
        int columns = 0;
        int labelWidth = 0;
        for (ImageSheet.Cell cell : sheet.cells()) {
            blocks.computeIfAbsent(cell.block(), block -> new ArrayList<>()).add(cell);
            columns = Math.max(columns, cell.column() + 1);
            labelWidth = Math.max(labelWidth, BitmapFont.width(cell.label(), DOT));
        }
        FilmImage first = sheet.cells().get(0).image();
        int longest = Math.max(first.width(), first.height());
        reduction = (longest + LONGEST - 1) / LONGEST;
        enlargement = Math.max(1, LONGEST_ENLARGED / longest);
        imageWidth = (first.width() + reduction - 1) / reduction * enlargement;
        imageHeight = (first.height() + reduction - 1) / reduction * enlargement;
        cellWidth = Math.max(imageWidth, labelWidth) + GAP;
        int line = BitmapFont.height(DOT) + GAP;
        rowHeight = 2 * line + imageHeight + GAP;
        int titleWidth = 0;
        for (int row = 0; row < sheet.rows().size(); row++) {
            titleWidth = Math.max(titleWidth, BitmapFont.width(title(row, -99.5), DOT));
        }
        for (String block : blocks.keySet()) {
            titleWidth = Math.max(titleWidth, BitmapFont.width(block, TITLE_DOT));
        }
        width = GAP + Math.max(columns * cellWidth, titleWidth + GAP);
        height = Math.multiplyExact(blocks.size(), blockHeight()) + GAP;
        rgb = new float[Math.multiplyExact(3, Math.multiplyExact(width, height))];
        Arrays.fill(rgb, BACKGROUND);
    }

    private int blockHeight() {
        return GAP + BitmapFont.height(TITLE_DOT) + GAP + sheet.rows().size() * rowHeight;
    }

    /**
     * Writes a page as a PNG.
     *
     * @param sheet at least one image
     * @throws ImageFileException if the file cannot be written
     */
    static void write(Path file, ImageSheet sheet) throws ImageFileException {
        ContactSheet page = new ContactSheet(sheet);
        page.draw();
        PngWriter.write(file, page.width, page.height, page.rgb);
    }

    private void draw() {
        double[] stops = new double[sheet.rows().size()];
        for (int row = 0; row < stops.length; row++) {
            stops[row] = exposure(row);
        }
        int y = 0;
        for (Map.Entry<String, List<ImageSheet.Cell>> block : blocks.entrySet()) {
            BitmapFont.draw(block.getKey(), rgb, width, GAP, y + GAP, TITLE_DOT);
            int top = y + GAP + BitmapFont.height(TITLE_DOT) + GAP;
            for (int row = 0; row < stops.length; row++) {
                BitmapFont.draw(title(row, stops[row]), rgb, width, GAP, top + row * rowHeight + GAP, DOT);
            }
            for (ImageSheet.Cell cell : block.getValue()) {
                drawCell(cell, GAP + cell.column() * cellWidth, top + cell.row() * rowHeight, stops[cell.row()]);
            }
            y += blockHeight();
        }
    }

    private String title(int row, double stops) {
        return sheet.rows().get(row) + String.format(Locale.ROOT, ", exposure %+.1f stops", stops);
    }

    private void drawCell(ImageSheet.Cell cell, int x, int y, double stops) {
        int line = BitmapFont.height(DOT) + GAP;
        BitmapFont.draw(cell.label(), rgb, width, x, y + line + GAP, DOT);
        int top = y + 2 * line + GAP;
        FilmImage image = cell.image();
        double scale = Math.pow(2, stops);
        String[] names = {"R", "G", "B"};
        for (int c = 0; c < names.length; c++) {
            float[] plane = image.channel(names[c]);
            for (int py = 0; py < imageHeight; py++) {
                for (int px = 0; px < imageWidth; px++) {
                    double value = mean(plane, image.width(), image.height(), px / enlargement, py / enlargement);
                    rgb[3 * ((top + py) * width + x + px) + c] = (float) (scale * value);
                }
            }
        }
    }

    /** Mean over the pixels that become one. */
    private double mean(float[] plane, int columns, int rows, int x, int y) {
        double sum = 0;
        int toX = Math.min(columns, (x + 1) * reduction);
        int toY = Math.min(rows, (y + 1) * reduction);
        for (int py = y * reduction; py < toY; py++) {
            for (int px = x * reduction; px < toX; px++) {
                sum += plane[py * columns + px];
            }
        }
        return sum / ((toX - x * reduction) * (toY - y * reduction));
    }

    /** Exposure of a row in half stops; 0 if it is black. */
    private double exposure(int row) {
        double[] luminance = new double[0];
        String block = sheet.cells().get(0).block();
        for (ImageSheet.Cell cell : sheet.cells()) {
            if (cell.row() == row && cell.block().equals(block)) {
                float[] r = cell.image().channel("R");
                float[] g = cell.image().channel("G");
                float[] b = cell.image().channel("B");
                luminance = luminance.length == 0 ? new double[r.length] : luminance;
                for (int i = 0; i < r.length; i++) {
                    luminance[i] += Spectrum.luminance(r[i], g[i], b[i]);
                }
            }
        }
        double[] lit = Arrays.stream(luminance)
                .filter(v -> v > 0 && v < Double.POSITIVE_INFINITY)
                .sorted()
                .toArray();
        if (lit.length == 0) {
            return 0;
        }
        double bright = lit[(int) (PERCENTILE * (lit.length - 1))];
        return Math.rint(2 * Math.log(BRIGHT / bright) / Math.log(2)) / 2;
    }
}
