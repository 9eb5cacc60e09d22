package org.daybreak.metropolis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.daybreak.bidirectional.BiDirectionalProcessor;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.IndependentSampler;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.ChainStatistics;
import org.daybreak.metropolis.chains.ChainWorker;
import org.daybreak.metropolis.chains.PatternSet;
import org.daybreak.metropolis.chains.PilotWorker;
import org.daybreak.metropolis.strategy.LightPath;
import org.daybreak.metropolis.strategy.PathBuilder;
import org.daybreak.metropolis.strategy.PathPattern;
import org.daybreak.tracing.RaySample;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** That samples and chains agree on the kind of each path: else they would find some twice and others not at all. */
class PathPatternTest {
    private static final int SAMPLES = 2000;
    static final MetropolisSettings SETTINGS =
            MetropolisSettings.of(ParameterValues.parse(MetropolisSettings.PARAMETERS, Map.of(), "metropolis"));

    static Iterable<String> scenes() {
        return ToyScenes.names();
    }

    /** The pattern of a path that a sample has found is that of the state that a chain makes of it, whichever technique has found it. */
    @ParameterizedTest
    @MethodSource("scenes")
    void samplesAndChainsSeeTheSamePattern(String name) {
        Scene scene = ToyScenes.scene(name);
        PathBuilder builder = new PathBuilder(scene, scene.camera());
        LightPath path = new LightPath();
        Set<String> techniques = new HashSet<>();
        BiDirectionalProcessor processor =
                new BiDirectionalProcessor(scene, scene.camera(), false, SETTINGS.bidirectional(), found -> {
                    if (builder.assemble(found, path)) {
                        assertEquals(PathPattern.of(found), PathPattern.of(path));
                        techniques.add(Math.min(2, found.lightVertices()) + " " + Math.min(2, found.eyeVertices()));
                    }
                });
        sample(processor);
        assertTrue(techniques.size() >= 2, () -> "only techniques " + techniques);
    }

    private static void sample(BiDirectionalProcessor processor) {
        IndependentSampler sampler = new IndependentSampler(5, StreamDomain.SELF_CHECK);
        SplatBuffer splats = new SplatBuffer();
        for (int i = 0; i < SAMPLES; i++) {
            sampler.start(i, 0);
            splats.clear();
            double x = sampler.next() * ToyScenes.SIZE;
            double y = sampler.next() * ToyScenes.SIZE;
            processor.trace(x, y, sampler, new RaySample(), splats);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "1, true",
        "10, true",
        "11, true",
        "100, true",
        "110, true",
        "101, false",
        "1101, false",
        "1001, true",
        "10101, false",
        "111, true"
    })
    void whatSamplesCanMake(String pattern, boolean suits) {
        assertEquals(suits, PathPattern.suitsSamples(Long.parseLong(pattern, 2)));
    }

    /** The kind of path that brings most light is left out: no mutation goes there, but to others. */
    @ParameterizedTest
    @MethodSource("scenes")
    void chainsKeepOffWhatIsLeftOut(String name) {
        Scene scene = ToyScenes.scene(name);
        Map<Long, Double> light = new TreeMap<>();
        PilotWorker pilot = new MetropolisAlgorithm(SETTINGS).newPilotWorker(scene, scene.camera(), 3, 1);
        PilotWorker.Survey survey = new PilotWorker.Survey() {
            @Override
            public void found(long pattern, double x, double y, double weight, PilotWorker.By by, int sample) {
                light.merge(pattern, weight, Double::sum);
            }

            @Override
            public void moved(long pattern, double weight, double work) {
                // PilotChainTest asks for these.
            }
        };
        for (int i = 0; i < SAMPLES / 8; i++) {
            pilot.survey(i, 0, 0, survey);
        }
        long brightest = light.entrySet().stream()
                .max(Map.Entry.comparingByValue())
                .orElseThrow()
                .getKey();
        ChainWorker worker = new MetropolisAlgorithm(SETTINGS)
                .remainder(new PatternSet(brightest))
                .newWorker(scene, scene.camera(), 3, 1);
        boolean[] offered = new boolean[1];
        long candidate = -1;
        while (!offered[0]) {
            candidate++;
            worker.candidate(candidate, (number, x, y, weight) -> offered[0] = true);
        }
        PathChain chain = (PathChain) worker.newChain(0);
        worker.start(chain, candidate, 0);
        Set<Long> met = new HashSet<>();
        ChainStatistics statistics = new ChainStatistics(MetropolisSettings.STRATEGIES.size());
        SplatBuffer splats = new SplatBuffer();
        for (int i = 0; i < 4 * SAMPLES; i++) {
            splats.clear();
            worker.advance(chain, 1, splats, statistics);
            met.add(PathPattern.of(chain.current));
        }
        assertFalse(met.contains(brightest));
        assertTrue(met.size() > 1, () -> "the chain has only met " + met);
    }
}
