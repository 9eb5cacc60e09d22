package org.daybreak.metropolis.primary;

import org.daybreak.bidirectional.BiDirectionalProcessor;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.bidirectional.Contribution;
import org.daybreak.bidirectional.TechniqueSampler;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Chain;
import org.daybreak.tracing.Dimensions;
import org.jspecify.annotations.Nullable;

/**
 * Chains of paths of a fixed number k of edges, in which one more number chooses the technique (s, t) that makes the path (Hachisuka
 * et al. 2014). A state brings w_{s,t}·f/p times the number of techniques to one film position.
 *
 * <p>Candidates are samples of bidirectional path tracing: each path of them is a state, as its numbers make the same path by its technique
 * alone. So a length is chosen with its share of b, and there is no need for a largest one. Russian roulette, which ends the subpaths
 * of candidates, is no part of a state: it thins out candidates, and its factor is in their weights.
 */
final class TechniqueWorker extends PrimaryWorker {
    /** The coordinate that chooses the technique: one behind those for the point on the lens. */
    private static final int TECHNIQUE = Dimensions.choices(0) + 2;

    private final BiDirectionalProcessor processor;
    private final TechniqueSampler techniques;
    private @Nullable Candidates receiver;
    private int counted;
    private int wanted;
    private int wantedEdges;
    private int wantedLightVertices;

    TechniqueWorker(Scene scene, Camera camera, PrimarySettings settings, long seed, int shortest) {
        super(camera, settings, seed);
        BidirectionalSettings paths = settings.paths().singleSample().withMinDepth(shortest);
        processor = new BiDirectionalProcessor(scene, camera, false, paths, this::found);
        techniques = new TechniqueSampler(scene, camera, paths);
    }

    @Override
    boolean evaluate(PrimarySample numbers, int edges, StateImage image) {
        int count = techniques.techniques(edges);
        numbers.setDimension(TECHNIQUE);
        int number = Math.min(count - 1, (int) (count * numbers.next()));
        int lightVertices = techniques.lightVertices(edges, number);
        double filmX = 0;
        double filmY = 0;
        if (lightVertices < edges) {
            numbers.setDimension(0);
            filmX = filmX(numbers.next());
            filmY = filmY(numbers.next());
        }
        boolean finite = techniques.trace(edges, lightVertices, filmX, filmY, numbers, sample(), splats());
        gather(filmX, filmY, count, image);
        return finite;
    }

    @Override
    public void candidate(long index, Candidates found) {
        receiver = found;
        sample(candidate, index);
        receiver = null;
    }

    @Override
    public void start(Chain chain, long index, int number) {
        PrimaryChain started = (PrimaryChain) chain;
        wanted = number;
        sample(started.numbers, index);
        int count = techniques.techniques(wantedEdges);
        int technique = techniques.number(wantedEdges, wantedLightVertices);
        started.edges = wantedEdges;
        started.numbers.set(TECHNIQUE, Math.min((technique + started.random.nextDouble()) / count, Math.nextDown(1.0)));
        evaluate(started.numbers, started.edges, started.image);
    }

    private void sample(PrimarySample numbers, long index) {
        counted = 0;
        begin(numbers, index);
        double filmX = filmX(numbers.next());
        double filmY = filmY(numbers.next());
        processor.trace(filmX, filmY, numbers, sample(), splats());
    }

    private void found(Contribution c) {
        double luminance = c.weight() * Spectrum.luminance(c.red(), c.green(), c.blue());
        double share = c.eyeVertices() == 1 ? perPixel() : 1;
        double weight = share * luminance * importance.at(c.filmX(), c.filmY());
        if (!(weight > 0 && weight < Double.POSITIVE_INFINITY)) {
            return;
        }
        if (receiver != null) {
            receiver.found(counted, c.filmX(), c.filmY(), weight);
        } else if (counted == wanted) {
            wantedEdges = c.lightVertices() + c.eyeVertices() - 1;
            wantedLightVertices = c.lightVertices();
        }
        counted++;
    }

    @Override
    public long rays(RayKind kind) {
        return processor.rays(kind) + techniques.rays(kind);
    }
}
