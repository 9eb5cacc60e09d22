package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.CheckpointSink;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Grids;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The same seed gives the same image, bit for bit, however it is computed. The film of 70×38 pixels has tiles that are cut
 * off on two sides.
 */
class ReproducibilityTest {
    private static final int WIDTH = 70;
    private static final int HEIGHT = 38;
    private static final long SEED = 7;

    private static Scene scene;

    /** A renderer with its defaults, but for the length of Markov chains, which the samples per pixel do not set. */
    private static Renderer renderer(String id, int mutationsPerPixel) {
        return Rendering.renderer(
                id,
                Map.of(
                        "mutationsPerPixel",
                        Integer.toString(mutationsPerPixel),
                        "seedPaths",
                        "50",
                        "bootstrapSamples",
                        "2000",
                        "directSamples",
                        "3",
                        "sharing",
                        "always"));
    }

    @BeforeAll
    static void compileScene() throws SceneException {
        scene = ShippedScenes.compile(
                ShippedScenes.read("cornell_spheres/scene.xml").graph(), WIDTH, HEIGHT);
    }

    @ParameterizedTest
    @CsvSource({
        "path, BOX, sobol",
        "path, MITCHELL, sobol",
        "path, GAUSSIAN, stratified",
        "path, TENT, grid",
        "path, BOX, none",
        "path, BOX, adaptive",
        "path, MITCHELL, adaptive",
        "raytracer, MITCHELL, sobol",
        "raytracer, BOX, sobol",
        "light, BOX, sobol",
        "light, MITCHELL, sobol",
        "bidirectional, BOX, sobol",
        "bidirectional, MITCHELL, sobol",
        "bidirectional, GAUSSIAN, stratified",
        "bidirectional, BOX, none",
        "metropolis, BOX, sobol",
        "metropolis, MITCHELL, stratified",
        "pssmlt, BOX, sobol",
        "pssmlt, MITCHELL, stratified",
        "mmlt, BOX, sobol",
        "mmlt, GAUSSIAN, none"
    })
    void threadsDoNotChangeABit(String rendererId, ReconstructionFilter.Kind filter, String antialiasing) {
        Renderer renderer = renderer(rendererId, 6);
        // Below 16 samples per pixel the adaptive method is a uniform one.
        int samplesPerPixel = antialiasing.equals("adaptive") ? 20 : 5;
        Setup setup = new Setup(filter(filter), antialiasing(antialiasing), samplesPerPixel);
        FilmImage one = setup.render(renderer, SEED, 1);
        for (int threads : new int[] {1, 2, 3, 8}) {
            assertSame(one, setup.render(renderer, SEED, threads), threads + " threads");
        }
        assertFalse(
                Arrays.equals(
                        one.channel("G"), setup.render(renderer, SEED + 1, 2).channel("G")),
                "another seed gives another image");
    }

    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light", "bidirectional", "metropolis", "pssmlt", "mmlt"})
    void compilingAgainDoesNotChangeABit(String rendererId) throws SceneException {
        Setup setup = new Setup(ReconstructionFilter.BOX, antialiasing("sobol"), 4);
        Renderer renderer = renderer(rendererId, 6);
        Scene again = ShippedScenes.compile(
                ShippedScenes.read("cornell_spheres/scene.xml").graph(), WIDTH, HEIGHT);
        assertSame(setup.render(renderer, SEED, 2), setup.render(renderer, again, SEED, 2), "compiled again");
    }

    /** After a collection threads make anew what they work with: {@link org.daybreak.core.render.ThreadOwned}. */
    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light", "bidirectional", "metropolis", "pssmlt", "mmlt"})
    void collectionsDoNotChangeABit(String rendererId) throws InterruptedException {
        Setup setup = new Setup(ReconstructionFilter.BOX, antialiasing("sobol"), 64);
        Renderer renderer = renderer(rendererId, 40);
        FilmImage undisturbed = setup.render(renderer, SEED, 2);
        AtomicBoolean rendering = new AtomicBoolean(true);
        Thread collector = new Thread(() -> {
            while (rendering.get()) {
                System.gc();
            }
        });
        collector.start();
        try {
            assertSame(undisturbed, setup.render(renderer, SEED, 2), "while memory is collected");
        } finally {
            rendering.set(false);
            collector.join();
        }
    }

    /** Two renders at a time share the scene and the renderer, and a third one is cancelled meanwhile. */
    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light", "bidirectional", "pssmlt", "mmlt"})
    void rendersAtTheSameTimeDoNotDisturbEachOther(String rendererId)
            throws InterruptedException, ExecutionException, TimeoutException {
        Renderer renderer = renderer(rendererId, 6);
        Setup setup = new Setup(ReconstructionFilter.MITCHELL, antialiasing("sobol"), 16);
        FilmImage alone1 = setup.render(renderer, SEED, 1);
        FilmImage alone2 = setup.render(renderer, SEED + 1, 1);
        ExecutorService executor = Executors.newFixedThreadPool(3);
        try {
            CountDownLatch started = new CountDownLatch(1);
            CancellationToken token = new CancellationToken();
            Future<RenderReport> endless = executor.submit(() -> {
                RenderListener listener = new RenderListener() {
                    @Override
                    public void passFinished(Film film) {
                        started.countDown();
                    }
                };
                RenderContext context = new RenderContext(
                        SEED, 2, RenderBudget.samples(1 << 24), antialiasing("sobol"), token, listener);
                return renderer(rendererId, 1 << 20).render(scene, scene.camera(), new Film(scene.film()), context);
            });
            assertTrue(started.await(60, TimeUnit.SECONDS));
            Future<FilmImage> first = executor.submit(() -> setup.render(renderer, SEED, 2));
            Future<FilmImage> second = executor.submit(() -> {
                token.cancel();
                return setup.render(renderer, SEED + 1, 3);
            });
            assertSame(alone1, first.get(60, TimeUnit.SECONDS), "first");
            assertSame(alone2, second.get(60, TimeUnit.SECONDS), "second");
            assertTrue(endless.get(60, TimeUnit.SECONDS).cancelled());
        } finally {
            executor.shutdownNow();
        }
    }

    /** A render goes on from a checkpoint while another one begins and a third one is cancelled. */
    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light", "bidirectional", "pssmlt", "mmlt"})
    void resumedRendersAreNotDisturbed(String rendererId)
            throws InterruptedException, ExecutionException, TimeoutException {
        Renderer renderer = renderer(rendererId, 6);
        Setup setup = new Setup(ReconstructionFilter.MITCHELL, antialiasing("sobol"), 32);
        FilmImage whole = setup.render(renderer, SEED, 1);
        FilmImage other = setup.render(renderer, SEED + 1, 1);
        CancellationToken token = new CancellationToken();
        AtomicReference<RenderState> last = new AtomicReference<>();
        RenderListener cancelling = new RenderListener() {
            @Override
            public void passFinished(Film film) {
                token.cancel();
            }
        };
        CheckpointSink sink = new CheckpointSink() {
            @Override
            public double intervalSeconds() {
                return Double.POSITIVE_INFINITY;
            }

            @Override
            public void save(RenderState state) {
                last.set(state);
            }
        };
        RenderContext context =
                new RenderContext(SEED, 2, RenderBudget.samples(32), antialiasing("sobol"), token, cancelling);
        renderer.render(scene, scene.camera(), setup.film(), context.withCheckpoints(sink));
        RenderState state = last.get();
        CancellationToken third = new CancellationToken();
        ExecutorService executor = Executors.newFixedThreadPool(3);
        try {
            Future<RenderReport> endless = executor.submit(() -> renderer(rendererId, 1 << 20)
                    .render(
                            scene,
                            scene.camera(),
                            setup.film(),
                            new RenderContext(
                                    SEED,
                                    1,
                                    RenderBudget.samples(1 << 24),
                                    antialiasing("sobol"),
                                    third,
                                    RenderListener.NONE)));
            Future<FilmImage> resumed = executor.submit(() -> {
                Film film = setup.film();
                RenderContext rest = new RenderContext(
                        SEED,
                        3,
                        RenderBudget.samples(32),
                        antialiasing("sobol"),
                        new CancellationToken(),
                        RenderListener.NONE);
                renderer.render(scene, scene.camera(), film, rest.withStart(state));
                return film.develop();
            });
            Future<FilmImage> second = executor.submit(() -> {
                third.cancel();
                return setup.render(renderer, SEED + 1, 2);
            });
            assertSame(whole, resumed.get(60, TimeUnit.SECONDS), "resumed");
            assertSame(other, second.get(60, TimeUnit.SECONDS), "second");
            assertTrue(endless.get(60, TimeUnit.SECONDS).cancelled());
        } finally {
            executor.shutdownNow();
        }
    }

    /** A crop takes the samples of its border too, so that filters that reach across it find what they need. */
    @ParameterizedTest
    @CsvSource({"path, BOX", "path, GAUSSIAN", "path, MITCHELL", "raytracer, TENT", "light, BOX"})
    void cropIsThatPartOfTheImage(String rendererId, ReconstructionFilter.Kind kind) {
        Renderer renderer = renderer(rendererId, 6);
        ReconstructionFilter filter = filter(kind);
        Setup setup = new Setup(filter, antialiasing("sobol"), 4);
        FilmImage whole = setup.render(renderer, SEED, 2);
        FilmSettings.Crop crop = new FilmSettings.Crop(27, 9, 21, 26);
        Film film = new Film(new FilmSettings(WIDTH, HEIGHT, crop, filter));
        Rendering.render(renderer, scene, film, SEED, 4, 2, antialiasing("sobol"));
        FilmImage part = film.develop();
        assertEquals(crop.width(), part.width());
        int different = 0;
        for (int y = 0; y < crop.height(); y++) {
            for (int x = 0; x < crop.width(); x++) {
                for (String channel : Runs.CHANNELS) {
                    float expected = whole.get(channel, crop.x() + x, crop.y() + y);
                    float actual = part.get(channel, x, y);
                    // Samples come in tiles, and tiles of the crop begin elsewhere: sums differ in their order.
                    assertEquals(expected, actual, 2 * Math.ulp(expected), () -> channel);
                    different += expected == actual ? 0 : 1;
                }
            }
        }
        if (kind == ReconstructionFilter.Kind.BOX) {
            assertEquals(0, different, "within a pixel the order of samples is the same");
        }
    }

    /**
     * If threads shared random numbers, the mean would be right but the variance too large. Seeds of the two sets are
     * different, so that bit-identity is not what is tested. For each tile the logarithm of the ratio of variances has
     * expectation 0; a t-test over tiles, which are independent with path tracing, and nearly so with bidirectional path tracing, where
     * few of the splats of a sample land in other tiles than its own share of the light. False-alarm rate 1e-4 per renderer.
     */
    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "bidirectional"})
    void varianceDoesNotDependOnThreads(String rendererId) {
        Renderer renderer = renderer(rendererId, 6);
        int runs = 24;
        double[][] one = new double[runs][];
        double[][] four = new double[runs][];
        Setup setup = new Setup(ReconstructionFilter.BOX, antialiasing("sobol"), 4);
        for (int i = 0; i < runs; i++) {
            one[i] = tiles(setup.render(renderer, 100 + i, 1));
            four[i] = tiles(setup.render(renderer, 200 + i, 4));
        }
        Moments logRatios = logRatios(one, four);
        ZTest.assertNotRejected("variance", ZTest.oneSample(logRatios, 0), 1e-4);

        // Were half of the samples copies of the other half, the variance would double: that would be found.
        double[][] doubled = Arrays.stream(four)
                .map(run -> Arrays.stream(run).map(v -> v * Math.sqrt(2)).toArray())
                .toArray(double[][]::new);
        assertTrue(ZTest.oneSample(logRatios(one, doubled), 0) < 1e-4, "twice the variance is found");
    }

    private static Moments logRatios(double[][] runs1, double[][] runs2) {
        Moments logRatios = new Moments();
        for (int tile = 0; tile < runs1[0].length; tile++) {
            double v1 = Runs.moments(runs1, tile).variance();
            double v2 = Runs.moments(runs2, tile).variance();
            if (v1 > 0 && v2 > 0) {
                logRatios.add(Math.log(v1 / v2));
            }
        }
        assertTrue(logRatios.count() > runs1[0].length / 2, "most tiles have a variance");
        return logRatios;
    }

    private static double[] tiles(FilmImage image) {
        return Grids.tileMeans(Runs.toDoubles(image.channel("G")), image.width(), 4);
    }

    /** How to render {@link #scene}, with all auxiliary images. */
    private record Setup(ReconstructionFilter filter, Antialiasing antialiasing, int samplesPerPixel) {
        Film film() {
            return new Film(new FilmSettings(WIDTH, HEIGHT, filter), Set.of(FilmLayer.values()));
        }

        FilmImage render(Renderer renderer, long seed, int threads) {
            return render(renderer, scene, seed, threads);
        }

        FilmImage render(Renderer renderer, Scene what, long seed, int threads) {
            Film film = film();
            RenderReport report = Rendering.render(renderer, what, film, seed, samplesPerPixel, threads, antialiasing);
            assertEquals(0, report.nonFiniteSamples());
            return film.develop();
        }
    }

    private static void assertSame(FilmImage expected, FilmImage actual, String what) {
        assertEquals(expected.channelNames(), actual.channelNames());
        for (Map.Entry<String, float[]> channel : expected.channels().entrySet()) {
            float[] other = actual.channel(channel.getKey());
            assertArrayEquals(channel.getValue(), other, what + ", channel " + channel.getKey());
        }
    }

    private static ReconstructionFilter filter(ReconstructionFilter.Kind kind) {
        return switch (kind) {
            case BOX -> ReconstructionFilter.BOX;
            case TENT -> ReconstructionFilter.TENT;
            case GAUSSIAN -> ReconstructionFilter.GAUSSIAN;
            case MITCHELL -> ReconstructionFilter.MITCHELL;
            case BLACKMAN_HARRIS -> ReconstructionFilter.BLACKMAN_HARRIS;
            case LANCZOS -> ReconstructionFilter.LANCZOS;
        };
    }

    private static Antialiasing antialiasing(String id) {
        List<AntialiasingFactory> factories = ServiceLoader.load(AntialiasingFactory.class).stream()
                .map(ServiceLoader.Provider::get)
                .toList();
        AntialiasingFactory factory = factories.stream()
                .filter(candidate -> candidate.id().equals(id))
                .findFirst()
                .orElseThrow();
        return factory.create(ParameterValues.defaults(factory.parameters()));
    }
}
