package org.daybreak.metropolis;

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
import org.daybreak.metropolis.strategy.PathPattern;
import org.daybreak.tracing.RaySample;

/** Surveys paths with the samples that chains start from and with those that may take light off them. */
final class MetropolisPilot implements PilotWorker {
    private static final int SOBOL_GROUP = 4;

    private final int width;
    private final int height;
    private final int shortest;
    private final BiDirectionalProcessor candidates;
    private final BiDirectionalProcessor samples;
    private final Sampler anywhere;
    private final Sampler ofPixel;
    private final RaySample sample = new RaySample();
    private final SplatBuffer splats = new SplatBuffer();
    private By bySample = By.FIRST;
    private Survey receiver = (pattern, filmX, filmY, weight, by) -> {};

    /**
     * Creates a worker.
     *
     * @param seed of the pilot
     * @param bidirectional settings of candidates
     * @param shortest smallest number of edges of the paths of chains
     */
    MetropolisPilot(Scene scene, Camera camera, long seed, BidirectionalSettings bidirectional, int shortest) {
        width = camera.width();
        height = camera.height();
        this.shortest = shortest;
        candidates =
                new BiDirectionalProcessor(scene, camera, false, bidirectional, path -> found(path, By.CANDIDATES));
        samples = new BiDirectionalProcessor(
                scene, camera, false, bidirectional.ofPixels(), path -> found(path, bySample));
        anywhere = new IndependentSampler(seed, StreamDomain.BOOTSTRAP);
        ofPixel = new SobolSampler(seed, StreamDomain.PIXEL, SOBOL_GROUP);
    }

    @Override
    public void survey(long index, int column, int row, Survey found) {
        receiver = found;
        for (int i = 0; i < 2 * BLOCK; i++) {
            anywhere.start(index, i);
            trace(anywhere.next() * width, anywhere.next() * height, anywhere, candidates);
        }
        for (int half = 0; half < 2; half++) {
            bySample = half == 0 ? By.FIRST : By.SECOND;
            for (int i = 0; i < BLOCK; i++) {
                ofPixel.start(2 * index + half, i);
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
    public long rays() {
        long rays = 0;
        for (RayKind kind : RayKind.values()) {
            rays += kind == RayKind.SHADOW ? 0 : samples.rays(kind);
        }
        return rays;
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
        receiver.found(pattern, path.filmX(), path.filmY(), weight / (by == By.CANDIDATES ? 2 * BLOCK : BLOCK), by);
    }
}
