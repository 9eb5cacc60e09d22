package org.daybreak.exr;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Makes the reduced levels of a tiled image. Each level comes from the one before: a sample is the mean over the area
 * that it covers (box filter, in double precision, rounded once), so that also odd sizes keep the picture in place.
 * Unsigned integers are labels as often as amounts and are picked from the middle of the area, not averaged.
 */
final class LevelReduction {
    private LevelReduction() {}

    /** All levels in the order of the file, the given full one first. */
    static List<ExrLevel> levels(TileDescription tiles, ExrLevel full) {
        int xLevels = tiles.xLevels(full.width(), full.height());
        int yLevels = tiles.yLevels(full.width(), full.height());
        List<ExrLevel> levels = new ArrayList<>();
        levels.add(full);
        switch (tiles.mode()) {
            case ONE_LEVEL -> {
                // The full level is all there is.
            }
            case MIPMAP -> {
                for (int level = 1; level < xLevels; level++) {
                    levels.add(reduce(tiles, full, levels.get(level - 1), level, level));
                }
            }
            case RIPMAP -> {
                for (int y = 0; y < yLevels; y++) {
                    for (int x = y == 0 ? 1 : 0; x < xLevels; x++) {
                        int before = x > 0 ? y * xLevels + x - 1 : (y - 1) * xLevels;
                        levels.add(reduce(tiles, full, levels.get(before), x, y));
                    }
                }
            }
        }
        return levels;
    }

    private static ExrLevel reduce(TileDescription tiles, ExrLevel full, ExrLevel from, int xLevel, int yLevel) {
        int width = (int) tiles.levelSize(full.width(), xLevel);
        int height = (int) tiles.levelSize(full.height(), yLevel);
        Map<String, float[]> samples = new HashMap<>();
        from.samples().forEach((name, plane) -> samples.put(name, average(plane, from, width, height)));
        Map<String, int[]> uintSamples = new HashMap<>();
        from.uintSamples().forEach((name, plane) -> uintSamples.put(name, pick(plane, from, width, height)));
        return new ExrLevel(width, height, samples, uintSamples);
    }

    private static float[] average(float[] plane, ExrLevel from, int width, int height) {
        float[] result = new float[width * height];
        double xScale = (double) from.width() / width;
        double yScale = (double) from.height() / height;
        for (int y = 0; y < height; y++) {
            double top = y * yScale;
            double bottom = y == height - 1 ? from.height() : (y + 1) * yScale;
            for (int x = 0; x < width; x++) {
                double left = x * xScale;
                double right = x == width - 1 ? from.width() : (x + 1) * xScale;
                result[y * width + x] = (float) mean(plane, from.width(), left, right, top, bottom);
            }
        }
        return result;
    }

    private static double mean(float[] plane, int stride, double left, double right, double top, double bottom) {
        double sum = 0;
        double area = 0;
        for (int y = (int) top; y < bottom; y++) {
            double rowWeight = Math.min(bottom, y + 1.0) - Math.max(top, y);
            for (int x = (int) left; x < right; x++) {
                double weight = rowWeight * (Math.min(right, x + 1.0) - Math.max(left, x));
                sum += weight * plane[y * stride + x];
                area += weight;
            }
        }
        return sum / area;
    }

    private static int[] pick(int[] plane, ExrLevel from, int width, int height) {
        int[] result = new int[width * height];
        for (int y = 0; y < height; y++) {
            int row = (int) ((2L * y + 1) * from.height() / (2L * height));
            for (int x = 0; x < width; x++) {
                int column = (int) ((2L * x + 1) * from.width() / (2L * width));
                result[y * width + x] = plane[row * from.width() + column];
            }
        }
        return result;
    }
}
