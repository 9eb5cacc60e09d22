package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.SampleAddress;
import org.daybreak.core.render.SampleRecord;
import org.daybreak.core.render.SampleRequest;
import org.daybreak.core.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SampleTraceTest {
    private static final long SEED = 4;

    /**
     * Records of all samples together are the render, contributions that the roulette left out included: that it does so is
     * seen by the factor on those that survived. The film has tiles that are cut off on two sides, and four passes.
     */
    @ParameterizedTest
    @CsvSource({"one", "all"})
    void recordsOfAllSamplesAreTheRender(String lights) {
        int width = 34;
        int height = 3;
        int samplesPerPixel = 5;
        Scene scene = TestScenes.everything(width, height);
        FilmSettings settings = new FilmSettings(width, height, ReconstructionFilter.BOX);
        BidirectionalRendererFactory factory = new BidirectionalRendererFactory();
        Map<String, String> values = Map.of("lightsPerPath", lights, "maxDepth", "6");
        Renderer renderer = factory.create(ParameterValues.parse(factory.parameters(), values, factory.id()));
        Film film = new Film(settings);
        renderer.render(
                scene,
                scene.camera(),
                film,
                new RenderContext(
                        SEED,
                        2,
                        RenderBudget.samples(samplesPerPixel),
                        new SobolSampling(),
                        new CancellationToken(),
                        RenderListener.NONE));
        double[] expected = new double[width * height];
        int leftOut = 0;
        for (int p = 0; p < width * height; p++) {
            int row = p / width;
            for (int i = 0; i < samplesPerPixel; i++) {
                SampleAddress address = new SampleAddress(SEED, p % width, row, i);
                SampleRequest request = new SampleRequest(address, settings, new SobolSampling(), samplesPerPixel);
                SampleRecord record =
                        renderer.replay(scene, scene.camera(), request).orElseThrow();
                expected[p] += record.radiance().g() / samplesPerPixel;
                for (SampleRecord.Contribution c : record.contributions()) {
                    if (c.outcome() == SampleRecord.Outcome.SPLATTED) {
                        int at = ((int) c.filmY()) * width + (int) c.filmX();
                        expected[at] += c.weight() * c.unweighted().g() / (samplesPerPixel * expected.length);
                    }
                    leftOut += c.outcome() == SampleRecord.Outcome.ROULETTE ? 1 : 0;
                }
            }
        }
        FilmImage image = film.develop();
        for (int p = 0; p < expected.length; p++) {
            assertEquals(expected[p], image.channel("G")[p], 1e-6 * expected[p], "pixel " + p);
        }
        assertTrue(leftOut > 100, leftOut + " are left out");
    }
}
