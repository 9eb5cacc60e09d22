package org.daybreak.core.film;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * All that a {@link Film} has accumulated, in exact double bits: enough to go on, and to put a film together from parts.
 * Immutable as long as the arrays it hands out are not written to.
 *
 * @param settings size, crop and filter
 * @param layers auxiliary images that are gathered
 * @param weighted whether samples carry weights of their own, see {@link Film#useSampleWeights()}
 * @param regions rectangles of the film, within the crop and without overlap, whose sample sums are held
 * @param sums sample sums of the regions, one region after the other, each row by row, {@link #stride} numbers per pixel
 * @param samples number of samples
 * @param splats sums of splats, over the whole crop, {@link #splatStride} numbers per pixel: that of the lanes which were
 *     added up already, null if they have no splat; then those of lanes that are kept apart; then that of the open lane
 * @param splatPaths number of subpaths that were traced for the splats
 * @param splatScale factor on the mean of the splats
 * @param dependence what the variance of splats is estimated from if they depend on each other; null if they do not
 */
public record FilmState(
        FilmSettings settings,
        Set<FilmLayer> layers,
        boolean weighted,
        List<FilmSettings.Crop> regions,
        double[] sums,
        long samples,
        Splats splats,
        long splatPaths,
        double splatScale,
        @Nullable DependentSplats dependence) {
    /**
     * Sums of splats in the order in which they are added up: (total + lane₀) + lane₁ + … + open.
     *
     * @param total sum of finished lanes
     * @param lanes those lanes with any splat that are kept apart, by rising numbers
     * @param open the lane without a number that is being filled
     */
    public record Splats(double @Nullable [] total, List<Lane> lanes, double @Nullable [] open) {
        /** No splat at all. */
        public static final Splats NONE = new Splats(null, List.of(), null);

        /**
         * Copies the list.
         *
         * @throws IllegalArgumentException if the numbers do not rise from 0 or above
         */
        public Splats {
            lanes = List.copyOf(lanes);
            int last = -1;
            for (Lane lane : lanes) {
                if (lane.number <= last) {
                    throw new IllegalArgumentException("lane " + lane.number + " of splats follows lane " + last);
                }
                last = lane.number;
            }
        }

        /** As the constructor, whose class file does not say which of its arrays may be null. */
        public static Splats of(double @Nullable [] total, List<Lane> lanes, double @Nullable [] open) {
            return new Splats(total, lanes, open);
        }
    }

    /**
     * A lane of splats.
     *
     * @param number place of the lane in the order of summation
     * @param sums its sums
     */
    public record Lane(int number, double[] sums) {}

    /**
     * See {@link Film#useDependentSplats()}.
     *
     * @param scaleError standard error of the factor on the splats over itself
     * @param lanePaths number of subpaths of each lane, in their order
     */
    public record DependentSplats(double scaleError, long[] lanePaths) {}

    /** A state whose splats, if there are any, do not depend on each other. */
    public FilmState(
            FilmSettings settings,
            Set<FilmLayer> layers,
            boolean weighted,
            List<FilmSettings.Crop> regions,
            double[] sums,
            long samples,
            Splats splats,
            long splatPaths,
            double splatScale) {
        this(settings, layers, weighted, regions, sums, samples, splats, splatPaths, splatScale, null);
    }

    /**
     * Checks that regions and lengths fit the settings.
     *
     * @throws IllegalArgumentException if they do not
     */
    public FilmState {
        layers = java.util.Collections.unmodifiableSet(
                layers.isEmpty() ? EnumSet.noneOf(FilmLayer.class) : EnumSet.copyOf(layers));
        regions = List.copyOf(regions);
        long pixels = 0;
        FilmSettings.Crop crop = settings.crop();
        for (FilmSettings.Crop r : regions) {
            if (r.width() < 1
                    || r.height() < 1
                    || r.x() < crop.x()
                    || r.y() < crop.y()
                    || (long) r.x() + r.width() > crop.x() + crop.width()
                    || (long) r.y() + r.height() > crop.y() + crop.height()) {
                throw new IllegalArgumentException("the region " + r + " does not lie within the crop " + crop);
            }
            pixels += (long) r.width() * r.height();
        }
        check("sums of samples", sums, pixels * new FilmLayout(settings, layers, weighted).stride);
        long splatLength = (long) crop.width() * crop.height() * splatStride(layers);
        check("sums of splats", splats.total(), splatLength);
        check("sums of splats", splats.open(), splatLength);
        for (Lane lane : splats.lanes()) {
            check("sums of splats", lane.sums, splatLength);
        }
        if (dependence != null && dependence.lanePaths.length != splats.lanes().size()) {
            throw new IllegalArgumentException("there are " + splats.lanes().size()
                    + " lanes of splats but numbers of subpaths of " + dependence.lanePaths.length);
        }
        if (samples < 0 || splatPaths < 0) {
            throw new IllegalArgumentException("a number of samples is negative");
        }
    }

    /** Numbers per pixel in {@link #sums}. */
    public int stride() {
        return new FilmLayout(settings, layers, weighted).stride;
    }

    /** Numbers per pixel in {@link #splats}. */
    public int splatStride() {
        return splatStride(layers);
    }

    static int splatStride(Set<FilmLayer> layers) {
        return layers.contains(FilmLayer.VARIANCE) ? 7 : 4;
    }

    private static void check(String what, double @Nullable [] array, long length) {
        if (array != null && array.length != length) {
            throw new IllegalArgumentException("there are " + array.length + " " + what + " but must be " + length);
        }
    }
}
