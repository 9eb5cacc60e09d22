package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.daybreak.antialiasing.AdaptiveSampling;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.CancellationToken;
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

/** Renders in parts, and renders that are interrupted and go on, have the bits of renders in one go, splats included. */
class PartsTest {
    private static final int WIDTH = 70;
    private static final int HEIGHT = 70;
    private static final Scene SCENE = TestScenes.everything(WIDTH, HEIGHT);

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

    private static Renderer renderer(String... texts) {
        Map<String, String> values = texts.length == 0 ? Map.of() : Map.of(texts[0], texts[1]);
        BidirectionalRendererFactory factory = new BidirectionalRendererFactory();
        return factory.create(ParameterValues.parse(factory.parameters(), values, factory.id()));
    }

    private static FilmSettings settings(String filter) {
        return new FilmSettings(WIDTH, HEIGHT, filter(filter));
    }

    private static ReconstructionFilter filter(String name) {
        return switch (name) {
            case "box" -> ReconstructionFilter.BOX;
            case "tent" -> ReconstructionFilter.TENT;
            case "gaussian" -> ReconstructionFilter.GAUSSIAN;
            default -> ReconstructionFilter.MITCHELL;
        };
    }

    private static RenderContext context(int samplesPerPixel, int threads) {
        return new RenderContext(
                11,
                threads,
                RenderBudget.samples(samplesPerPixel),
                new SobolSampling(),
                new CancellationToken(),
                RenderListener.NONE);
    }

    private static Film film(FilmSettings settings) {
        return new Film(settings, Set.of(FilmLayer.values()));
    }

    private static void assertSame(Film expected, Film actual) {
        FilmImage a = expected.develop();
        FilmImage b = actual.develop();
        for (String channel : a.channelNames()) {
            assertArrayEquals(a.channel(channel), b.channel(channel), channel);
        }
        assertEquals(expected.relativeError(), actual.relativeError());
        assertEquals(expected.samples(), actual.samples());
        assertEquals(expected.splatPaths(), actual.splatPaths());
    }

    private static void assertPartsAreTheWhole(
            Renderer renderer, Scene scene, FilmSettings settings, int samplesPerPixel, int parts) {
        Film whole = film(settings);
        RenderReport report = renderer.render(scene, scene.camera(), whole, context(samplesPerPixel, 2));
        Film merged = film(settings);
        long samples = 0;
        for (int i = 0; i < parts; i++) {
            Collector collector = new Collector();
            RenderContext context = context(samplesPerPixel, 1 + i % 3).withPart(new RenderPart(i, parts));
            renderer.render(scene, scene.camera(), film(settings), context.withCheckpoints(collector));
            assertTrue(collector.last().complete());
            assertEquals(
                    report.samplesPerPixel(), collector.last().samplesPerPixel(), "samples per pixel of part " + i);
            samples += collector.last().samples();
            merged.merge(collector.last().film());
        }
        assertEquals(report.samples(), samples);
        assertSame(whole, merged);
    }

    /** The passes of 21 samples per pixel have 1, 1, 2, 4, 8 and 5. */
    @ParameterizedTest
    @CsvSource({
        "box, 1, 4",
        "box, 21, 2",
        "box, 21, 9",
        "tent, 3, 3",
        "gaussian, 21, 2",
        "gaussian, 6, 9",
        "mitchell, 6, 5"
    })
    void partsTogetherHaveTheSameBits(String filter, int samplesPerPixel, int parts) {
        assertPartsAreTheWhole(renderer(), SCENE, settings(filter), samplesPerPixel, parts);
    }

    @ParameterizedTest
    @CsvSource({
        "russianRoulette, throughput, gaussian",
        "lightsPerPath, all, box",
        "causticMap, false, gaussian",
        "maxEyeDepth, 1, tent",
        "maxLightDepth, 1, tent",
    })
    void partsOfOtherSettings(String name, String value, String filter) {
        assertPartsAreTheWhole(renderer(name, value), SCENE, settings(filter), 5, 4);
    }

    @ParameterizedTest
    @CsvSource({
        "gaussian, 5, 9, 40, 37, 4",
        "box, 5, 9, 40, 37, 3",
        "mitchell, 40, 40, 1, 1, 1",
        "tent, 0, 69, 70, 1, 2"
    })
    void partsOfCrops(String filter, int x, int y, int width, int height, int parts) {
        FilmSettings.Crop crop = new FilmSettings.Crop(x, y, width, height);
        assertPartsAreTheWhole(renderer(), SCENE, new FilmSettings(WIDTH, HEIGHT, crop, filter(filter)), 5, parts);
    }

    @Test
    void partsWithFilterSampling() {
        assertPartsAreTheWhole(renderer(), SCENE, settings("mitchell").withFilterSampling(true), 5, 4);
    }

    @Test
    void aFilmOfOnePixelIsOnePart() {
        Scene scene = TestScenes.everything(1, 1);
        FilmSettings settings = new FilmSettings(1, 1, ReconstructionFilter.GAUSSIAN);
        assertPartsAreTheWhole(renderer(), scene, settings, 21, 1);
        RenderContext half = context(4, 1).withPart(new RenderPart(0, 2));
        ParameterException e = assertThrows(
                ParameterException.class, () -> renderer().render(scene, scene.camera(), film(settings), half));
        assertEquals(
                "splats of an image of 1x1 pixels are added up in 1 lanes: it can be cut into at most so many parts, not 2",
                e.getMessage());
    }

    /** There are at most 16 lanes: 10 columns and 10 rows of tiles would be 100 parts of path tracing. */
    @Test
    void thereAreAsManyPartsAsLanes() {
        Scene scene = TestScenes.everything(320, 320);
        FilmSettings settings = new FilmSettings(320, 320, ReconstructionFilter.BOX);
        assertPartsAreTheWhole(renderer("maxDepth", "2"), scene, settings, 1, 16);
        RenderContext context = context(1, 1).withPart(new RenderPart(0, 17));
        assertThrows(ParameterException.class, () -> renderer().render(scene, scene.camera(), film(settings), context));
        renderer("causticMap", "false").render(scene, scene.camera(), film(settings), context);
    }

    /** A render, or a part of one, goes on from states that it had, with another number of threads. */
    @ParameterizedTest
    @CsvSource({"0, 1", "1, 2", "2, 3"})
    void resumedRendersHaveTheSameBits(int part, int parts) {
        FilmSettings settings = settings("gaussian");
        RenderContext context = context(21, 3).withPart(new RenderPart(part, parts));
        Collector collector = new Collector();
        Film film = film(settings);
        renderer().render(SCENE, SCENE.camera(), film, context.withCheckpoints(collector));
        int n = collector.states.size();
        for (int i : new int[] {0, n / 2, n - 1}) {
            Collector second = new Collector();
            Film resumed = film(settings);
            RenderContext again = context(21, 1).withPart(new RenderPart(part, parts));
            renderer()
                    .render(
                            SCENE,
                            SCENE.camera(),
                            resumed,
                            again.withStart(collector.states.get(i)).withCheckpoints(second));
            assertNotEquals(0, second.last().film().splats().lanes().size());
            Film one = film(settings);
            one.merge(collector.last().film());
            Film other = film(settings);
            other.merge(second.last().film());
            assertSame(one, other);
        }
    }

    @Test
    void methodsThatDivideSamplesAmongPixelsAreRefused() {
        AdaptiveSampling factory = new AdaptiveSampling();
        Antialiasing adaptive = factory.create(ParameterValues.defaults(factory.parameters()));
        RenderContext context = new RenderContext(
                0, 1, RenderBudget.samples(20), adaptive, new CancellationToken(), RenderListener.NONE);
        ParameterException e = assertThrows(
                ParameterException.class,
                () -> renderer().render(SCENE, SCENE.camera(), film(settings("box")), context));
        assertTrue(e.getMessage().startsWith("renderer 'bidirectional' cannot be used with antialiasing 'adaptive'"));
        renderer("causticMap", "false").render(SCENE, SCENE.camera(), film(settings("box")), context);
    }
}
