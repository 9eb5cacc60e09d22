package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.stream.Collectors;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Allocation;
import org.daybreak.tracing.RaySample;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class BidirectionalRendererTest {
    private static BidirectionalSettings parse(Map<String, String> values) {
        return BidirectionalSettings.of(
                ParameterValues.parse(BidirectionalSettings.PARAMETERS, values, "bidirectional"));
    }

    @Test
    void defaultsHaveNoLimits() {
        assertEquals(
                new BidirectionalSettings(
                        -1, -1, -1, 2, BidirectionalSettings.Roulette.EFFICIENCY, 3, 2, false, true, 0.25, false, 1),
                parse(Map.of()));
    }

    /** The thesis' figure 4.6 shows these labels. */
    @Test
    void parametersHaveTheLabelsOfTheThesis() {
        Map<String, String> labels = new BidirectionalRendererFactory()
                .parameters().stream().collect(Collectors.toMap(Parameter::name, Parameter::label));
        assertEquals("Max. eye path depth", labels.get("maxEyeDepth"));
        assertEquals("Max. light path depth", labels.get("maxLightDepth"));
        assertEquals("Heuristic exponent", labels.get("heuristicExponent"));
        assertEquals("bidirectional", new BidirectionalRendererFactory().id());
    }

    @ParameterizedTest
    @CsvSource({
        "maxEyeDepth, 0",
        "maxLightDepth, 0",
        "maxEyeDepth, -2",
        "maxLightDepth, -2",
        "maxDepth, -2",
        "heuristicExponent, -1",
        "heuristicExponent, NaN",
        "russianRoulette, some",
        "rrDepth, 0",
        "splitting, 0",
        "lightsPerPath, two",
        "causticMap, 1",
        "lensHits, 1",
    })
    void wrongValuesAreNamed(String name, String value) {
        ParameterException e = assertThrows(ParameterException.class, () -> parse(Map.of(name, value)));
        assertTrue(e.getMessage().contains("'" + name + "'"), e.getMessage());
    }

    @Test
    void combinationsThatShowNothingAreErrors() {
        ParameterException e =
                assertThrows(ParameterException.class, () -> parse(Map.of("maxEyeDepth", "1", "causticMap", "false")));
        assertEquals("with maxEyeDepth 1 all light comes through the caustic map, which is off", e.getMessage());
    }

    @ParameterizedTest
    @CsvSource({"-1, -1, -1, false", "5, -1, -1, false", "-1, 5, -1, false", "5, 5, -1, true", "-1, -1, 8, true"})
    void withoutRoulettePathsNeedALimit(String eye, String light, String edges, boolean valid) {
        Map<String, String> values =
                Map.of("maxEyeDepth", eye, "maxLightDepth", light, "maxDepth", edges, "russianRoulette", "none");
        if (valid) {
            parse(values);
        } else {
            assertThrows(ParameterException.class, () -> parse(values));
        }
    }

    /** After warming up, samples are taken without allocation; the limit is 1 byte per sample. */
    @ParameterizedTest
    @CsvSource({"one, 1, false", "one, 3, false", "all, 1, false", "one, 2, true"})
    void samplesAllocateNothing(String lights, String splitting, String lensHits) {
        Scene scene = lensHits.equals("true") ? TestScenes.glassThroughWideLens(24, 18) : TestScenes.everything(24, 18);
        Sampler sampler = new SobolSampling().newSampler(1, 64);
        RaySample sample = new RaySample();
        SplatBuffer splats = new SplatBuffer();
        BiDirectionalProcessor processor = new BiDirectionalProcessor(
                scene,
                scene.camera(),
                true,
                parse(Map.of("lightsPerPath", lights, "splitting", splitting, "lensHits", lensHits)),
                null);
        int samples = 24 * 18 * 16;
        Allocation.assertNone("sample", samples, 40, () -> {
            for (int i = 0; i < samples; i++) {
                int pixel = i / 16;
                int row = pixel / 24;
                sampler.start(pixel, i % 16);
                double x = pixel % 24 + sampler.next();
                double y = row + sampler.next();
                splats.clear();
                processor.trace(x, y, sampler, sample, splats);
            }
        });
    }
}
