package org.daybreak.metropolis.chains;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.FilmState;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.CheckpointException;
import org.daybreak.core.render.CheckpointSink;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Rendering.Collector;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Renders that are interrupted and go on, and renders in parts, have the bits of renders in one go. */
class ChainStateTest {
    private static final int WIDTH = 70;
    private static final int HEIGHT = 38;
    private static final long SEED = 11;
    private static final Scene SCENE = Rendering.sky(WIDTH, HEIGHT);

    private static Film film() {
        return new Film(
                new FilmSettings(WIDTH, HEIGHT, ReconstructionFilter.GAUSSIAN),
                Set.of(FilmLayer.VARIANCE, FilmLayer.DEPTH));
    }

    private static RenderReport render(ChainRenderer renderer, Film film, RenderContext context) {
        return renderer.render(SCENE, SCENE.camera(), film, context);
    }

    private static void assertSame(Film expected, Film actual, String what) {
        assertEquals(expected.samples(), actual.samples(), what);
        assertEquals(expected.splatPaths(), actual.splatPaths(), what);
        for (String channel : expected.develop().channelNames()) {
            assertArrayEquals(
                    expected.develop().channel(channel), actual.develop().channel(channel), what + ": " + channel);
        }
        assertEquals(expected.relativeError(), actual.relativeError(), what);
        List<FilmSettings.Crop> all = List.of(expected.settings().crop());
        assertSame(expected.state(all), actual.state(all), what);
    }

    private static void assertSame(FilmState expected, FilmState actual, String what) {
        assertArrayEquals(expected.sums(), actual.sums(), what);
        assertEquals(expected.splats().lanes().size(), actual.splats().lanes().size(), what);
        for (int i = 0; i < expected.splats().lanes().size(); i++) {
            FilmState.Lane lane = expected.splats().lanes().get(i);
            assertEquals(lane.number(), actual.splats().lanes().get(i).number(), what);
            assertArrayEquals(lane.sums(), actual.splats().lanes().get(i).sums(), what + ": lane " + lane.number());
        }
    }

    private static RenderContext cancelling(int threads, CancellationToken token, int passes, Collector collector) {
        RenderContext context = Rendering.context(SEED, threads);
        return new RenderContext(
                SEED,
                threads,
                context.budget(),
                context.antialiasing(),
                token,
                new RenderListener() {
                    private int seen;

                    @Override
                    public void passFinished(Film film) {
                        if (++seen == passes) {
                            token.cancel();
                        }
                    }
                },
                RenderPart.WHOLE,
                null,
                collector);
    }

    /** All states that a render hands out, whatever it was doing then, are gone on from with another number of threads. */
    @ParameterizedTest
    @CsvSource({"40, 150, true, false", "3, 150, false, true", "40, 150, true, true", "1, 20, true, true"})
    void resumedRendersHaveTheSameBits(int chains, int mutations, boolean direct, boolean twoStage) {
        ChainSettings settings = new ChainSettings(chains, mutations, direct, 40, twoStage, 5, 2000);
        ChainRenderer renderer = Rendering.toy(settings);
        assertTrue(renderer.isResumable());
        Film whole = film();
        RenderReport wholeReport = render(renderer, whole, Rendering.context(SEED, 2));
        Set<String> phases = new HashSet<>();
        for (int passes : new int[] {1, 3, 5}) {
            Collector collector = new Collector();
            render(renderer, film(), cancelling(3, new CancellationToken(), passes, collector));
            int n = collector.states.size();
            for (int i : new int[] {0, n / 2, n - 1}) {
                RenderState start = collector.states.get(i);
                phases.addAll(start.position().keySet());
                Film resumed = film();
                Collector second = new Collector();
                RenderReport report = render(
                        renderer,
                        resumed,
                        Rendering.context(SEED, 1 + i % 4).withStart(start).withCheckpoints(second));
                String what =
                        "state " + i + " of " + n + " with " + start.position().keySet();
                assertFalse(report.cancelled());
                assertTrue(second.last().complete(), what);
                assertEquals(start.samples(), report.resumedSamples(), what);
                assertEquals(wholeReport.samples(), report.samples(), what);
                assertEquals(wholeReport.samplesPerPixel(), report.samplesPerPixel(), what);
                assertEquals(wholeReport.nonFiniteSamples(), report.nonFiniteSamples(), what);
                if (!start.complete()) {
                    assertEquals(wholeReport.figures(), report.figures(), what);
                }
                assertSame(whole, resumed, what);
            }
        }
        assertTrue(phases.contains("chains"), phases::toString);
        assertEquals(direct, phases.contains("direct"), phases::toString);
    }

    @Test
    void completeRendersStayAsTheyAre() {
        ChainRenderer renderer = Rendering.toy(Rendering.settings(10, 10, false));
        Collector first = new Collector();
        Film whole = film();
        render(renderer, whole, Rendering.context(SEED, 2).withCheckpoints(first));
        assertTrue(first.last().complete());
        Film again = film();
        RenderReport report = render(renderer, again, Rendering.context(SEED, 2).withStart(first.last()));
        assertFalse(report.cancelled());
        assertEquals(10L * WIDTH * HEIGHT, report.samples());
        assertSame(whole, again, "again");
    }

    @ParameterizedTest
    @CsvSource({
        "40, true, false, 4",
        "40, true, true, 3",
        "5, false, true, 5",
        "1000, false, false, 16",
        "2, true, false, 2"
    })
    void partsTogetherHaveTheSameBits(int chains, boolean direct, boolean twoStage, int parts) {
        ChainSettings settings = new ChainSettings(chains, 20, direct, 3, twoStage, 5, 2000);
        ChainRenderer renderer = Rendering.toy(settings);
        Film whole = film();
        RenderReport report = render(renderer, whole, Rendering.context(SEED, 2));
        Film merged = film();
        long samples = 0;
        for (int i = 0; i < parts; i++) {
            Collector collector = new Collector();
            RenderReport partReport = render(
                    renderer,
                    film(),
                    Rendering.context(SEED, 1 + i % 3)
                            .withPart(new RenderPart(i, parts))
                            .withCheckpoints(collector));
            assertTrue(collector.last().complete());
            assertEquals(20, collector.last().samplesPerPixel());
            assertEquals(report.figures().get("b"), partReport.figures().get("b"));
            samples += collector.last().samples();
            merged.merge(collector.last().film());
        }
        assertEquals(report.samples(), samples);
        assertSame(whole, merged, parts + " parts");
    }

    @Test
    void aPartIsResumed() {
        ChainRenderer renderer = Rendering.toy(new ChainSettings(40, 100, true, 10, false, 5, 2000));
        RenderPart part = new RenderPart(1, 3);
        Collector first = new Collector();
        render(renderer, film(), Rendering.context(SEED, 2).withPart(part).withCheckpoints(first));
        for (RenderState state :
                List.of(first.states.get(0), first.states.get(first.states.size() / 2), first.last())) {
            Collector second = new Collector();
            RenderContext context = Rendering.context(SEED, 3).withPart(part);
            render(renderer, film(), context.withStart(state).withCheckpoints(second));
            assertSame(first.last().film(), second.last().film(), "part");
        }
    }

    /** A part that is one lane has nothing to tell its error from; merged with others it has. */
    @Test
    void errorsAreKnownFromTwoLanesOn() {
        ChainRenderer renderer = Rendering.toy(new ChainSettings(2, 20, false, 1, false, 5, 2000));
        Film half = film();
        RenderReport report = render(renderer, half, Rendering.context(SEED, 2).withPart(new RenderPart(0, 2)));
        assertTrue(Double.isNaN(half.relativeError()));
        assertTrue(Double.isNaN(report.figures().get("relativeError")));
        Film whole = film();
        render(renderer, whole, Rendering.context(SEED, 2));
        assertTrue(whole.relativeError() > 0);
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 17})
    void tooManyPartsAreRefused(int parts) {
        ChainRenderer renderer = Rendering.toy(Rendering.settings(parts == 3 ? 2 : 1000, 20, false));
        RenderContext context = Rendering.context(SEED, 1).withPart(new RenderPart(0, parts));
        ParameterException e = assertThrows(ParameterException.class, () -> render(renderer, film(), context));
        assertTrue(String.valueOf(e.getMessage()).contains("lanes"), e::getMessage);
    }

    @Test
    void aStateOfAnotherRendererIsRefused() {
        ChainRenderer renderer = Rendering.toy(new ChainSettings(10, 50, true, 3, false, 5, 200));
        Collector collector = new Collector();
        render(renderer, film(), Rendering.context(SEED, 2).withCheckpoints(collector));
        RenderState last = collector.last();
        for (Map<String, long[]> position :
                List.<Map<String, long[]>>of(Map.of("unit", new long[] {1}), Map.of("chains", new long[] {1, 2, 3}))) {
            RenderState other = new RenderState(last.film(), position, 1, 1, false, 0, List.of(), 1);
            assertThrows(
                    ParameterException.class,
                    () -> render(renderer, film(), Rendering.context(SEED, 1).withStart(other)));
        }
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
        for (boolean direct : new boolean[] {false, true}) {
            ChainRenderer renderer = Rendering.toy(new ChainSettings(20, 100_000, direct, 10, false, 5, 2000));
            assertThrows(
                    CheckpointException.class,
                    () -> render(renderer, film(), Rendering.context(SEED, 2).withCheckpoints(full)));
        }
    }

    /** Where time ends a render, its state can be gone on from, too. */
    @Test
    void goesOnAfterATimeLimit() {
        ChainRenderer renderer = Rendering.toy(new ChainSettings(20, 300, false, 10, false, 5, 2000));
        Film whole = film();
        render(renderer, whole, Rendering.context(SEED, 2));
        Collector collector = new Collector();
        RenderReport cut = render(
                renderer,
                film(),
                Rendering.context(SEED, 2, new RenderBudget(1, 0.1, 0)).withCheckpoints(collector));
        Film resumed = film();
        RenderReport report =
                render(renderer, resumed, Rendering.context(SEED, 2).withStart(collector.last()));
        assertEquals(cut.samples(), report.resumedSamples());
        if (cut.samples() > 0) {
            assertSame(whole, resumed, "after " + cut.samples() + " steps");
        }
    }
}
