package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.RaySample;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MisWeightTest {
    private static CombinedPathValues path() {
        // Four vertices: a light, a diffuse, a mirror-like one, the lens.
        CombinedPathValues path = new CombinedPathValues();
        path.setLength(4);
        path.fromLight = new double[] {2, 3, 5, 23};
        path.fromEye = new double[] {7, 11, 13, 19};
        path.nextEvent = 17;
        path.hittable = true;
        return path;
    }

    /** p₀ = 7·11·13·19, p₁ = 17·11·13·19, p₂ = 2·3·13·19, p₃ = 2·3·5·19, p₄ = 2·3·5·23; of p₃ a third counts. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 2, 4})
    void weightsAreThoseOfTheDensities(double exponent) {
        double[] densities = {7 * 11 * 13 * 19, 17 * 11 * 13 * 19, 2 * 3 * 13 * 19, 2 * 3 * 5 * 19 / 3.0, 2 * 3 * 5 * 23
        };
        TechniqueLimits limits = new TechniqueLimits(100, 100, true, false, true, 1 / 3.0);
        double sum = 0;
        for (double density : densities) {
            sum += Math.pow(density, exponent);
        }
        for (int s = 0; s < 5; s++) {
            double expected = Math.pow(densities[s], exponent) / sum;
            assertEquals(expected, MisWeight.weight(path(), s, limits, exponent), 1e-12 * expected);
        }
    }

    /** With β = 0 the weight is one over the number of techniques that can be sampled. */
    @ParameterizedTest
    @CsvSource({
        // eye vertices, light vertices, lens, hits of the lens, hittable, delta vertex, number
        "9, 9, true, false, true, 0, 4",
        "9, 9, false, false, true, 0, 3",
        "9, 9, true, false, false, 0, 3",
        "9, 9, true, false, true, 1, 2",
        "9, 9, true, false, true, 2, 2",
        "3, 9, true, false, true, 0, 3",
        "2, 9, true, false, true, 0, 2",
        "1, 9, true, false, true, 0, 1",
        "9, 1, true, false, true, 0, 2",
        "9, 0, true, false, true, 0, 1",
        "2, 2, true, false, true, 0, 1",
        "9, 9, true, true, true, 0, 5",
        "9, 9, false, true, true, 0, 4",
        "9, 9, true, true, true, 2, 3",
        "9, 3, true, true, true, 0, 4",
        "1, 9, false, true, true, 0, 1",
    })
    void limitsTakeTechniquesAway(
            int eyeVertices,
            int lightVertices,
            boolean lens,
            boolean lensHits,
            boolean hittable,
            int delta,
            int number) {
        CombinedPathValues path = path();
        path.hittable = hittable;
        if (delta > 0) {
            path.delta[delta] = true;
        }
        TechniqueLimits limits = new TechniqueLimits(eyeVertices, lightVertices, lens, false, lensHits, 0.1);
        int admitted = 0;
        for (int s = 0; s <= 4; s++) {
            if (limits.admits(path, s)) {
                assertEquals(1.0 / number, MisWeight.weight(path, s, limits, 0), 1e-15);
                admitted++;
            }
        }
        assertEquals(number, admitted);
    }

    @Test
    void whatCannotBeSampledHasNoPartEvenInEqualWeights() {
        assertEquals(0, MisWeight.power(0, 0));
        assertEquals(1, MisWeight.power(3, 0));
        assertEquals(9, MisWeight.power(3, 2));
        assertEquals(3, MisWeight.power(3, 1));
    }

    /** The form that costs the same for any length of the path gives what the arrays of densities give. */
    @ParameterizedTest
    @CsvSource({
        "0, true, 0.1, false",
        "0.5, true, 0.1, false",
        "1, true, 0.1, false",
        "2, true, 0.1, false",
        "2, true, 1, false",
        "4, true, 0.1, false",
        "2, false, 0.1, false",
        "0, false, 0.1, false",
        "0, true, 0.1, true",
        "1, true, 0.1, true",
        "2, true, 0.1, true",
        "2, true, 1, true",
        "4, true, 0.1, true",
        "2, false, 0.1, true"
    })
    void chainedFormIsTheArrayForm(double exponent, boolean lens, double share, boolean lensHits) {
        Scene scene = lensHits ? TestScenes.glassThroughWideLens(24, 18) : TestScenes.everything(24, 18);
        TechniqueLimits limits =
                new TechniqueLimits(Integer.MAX_VALUE, Integer.MAX_VALUE, lens, false, lensHits, share);
        BidirectionalSettings settings = new BidirectionalSettings(
                -1, -1, -1, exponent, BidirectionalSettings.Roulette.THROUGHPUT, 5, 2, false, lens, share, lensHits, 1);
        int[] lengths = new int[64];
        int[] hits = new int[1];
        Contribution.Listener listener = c -> {
            double array = MisWeight.weight(c.densities(), c.s, limits, exponent);
            assertEquals(array, c.weight, 1e-10 * array);
            lengths[Math.min(c.s + c.t, 63)]++;
            hits[0] += c.t == 0 ? 1 : 0;
        };
        BiDirectionalProcessor processor = new BiDirectionalProcessor(scene, scene.camera(), false, settings, listener);
        Sampler sampler = new SobolSampling().newSampler(5, 32);
        RaySample sample = new RaySample();
        SplatBuffer splats = new SplatBuffer();
        // Few light paths hit the lens.
        int samplesPerPixel = lensHits ? 32 : 4;
        for (int i = 0; i < 24 * 18 * samplesPerPixel; i++) {
            int pixel = i / samplesPerPixel;
            int row = pixel / 24;
            sampler.start(pixel, i % samplesPerPixel);
            double x = pixel % 24 + sampler.next();
            double y = row + sampler.next();
            splats.clear();
            processor.trace(x, y, sampler, sample, splats);
        }
        for (int vertices = 2; vertices < 9; vertices++) {
            assertTrue(lengths[vertices] > 30, "paths of " + vertices + " vertices");
        }
        assertEquals(lensHits, hits[0] > 10, hits[0] + " hits of the lens");
    }
}
