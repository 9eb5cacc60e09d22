package org.daybreak.metropolis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Allocation;
import org.daybreak.metropolis.chains.Chain;
import org.daybreak.metropolis.chains.ChainStatistics;
import org.daybreak.metropolis.chains.ChainWorker;
import org.daybreak.metropolis.chains.StateReader;
import org.daybreak.metropolis.chains.StateWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class MetropolisProcessorTest {
    private static final int MOVES = MetropolisSettings.STRATEGIES.size();

    static Iterable<String> scenes() {
        return ToyScenes.names();
    }

    private static MetropolisSettings settings(String... values) {
        Map<String, String> texts = new HashMap<>();
        for (String value : values) {
            int equals = value.indexOf('=');
            texts.put(value.substring(0, equals), value.substring(equals + 1));
        }
        return MetropolisSettings.of(ParameterValues.parse(MetropolisSettings.PARAMETERS, texts, "metropolis"));
    }

    private static ChainWorker worker(Scene scene) {
        return new MetropolisAlgorithm(settings()).newWorker(scene, scene.camera(), 3, 1);
    }

    /** A chain on the first state of the first candidate that offers one. */
    private static Chain start(ChainWorker worker) {
        boolean[] offered = new boolean[1];
        for (long candidate = 0; ; candidate++) {
            worker.candidate(candidate, (number, x, y, weight) -> offered[0] = true);
            if (offered[0]) {
                Chain chain = worker.newChain(0);
                worker.start(chain, candidate, 0);
                return chain;
            }
        }
    }

    /** After warming up, mutations allocate nothing; the limit is 1 byte per mutation. */
    @ParameterizedTest
    @MethodSource("scenes")
    void mutationsAllocateNothing(String name) {
        ChainWorker worker = worker(ToyScenes.scene(name));
        Chain chain = start(worker);
        SplatBuffer splats = new SplatBuffer();
        ChainStatistics statistics = new ChainStatistics(MOVES);
        int steps = 4000;
        Allocation.assertNone("mutation", steps, 60, () -> {
            splats.clear();
            worker.advance(chain, steps, splats, statistics);
        });
    }

    /** What is saved of a chain is all that its future depends on. */
    @ParameterizedTest
    @MethodSource("scenes")
    void chainsGoOnFromWhatWasSaved(String name) {
        Scene scene = ToyScenes.scene(name);
        ChainWorker worker = worker(scene);
        Chain chain = start(worker);
        ChainStatistics statistics = new ChainStatistics(MOVES);
        worker.advance(chain, 500, new SplatBuffer(), statistics);
        StateWriter saved = new StateWriter();
        chain.save(saved);
        ChainWorker other = worker(scene);
        Chain copy = other.newChain(0);
        copy.load(new StateReader(saved.toArray()));
        double[] expected = splats(worker, chain);
        assertTrue(expected.length > 0);
        assertTrue(Arrays.equals(expected, splats(other, copy)), "the copy went another way");
        assertEquals(chain.random.position(), copy.random.position());
    }

    private static double[] splats(ChainWorker worker, Chain chain) {
        SplatBuffer splats = new SplatBuffer();
        worker.advance(chain, 2000, splats, new ChainStatistics(MOVES));
        double[] values = new double[3 * splats.size()];
        for (int i = 0; i < splats.size(); i++) {
            values[3 * i] = splats.filmX(i);
            values[3 * i + 1] = splats.filmY(i);
            values[3 * i + 2] = splats.luminance(i);
        }
        return values;
    }

    @Test
    void allStrategiesOffIsAnError() {
        ParameterException e = assertThrows(
                ParameterException.class,
                () -> settings(
                        "bidirectional=0", "lensSubpath=0", "lens=0", "caustic=0", "multiChain=0", "manifold=0"));
        assertTrue(String.valueOf(e.getMessage()).contains("all mutation strategies are switched off"), e.getMessage());
    }

    @Test
    void perturbationsAloneAreWarnedOf() {
        assertEquals(
                1,
                new MetropolisAlgorithm(settings("bidirectional=0")).warnings().size());
        assertEquals(0, new MetropolisAlgorithm(settings("lens=0")).warnings().size());
    }

    @Test
    void tablesWithZerosAreErrors() {
        assertThrows(ParameterException.class, () -> settings("deletedEdges=0.5,0"));
        assertThrows(ParameterException.class, () -> settings("addedEdges=x"));
    }
}
