package org.daybreak.metropolis.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.daybreak.bidirectional.BiDirectionalProcessor;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.bidirectional.TechniqueSampler;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Allocation;
import org.daybreak.metropolis.chains.Chain;
import org.daybreak.metropolis.chains.ChainStatistics;
import org.daybreak.metropolis.chains.ChainWorker;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.metropolis.chains.Outcome;
import org.daybreak.metropolis.chains.StateReader;
import org.daybreak.metropolis.chains.StateWriter;
import org.daybreak.tracing.RaySample;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What states bring, and what a step does, against bidirectional path tracing with the same numbers. */
class PrimaryWorkerTest {
    private static final long SEED = 11;
    private static final int CANDIDATES = 300;

    /** A state that a candidate offers. */
    private record State(int number, double filmX, double filmY, double weight) {}

    static Stream<Arguments> scenes() {
        Map<String, Supplier<Scene>> scenes = Map.of(
                "room", PrimaryScenes::room,
                "room through a lens", PrimaryScenes::roomThroughLens,
                "outdoors", PrimaryScenes::outdoors);
        return scenes.entrySet().stream()
                .flatMap(scene ->
                        Stream.of(1, 3).map(shortest -> Arguments.of(scene.getKey(), scene.getValue(), shortest)));
    }

    private static PrimarySettings settings(String... namesAndValues) {
        Map<String, String> values = new HashMap<>();
        for (int i = 0; i < namesAndValues.length; i += 2) {
            values.put(namesAndValues[i], namesAndValues[i + 1]);
        }
        return PrimarySettings.of(ParameterValues.parse(PrimarySettings.PARAMETERS, values, "pssmlt"));
    }

    private static PrimaryWorker worker(Scene scene, boolean multiplexed, PrimarySettings settings, int shortest) {
        return (PrimaryWorker)
                new PrimaryAlgorithm("test", settings, multiplexed).newWorker(scene, scene.camera(), SEED, shortest);
    }

    private static List<State> candidate(ChainWorker worker, long index) {
        List<State> states = new ArrayList<>();
        worker.candidate(index, (number, x, y, weight) -> states.add(new State(number, x, y, weight)));
        return states;
    }

    /** The target of a sample is the sum of the luminances of all that bidirectional path tracing finds with its numbers. */
    @ParameterizedTest
    @MethodSource("scenes")
    void sampleBringsWhatBidirectionalPathTracingFinds(String name, Supplier<Scene> maker, int shortest) {
        Scene scene = maker.get();
        Camera camera = scene.camera();
        PrimarySettings settings = settings();
        PrimaryWorker worker = worker(scene, false, settings, shortest);
        double pixels = (double) camera.width() * camera.height();
        double[] sum = new double[1];
        BidirectionalSettings paths = settings.paths().withMinDepth(shortest);
        BiDirectionalProcessor processor = new BiDirectionalProcessor(scene, camera, false, paths, c -> {
            double luminance = c.weight() * Spectrum.luminance(c.red(), c.green(), c.blue());
            sum[0] += c.eyeVertices() == 1 ? luminance / pixels : luminance;
        });
        int found = 0;
        for (long index = 0; index < CANDIDATES; index++) {
            PrimarySample numbers = new PrimarySample(settings.step());
            numbers.begin(new RandomStream(SEED, StreamDomain.BOOTSTRAP, index, 0));
            double filmX = camera.width() * numbers.next();
            double filmY = camera.height() * numbers.next();
            sum[0] = 0;
            processor.trace(filmX, filmY, numbers, new RaySample(), new SplatBuffer());
            List<State> states = candidate(worker, index);
            assertEquals(sum[0] > 0 ? 1 : 0, states.size());
            if (sum[0] > 0) {
                assertEquals(sum[0], states.get(0).weight, 1e-12 * sum[0], name);
                PrimaryChain chain = (PrimaryChain) worker.newChain(0);
                worker.start(chain, index, 0);
                assertEquals(sum[0], chain.image.target(ImageImportance.UNIFORM), 1e-12 * sum[0]);
                found++;
            }
        }
        assertTrue(found > CANDIDATES / 4, () -> name + ": hardly any candidate brings light");
    }

    /** The paths of a candidate are the parts of the sample with the same numbers. */
    @ParameterizedTest
    @MethodSource("scenes")
    void pathsOfCandidatesAddUpToSamples(String name, Supplier<Scene> maker, int shortest) {
        Scene scene = maker.get();
        PrimaryWorker samples = worker(scene, false, settings(), shortest);
        PrimaryWorker paths = worker(scene, true, settings(), shortest);
        for (long index = 0; index < CANDIDATES; index++) {
            double whole = candidate(samples, index).stream()
                    .mapToDouble(State::weight)
                    .sum();
            List<State> states = candidate(paths, index);
            assertEquals(whole, states.stream().mapToDouble(State::weight).sum(), 1e-12 * whole, name);
            for (int i = 0; i < states.size(); i++) {
                assertEquals(i, states.get(i).number);
            }
        }
    }

    /** Without Russian roulette, a path as a state brings what the candidate says times the number of techniques. */
    @ParameterizedTest
    @MethodSource("scenes")
    void pathBringsWhatTheCandidateSays(String name, Supplier<Scene> maker, int shortest) {
        Scene scene = maker.get();
        PrimarySettings settings = settings("maxDepth", "6", "maxLightDepth", "4", "russianRoulette", "none");
        PrimaryWorker worker = worker(scene, true, settings, shortest);
        TechniqueSampler techniques = new TechniqueSampler(scene, scene.camera(), settings.paths());
        boolean[] lengths = new boolean[7];
        for (long index = 0; index < CANDIDATES; index++) {
            for (State state : candidate(worker, index)) {
                PrimaryChain chain = (PrimaryChain) worker.newChain(state.number);
                worker.start(chain, index, state.number);
                double expected = state.weight * techniques.techniques(chain.edges);
                assertEquals(expected, chain.image.target(ImageImportance.UNIFORM), 1e-9 * expected, name);
                assertEquals(state.filmX, chain.image.filmX(), 1e-9);
                assertEquals(state.filmY, chain.image.filmY(), 1e-9);
                lengths[chain.edges] = true;
            }
        }
        for (int edges = 1; edges < lengths.length; edges++) {
            assertEquals(edges >= shortest, lengths[edges], "paths of " + edges + " edges");
        }
    }

    /** A started chain; of the first candidate that offers a state. */
    private static Chain start(ChainWorker worker, int number) {
        for (long index = 1000L * number; ; index++) {
            List<State> states = candidate(worker, index);
            if (!states.isEmpty()) {
                Chain chain = worker.newChain(number);
                worker.start(chain, index, states.size() - 1);
                return chain;
            }
        }
    }

    private static double weighted(SplatBuffer splats, ImageImportance importance) {
        double sum = 0;
        for (int i = 0; i < splats.size(); i++) {
            sum += importance.at(splats.filmX(i), splats.filmY(i))
                    * Spectrum.luminance(splats.value(i, 0), splats.value(i, 1), splats.value(i, 2));
        }
        return sum;
    }

    /** Each step splats a luminance of 1, over the factor on the target. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void eachStepSplatsTheSame(boolean multiplexed) {
        Scene scene = PrimaryScenes.roomThroughLens();
        ImageImportance importance = new ImageImportance(3, 2, 3, new double[] {1, 2, 0.5, 0.1, 4, 1});
        for (String expectedValues : new String[] {"true", "false"}) {
            PrimaryWorker worker = worker(scene, multiplexed, settings("expectedValues", expectedValues), 1);
            worker.setImportance(importance);
            Chain chain = start(worker, 0);
            ChainStatistics statistics = new ChainStatistics(2);
            SplatBuffer splats = new SplatBuffer();
            worker.advance(chain, 700, splats, statistics);
            assertEquals(700, weighted(splats, importance), 1e-8);
            worker.setImportance(ImageImportance.UNIFORM);
            splats.clear();
            worker.advance(chain, 300, splats, statistics);
            assertEquals(300, weighted(splats, ImageImportance.UNIFORM), 1e-8);
            assertEquals(1000, chain.steps);
            assertEquals(1000, statistics.steps);
            assertEquals(1000, statistics.tried(0) + statistics.tried(1));
            assertTrue(statistics.accepted(0) > 0 && statistics.accepted(1) > 0);
            assertTrue(statistics.meanDistance(0) > statistics.meanDistance(1));
            assertTrue(statistics.meanAcceptance(1) > statistics.meanAcceptance(0));
            assertTrue(statistics.longestRejection > 0);
        }
    }

    /** Where a chain goes does not depend on how its steps are divided, nor on whether it has been saved meanwhile. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void savedChainGoesOnWithTheSameBits(boolean multiplexed) {
        Scene scene = PrimaryScenes.room();
        PrimaryWorker worker = worker(scene, multiplexed, settings(), 1);
        ChainStatistics statistics = new ChainStatistics(2);
        Chain whole = start(worker, 3);
        worker.advance(whole, 500, new SplatBuffer(), statistics);
        Chain part = start(worker, 3);
        worker.advance(part, 200, new SplatBuffer(), statistics);
        StateWriter out = new StateWriter();
        part.save(out);
        PrimaryWorker other = worker(scene, multiplexed, settings(), 1);
        Chain loaded = other.newChain(3);
        loaded.load(new StateReader(out.toArray()));
        SplatBuffer expected = new SplatBuffer();
        SplatBuffer actual = new SplatBuffer();
        worker.advance(part, 300, expected, statistics);
        other.advance(loaded, 300, actual, statistics);
        assertEquals(expected.size(), actual.size());
        for (int i = 0; i < expected.size(); i++) {
            assertEquals(expected.filmX(i), actual.filmX(i));
            assertEquals(expected.value(i, 1), actual.value(i, 1));
        }
        for (Chain chain : List.of(part, loaded)) {
            assertEquals(((PrimaryChain) whole).image.filmX(), ((PrimaryChain) chain).image.filmX());
            assertEquals(whole.random.position(), chain.random.position());
            assertEquals(whole.rejections, chain.rejections);
        }
    }

    /** After warming up, steps allocate nothing; the limit is 1 byte per step. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void stepsAllocateNothing(boolean multiplexed) {
        PrimaryWorker worker = worker(PrimaryScenes.roomThroughLens(), multiplexed, settings(), 1);
        Chain chain = start(worker, 0);
        SplatBuffer splats = new SplatBuffer();
        ChainStatistics statistics = new ChainStatistics(2);
        int steps = 4000;
        Allocation.assertNone("step", steps, 40, () -> {
            splats.clear();
            worker.advance(chain, steps, splats, statistics);
        });
    }

    /** What is infinite or not a number is counted and never becomes a state. */
    @Test
    void valuesThatAreNotFiniteAreLeftOut() {
        Scene scene = PrimaryScenes.room();
        PrimaryWorker worker = new PrimaryWorker(scene.camera(), settings(), SEED) {
            @Override
            boolean evaluate(PrimarySample numbers, int edges, StateImage image) {
                numbers.setDimension(0);
                double u = numbers.next();
                image.clear();
                image.add(filmX(u), 1, u < 0.2 ? Double.NaN : u < 0.4 ? Double.POSITIVE_INFINITY : 1, 1, 1);
                return u < 0.8;
            }

            @Override
            public void candidate(long index, Candidates found) {
                found.found(0, 0, 0, 1);
            }

            @Override
            public void start(Chain chain, long index, int number) {
                PrimaryChain started = (PrimaryChain) chain;
                begin(started.numbers, index);
                started.numbers.set(0, 0.5);
                evaluate(started.numbers, 0, started.image);
            }

            @Override
            public long rays(RayKind kind) {
                return 0;
            }
        };
        Chain chain = worker.newChain(0);
        worker.start(chain, 0, 0);
        SplatBuffer splats = new SplatBuffer();
        ChainStatistics statistics = new ChainStatistics(2);
        worker.advance(chain, 1000, splats, statistics);
        assertEquals(1000, weighted(splats, ImageImportance.UNIFORM), 1e-9);
        for (int i = 0; i < splats.size(); i++) {
            double x = splats.filmX(i) / scene.camera().width();
            assertTrue(x >= 0.4 && x < 0.8, "at " + x);
        }
        long black = statistics.outcomes(0, Outcome.BLACK) + statistics.outcomes(1, Outcome.BLACK);
        assertTrue(black > 100);
        assertEquals(black, statistics.nonFinite);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void darkScenesOfferNothing(boolean multiplexed) {
        PrimaryWorker worker = worker(PrimaryScenes.dark(), multiplexed, settings(), 1);
        for (long index = 0; index < CANDIDATES; index++) {
            assertTrue(candidate(worker, index).isEmpty());
        }
        assertTrue(Arrays.stream(RayKind.values()).mapToLong(worker::rays).sum() >= CANDIDATES);
    }
}
