package org.daybreak.metropolis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.daybreak.bidirectional.BidirectionalRendererFactory;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.ZTest;
import org.daybreak.metropolis.chains.Rendering;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Images of very short chains are unbiased: more than 10⁴ chains of ten mutations, in renders of two chains each that start from a dozen
 * candidates. So few candidates know neither the brightness nor where the light is; what is right all the same is right because brightness
 * and starts come from the same candidates.
 *
 * <p>Renders are put into groups, whose means are near normal; t-tests of each pixel and of the mean of the image against bidirectional
 * path tracing, with a false-alarm rate of 1e-4 per scene by Šidák's correction. Seeds are fixed.
 */
class StartUpTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int WIDTH = 5;
    private static final int HEIGHT = 4;
    private static final int GROUPS = 40;
    private static final int RENDERS = 130;
    private static final int CHAINS = 2;
    private static final int STEPS = 10;
    private static final int REFERENCE_SAMPLES = 500;

    @Test
    void shortChainsAreUnbiased() {
        check("plastic");
    }

    @Tag("reference")
    @ParameterizedTest
    @ValueSource(strings = {"area light", "environments", "mirror and glass", "masks", "thin lens"})
    void shortChainsInMoreScenesAreUnbiased(String name) {
        check(name);
    }

    private static void check(String name) {
        assertTrue(GROUPS * RENDERS * CHAINS > 10_000);
        assertEquals(WIDTH * HEIGHT, CHAINS * STEPS);
        Scene scene = ToyScenes.scene(name, WIDTH, HEIGHT);
        Renderer metropolis = renderer(
                new MetropolisRendererFactory(),
                Map.of(
                        "mutationsPerPixel", "1",
                        "seedPaths", Integer.toString(CHAINS),
                        "bootstrapSamples", "12",
                        "separateDirect", "false"));
        Renderer bidirectional = renderer(new BidirectionalRendererFactory(), Map.of());
        double[][] expected = new double[GROUPS][];
        double[][] unbiased = new double[GROUPS][WIDTH * HEIGHT + 1];
        double[][] consistent = new double[GROUPS][WIDTH * HEIGHT + 1];
        for (int group = 0; group < GROUPS; group++) {
            expected[group] = new double[WIDTH * HEIGHT + 1];
            Film film = Rendering.film(WIDTH, HEIGHT);
            render(bidirectional, scene, film, 90_000 + group, REFERENCE_SAMPLES);
            addImage(film, 1, expected[group]);
            double brightness = expected[group][WIDTH * HEIGHT];
            for (int i = 0; i < RENDERS; i++) {
                Film few = Rendering.film(WIDTH, HEIGHT);
                double b = render(metropolis, scene, few, (long) RENDERS * group + i, 1)
                        .figures()
                        .getOrDefault("b", 0.0);
                addImage(few, 1.0 / RENDERS, unbiased[group]);
                if (b > 0) {
                    addImage(few, brightness / b / RENDERS, consistent[group]);
                }
            }
        }
        ZTest.assertNoneRejected(name, ZTest.tilesOfRuns(expected, unbiased), SIGNIFICANCE);
        double[] pValues = ZTest.tilesOfRuns(expected, consistent);
        assertThrows(
                AssertionError.class,
                () -> ZTest.assertNoneRejected(name, pValues, SIGNIFICANCE),
                name + ": another brightness than that of the candidates is not found out");
    }

    private static Renderer renderer(RendererFactory factory, Map<String, String> parameters) {
        return factory.create(ParameterValues.parse(factory.parameters(), parameters, factory.id()));
    }

    private static RenderReport render(Renderer renderer, Scene scene, Film film, long seed, long samples) {
        RenderReport report =
                renderer.render(scene, scene.camera(), film, Rendering.context(seed, 1, RenderBudget.samples(samples)));
        assertEquals(0, report.nonFiniteSamples());
        return report;
    }

    /** Adds luminances, and last their mean. */
    private static void addImage(Film film, double factor, double[] sums) {
        FilmImage image = film.develop();
        float[] r = image.channel("R");
        float[] g = image.channel("G");
        float[] b = image.channel("B");
        for (int i = 0; i < r.length; i++) {
            double luminance = factor * Spectrum.luminance(r[i], g[i], b[i]);
            sums[i] += luminance;
            sums[r.length] += luminance / r.length;
        }
    }
}
