package org.daybreak.core.film;

import java.util.Set;

/**
 * Where a pixel's sums lie in the arrays of film and tiles. Immutable.
 *
 * <p>With weights w (filter), sample values v and their luminance Y, a pixel keeps Σw, Σw·v and what the variance of
 * Σw·v/Σw needs: Σw², Σw²Y and Σw²Y²; with the variance layer also Σw²v and Σw²v². With the one-pixel box and with filter
 * sampling all weights are 1 unless samples have weights of their own, and sums that are then equal are kept once.
 */
final class FilmLayout {
    /** Numbers per pixel. */
    final int stride;

    /** True for the box of one pixel: a sample belongs to the pixel it lies in. */
    final boolean pixelBox;

    /** True if all weights are 1: the box of one pixel or filter sampling, and samples without weights of their own. */
    final boolean unitWeights;

    /** True if the variance layer is kept. */
    final boolean variance;

    /** Σw; three entries Σw·v follow it. */
    static final int WEIGHT = 0;

    static final int COLOR = 1;

    /** Σw²Y². */
    static final int LUMINANCE_SQUARED = 4;

    /** Σw² and, after it, Σw²Y; for the unit box only {@link #WEIGHT} and the colour. */
    final int squaredWeight;

    /** Σw²v, three entries; equal to {@link #COLOR} for the unit box. */
    final int first;

    /** Σw²v², three entries. */
    final int second;

    /** Σw·albedo, three entries, or -1. */
    final int albedo;

    /** Σw·normal, three entries, or -1. */
    final int normal;

    /** Σw·depth and Σw over samples that see a surface, or -1. */
    final int depth;

    /** True if some layer needs the features of samples. */
    final boolean features;

    FilmLayout(FilmSettings settings, Set<FilmLayer> layers, boolean weighted) {
        pixelBox = isUnitBox(settings.filter());
        unitWeights = (settings.filterSampling() || pixelBox) && !weighted;
        variance = layers.contains(FilmLayer.VARIANCE);
        int next = LUMINANCE_SQUARED + 1;
        if (unitWeights) {
            squaredWeight = WEIGHT;
            first = COLOR;
        } else {
            squaredWeight = next;
            next += 2;
            first = variance ? next : -1;
            next += variance ? 3 : 0;
        }
        second = variance ? next : -1;
        next += variance ? 3 : 0;
        albedo = layers.contains(FilmLayer.ALBEDO) ? next : -1;
        next += albedo >= 0 ? 3 : 0;
        normal = layers.contains(FilmLayer.NORMAL) ? next : -1;
        next += normal >= 0 ? 3 : 0;
        depth = layers.contains(FilmLayer.DEPTH) ? next : -1;
        next += depth >= 0 ? 2 : 0;
        features = albedo >= 0 || normal >= 0 || depth >= 0;
        stride = next;
    }

    /** True for the box of one pixel. */
    static boolean isUnitBox(ReconstructionFilter filter) {
        return filter.kind() == ReconstructionFilter.Kind.BOX && filter.radius() == 0.5;
    }
}
