package org.daybreak.metropolis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.PilotWorker;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The steps that a pilot tries are those that chains take. */
class PilotChainTest {
    private static final int BATCHES = 60;
    private static final int SURVEYS = 60;

    /** Standard errors, of 60 batches: p = 1e-7 per kind, below 1e-5 for all kinds of all scenes. */
    private static final double ALLOWED = 6;

    static Iterable<String> scenes() {
        return PathPatternTest.scenes();
    }

    /** What one batch has found. */
    private static final class Batch implements PilotWorker.Survey {
        private final Map<Long, Double> light = new TreeMap<>();
        private final Map<Long, Double> moves = new TreeMap<>();
        private double least = Double.POSITIVE_INFINITY;

        @Override
        public void found(long pattern, double x, double y, double weight, PilotWorker.By by, int sample) {
            if (by == PilotWorker.By.CANDIDATES) {
                light.merge(pattern, weight * 2 * PilotWorker.BLOCK, Double::sum);
            }
        }

        @Override
        public void moved(long pattern, double weight, double work) {
            moves.merge(pattern, weight / PilotChain.STEPS, Double::sum);
            least = Math.min(least, work);
        }
    }

    /** From each kind of paths as many steps are tried as it has light, also after the first step: the start is stationary. */
    @ParameterizedTest
    @MethodSource("scenes")
    void statesAreThoseOfChains(String name) {
        Scene scene = ToyScenes.scene(name);
        PilotWorker pilot =
                new MetropolisAlgorithm(PathPatternTest.SETTINGS).newPilotWorker(scene, scene.camera(), 7, 1);
        Batch[] batches = new Batch[BATCHES];
        TreeSet<Long> kinds = new TreeSet<>();
        for (int i = 0; i < BATCHES; i++) {
            batches[i] = new Batch();
            for (int j = 0; j < SURVEYS; j++) {
                pilot.survey((long) i * SURVEYS + j, 0, 0, batches[i]);
            }
            kinds.addAll(batches[i].light.keySet());
            kinds.addAll(batches[i].moves.keySet());
            assertTrue(batches[i].least > 0, "each step takes some work");
        }
        // What is rarer has no normal distribution.
        kinds.removeIf(kind ->
                Stream.of(batches).anyMatch(batch -> !batch.light.containsKey(kind) || !batch.moves.containsKey(kind)));
        assertTrue(kinds.size() > 1, () -> "only kinds " + kinds);
        for (long kind : kinds) {
            double sum = 0;
            double squares = 0;
            for (Batch batch : batches) {
                double difference = batch.moves.getOrDefault(kind, 0.0) - batch.light.getOrDefault(kind, 0.0);
                sum += difference;
                squares += difference * difference;
            }
            double mean = sum / BATCHES;
            double error = Math.sqrt((squares / BATCHES - mean * mean) / (BATCHES - 1));
            assertEquals(0, mean, ALLOWED * error + 1e-12, () -> "kind " + Long.toBinaryString(kind));
        }
    }
}
