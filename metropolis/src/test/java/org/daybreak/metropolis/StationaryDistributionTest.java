package org.daybreak.metropolis;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Significance;
import org.daybreak.metropolis.chains.ChainStatistics;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.metropolis.strategy.LightPath;
import org.daybreak.metropolis.strategy.MutationStrategy;
import org.daybreak.metropolis.strategy.PathBuilder;
import org.daybreak.metropolis.strategy.Paths;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * All strategies, one by one and together, keep the distribution f*·v/b, on small scenes whose path space is cut into cells: by
 * surfaces and lobes of the vertices, by their places and the quadrant of the film, by lengths of edges, by the contribution.
 *
 * <p>Chains start from that very distribution ({@link StationaryStates}), independent of each other, so whatever the number of steps,
 * the distribution of their ends is known, and there are no correlations to allow for. Two χ² tests:
 *
 * <ul>
 *   <li>Detailed balance: moves between any two cells are as frequent in both directions ({@link Symmetry}), for one step of each
 *       strategy alone, ergodic or not, and for several steps of mixtures.
 *   <li>Stationary distribution: the ends of chains of mixtures fall into the cells as a table says, which bidirectional sampling
 *       without any chain gives, with its own error.
 * </ul>
 *
 * <p>The false-alarm rate is 1e-4 per scene by Šidák's correction. Seeds are fixed.
 */
class StationaryDistributionTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int STEPS = 12;
    private static final int STARTS = 12_000;
    private static final int REFERENCE_FACTOR = 5;

    /** Bidirectional samples for each start at most, if only few give one. */
    private static final long MOST_SAMPLES = 12;

    /** Samples for the table per sample for the starts. */
    private static final int TABLE = 3;

    private static final String ALONE = "BISLCMF";
    private static final List<String> MIXTURES = List.of("B", "I", "BS", "BL", "BC", "BM", "BF", "BSLCMF", "ISLCMF");

    /** Cells with fewer expected ends are pooled. */
    private static final double LEAST_EXPECTED = 5;

    static Iterable<String> scenes() {
        return ToyScenes.names();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void strategiesKeepTheDistribution(String name) {
        check(name, STARTS, ImageImportance.UNIFORM, List.of("BSLCMF"));
    }

    /** The target of the second of two stages. */
    @Test
    void strategiesKeepTheDistributionOfTheSecondStage() {
        check("plastic", STARTS, factor(), List.of("BSLCMF"));
    }

    private static ImageImportance factor() {
        return new ImageImportance(3, 2, ToyScenes.SIZE / 3.0, new double[] {1, 4, 2, 0.5, 3, 1});
    }

    @Tag("reference")
    @ParameterizedTest
    @MethodSource("scenes")
    void mixturesKeepTheDistribution(String name) {
        check(name, REFERENCE_FACTOR * STARTS, ImageImportance.UNIFORM, MIXTURES);
    }

    @Tag("reference")
    @Test
    void mixturesKeepTheDistributionOfTheSecondStage() {
        check("plastic", REFERENCE_FACTOR * STARTS, factor(), MIXTURES);
    }

    private static void check(String name, int starts, ImageImportance importance, List<String> mixtures) {
        Scene scene = ToyScenes.scene(name);
        int shortest = ToyScenes.shortest(name);
        StationaryStates states = new StationaryStates(scene, 42, shortest, Math.max(4, shortest + 1), importance);
        new Check(name, scene, states, importance, mixtures).run(starts);
    }

    /**
     * A way to cut path space into cells. The number of a cell is the hash of its name: should two have the same, they are one cell, which
     * is one as well.
     */
    private record Cells(String name, Function<LightPath, String> cell) {
        int of(LightPath path) {
            return cell.apply(path).hashCode();
        }
    }

    private static final class Check {
        private final String name;
        private final Scene scene;
        private final StationaryStates states;
        private final ImageImportance importance;
        private final List<String> mixtures;
        private final List<Cells> partitions = List.of(
                new Cells("kinds", Paths::signature),
                new Cells("ends", Paths::ends),
                new Cells("counts", Paths::counts),
                new Cells("places", path -> Paths.places(path, 0, -0.1, -0.4, ToyScenes.SIZE)),
                new Cells("lengths", Paths::lengths),
                new Cells("short edges", path -> Paths.shortEdges(path, StationaryStates.SHORT)),
                new Cells("magnitudes", Paths::magnitude));
        private final Cells tableCells = new Cells(
                "table",
                path -> Paths.signature(path)
                        + Paths.places(path, 0, -0.1, -0.4, ToyScenes.SIZE).substring(0, 2));
        private final Map<Integer, double[]> table = new HashMap<>();
        private final Map<String, Double> pValues = new LinkedHashMap<>();
        private final Map<String, Symmetry> symmetries = new LinkedHashMap<>();
        private final Map<String, Map<Integer, Long>> ends = new LinkedHashMap<>();

        Check(String name, Scene scene, StationaryStates states, ImageImportance importance, List<String> mixtures) {
            this.name = name;
            this.scene = scene;
            this.states = states;
            this.importance = importance;
            this.mixtures = mixtures;
        }

        void run(int starts) {
            MetropolisProcessor any = states.processor("B", 1);
            PathChain chain = (PathChain) any.newChain(0);
            PathBuilder builder = new PathBuilder(scene, scene.camera());
            List<MutationStrategy> alone = states.strategies(ALONE);
            List<MetropolisPathMutator> mutators = new ArrayList<>();
            for (MutationStrategy strategy : alone) {
                mutators.add(new MetropolisPathMutator(List.of(strategy), builder));
            }
            List<MetropolisProcessor> processors = new ArrayList<>();
            for (String mixture : mixtures) {
                processors.add(states.processor(mixture, 1));
            }
            RandomStream random = new RandomStream();
            LightPath proposal = new LightPath();
            SplatBuffer splats = new SplatBuffer();
            long samples = 0;
            long first = 1_000_000_000L;
            int started = 0;
            while (started < starts && samples < MOST_SAMPLES * starts) {
                long sample = first + samples++;
                states.draw(sample);
                for (int copies = states.copies(); copies > 0; copies--) {
                    LightPath x = states.path(chain, sample);
                    int[] from = cells(x);
                    for (int i = 0; i < mutators.size(); i++) {
                        random.seat(started, StreamDomain.SELF_CHECK, i, 1);
                        MetropolisPathMutator mutator = mutators.get(i);
                        if (alone.get(i).weight(x) > 0
                                && mutator.propose(x, proposal, importance, random, (long) ALONE.length() * started + i)
                                && random.nextDouble() < mutator.acceptance()) {
                            count(ALONE.charAt(i) + " alone", from, cells(proposal));
                        }
                    }
                    for (int i = 0; i < mixtures.size(); i++) {
                        PathChain moved = (PathChain) processors.get(i).newChain(starts * i + started);
                        states.start(processors.get(i), moved, sample);
                        processors
                                .get(i)
                                .advance(
                                        moved,
                                        STEPS,
                                        splats,
                                        new ChainStatistics(mixtures.get(i).length()));
                        splats.clear();
                        count(mixtures.get(i), from, cells(moved.current));
                        ends.computeIfAbsent(mixtures.get(i), k -> new HashMap<>())
                                .merge(tableCells.of(moved.current), 1L, Long::sum);
                    }
                    started++;
                }
            }
            tabulate(chain, TABLE * samples);
            symmetries.forEach((what, symmetry) -> pValues.put(what, symmetry.pValue()));
            for (Map.Entry<String, Map<Integer, Long>> entry : ends.entrySet()) {
                pValues.put(entry.getKey() + " ends", compare(entry.getValue(), samples, TABLE * samples));
            }
            double level = Significance.sidak(SIGNIFICANCE, pValues.size());
            pValues.forEach((what, p) -> {
                if (!(p >= level)) {
                    fail(String.format(Locale.ROOT, "%s, %s: p = %.3g is below %.3g", name, what, p, level));
                }
            });
        }

        private int[] cells(LightPath path) {
            return partitions.stream().mapToInt(cells -> cells.of(path)).toArray();
        }

        private void count(String what, int[] from, int[] to) {
            for (int i = 0; i < from.length; i++) {
                symmetries
                        .computeIfAbsent(what + ", " + partitions.get(i).name, k -> new Symmetry())
                        .add(from[i], to[i]);
            }
        }

        /** Adds up weights and their squares in cells. */
        private void tabulate(PathChain chain, long samples) {
            for (long sample = 0; sample < samples; sample++) {
                double weight = states.draw(sample + 1_000_000);
                if (weight > 0) {
                    double[] cell = table.computeIfAbsent(
                            tableCells.of(states.path(chain, sample + 1_000_000)), k -> new double[2]);
                    cell[0] += weight;
                    cell[1] += weight * weight;
                }
            }
        }

        private double compare(Map<Integer, Long> observed, long samples, long tableSamples) {
            double scale = samples / (tableSamples * states.bound());
            double statistic = 0;
            int degreesOfFreedom = 0;
            double[] pool = new double[3];
            Set<Integer> cells = new TreeSet<>(table.keySet());
            cells.addAll(observed.keySet());
            for (int cell : cells) {
                double[] sums = table.getOrDefault(cell, new double[2]);
                double expected = scale * sums[0];
                double variance = scale * scale * sums[1];
                double count = observed.getOrDefault(cell, 0L);
                if (expected < LEAST_EXPECTED) {
                    pool[0] += expected;
                    pool[1] += variance;
                    pool[2] += count;
                } else {
                    statistic += (count - expected) * (count - expected) / (expected + variance);
                    degreesOfFreedom++;
                }
            }
            if (pool[0] >= LEAST_EXPECTED) {
                statistic += (pool[2] - pool[0]) * (pool[2] - pool[0]) / (pool[0] + pool[1]);
                degreesOfFreedom++;
            }
            assertTrue(degreesOfFreedom > 10, name + ": hardly any cells");
            return Significance.chiSquare(statistic, degreesOfFreedom);
        }
    }
}
