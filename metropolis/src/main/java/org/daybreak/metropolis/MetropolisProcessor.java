package org.daybreak.metropolis;

import java.util.List;
import org.daybreak.bidirectional.BiDirectionalProcessor;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.bidirectional.Contribution;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.IndependentSampler;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Chain;
import org.daybreak.metropolis.chains.ChainStatistics;
import org.daybreak.metropolis.chains.ChainWorker;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.metropolis.chains.PatternSet;
import org.daybreak.metropolis.strategy.LightPath;
import org.daybreak.metropolis.strategy.MutationStrategy;
import org.daybreak.metropolis.strategy.PathBuilder;
import org.daybreak.metropolis.strategy.PathPattern;
import org.daybreak.tracing.RaySample;

/**
 * Moves chains of paths (the thesis' class of that name; Veach 1997, chapter 11). Candidates for their first states are samples of
 * bidirectional path tracing: each path of a sample, with its weight. One object per worker.
 */
final class MetropolisProcessor implements ChainWorker {
    private final Scene scene;
    private final long seed;
    private final PatternSet ofSamples;
    private final boolean expectedValues;
    private final long strideOfStrata;
    private final double pixels;
    private final int width;
    private final int height;
    private final PathBuilder builder;
    private final MetropolisPathMutator mutator;
    private final BiDirectionalProcessor candidates;
    private final IndependentSampler sampler;
    private final RaySample sample = new RaySample();
    private final SplatBuffer candidateSplats = new SplatBuffer();
    private ImageImportance importance = ImageImportance.UNIFORM;

    /** What is done with the paths of a candidate. */
    private Candidates found = (number, filmX, filmY, weight) -> {};

    private int wanted;
    private int counted;
    private LightPath target = new LightPath();
    private boolean assembled;

    /**
     * Creates a worker.
     *
     * @param ofSamples kinds of paths that chains do not find
     * @param expectedValues whether both states of a step are deposited
     * @param chains number of chains of the render
     */
    MetropolisProcessor(
            Scene scene,
            Camera camera,
            long seed,
            BidirectionalSettings bidirectional,
            List<MutationStrategy> strategies,
            PatternSet ofSamples,
            boolean expectedValues,
            int chains) {
        this.scene = scene;
        this.seed = seed;
        this.ofSamples = ofSamples;
        this.expectedValues = expectedValues;
        strideOfStrata = chains;
        width = camera.width();
        height = camera.height();
        pixels = (double) width * height;
        builder = new PathBuilder(scene, camera);
        mutator = new MetropolisPathMutator(strategies, builder);
        candidates = new BiDirectionalProcessor(scene, camera, false, bidirectional, this::found);
        sampler = new IndependentSampler(seed, StreamDomain.BOOTSTRAP);
    }

    @Override
    public void setImportance(ImageImportance factor) {
        importance = factor;
    }

    @Override
    public long rays(RayKind kind) {
        return builder.rays(kind) + candidates.rays(kind);
    }

    // Start-up

    @Override
    public void candidate(long index, Candidates receiver) {
        found = receiver;
        draw(index, -1);
    }

    private void draw(long index, int number) {
        wanted = number;
        counted = 0;
        sampler.start(index, 0);
        double filmX = sampler.next() * width;
        double filmY = sampler.next() * height;
        candidateSplats.clear();
        candidates.beginUnit();
        candidates.trace(filmX, filmY, sampler, sample, candidateSplats);
    }

    private void found(Contribution path) {
        double luminance = path.weight() * Spectrum.luminance(path.red(), path.green(), path.blue());
        if (!(luminance > 0)) {
            return;
        }
        // What light subpaths bring to the lens is per pixel.
        double share = path.eyeVertices() == 1 ? luminance / pixels : luminance;
        if (!ofSamples.isEmpty() && ofSamples.contains(PathPattern.of(path))) {
            return;
        }
        int number = counted++;
        if (wanted < 0) {
            found.found(number, path.filmX(), path.filmY(), share * importance.at(path.filmX(), path.filmY()));
        } else if (number == wanted) {
            assembled = builder.assemble(path, target);
        }
    }

    @Override
    public Chain newChain(int number) {
        return new PathChain(scene, seed, number);
    }

    @Override
    public void start(Chain chain, long index, int number) {
        PathChain paths = (PathChain) chain;
        target = paths.current;
        assembled = false;
        draw(index, number);
        if (!assembled) {
            throw new IllegalStateException(
                    "candidate " + index + " has no path " + number + " that can be built again");
        }
    }

    // Moving

    @Override
    public void advance(Chain chain, long steps, SplatBuffer splats, ChainStatistics statistics) {
        PathChain paths = (PathChain) chain;
        // What the state has to its credit since it was last deposited.
        double credit = 0;
        for (long i = 0; i < steps; i++) {
            long stratum = paths.strata * strideOfStrata + paths.number;
            boolean proposed = mutator.propose(paths.current, paths.proposal, importance, paths.random, stratum);
            if (mutator.usedStratum()) {
                paths.strata++;
            }
            double a = mutator.acceptance();
            if (!(a >= 0)) {
                statistics.nonFinite++;
                a = 0;
            }
            int move = mutator.strategy();
            statistics.count(move, mutator.outcome());
            statistics.addAcceptance(move, a);
            boolean accepted = proposed && paths.random.nextDouble() < a;
            if (expectedValues) {
                credit += 1 - a;
                if (a > 0 && !accepted) {
                    deposit(paths.proposal, a, splats, statistics);
                }
            } else if (!accepted) {
                credit += 1;
            }
            if (accepted) {
                statistics.countAccepted(move, distance(paths.current, paths.proposal));
                deposit(paths.current, credit, splats, statistics);
                credit = expectedValues ? a : 1;
                paths.swap();
                paths.rejections = 0;
            } else {
                paths.rejections++;
                statistics.longestRejection = Math.max(statistics.longestRejection, paths.rejections);
            }
        }
        deposit(paths.current, credit, splats, statistics);
        paths.steps += steps;
        statistics.steps += steps;
    }

    private void deposit(LightPath path, double credit, SplatBuffer splats, ChainStatistics statistics) {
        if (credit == 0) {
            return;
        }
        double factor = credit / (path.contribution() * importance.at(path.filmX(), path.filmY()));
        Spectrum value = path.value();
        if (!splats.add(path.filmX(), path.filmY(), factor * value.r, factor * value.g, factor * value.b)) {
            statistics.nonFinite++;
        }
    }

    private static double distance(LightPath x, LightPath y) {
        return Math.hypot(y.filmX() - x.filmX(), y.filmY() - x.filmY());
    }
}
