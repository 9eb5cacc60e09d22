package org.daybreak.metropolis;

import java.util.List;
import org.daybreak.bidirectional.BiDirectionalProcessor;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.bidirectional.Contribution;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.IndependentSampler;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.sampling.SobolSampler;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.PilotWorker;
import org.daybreak.metropolis.strategy.MutationStrategy;
import org.daybreak.metropolis.strategy.PathPattern;
import org.daybreak.tracing.RaySample;
import org.jspecify.annotations.Nullable;

/** Surveys paths with the samples that chains start from, with steps from there, and with the samples that may take light off chains. */
final class MetropolisPilot implements PilotWorker {
    private static final int SOBOL_GROUP = 4;
    private static final double WORK_OF_SHADOW_RAY = 0.5;

    private final int width;
    private final int height;
    private final int shortest;
    private final BiDirectionalProcessor candidates;
    private final BiDirectionalProcessor samples;
    private final Sampler anywhere;
    private final Sampler ofPixel;
    private final PilotChain chain;
    private final RaySample sample = new RaySample();
    private final SplatBuffer splats = new SplatBuffer();
    private By half = By.FIRST;
    private int number;
    private @Nullable Survey receiver;

    /**
     * Creates a worker.
     *
     * @param seed of the pilot
     * @param bidirectional settings of candidates
     * @param strategies moves of the chains
     * @param shortest smallest number of edges of the paths of chains
     */
    MetropolisPilot(
            Scene scene,
            Camera camera,
            long seed,
            BidirectionalSettings bidirectional,
            List<MutationStrategy> strategies,
            int shortest) {
        width = camera.width();
        height = camera.height();
        this.shortest = shortest;
        candidates =
                new BiDirectionalProcessor(scene, camera, false, bidirectional, path -> found(path, By.CANDIDATES));
        samples = new BiDirectionalProcessor(scene, camera, false, bidirectional.ofPixels(), path -> found(path, half));
        chain = new PilotChain(scene, camera, seed, strategies);
        anywhere = new IndependentSampler(seed, StreamDomain.BOOTSTRAP);
        ofPixel = new SobolSampler(seed, StreamDomain.PIXEL, SOBOL_GROUP);
    }

    @Override
    public void survey(long index, int column, int row, Survey found) {
        receiver = found;
        number = 0;
        for (int i = 0; i < 2 * BLOCK; i++) {
            chain.begin(2 * BLOCK * index + i);
            anywhere.start(index, i);
            trace(anywhere.next() * width, anywhere.next() * height, anywhere, candidates);
            chain.move(found);
        }
        for (int block = 0; block < 2; block++) {
            half = block == 0 ? By.FIRST : By.SECOND;
            for (number = 0; number < BLOCK; number++) {
                ofPixel.start(2 * index + block, number);
                trace(column + ofPixel.next(), row + ofPixel.next(), ofPixel, samples);
            }
        }
    }

    private void trace(double filmX, double filmY, Sampler sampler, BiDirectionalProcessor processor) {
        splats.clear();
        processor.beginUnit();
        processor.trace(filmX, filmY, sampler, sample, splats);
    }

    @Override
    public long rays(RayKind kind) {
        return candidates.rays(kind) + samples.rays(kind) + chain.rays(kind);
    }

    @Override
    public double work() {
        double work = 0;
        for (RayKind kind : RayKind.values()) {
            work += workOf(kind) * samples.rays(kind);
        }
        return work;
    }

    /** Any hit is found sooner than the nearest one. */
    static double workOf(RayKind kind) {
        return kind == RayKind.SHADOW ? WORK_OF_SHADOW_RAY : 1;
    }

    private void found(Contribution path, By by) {
        double luminance = path.weight() * Spectrum.luminance(path.red(), path.green(), path.blue());
        if (!(luminance > 0)) {
            return;
        }
        // What light subpaths bring to the lens is per pixel.
        double weight = path.eyeVertices() == 1 ? luminance / ((double) width * height) : luminance;
        int edges = path.lightVertices() + path.eyeVertices() - 1;
        long pattern = edges < shortest ? SHORT : PathPattern.of(path);
        if (by != By.CANDIDATES && pattern != SHORT && !PathPattern.suitsSamples(pattern)) {
            // What is found by chance tells little of what will be.
            return;
        }
        if (by == By.CANDIDATES && pattern != SHORT) {
            chain.offer(path, weight);
        }
        if (receiver != null) {
            double share = weight / (by == By.CANDIDATES ? 2 * BLOCK : BLOCK);
            receiver.found(pattern, path.filmX(), path.filmY(), share, by, by == By.CANDIDATES ? 0 : number);
        }
    }
}
