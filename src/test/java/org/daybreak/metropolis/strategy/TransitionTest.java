package org.daybreak.metropolis.strategy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.daybreak.bidirectional.BiDirectionalProcessor;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.bidirectional.Contribution;
import org.daybreak.convergence.BidirectionalScenes;
import org.daybreak.convergence.ShippedScenes;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.IndependentSampler;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.metropolis.MetropolisPathMutator;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.tracing.EmissionGuide;
import org.daybreak.tracing.RaySample;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Detailed balance of each real proposal of all strategies: what the program takes for f*(x), f*(y), T(x→y), T(y→x) and the acceptance
 * probability a must be what {@link PlainPath} and {@link PlainTransitions} compute from the vertices alone, and with that a(x→y)·f*(x)·T(x→y)·P(S|x) =
 * a(y→x)·f*(y)·T(y→x)·P(S|y).
 *
 * <p>Both sides evaluate the same formulas on the same points and directions, in another order, so they differ by rounding; but
 * materials and lights amplify it, where they see directions at grazing angles or near the borders of a light. The tolerance is far below
 * what any forgotten factor makes, and far above the largest difference that was seen.
 */
class TransitionTest {
    private static final double TOLERANCE = 1e-6;

    /** Of densities that finite differences through several lobes are part of: that of two steps, of which these are extrapolated. */
    private static final double CHAIN_TOLERANCE = PlainPath.AGREEMENT;

    /** Largest part of the chains that may be left out. */
    private static final double MOST_UNKNOWN = 0.05;

    /** Of finite differences of single lobes, per magnification. */
    private static final double BUNDLE_TOLERANCE = 1e-6;

    /**
     * Of directions at delta lobes, as a multiple of what rays start above surfaces: points are kept off each edge of a triangle by four times
     * that, so off a corner of 17 degrees by 27 times, and refraction magnifies it. A wrong lobe is off by a hundred thousand times.
     */
    private static final double MOST_LEFT_OVER = 100;

    private static final double WHOLE = 0.15;
    private static final double[] DELETED = {0.25, 0.5, 0.125};
    private static final double[] ADDED = {0.5, 0.15, 0.05};
    private static final double[] WEIGHTS = {1, 0.7, 0.5, 0.9, 1.1, 1.3};
    private static final int SIZE = 32;
    private static final int LONGEST = 9;
    private static final double SMALLEST = 0.1;
    private static final double LARGEST = Math.sqrt(0.05 * SIZE * SIZE / Math.PI);
    private static final double SHORT = 0.3;
    private static final int STEPS_OF_CHAIN = 100;
    private static final int PROPOSALS = 2500;

    /** With four scenes of the repository: 10⁵ for each set of strategies. */
    private static final int REFERENCE_FACTOR = 12;

    private static final List<String> SHIPPED = List.of("cornell_spheres", "gold_ring", "veach_room", "door_ajar");

    private static final List<String> OTHERS = List.of(
            "all kinds",
            "spot",
            "shading normals",
            "instances",
            "light in glass",
            "thin lens",
            "environment camera",
            "lights of every kind",
            "masks",
            "within glass",
            "lamp, glass and metal, parallel rays",
            "lamp, glass and metal, thin lens",
            "mirrored instances of glass",
            "materials 1",
            "materials 2",
            "materials 4",
            "shining glass");

    static List<String> shipped() {
        return SHIPPED;
    }

    static List<String> others() {
        return OTHERS;
    }

    private static Scene scene(String name) throws SceneException {
        if (SHIPPED.contains(name)) {
            return ShippedScenes.compile(ShippedScenes.read(name + "/scene.xml").graph(), SIZE, SIZE);
        }
        return SceneCompiler.compile(BidirectionalScenes.withCrossScenes().get(name));
    }

    @ParameterizedTest
    @MethodSource("shipped")
    void proposalsAreInDetailedBalance(String name) throws SceneException {
        check(name, PROPOSALS, 1);
    }

    @ParameterizedTest
    @MethodSource("others")
    void proposalsAreInDetailedBalanceWithAllKindsOfThings(String name) throws SceneException {
        check(name, PROPOSALS / 4, 2);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("shipped")
    void moreProposalsAreInDetailedBalance(String name) throws SceneException {
        assertTrue(SHIPPED.size() * REFERENCE_FACTOR * PROPOSALS > 100_000);
        check(name, REFERENCE_FACTOR * PROPOSALS, 3);
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("others")
    void moreProposalsAreInDetailedBalanceWithAllKindsOfThings(String name) throws SceneException {
        check(name, REFERENCE_FACTOR * PROPOSALS / 4, 4);
    }

    private static void check(String name, int proposals, long seed) throws SceneException {
        Scene scene = scene(name);
        for (int shortest : new int[] {1, 3}) {
            for (boolean importance : new boolean[] {false, true}) {
                new Check(name, scene, shortest, importance, seed).run(proposals);
            }
        }
    }

    /** Proposals in one scene, by all strategies in turn. */
    private static final class Check {
        private final String name;
        private final Scene scene;
        private final Camera camera;
        private final EmissionGuide guide;
        private final int shortest;
        private final boolean importance;
        private final long seed;
        private final PathBuilder builder;
        private final List<MutationStrategy> strategies;
        private final PlainTransitions plain;
        private final ImageImportance factor;
        private int checked;
        private int lobesChecked;

        /** Chains that the manifold perturbation moved, and those of them that finite differences do not tell of. */
        private int moved;

        private int unknown;

        /** Number of paths of the sample in hand, of which one is taken by chance. */
        private int found;

        private boolean assembled;

        Check(String name, Scene scene, int shortest, boolean importance, long seed) {
            this.name = name;
            this.scene = scene;
            this.shortest = shortest;
            this.importance = importance;
            this.seed = seed;
            camera = scene.camera();
            guide = new EmissionGuide(scene);
            builder = new PathBuilder(scene, camera);
            PathLimits limits = new PathLimits(shortest, LONGEST + 1L, Integer.MAX_VALUE, Integer.MAX_VALUE);
            strategies = List.of(
                    new BidirectionalMutationStrat(WEIGHTS[0], limits, WHOLE, DELETED, ADDED, importance),
                    new LensSubpathStrat(WEIGHTS[1], limits, new FilmStrata(camera.width(), this::pixel)),
                    new LensPerturbationStrat(WEIGHTS[2], SMALLEST, LARGEST),
                    new CausticPerturbationStrat(WEIGHTS[3], SMALLEST, LARGEST),
                    new MultiChainPerturbationStrat(WEIGHTS[4], SMALLEST, LARGEST, SMALLEST, LARGEST, SHORT),
                    new ManifoldPerturbationStrat(WEIGHTS[5], SMALLEST, LARGEST, SMALLEST, LARGEST));
            plain = new PlainTransitions(WHOLE, DELETED, ADDED, shortest, LONGEST, SMALLEST, LARGEST, SHORT);
            factor = new ImageImportance(
                    2, 2, 0.5 * Math.max(camera.width(), camera.height()), new double[] {1, 2, 3, 0.5});
        }

        private long pixel(long number) {
            return Long.remainderUnsigned(
                    new RandomStream(seed, StreamDomain.LENS, number, 0).nextLong(),
                    (long) camera.width() * camera.height());
        }

        /** Runs short chains, each from another path of bidirectional path tracing, until there were enough proposals. */
        void run(int proposals) {
            BidirectionalSettings settings = new BidirectionalSettings(
                            -1, -1, LONGEST, 2, BidirectionalSettings.Roulette.NONE, 3, 1, false, true)
                    .withMinDepth(shortest);
            LightPath x = new LightPath();
            RandomStream random = new RandomStream(seed, StreamDomain.CHAIN, shortest, 0);
            Contribution.Listener listener = contribution -> {
                if (contribution.weight() > 0 && random.nextInt(++found) == 0) {
                    assembled = builder.assemble(contribution, x);
                }
            };
            BiDirectionalProcessor processor = new BiDirectionalProcessor(scene, camera, false, settings, listener);
            IndependentSampler sampler = new IndependentSampler(seed, StreamDomain.BOOTSTRAP);
            MetropolisPathMutator mutator = new MetropolisPathMutator(strategies, builder);
            SplatBuffer splats = new SplatBuffer();
            RaySample sample = new RaySample();
            for (long i = 0; checked < proposals; i++) {
                assertTrue(i < 1000L * proposals, name + ": hardly a sample finds a path");
                found = 0;
                assembled = false;
                sampler.start(i, 0);
                splats.clear();
                processor.trace(
                        sampler.next() * camera.width(), sampler.next() * camera.height(), sampler, sample, splats);
                if (assembled) {
                    walk(mutator, x, random, Math.min(proposals, checked + STEPS_OF_CHAIN / 4));
                }
            }
            assertTrue(
                    unknown <= MOST_UNKNOWN * moved + 3,
                    () -> name + ": " + unknown + " of " + moved + " chains unknown");
        }

        private void walk(MetropolisPathMutator mutator, LightPath start, RandomStream random, int end) {
            LightPath x = new LightPath();
            LightPath y = new LightPath();
            x.length = start.length;
            x.copy(start, 0, start.length, 0);
            x.copyLight(start);
            x.copyLens(start);
            x.value.set(start.value);
            x.contribution = start.contribution;
            for (int step = 0; step < STEPS_OF_CHAIN && checked < end; step++) {
                if (!mutator.propose(x, y, factor, random, checked)) {
                    continue;
                }
                checked++;
                compare(x, y, mutator);
                if (random.nextDouble() < mutator.acceptance()) {
                    LightPath swapped = x;
                    x = y;
                    y = swapped;
                }
            }
        }

        private void compare(LightPath x, LightPath y, MetropolisPathMutator mutator) {
            MutationStrategy strategy = strategies.get(mutator.strategy());
            String id = strategy.id();
            PlainPath px = new PlainPath(scene, camera, guide, x);
            PlainPath py = new PlainPath(scene, camera, guide, y);
            assertClose(px.contribution, x.contribution, TOLERANCE, "f*(x)", id, x, y);
            assertClose(py.contribution, y.contribution, TOLERANCE, "f*(y)", id, x, y);
            Move move = mutator.move();
            double there = strategy.transition(x, y, move, builder);
            double plainThere = plain.transition(id, importance, px, py, move);
            double back = 0;
            double plainBack = 0;
            double probabilityBack = 0;
            if (plain.applies(id, py)) {
                move.reverse();
                plainBack = plain.transition(id, importance, py, px, move);
                back = strategy.transition(y, x, move, builder);
                move.reverse();
                probabilityBack = probability(strategy, py);
            }
            double tolerance = TOLERANCE;
            if (id.equals("manifold") && PlainTransitions.movesChain(py, move)) {
                tolerance = CHAIN_TOLERANCE;
                moved++;
                assertTrue(py.passes(PlainTransitions.joined(py, move)), () -> describe(id, x, y) + ": is occluded");
                if (Double.isNaN(plainThere + plainBack)) {
                    unknown++;
                    return;
                }
            }
            assertTrue(plainThere > 0, () -> describe(id, x, y) + ": proposed, but T(x→y) = 0");
            assertTrue(Double.isFinite(plainBack), () -> describe(id, x, y) + ": T(y→x) is not finite");
            assertClose(plainThere, there, tolerance, "T(x→y)", id, x, y);
            assertClose(plainBack, back, tolerance, "T(y→x)", id, x, y);
            double flow = px.contribution * factor.at(px.filmX, px.filmY) * plainThere * probability(strategy, px);
            double flowBack = py.contribution * factor.at(py.filmX, py.filmY) * plainBack * probabilityBack;
            assertClose(Math.min(flow, flowBack), mutator.acceptance() * flow, 2 * tolerance, "a·f*·T·P", id, x, y);
            checkLobes(py);
        }

        private double probability(MutationStrategy chosen, PlainPath path) {
            double sum = 0;
            double weight = 0;
            for (int i = 0; i < strategies.size(); i++) {
                double own = WEIGHTS[i];
                if (plain.applies(strategies.get(i).id(), path)) {
                    sum += own;
                    weight = strategies.get(i) == chosen ? own : weight;
                }
            }
            return weight / sum;
        }

        /** The path follows its delta lobes, and the factors that stand for them have the ratio of solid angles. */
        private void checkLobes(PlainPath path) {
            for (int i = 1; i < path.k; i++) {
                if (path.isDelta(i)) {
                    double left = path.relativeLeftOver(i);
                    assertTrue(
                            left < MOST_LEFT_OVER,
                            () -> name + ", proposal " + checked + ": the path leaves its lobe by " + left);
                }
                if (path.isDelta(i) && i + 1 < path.k && !(i == 1 && path.deltaLight) && lobesChecked++ % 16 == 0) {
                    double ratio = path.bundleRatio(i);
                    if (Double.isFinite(ratio)) {
                        // Differences are as rough as the bundle is magnified.
                        double tolerance = BUNDLE_TOLERANCE * Math.max(ratio, 1 / ratio);
                        assertEquals(ratio, path.factorRatio(i), tolerance * ratio, name + ": delta lobe");
                    }
                }
            }
        }

        private void assertClose(
                double expected, double actual, double tolerance, String what, String id, LightPath x, LightPath y) {
            assertEquals(
                    expected,
                    actual,
                    tolerance * Math.abs(expected),
                    () -> what + " by " + describe(id, x, y) + ", ratio " + actual / expected);
        }

        private String describe(String id, LightPath x, LightPath y) {
            return id + " in " + name + ", proposal " + checked + ", " + kinds(x) + " → " + kinds(y);
        }

        private static String kinds(LightPath path) {
            StringBuilder text = new StringBuilder();
            for (int i = 0; i < path.length; i++) {
                text.append(i == 0 ? "L" : i == path.length - 1 ? "E" : path.lobe[i] < 0 ? "D" : "S");
            }
            return text.toString();
        }
    }
}
