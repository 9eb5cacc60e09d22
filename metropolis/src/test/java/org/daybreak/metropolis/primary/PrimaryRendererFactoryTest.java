package org.daybreak.metropolis.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.core.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PrimaryRendererFactoryTest {
    private static RendererFactory factory(String id) {
        return id.equals("mmlt") ? new MultiplexedFactory() : new PrimarySampleSpaceFactory();
    }

    /** Renders in a short way, with names and values of parameters. */
    private static RenderReport render(String id, Scene scene, Film film, String... namesAndValues) {
        Map<String, String> values = new HashMap<>(Map.of(
                "seedPaths", "40", "bootstrapSamples", "1000", "mutationsPerPixel", "300", "directSamples", "2"));
        for (int i = 0; i < namesAndValues.length; i += 2) {
            values.put(namesAndValues[i], namesAndValues[i + 1]);
        }
        RendererFactory factory = factory(id);
        RenderContext context = new RenderContext(
                1, 2, RenderBudget.samples(4), new SobolSampling(), new CancellationToken(), RenderListener.NONE);
        return factory.create(ParameterValues.parse(factory.parameters(), values, id))
                .render(scene, scene.camera(), film, context);
    }

    private static double sum(Film film) {
        double sum = 0;
        for (float value : film.develop().channel("G")) {
            sum += value;
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(strings = {"pssmlt", "mmlt"})
    void reportTellsOfLargeAndSmallSteps(String id) {
        Scene scene = PrimaryScenes.room();
        assertEquals(id, factory(id).id());
        Film film = new Film(scene.film());
        RenderReport report = render(id, scene, film);
        assertEquals(0, report.nonFiniteSamples());
        assertFalse(report.cancelled());
        Map<String, Double> figures = report.figures();
        double large = figures.get("move.large step.tried");
        double small = figures.get("move.small step.tried");
        assertEquals(300.0 * 9 * 6, large + small);
        assertEquals(0.3, large / (large + small), 0.02);
        assertTrue(figures.get("b") > 0 && figures.get("bStandardError") > 0);
        assertTrue(sum(film) > 0);
    }

    /** Chains with paths of different lengths have no target in common. */
    @Test
    void chainsAreComparedWhereTheyAreAlike() {
        Scene scene = PrimaryScenes.room();
        assertTrue(render("pssmlt", scene, new Film(scene.film())).figures().get("rHat") < 2);
        assertEquals(
                Double.NaN,
                render("mmlt", scene, new Film(scene.film())).figures().get("rHat"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"pssmlt", "mmlt"})
    void darkSceneIsBlackAndTheReportSaysSo(String id) {
        Scene scene = PrimaryScenes.dark();
        Film film = new Film(scene.film());
        RenderReport report = render(id, scene, film);
        assertEquals(0, sum(film));
        assertEquals(0, report.nonFiniteSamples());
        assertTrue(report.warnings().stream().anyMatch(w -> w.contains("found no light")), report.warnings()::toString);
    }

    @ParameterizedTest
    @ValueSource(strings = {"pssmlt", "mmlt"})
    void smallStepsAloneAreWarnedOf(String id) {
        Scene scene = PrimaryScenes.room();
        List<String> warnings =
                render(id, scene, new Film(scene.film()), "largeStep", "0").warnings();
        assertTrue(warnings.stream().anyMatch(w -> w.startsWith("without large steps")), warnings::toString);
    }

    /** A single chain, a single candidate, one mutation, large steps alone, limits of depth that leave little. */
    @ParameterizedTest
    @CsvSource({
        "pssmlt, seedPaths, 1",
        "mmlt, seedPaths, 1",
        "pssmlt, bootstrapSamples, 1",
        "mmlt, bootstrapSamples, 1",
        "pssmlt, mutationsPerPixel, 1",
        "mmlt, mutationsPerPixel, 1",
        "pssmlt, largeStep, 1",
        "mmlt, largeStep, 1",
        "pssmlt, maxDepth, 3",
        "mmlt, maxDepth, 3",
        "pssmlt, maxEyeDepth, 1",
        "mmlt, maxEyeDepth, 1",
        "pssmlt, maxLightDepth, 1",
        "mmlt, maxLightDepth, 1",
        "pssmlt, maxDepth, 1",
        "mmlt, maxDepth, 1"
    })
    void extremesRender(String id, String name, String value) {
        Scene scene = PrimaryScenes.room();
        for (String separateDirect : new String[] {"true", "false"}) {
            RenderReport report =
                    render(id, scene, new Film(scene.film()), name, value, "separateDirect", separateDirect);
            assertEquals(0, report.nonFiniteSamples());
            assertFalse(report.cancelled());
        }
    }

    @ParameterizedTest
    @CsvSource({"largeStep, 1.5", "largeStep, -0.1", "smallestStep, 0", "largestStep, 0.6", "expectedValues, 2"})
    void wrongValuesAreNamed(String name, String value) {
        Scene scene = PrimaryScenes.room();
        Film film = new Film(scene.film());
        ParameterException e = assertThrows(ParameterException.class, () -> render("mmlt", scene, film, name, value));
        assertTrue(e.getMessage().contains("'" + name + "'"), e.getMessage());
    }
}
