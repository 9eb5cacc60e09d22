package org.daybreak.metropolis.chains;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.Progress;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Renders of a known function by chains. False-alarm rate 1e-5 per assertion, for the fixed seeds once and for all. */
class ChainRendererTest {
    private static final double LEVEL = 1e-5;
    private static final int WIDTH = Rendering.WIDTH;
    private static final int HEIGHT = Rendering.HEIGHT;

    /** A camera is all that the toy sees of the scene. */
    private static final Scene SCENE = Rendering.sky(WIDTH, HEIGHT);

    private static RenderReport render(ChainRenderer renderer, Film film, RenderContext context) {
        int width = film.settings().width();
        int height = film.settings().height();
        Scene scene = width == WIDTH && height == HEIGHT ? SCENE : Rendering.sky(width, height);
        return renderer.render(scene, scene.camera(), film, context);
    }

    private static float[] image(ChainRenderer renderer, RenderContext context) {
        Film film = Rendering.film(WIDTH, HEIGHT);
        render(renderer, film, context);
        return film.develop().channel("R");
    }

    /** p-values of blocks of 4×4 pixels over independent runs. */
    private static void assertIsTheFunction(ChainRenderer renderer, int runs, String what) {
        Moments[] blocks = new Moments[WIDTH * HEIGHT / 16];
        double[] expected = new double[blocks.length];
        for (int i = 0; i < blocks.length; i++) {
            blocks[i] = new Moments();
        }
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                expected[y / 4 * (WIDTH / 4) + x / 4] += ToyAlgorithm.RED * ToyAlgorithm.mean(x, y, WIDTH, HEIGHT) / 16;
            }
        }
        for (int run = 0; run < runs; run++) {
            float[] image = image(renderer, Rendering.context(run, 2));
            double[] sums = new double[blocks.length];
            for (int p = 0; p < image.length; p++) {
                sums[p / WIDTH / 4 * (WIDTH / 4) + p % WIDTH / 4] += image[p] / 16;
            }
            for (int i = 0; i < blocks.length; i++) {
                blocks[i].add(sums[i]);
            }
        }
        double[] pValues = new double[blocks.length];
        for (int i = 0; i < blocks.length; i++) {
            pValues[i] = ZTest.oneSample(blocks[i], expected[i]);
        }
        ZTest.assertNoneRejected(what, pValues, LEVEL);
    }

    @ParameterizedTest
    @CsvSource({"50, 40, false", "50, 40, true", "3, 40, false", "1, 40, true", "5000, 8, false"})
    void convergesToTheFunction(int chains, int mutations, boolean twoStage) {
        assertIsTheFunction(
                Rendering.toy(Rendering.settings(chains, mutations, twoStage)),
                100,
                chains + " chains" + (twoStage ? " in two stages" : ""));
    }

    @Test
    void withoutExpectedValuesToo() {
        ToyAlgorithm plain = new ToyAlgorithm(ToyAlgorithm.Fault.NONE, false);
        assertIsTheFunction(
                new ChainRenderer(plain, Rendering.settings(50, 40, false), -1, -1), 100, "without expected values");
    }

    /** Chains of a single step from few candidates: nothing but the start makes the image right. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void shortChainsAreUnbiased(boolean rare) {
        ChainSettings settings = new ChainSettings(WIDTH * HEIGHT, 1, false, 1, false, 8, rare ? 500 : 10);
        ToyAlgorithm algorithm = new ToyAlgorithm(rare ? ToyAlgorithm.Fault.RARE : ToyAlgorithm.Fault.NONE, true);
        ChainRenderer renderer = new ChainRenderer(algorithm, settings, -1, -1);
        Moments means = new Moments();
        Moments bright = new Moments();
        double expected = 0;
        for (int y = 0; y < HEIGHT; y++) {
            expected += ToyAlgorithm.RED * ToyAlgorithm.mean(WIDTH - 1, y, WIDTH, HEIGHT) / HEIGHT;
        }
        for (int run = 0; run < 2000; run++) {
            float[] image = image(renderer, Rendering.context(run, 1));
            double sum = 0;
            double right = 0;
            for (int p = 0; p < image.length; p++) {
                sum += image[p];
                right += p % WIDTH == WIDTH - 1 ? image[p] : 0;
            }
            means.add(sum / image.length);
            bright.add(right / HEIGHT);
        }
        double brightness = ToyAlgorithm.brightness()
                * ToyAlgorithm.RED
                / Spectrum.luminance(ToyAlgorithm.RED, ToyAlgorithm.GREEN, ToyAlgorithm.BLUE);
        ZTest.assertNotRejected("mean of the image", ZTest.oneSample(means, brightness), LEVEL);
        ZTest.assertNotRejected("mean of the bright column", ZTest.oneSample(bright, expected), LEVEL);
    }

    @Test
    void estimatesBrightnessAndItsError() {
        Moments normalised = new Moments();
        for (int run = 0; run < 200; run++) {
            RenderReport report = render(
                    Rendering.toy(Rendering.settings(10, 1, false)),
                    Rendering.film(WIDTH, HEIGHT),
                    Rendering.context(run, 2));
            double b = report.figures().get("b");
            normalised.add((b - ToyAlgorithm.brightness()) / report.figures().get("bStandardError"));
            assertEquals(1000, report.figures().get("seeds"));
            assertTrue(report.figures().get("seedsWithoutLight") > 0);
        }
        ZTest.assertNotRejected("b", ZTest.oneSample(normalised, 0), LEVEL);
        // 200 runs: the variance is known to ±10 %; 4.5 standard deviations.
        assertEquals(1, normalised.variance(), 0.45);
    }

    @ParameterizedTest
    @CsvSource({"50, 20, false, false", "50, 20, true, true", "2, 20, false, false", "1, 3, false, true"})
    void sameBitsForAnyNumberOfThreads(int chains, int mutations, boolean twoStage, boolean direct) {
        ChainSettings settings = new ChainSettings(chains, mutations, direct, 2, twoStage, 3, 1000);
        Film expected = Rendering.film(WIDTH, HEIGHT);
        RenderReport first = render(Rendering.toy(settings), expected, Rendering.context(7, 1));
        for (int threads : new int[] {2, 3, 8}) {
            Film film = Rendering.film(WIDTH, HEIGHT);
            RenderReport report = render(Rendering.toy(settings), film, Rendering.context(7, threads));
            for (String channel : List.of("R", "G", "B", "variance.R", "variance.B")) {
                assertArrayEquals(
                        expected.develop().channel(channel), film.develop().channel(channel), threads + " threads");
            }
            assertEquals(first.figures(), report.figures());
            assertEquals(first.samples(), report.samples());
        }
    }

    @Test
    void takesExactlyTheStepsThatAreAskedFor() {
        RenderReport report = render(
                Rendering.toy(Rendering.settings(7, 11, false)),
                Rendering.film(WIDTH, HEIGHT),
                Rendering.context(1, 3));
        assertEquals(11L * WIDTH * HEIGHT, report.samples());
        assertEquals(11, report.samplesPerPixel());
        assertEquals(11, report.figures().get("mutationsPerPixel"));
        double tried =
                report.figures().get("move.jump.tried") + report.figures().get("move.walk.tried");
        assertEquals(11L * WIDTH * HEIGHT, tried);
        assertFalse(report.cancelled());
        assertTrue(report.warnings().contains("this is a toy"));
        assertNotNull(report.figures().get("move.walk.acceptance"));
        assertNotNull(report.figures().get("move.walk.kindChanged"));
    }

    @Test
    void aCropIsAPartOfTheImage() {
        ChainRenderer renderer = Rendering.toy(Rendering.settings(20, 10, true));
        Film whole = Rendering.film(WIDTH, HEIGHT);
        render(renderer, whole, Rendering.context(3, 2));
        FilmSettings.Crop crop = new FilmSettings.Crop(5, 3, 9, 7);
        Film part =
                new Film(new FilmSettings(WIDTH, HEIGHT, crop, ReconstructionFilter.BOX), Set.of(FilmLayer.VARIANCE));
        render(renderer, part, Rendering.context(3, 2));
        for (int y = 0; y < crop.height(); y++) {
            for (int x = 0; x < crop.width(); x++) {
                assertEquals(
                        whole.develop().get("G", crop.x() + x, crop.y() + y),
                        part.develop().get("G", x, y));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 1", "1, 1, 50", "1, 40, 3", "33, 1, 1000", "2, 2, 4"})
    void smallFilms(int width, int height, int chains) {
        Film film = Rendering.film(width, height);
        ChainSettings settings = new ChainSettings(chains, 2000, false, 1, true, 8, 100_000);
        RenderReport report = render(Rendering.toy(settings), film, Rendering.context(1, 4));
        assertEquals(2000L * width * height, report.samples());
        for (int y = 0; y < height; y++) {
            double sum = 0;
            double expected = 0;
            for (int x = 0; x < width; x++) {
                sum += film.develop().get("B", x, y);
                expected += ToyAlgorithm.BLUE * ToyAlgorithm.mean(x, y, width, height);
            }
            // b is known to 0.6 %, and 2000 steps of a chain that forgets within ten leave some 7 % in a pixel.
            assertEquals(expected, sum, 0.3 * expected + 1e-12);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void withoutLightTheImageIsBlackOrDirectlyLit(boolean direct) {
        ChainSettings settings = new ChainSettings(10, 10, direct, 2, true, 8, 100);
        ChainRenderer renderer = new ChainRenderer(new ToyAlgorithm(ToyAlgorithm.Fault.DARK, true), settings, -1, -1);
        Film film = Rendering.film(WIDTH, HEIGHT);
        RenderReport report = render(renderer, film, Rendering.context(1, 2));
        for (float value : film.develop().channel("R")) {
            assertEquals(direct ? 1f : 0f, value, 1e-6f);
        }
        assertFalse(report.cancelled());
        assertTrue(report.warnings().stream().anyMatch(w -> w.contains("no light")), report.warnings()::toString);
        assertEquals(0, report.figures().get("b"));
        assertEquals(100, report.figures().get("seedsWithoutLight"));
    }

    /** The toy adds to the direct light as if its paths were longer. */
    @Test
    void directLightIsAddedToWhatTheChainsBring() {
        ChainSettings settings = new ChainSettings(50, 100, true, 4, false, 8, 100_000);
        Film film = Rendering.film(WIDTH, HEIGHT);
        RenderReport report = render(Rendering.toy(settings), film, Rendering.context(1, 2));
        assertEquals(1, film.develop().get("R", 0, 0), 1e-6);
        assertEquals(2, film.develop().get("G", 0, 0), 1e-6);
        assertEquals(
                3
                        + ToyAlgorithm.BLUE
                                * ToyAlgorithm.brightness()
                                / Spectrum.luminance(ToyAlgorithm.RED, ToyAlgorithm.GREEN, ToyAlgorithm.BLUE),
                film.develop().mean("B"),
                0.01);
        assertEquals(104L * WIDTH * HEIGHT, report.samples());
        assertEquals(100, report.samplesPerPixel());
        assertTrue(report.raysByKind().get("camera") >= 4L * WIDTH * HEIGHT + 100_000);
    }

    @Test
    void nothingIsLeftForChainsOfPathsOfTwoEdges() {
        ChainSettings settings = new ChainSettings(50, 100, true, 4, false, 8, 100_000);
        Film film = Rendering.film(WIDTH, HEIGHT);
        RenderReport report =
                render(new ChainRenderer(new ToyAlgorithm(), settings, -1, 2), film, Rendering.context(1, 2));
        assertEquals(1, film.develop().mean("R"), 1e-6);
        assertEquals(4L * WIDTH * HEIGHT, report.samples());
        assertFalse(report.cancelled());
    }

    /** With such a limit path tracing would find more than bidirectional path tracing does. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void shortEyePathsLeaveDirectLightToTheChains(int maxEyeDepth) {
        ChainSettings settings = new ChainSettings(50, 10, true, 4, false, 8, 1000);
        Film film = Rendering.film(WIDTH, HEIGHT);
        RenderReport report =
                render(new ChainRenderer(new ToyAlgorithm(), settings, maxEyeDepth, -1), film, Rendering.context(1, 2));
        assertEquals(10L * WIDTH * HEIGHT, report.samples());
        assertEquals(0, film.develop().get("R", 0, 0));
        assertTrue(report.warnings().stream().anyMatch(w -> w.contains("maxEyeDepth")));
    }

    @Test
    void timeEndsIt() {
        for (boolean direct : new boolean[] {false, true}) {
            ChainSettings settings = new ChainSettings(20, 10, direct, 4, true, 8, 100_000);
            Film film = Rendering.film(WIDTH, HEIGHT);
            long start = System.nanoTime();
            RenderReport report =
                    render(Rendering.toy(settings), film, Rendering.context(1, 2, RenderBudget.seconds(1)));
            double seconds = (System.nanoTime() - start) * 1e-9;
            assertTrue(seconds < 5, () -> seconds + " s");
            assertFalse(report.cancelled());
            assertTrue(report.figures().get("mutationsPerPixel") > 10);
            double blue = film.develop().mean("B") - (direct ? 3 : 0);
            double expected = ToyAlgorithm.BLUE
                    * ToyAlgorithm.brightness()
                    / Spectrum.luminance(ToyAlgorithm.RED, ToyAlgorithm.GREEN, ToyAlgorithm.BLUE);
            assertEquals(expected, blue, 0.05 * expected);
        }
    }

    @Test
    void targetErrorEndsItAtTheSamePlace() {
        ChainSettings settings = new ChainSettings(64, 10, false, 4, false, 8, 100_000);
        RenderBudget budget = new RenderBudget(Integer.MAX_VALUE, Double.POSITIVE_INFINITY, 0.05);
        float[] expected = image(Rendering.toy(settings), Rendering.context(2, 1, budget));
        for (int threads : new int[] {2, 5}) {
            Film film = Rendering.film(WIDTH, HEIGHT);
            RenderReport report = render(Rendering.toy(settings), film, Rendering.context(2, threads, budget));
            assertArrayEquals(expected, film.develop().channel("R"), threads + " threads");
            assertTrue(film.relativeError() < 0.05);
            assertEquals(film.relativeError(), report.figures().get("relativeError"));
            assertFalse(report.cancelled());
        }
        double squares = 0;
        double mean = 0;
        for (int p = 0; p < expected.length; p++) {
            double right = ToyAlgorithm.RED * ToyAlgorithm.mean(p % WIDTH, p / WIDTH, WIDTH, HEIGHT);
            squares += (expected[p] - right) * (expected[p] - right) / expected.length;
            mean += right / expected.length;
        }
        double error = Math.sqrt(squares) / mean;
        assertTrue(error > 0.03 && error < 0.07, () -> "the true error is " + error);
    }

    /** Walks correlate the splats of a chain: estimates that take them as independent come out too low by far. */
    @Test
    void errorEstimateIsRight() {
        double estimated = 0;
        double real = 0;
        int runs = 30;
        for (int run = 0; run < runs; run++) {
            Film film = Rendering.film(WIDTH, HEIGHT);
            render(Rendering.toy(Rendering.settings(64, 20, false)), film, Rendering.context(run, 2));
            float[] values = film.develop().channel("R");
            float[] variances = film.develop().channel("variance.R");
            for (int p = 0; p < values.length; p++) {
                double right = ToyAlgorithm.RED * ToyAlgorithm.mean(p % WIDTH, p / WIDTH, WIDTH, HEIGHT);
                estimated += variances[p];
                real += (values[p] - right) * (values[p] - right);
            }
        }
        // The error of b, common to all pixels of a run, dominates: 30 runs know its square to ±26 %.
        assertEquals(1, estimated / real, 0.6);
    }

    /** Whenever it is cancelled, there is an image without NaN. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void cancelledAtAnyMoment(boolean direct) {
        ChainSettings settings = new ChainSettings(20, 1_000_000, direct, 100_000, true, 8, 3_000_000);
        for (int delay : new int[] {0, 20, 60, 150, 400}) {
            CancellationToken token = new CancellationToken();
            Thread canceller = new Thread(() -> {
                try {
                    Thread.sleep(delay);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
                token.cancel();
            });
            canceller.start();
            Film film = Rendering.film(WIDTH, HEIGHT);
            RenderContext context = Rendering.context(1, 2);
            RenderReport report = render(
                    Rendering.toy(settings),
                    film,
                    new RenderContext(1, 2, context.budget(), context.antialiasing(), token, RenderListener.NONE));
            assertTrue(report.cancelled());
            for (float value : film.develop().channel("R")) {
                assertTrue(Float.isFinite(value));
            }
        }
    }

    @Test
    void reportsWhatIsNotFinite() {
        ChainRenderer renderer = new ChainRenderer(
                new ToyAlgorithm(ToyAlgorithm.Fault.NOT_FINITE, true), Rendering.settings(10, 50, false), -1, -1);
        RenderReport report = render(renderer, Rendering.film(WIDTH, HEIGHT), Rendering.context(5, 2));
        assertTrue(report.nonFiniteSamples() > 5);
        String address = report.nonFiniteAddresses().get(0);
        assertTrue(address.startsWith("seed 5, chain "), address);
    }

    @Test
    void chainsThatDoNotMixAreToldApart() {
        RenderReport good = render(
                Rendering.toy(Rendering.settings(50, 500, false)),
                Rendering.film(WIDTH, HEIGHT),
                Rendering.context(5, 2));
        assertTrue(
                good.figures().get("rHat") < 1.05, () -> "R̂ " + good.figures().get("rHat"));
        assertTrue(good.warnings().stream().noneMatch(w -> w.contains("R-hat")));
        RenderReport bad = render(
                new ChainRenderer(
                        new ToyAlgorithm(ToyAlgorithm.Fault.STUCK, true), Rendering.settings(50, 500, false), -1, -1),
                Rendering.film(WIDTH, HEIGHT),
                Rendering.context(5, 2));
        assertTrue(bad.figures().get("rHat") > 2, () -> "R̂ " + bad.figures().get("rHat"));
        assertTrue(bad.warnings().stream().anyMatch(w -> w.contains("R-hat")));
    }

    @Test
    void progressGrows() {
        ChainSettings settings = new ChainSettings(20, 400, true, 100, true, 8, 10_000);
        double[] last = {0};
        int[] passes = {0};
        RenderContext context = Rendering.context(1, 2).withListener(new RenderListener() {
            @Override
            public void progress(Progress progress) {
                assertTrue(progress.fraction() >= last[0] && progress.fraction() <= 1);
                last[0] = progress.fraction();
            }

            @Override
            public void passFinished(Film film) {
                passes[0]++;
            }
        });
        render(Rendering.toy(settings), Rendering.film(WIDTH, HEIGHT), context);
        assertEquals(1, last[0], 1e-9);
        assertTrue(passes[0] > 0);
    }

    @Test
    void aFilmThatDoesNotFitIsRefused() {
        Camera camera = SCENE.camera();
        assertThrows(
                ParameterException.class,
                () -> Rendering.toy(Rendering.settings(1, 1, false))
                        .render(SCENE, camera, Rendering.film(WIDTH, HEIGHT + 1), Rendering.context(1, 1)));
    }

    /** 384 pixels with 6250 mutations each: 300 000 candidates at most, of which 100 000 tell the brightness to 1 %. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void candidatesEndWhenTheyTellTheBrightness(int threads) {
        ChainSettings settings = new ChainSettings(4, 6250, false, 2, false, 3, 0);
        RenderReport report =
                render(Rendering.toy(settings), Rendering.film(WIDTH, HEIGHT), Rendering.context(1, threads));
        double candidates = report.figures().get("seeds");
        assertTrue(candidates >= 100_000 && candidates < 100_100, () -> candidates + " candidates");
        assertTrue(
                report.figures().get("bStandardError") < 0.01 * report.figures().get("b"));
    }

    @Test
    void settingsHaveTheThesisNumbers() {
        ChainSettings settings = ChainSettings.of(ParameterValues.defaults(ChainSettings.PARAMETERS));
        assertEquals(new ChainSettings(1000, 100, true, 0, false, 8, 0), settings);
        assertEquals(100_000, settings.candidates(1));
        assertEquals(100 * 1_000_000 / 8, settings.candidates(100 * 1_000_000));
        assertEquals("Count of seed paths", ChainSettings.PARAMETERS.get(0).label());
        assertEquals(
                "Count of mutations per pixel", ChainSettings.PARAMETERS.get(1).label());
    }
}
