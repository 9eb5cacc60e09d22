package org.daybreak.tracing;

import org.daybreak.core.film.FilmTile;
import org.daybreak.core.film.LuminanceStatistics;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.NonFiniteLog;
import org.jspecify.annotations.Nullable;

/** A tile of a pass: what to do and what came out. Mutable, reused. */
final class TileUnit {
    final FilmTile tile;
    final SplatBuffer splats = new SplatBuffer();
    final NonFiniteLog nonFinite = new NonFiniteLog();

    /** Position in the list of tiles. */
    int index;

    int x;
    int y;
    int width;
    int height;

    /** False if another part of the image counts these samples: they are here for the filter of neighbours. */
    boolean counted;

    /** Seed of the random numbers. */
    long seed;

    /** Number of the pass, from 0. */
    int pass;

    /** First sample of each pixel, and how many; not if {@link #counts} says so. */
    long firstSample;

    int samplesPerPixel;

    /** Samples of each pixel of the sample area in this pass, null if all have the same number. */
    int @Nullable [] counts;

    /** What the film held when the pass began; with {@link #counts}. */
    @Nullable
    LuminanceStatistics statistics;

    /** Which of how many slices of the pass this is; for {@link #counts}. */
    int slice;

    int slices;

    /** Weight of the pass. */
    double passWeight;

    boolean endsPass;

    /** Samples per pixel when the pass has ended. */
    long samplesPerPixelThen;

    /** How many samples were to be taken, and how many were. */
    long expected;

    long samples;

    TileUnit(FilmTile tile) {
        this.tile = tile;
    }
}
