package org.daybreak.tracing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.daybreak.antialiasing.AdaptiveSampling;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.FilmState;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.CheckpointException;
import org.daybreak.core.render.CheckpointSink;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Renders that are interrupted and go on, and renders in parts, have the bits of renders in one go. */
class StateTest {
    private static final int WIDTH = 70;
    private static final int HEIGHT = 38;
    private static final long SEED = 11;
    private static final Scene SCENE = TestScenes.veiledRoom(WIDTH, HEIGHT);

    /** Takes each state that it can get. */
    private static final class Collector implements CheckpointSink {
        final List<RenderState> states = new ArrayList<>();

        @Override
        public double intervalSeconds() {
            return 1e-9;
        }

        @Override
        public void save(RenderState state) {
            states.add(state);
        }

        RenderState last() {
            return states.get(states.size() - 1);
        }
    }

    private static Renderer renderer(String id) {
        return Rendering.renderer(id, Map.of());
    }

    private static Antialiasing antialiasing(String id) {
        AdaptiveSampling adaptive = new AdaptiveSampling();
        return id.equals("adaptive")
                ? adaptive.create(ParameterValues.defaults(adaptive.parameters()))
                : new SobolSampling();
    }

    private static Film film(ReconstructionFilter.Kind kind) {
        ReconstructionFilter filter = switch (kind) {
            case BOX -> ReconstructionFilter.BOX;
            case TENT -> ReconstructionFilter.TENT;
            case GAUSSIAN -> ReconstructionFilter.GAUSSIAN;
            default -> ReconstructionFilter.MITCHELL;
        };
        return new Film(new FilmSettings(WIDTH, HEIGHT, filter), Set.of(FilmLayer.values()));
    }

    private static RenderContext context(Antialiasing method, int spp, int threads) {
        return new RenderContext(
                SEED, threads, RenderBudget.samples(spp), method, new CancellationToken(), RenderListener.NONE);
    }

    private static void assertSame(FilmState expected, FilmState actual, String what) {
        assertEquals(expected.samples(), actual.samples(), what);
        assertEquals(expected.splatPaths(), actual.splatPaths(), what);
        assertArrayEquals(expected.sums(), actual.sums(), what);
        assertArrayEquals(expected.splats().total(), actual.splats().total(), what);
        assertArrayEquals(expected.splats().open(), actual.splats().open(), what);
    }

    /**
     * A render is cancelled wherever the threads happen to be, and goes on from its last state and from some before it, with
     * another number of threads.
     */
    @ParameterizedTest
    @CsvSource({
        "path, BOX, sobol",
        "path, GAUSSIAN, sobol",
        "raytracer, MITCHELL, sobol",
        "light, BOX, sobol",
        "light, TENT, sobol",
        "path, BOX, adaptive",
        "path, MITCHELL, adaptive"
    })
    void resumedRendersHaveTheSameBits(String rendererId, ReconstructionFilter.Kind filter, String antialiasing) {
        int spp = 24;
        Renderer renderer = renderer(rendererId);
        assertTrue(renderer.isResumable());
        Film whole = film(filter);
        RenderReport wholeReport =
                renderer.render(SCENE, SCENE.camera(), whole, context(antialiasing(antialiasing), spp, 2));
        FilmState expected = whole.state(List.of(whole.settings().crop()));

        CancellationToken token = new CancellationToken();
        Collector collector = new Collector();
        Film cancelled = film(filter);
        RenderContext context = new RenderContext(
                SEED,
                3,
                RenderBudget.samples(spp),
                antialiasing(antialiasing),
                token,
                new RenderListener() {
                    private int passes;

                    @Override
                    public void passFinished(Film film) {
                        if (++passes == 2) {
                            token.cancel();
                        }
                    }
                },
                RenderPart.WHOLE,
                null,
                collector);
        renderer.render(SCENE, SCENE.camera(), cancelled, context);
        int n = collector.states.size();
        for (int i : new int[] {n / 2, n - 1}) {
            RenderState start = collector.states.get(i);
            Film resumed = film(filter);
            Collector second = new Collector();
            RenderReport report = renderer.render(
                    SCENE,
                    SCENE.camera(),
                    resumed,
                    context(antialiasing(antialiasing), spp, 1 + i % 4)
                            .withStart(start)
                            .withCheckpoints(second));
            assertEquals(start.samples(), report.resumedSamples());
            assertFalse(report.cancelled());
            assertTrue(second.last().complete());
            assertEquals(wholeReport.samplesPerPixel(), report.samplesPerPixel());
            assertEquals(wholeReport.samples(), report.samples());
            assertSame(expected, resumed.state(List.of(resumed.settings().crop())), "state " + i + " of " + n);
        }
    }

    @ParameterizedTest
    @CsvSource({"path, BOX, 6", "path, GAUSSIAN, 5", "raytracer, MITCHELL, 4", "light, BOX, 5", "light, TENT, 16"})
    void partsTogetherHaveTheSameBits(String rendererId, ReconstructionFilter.Kind filter, int parts) {
        int spp = 6;
        Renderer renderer = renderer(rendererId);
        Film whole = film(filter);
        RenderReport report = renderer.render(SCENE, SCENE.camera(), whole, context(new SobolSampling(), spp, 2));
        Film merged = film(filter);
        long samples = 0;
        for (int i = 0; i < parts; i++) {
            Collector collector = new Collector();
            renderer.render(
                    SCENE,
                    SCENE.camera(),
                    film(filter),
                    context(new SobolSampling(), spp, 1 + i % 3)
                            .withPart(new RenderPart(i, parts))
                            .withCheckpoints(collector));
            assertTrue(collector.last().complete());
            samples += collector.last().samples();
            merged.merge(collector.last().film());
        }
        assertEquals(report.samples(), samples);
        List<FilmSettings.Crop> all = List.of(whole.settings().crop());
        assertSame(whole.state(all), merged.state(all), parts + " parts");
    }

    @Test
    void aPartIsResumed() {
        Renderer renderer = renderer("path");
        RenderPart part = new RenderPart(1, 3);
        Collector first = new Collector();
        RenderContext context = context(new SobolSampling(), 32, 2).withPart(part);
        renderer.render(
                SCENE, SCENE.camera(), film(ReconstructionFilter.Kind.MITCHELL), context.withCheckpoints(first));
        Collector second = new Collector();
        renderer.render(
                SCENE,
                SCENE.camera(),
                film(ReconstructionFilter.Kind.MITCHELL),
                context.withStart(first.states.get(0)).withCheckpoints(second));
        assertSame(first.last().film(), second.last().film(), "part");
    }

    @Test
    void aFailingSinkEndsTheRender() {
        CheckpointSink full = new CheckpointSink() {
            @Override
            public double intervalSeconds() {
                return 1e-9;
            }

            @Override
            public void save(RenderState state) {
                throw new CheckpointException("no space", new IllegalStateException());
            }
        };
        RenderContext context = context(new SobolSampling(), 1 << 20, 2).withCheckpoints(full);
        for (String id : new String[] {"path", "light"}) {
            assertThrows(
                    CheckpointException.class,
                    () -> renderer(id).render(SCENE, SCENE.camera(), film(ReconstructionFilter.Kind.BOX), context));
        }
    }

    @Test
    void impossiblePartsAreRefused() {
        RenderContext context = context(new SobolSampling(), 4, 1);
        for (String id : new String[] {"path", "light"}) {
            assertThrows(
                    ParameterException.class,
                    () -> renderer(id)
                            .render(
                                    SCENE,
                                    SCENE.camera(),
                                    film(ReconstructionFilter.Kind.BOX),
                                    context.withPart(new RenderPart(0, 17))));
        }
        RenderContext adaptive = context(antialiasing("adaptive"), 16, 1).withPart(new RenderPart(0, 2));
        assertThrows(
                ParameterException.class,
                () -> renderer("path").render(SCENE, SCENE.camera(), film(ReconstructionFilter.Kind.BOX), adaptive));
    }

    /** Where a render ends by its error does not depend on the number of threads. */
    @ParameterizedTest
    @CsvSource({"path, sobol", "light, sobol", "path, adaptive"})
    void targetErrorEndsAtTheSamePlace(String rendererId, String antialiasing) {
        RenderBudget budget = new RenderBudget(1 << 16, Double.POSITIVE_INFINITY, 0.3);
        List<FilmState> states = new ArrayList<>();
        for (int threads : new int[] {1, 2, 5}) {
            Film film = film(ReconstructionFilter.Kind.BOX);
            RenderReport report = renderer(rendererId)
                    .render(
                            SCENE,
                            SCENE.camera(),
                            film,
                            new RenderContext(
                                    SEED,
                                    threads,
                                    budget,
                                    antialiasing(antialiasing),
                                    new CancellationToken(),
                                    RenderListener.NONE));
            assertFalse(report.cancelled());
            assertTrue(film.relativeError() < 0.3, () -> "error " + film.relativeError());
            assertTrue(report.samplesPerPixel() < 1 << 16);
            states.add(film.state(List.of(film.settings().crop())));
        }
        assertSame(states.get(0), states.get(1), "2 threads");
        assertSame(states.get(0), states.get(2), "5 threads");
    }
}
