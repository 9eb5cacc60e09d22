package org.daybreak.metropolis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.daybreak.core.film.Film;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.PilotWorker;
import org.daybreak.metropolis.chains.Rendering;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** That a report counts what a pilot costs. */
class PilotReportTest {
    /** Of a pilot that surveys ten pixels in each of 8×8 cells. */
    private static final long SURVEYS = 640;

    private final Scene scene = ToyScenes.scene("environments");

    private RenderReport render(String sharing, int threads, Film film) {
        Map<String, String> parameters =
                Map.of("sharing", sharing, "mutationsPerPixel", "2", "directSamples", "1", "seedPaths", "7");
        MetropolisRendererFactory factory = new MetropolisRendererFactory();
        return factory.create(ParameterValues.parse(factory.parameters(), parameters, factory.id()))
                .render(scene, scene.camera(), film, Rendering.context(4, threads));
    }

    /** Where the pilot leaves all to chains, the image is that without it, and its rays are on top: a camera ray of each candidate and sample. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void countsTheRaysOfThePilot(int threads) {
        Film without = Rendering.film(ToyScenes.SIZE, ToyScenes.SIZE);
        Film with = Rendering.film(ToyScenes.SIZE, ToyScenes.SIZE);
        Map<String, Long> ofOthers = render("never", threads, without).raysByKind();
        RenderReport report = render("auto", threads, with);
        assertFalse(report.figures().containsKey("patternsOfSamples"), "this scene should leave all to chains");
        for (String channel : new String[] {"R", "G", "B"}) {
            assertArrayEquals(without.develop().channel(channel), with.develop().channel(channel));
        }
        long camera = report.raysByKind().get("camera") - ofOthers.get("camera");
        assertTrue(camera >= 4 * PilotWorker.BLOCK * SURVEYS, () -> camera + " camera rays");
    }
}
