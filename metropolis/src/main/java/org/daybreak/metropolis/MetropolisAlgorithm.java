package org.daybreak.metropolis;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.antialiasing.MetropolisAntiAliaser;
import org.daybreak.bidirectional.BidirectionalRenderer;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.ChainAlgorithm;
import org.daybreak.metropolis.chains.ChainWorker;
import org.daybreak.metropolis.chains.PatternSet;
import org.daybreak.metropolis.chains.PilotWorker;
import org.daybreak.metropolis.chains.Sharing;
import org.daybreak.metropolis.strategy.BidirectionalMutationStrat;
import org.daybreak.metropolis.strategy.CausticPerturbationStrat;
import org.daybreak.metropolis.strategy.FilmStrata;
import org.daybreak.metropolis.strategy.LensPerturbationStrat;
import org.daybreak.metropolis.strategy.LensSubpathStrat;
import org.daybreak.metropolis.strategy.ManifoldPerturbationStrat;
import org.daybreak.metropolis.strategy.MultiChainPerturbationStrat;
import org.daybreak.metropolis.strategy.MutationStrategy;
import org.daybreak.metropolis.strategy.PathLimits;
import org.daybreak.metropolis.strategy.PathPattern;

/** Metropolis light transport: states are paths, moves are Veach's mutations. */
final class MetropolisAlgorithm implements ChainAlgorithm {
    /** Identifier of the renderer. */
    static final String ID = "metropolis";

    private final MetropolisSettings settings;

    /** Kinds of paths that samples find. */
    private final PatternSet ofSamples;

    MetropolisAlgorithm(MetropolisSettings settings) {
        this(settings, PatternSet.NONE);
    }

    private MetropolisAlgorithm(MetropolisSettings settings, PatternSet ofSamples) {
        this.settings = settings;
        this.ofSamples = ofSamples;
    }

    @Override
    public Sharing sharing() {
        return settings.sharing();
    }

    @Override
    public PilotWorker newPilotWorker(Scene scene, Camera camera, long seed, int shortest) {
        return new MetropolisPilot(
                scene, camera, seed, settings.bidirectional(), strategies(camera, seed, shortest), shortest);
    }

    @Override
    public ChainAlgorithm remainder(PatternSet patterns) {
        return new MetropolisAlgorithm(settings, patterns);
    }

    @Override
    public Renderer samples(PatternSet patterns, int shortest) {
        return new BidirectionalRenderer(
                settings.bidirectional().ofPixels(),
                (light, s, eye, t) -> s + t - 1 < shortest || patterns.contains(PathPattern.of(light, s, eye, t)));
    }

    @Override
    public String id() {
        return ID;
    }

    @Override
    public List<String> moves() {
        List<String> names = new ArrayList<>();
        for (int i = 0; i < MetropolisSettings.STRATEGIES.size(); i++) {
            if (settings.weights().get(i) > 0) {
                names.add(MetropolisSettings.STRATEGIES.get(i));
            }
        }
        return names;
    }

    @Override
    public List<String> warnings() {
        return settings.isErgodic()
                ? List.of()
                : List.of(
                        "without the bidirectional mutation chains cannot reach all paths: the image keeps the accidents of"
                                + " the start");
    }

    @Override
    public ChainWorker newWorker(Scene scene, Camera camera, long seed, int shortest) {
        BidirectionalSettings candidates = settings.bidirectional().withMinDepth(shortest);
        return new MetropolisProcessor(
                scene,
                camera,
                seed,
                candidates,
                strategies(camera, seed, shortest),
                ofSamples,
                settings.expectedValues(),
                settings.chains().seedPaths());
    }

    private List<MutationStrategy> strategies(Camera camera, long seed, int shortest) {
        double pixels = (double) camera.width() * camera.height();
        PathLimits limits = limits(shortest);
        double jump = Math.max(2 * settings.smallestJump(), Math.sqrt(settings.largestJump() * pixels / Math.PI));
        double angle = Math.max(2 * settings.smallestAngle(), Math.sqrt(settings.largestAngle() * pixels / Math.PI));
        List<MutationStrategy> all = new ArrayList<>();
        for (int i = 0; i < settings.weights().size(); i++) {
            double weight = settings.weights().get(i);
            if (weight == 0) {
                continue;
            }
            all.add(
                    switch (MetropolisSettings.STRATEGIES.get(i)) {
                        case "bidirectional" ->
                            new BidirectionalMutationStrat(
                                    weight,
                                    limits,
                                    settings.wholePaths(),
                                    array(settings.deleted()),
                                    array(settings.added()),
                                    settings.importanceMutations());
                        case "lensSubpath" -> new LensSubpathStrat(weight, limits, strata(camera, seed));
                        case "lens" -> new LensPerturbationStrat(weight, settings.smallestJump(), jump);
                        case "caustic" -> new CausticPerturbationStrat(weight, settings.smallestAngle(), angle);
                        case "multiChain" ->
                            new MultiChainPerturbationStrat(
                                    weight,
                                    settings.smallestJump(),
                                    jump,
                                    settings.smallestAngle(),
                                    angle,
                                    settings.shortEdges());
                        default ->
                            new ManifoldPerturbationStrat(
                                    weight, settings.smallestJump(), jump, settings.smallestAngle(), angle);
                    });
        }
        return all;
    }

    /** All chains together propose each pixel once per round, in an order that is another one in each round. */
    private static FilmStrata strata(Camera camera, long seed) {
        long key = new RandomStream(seed, StreamDomain.LENS, 0, 0).nextLong();
        MetropolisAntiAliaser pixels = new MetropolisAntiAliaser(camera.width(), camera.height(), key);
        return new FilmStrata(camera.width(), pixels::pixel);
    }

    private PathLimits limits(int shortest) {
        BidirectionalSettings s = settings.bidirectional();
        long edges = s.maxDepth() < 0 ? Integer.MAX_VALUE : s.maxDepth();
        return new PathLimits(
                shortest,
                edges + 1,
                s.maxEyeDepth() < 0 ? Integer.MAX_VALUE : s.maxEyeDepth(),
                s.maxLightDepth() < 0 ? Integer.MAX_VALUE : s.maxLightDepth(),
                ofSamples);
    }

    private static double[] array(List<Double> numbers) {
        return numbers.stream().mapToDouble(Double::doubleValue).toArray();
    }
}
