package org.daybreak.core.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.daybreak.core.color.Spectrum;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

final class FilmTest {
    static Stream<ReconstructionFilter> filters() {
        return ReconstructionFilterTest.filters();
    }

    /** A smooth picture. */
    private static void picture(double x, double y, Spectrum out) {
        out.set(1 + 0.5 * Math.sin(x), 2 + Math.cos(0.7 * y), 0.1 * x + 0.05 * y);
    }

    /** Fills the sample area with n×n samples at the centres of cells of each pixel, in tiles of the given size. */
    private static void fill(Film film, int n, int tileSize, boolean constant) {
        FilmSettings.Crop area = film.sampleArea();
        FilmTile tile = film.newTile();
        Spectrum value = new Spectrum();
        for (int ty = 0; ty < area.height(); ty += tileSize) {
            for (int tx = 0; tx < area.width(); tx += tileSize) {
                int width = Math.min(tileSize, area.width() - tx);
                int height = Math.min(tileSize, area.height() - ty);
                tile.begin(area.x() + tx, area.y() + ty, width, height);
                for (int i = 0; i < width * n; i++) {
                    for (int j = 0; j < height * n; j++) {
                        double x = area.x() + tx + (i + 0.5) / n;
                        double y = area.y() + ty + (j + 0.5) / n;
                        picture(x, y, value);
                        if (constant) {
                            value.set(0.25, 3, 7);
                        }
                        assertTrue(tile.add(x, y, value));
                    }
                }
                film.commit(tile);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("filters")
    void constantImageIsConstantUpToTheEdges(ReconstructionFilter filter) {
        for (FilmSettings settings : List.of(
                new FilmSettings(7, 5, filter),
                new FilmSettings(1, 1, filter),
                new FilmSettings(20, 20, new FilmSettings.Crop(3, 4, 6, 5), filter))) {
            Film film = new Film(settings, EnumSet.of(FilmLayer.VARIANCE));
            fill(film, 4, 3, true);
            FilmImage image = film.develop();
            for (int p = 0; p < image.width() * image.height(); p++) {
                assertEquals(0.25, image.channel("R")[p], 1e-6);
                assertEquals(3, image.channel("G")[p], 1e-5);
                assertEquals(7, image.channel("B")[p], 1e-5);
                assertEquals(0, image.channel("variance.B")[p], 1e-12);
            }
            assertEquals(0, film.relativeError(), 1e-6);
        }
    }

    @ParameterizedTest
    @MethodSource("filters")
    void pixelsAreFilteredMeans(ReconstructionFilter filter) {
        Film film = new Film(new FilmSettings(9, 8, filter));
        fill(film, 8, 4, false);
        FilmImage image = film.develop();
        Spectrum value = new Spectrum();
        int n = 8;
        for (int px = 0; px < 9; px++) {
            for (int py = 0; py < 8; py++) {
                double sum = 0;
                double weights = 0;
                for (int i = 0; i < 9 * n; i++) {
                    for (int j = 0; j < 8 * n; j++) {
                        double x = (i + 0.5) / n;
                        double y = (j + 0.5) / n;
                        // At half-integer radii samples fall on the edge of the support: which side does not matter in
                        // the limit.
                        double w = filter.evaluate(x - px - 0.5) * filter.evaluate(y - py - 0.5);
                        picture(x, y, value);
                        sum += w * value.r;
                        weights += w;
                    }
                }
                assertEquals(sum / weights, image.get("R", px, py), 1e-4);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("filters")
    void cropIsPartOfTheWhole(ReconstructionFilter filter) {
        Film whole = new Film(new FilmSettings(24, 20, filter));
        fill(whole, 3, 32, false);
        FilmSettings.Crop crop = new FilmSettings.Crop(5, 0, 7, 9);
        Film part = new Film(new FilmSettings(24, 20, crop, filter));
        fill(part, 3, 32, false);
        FilmImage expected = whole.develop();
        FilmImage image = part.develop();
        assertEquals(7, image.width());
        assertEquals(9, image.height());
        for (int x = 0; x < 7; x++) {
            for (int y = 0; y < 9; y++) {
                assertEquals(expected.get("G", 5 + x, y), image.get("G", x, y), 1e-6);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("filters")
    void tileSizeDoesNotMatter(ReconstructionFilter filter) {
        Film small = new Film(new FilmSettings(24, 20, filter));
        fill(small, 2, 3, false);
        Film large = new Film(new FilmSettings(24, 20, filter));
        fill(large, 2, 64, false);
        assertArrayEquals(large.develop().channel("B"), small.develop().channel("B"), 1e-6f);
    }

    /** Splats spread evenly with mean 1 per pixel must give 1 everywhere, the edges included, like samples do. */
    @ParameterizedTest
    @MethodSource("filters")
    void splatsAreNormalised(ReconstructionFilter filter) {
        int n = 32;
        for (FilmSettings settings : List.of(
                new FilmSettings(6, 5, filter),
                new FilmSettings(6, 5, new FilmSettings.Crop(1, 2, 3, 2), filter),
                new FilmSettings(1, 1, filter))) {
            Film film = new Film(settings);
            SplatBuffer splats = new SplatBuffer();
            for (int i = 0; i < settings.width() * n; i++) {
                for (int j = 0; j < settings.height() * n; j++) {
                    assertTrue(splats.add((i + 0.5) / n, (j + 0.5) / n, new Spectrum(1, 2, 0.5)));
                }
            }
            // n² splats per pixel and as many paths: their sum over a pixel divided by the paths is the value.
            film.commit(splats, (long) n * n);
            FilmImage image = film.develop();
            for (int p = 0; p < image.width() * image.height(); p++) {
                // The midpoint rule's error is largest for box filters, whose edges fall between the splats.
                assertEquals(1, image.channel("R")[p], 0.04);
                assertEquals(2, image.channel("G")[p], 0.08);
                assertEquals(image.channel("R")[p] / 2, image.channel("B")[p], 1e-6);
            }
        }
    }

    @Test
    void splatsAddToSamplesWithTheirScale() {
        Film film = new Film(new FilmSettings(2, 1, ReconstructionFilter.BOX));
        fill(film, 1, 8, true);
        SplatBuffer splats = new SplatBuffer();
        splats.add(1.5, 0.5, new Spectrum(6, 0, 0));
        film.commit(splats, 2);
        film.setSplatScale(0.5);
        FilmImage image = film.develop();
        assertEquals(0.25, image.get("R", 0, 0), 1e-7);
        assertEquals(0.25 + 1.5, image.get("R", 1, 0), 1e-6);
        assertEquals(2, film.splatPaths());
        assertEquals(2, film.samples());
    }

    @Test
    void momentsGiveTheVarianceOfTheMean() {
        Film film = new Film(new FilmSettings(1, 1, ReconstructionFilter.BOX), EnumSet.of(FilmLayer.VARIANCE));
        assertTrue(Float.isNaN(film.develop().get("variance.R", 0, 0)));
        FilmTile tile = film.newTile();
        double[] values = {1, 4, 2, 9, 0.5};
        for (double v : values) {
            tile.begin(0, 0, 1, 1);
            tile.add(0.5, 0.5, new Spectrum(v, 2 * v, 1));
            film.commit(tile);
        }
        // mean 3.3, sum of squared deviations 47.8 (1: 5.29, 4: 0.49, 2: 1.69, 9: 32.49, 0.5: 7.84)
        FilmImage image = film.develop();
        assertEquals(3.3, image.get("R", 0, 0), 1e-6);
        assertEquals(47.8 / 4 / 5, image.get("variance.R", 0, 0), 1e-6);
        assertEquals(4 * 47.8 / 4 / 5, image.get("variance.G", 0, 0), 1e-5);
        assertEquals(0, image.get("variance.B", 0, 0), 1e-12);
        double luminance = Spectrum.luminance(3.3, 6.6, 1);
        double spread = Spectrum.LUMINANCE_R + 2 * Spectrum.LUMINANCE_G;
        assertEquals(spread * Math.sqrt(47.8 / 20) / luminance, film.relativeError(), 1e-9);
    }

    /**
     * With a wide filter the variance estimate must match the spread over independent films: 400 films, so the ratio of the two has
     * a standard deviation of about 0.07; the bounds are beyond 5 of these.
     */
    @ParameterizedTest
    @MethodSource("filters")
    void varianceMatchesTheSpreadOverFilms(ReconstructionFilter filter) {
        SplittableRandom random = new SplittableRandom(7);
        double sum = 0;
        double squares = 0;
        double estimate = 0;
        int films = 400;
        for (int i = 0; i < films; i++) {
            Film film = new Film(new FilmSettings(5, 5, filter), EnumSet.of(FilmLayer.VARIANCE));
            FilmTile tile = film.newTile();
            tile.begin(0, 0, 5, 5);
            for (int s = 0; s < 25 * 16; s++) {
                int column = s % 5;
                int row = s / 5 % 5;
                double v = random.nextDouble();
                tile.add(column + random.nextDouble(), row + random.nextDouble(), new Spectrum(v, v, v));
            }
            film.commit(tile);
            FilmImage image = film.develop();
            double value = image.get("R", 2, 2);
            sum += value;
            squares += value * value;
            estimate += image.get("variance.R", 2, 2) / films;
        }
        double mean = sum / films;
        double spread = (squares - films * mean * mean) / (films - 1);
        assertEquals(1, estimate / spread, 0.36);
        assertEquals(0.5, mean, 5 * Math.sqrt(spread / films));
    }

    @Test
    void splatVarianceMatchesTheSpreadOverFilms() {
        SplittableRandom random = new SplittableRandom(11);
        double sum = 0;
        double squares = 0;
        double estimate = 0;
        int films = 400;
        for (int i = 0; i < films; i++) {
            Film film = new Film(new FilmSettings(3, 3, ReconstructionFilter.TENT), EnumSet.of(FilmLayer.VARIANCE));
            SplatBuffer splats = new SplatBuffer();
            for (int s = 0; s < 200; s++) {
                double v = random.nextDouble();
                splats.add(3 * random.nextDouble(), 3 * random.nextDouble(), 9 * v, v, v);
            }
            film.commit(splats, 200);
            FilmImage image = film.develop();
            double value = image.get("R", 1, 1);
            sum += value;
            squares += value * value;
            estimate += image.get("variance.R", 1, 1) / films;
        }
        double mean = sum / films;
        double spread = (squares - films * mean * mean) / (films - 1);
        // As above: five standard deviations.
        assertEquals(1, estimate / spread, 0.36);
        assertEquals(0.5, mean, 5 * Math.sqrt(spread / films));
    }

    @Test
    void auxiliaryImagesAreMeans() {
        Film film = new Film(
                new FilmSettings(2, 1, ReconstructionFilter.BOX),
                EnumSet.of(FilmLayer.ALBEDO, FilmLayer.NORMAL, FilmLayer.DEPTH));
        assertTrue(film.needsFeatures());
        FilmTile tile = film.newTile();
        tile.begin(0, 0, 2, 1);
        FilmFeatures features = new FilmFeatures();
        Spectrum black = new Spectrum();
        tile.add(0.5, 0.5, black, features);
        features.hit = true;
        features.albedo.set(0.5, 0.25, 1);
        features.ny = 1;
        features.depth = 3;
        tile.add(0.25, 0.5, black, features);
        features.hit = false;
        tile.add(1.5, 0.5, black, features);
        film.commit(tile);
        FilmImage image = film.develop();
        assertEquals(
                List.of(
                        "R",
                        "G",
                        "B",
                        "albedo.R",
                        "albedo.G",
                        "albedo.B",
                        "normal.X",
                        "normal.Y",
                        "normal.Z",
                        "depth.Z"),
                image.channelNames());
        assertEquals(0.25, image.get("albedo.R", 0, 0));
        assertEquals(0.5, image.get("normal.Y", 0, 0));
        assertEquals(3, image.get("depth.Z", 0, 0));
        assertEquals(0, image.get("depth.Z", 1, 0));
        assertThrows(IllegalArgumentException.class, () -> image.channel("variance.R"));
    }

    @Test
    void nonFiniteValuesAreLeftOut() {
        Film film = new Film(new FilmSettings(1, 1, ReconstructionFilter.BOX), Set.of(FilmLayer.DEPTH));
        FilmTile tile = film.newTile();
        tile.begin(0, 0, 1, 1);
        FilmFeatures features = new FilmFeatures();
        assertFalse(tile.add(0.5, 0.5, new Spectrum(1, Double.NaN, 1), features));
        assertFalse(tile.add(0.5, 0.5, new Spectrum(1, 1, Double.POSITIVE_INFINITY), features));
        features.hit = true;
        features.depth = Double.NaN;
        assertFalse(tile.add(0.5, 0.5, new Spectrum(1, 1, 1), features));
        features.depth = 2;
        assertTrue(tile.add(0.5, 0.5, new Spectrum(2, 3, 4), features));
        assertEquals(1, tile.samples());
        film.commit(tile);
        assertEquals(3, film.develop().get("G", 0, 0));
        SplatBuffer splats = new SplatBuffer();
        assertFalse(splats.add(0.5, 0.5, new Spectrum(Double.NaN, 0, 0)));
        assertEquals(0, splats.size());
    }

    @Test
    void emptyFilmIsBlack() {
        Film film = new Film(new FilmSettings(3, 2, ReconstructionFilter.MITCHELL));
        assertArrayEquals(new float[6], film.develop().channel("G"));
        assertTrue(Double.isNaN(film.relativeError()));
    }

    @Test
    void refusesWhatDoesNotFit() {
        assertThrows(IllegalArgumentException.class, () -> new FilmSettings(0, 5, ReconstructionFilter.BOX));
        assertThrows(IllegalArgumentException.class, () -> new FilmSettings(5, 70_000, ReconstructionFilter.BOX));
        assertThrows(
                IllegalArgumentException.class,
                () -> new FilmSettings(5, 5, new FilmSettings.Crop(1, 1, 5, 4), ReconstructionFilter.BOX));
        assertThrows(
                IllegalArgumentException.class,
                () -> new Film(new FilmSettings(65_536, 65_536, ReconstructionFilter.BOX)));
    }
}
