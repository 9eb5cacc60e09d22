package org.daybreak.tracing;

import org.daybreak.core.film.Film;
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

    /** Tiles and splats of {@link FurtherImages}. */
    final FilmTile[] furtherTiles;

    final SplatBuffer[] furtherSplats;

    /** Position in the list of tiles. */
    int index;

    int x;
    int y;
    int width;
    int height;

    /** False if another part of the image counts these samples: they are here for the filter of neighbours. */
    boolean counted;

    /** Number of the lane that splats belong to. */
    int lane;

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

    TileUnit(FilmTile tile, FilmTile[] furtherTiles) {
        this.tile = tile;
        this.furtherTiles = furtherTiles;
        furtherSplats = new SplatBuffer[furtherTiles.length];
        for (int i = 0; i < furtherSplats.length; i++) {
            furtherSplats[i] = new SplatBuffer();
        }
    }

    /** Empties the unit: its samples will be taken. */
    void begin() {
        tile.begin(x, y, width, height);
        splats.clear();
        nonFinite.clear();
        samples = 0;
        for (int i = 0; i < furtherTiles.length; i++) {
            furtherTiles[i].begin(x, y, width, height);
            furtherSplats[i].clear();
        }
    }

    /** Sets the weight of the samples that follow. */
    void setSampleWeight(double weight) {
        tile.setSampleWeight(weight);
        for (FilmTile further : furtherTiles) {
            further.setSampleWeight(weight);
        }
    }

    /**
     * Adds the unit's samples to a film and those of further images.
     *
     * @param splatting whether the algorithm splats: if not, the samples are no subpaths that might have
     */
    void commit(Film film, Film[] further, boolean splatting) {
        long countedSamples = counted ? tile.samples() : 0;
        film.commit(tile, countedSamples);
        for (int i = 0; i < further.length; i++) {
            further[i].commit(furtherTiles[i], countedSamples);
        }
        if (counted && splatting) {
            film.commit(splats, samples, lane);
            for (int i = 0; i < further.length; i++) {
                further[i].commit(furtherSplats[i], samples);
            }
        }
    }
}
