package org.daybreak.metropolis.primary;

import java.util.List;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.metropolis.chains.Chain;
import org.daybreak.metropolis.chains.ChainStatistics;
import org.daybreak.metropolis.chains.ChainWorker;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.metropolis.chains.Outcome;
import org.daybreak.tracing.RaySample;

/**
 * Moves chains over random numbers by large and small steps. Both are symmetric, so that a proposal is accepted with
 * min(1, f*′v′/f*v), where f* is the luminance of all that a state brings to the image. What that is, subclasses say.
 */
abstract class PrimaryWorker implements ChainWorker {
    /** Names of the moves. */
    static final List<String> MOVES = List.of("large step", "small step");

    private static final int LARGE = 0;
    private static final int SMALL = 1;

    private final PrimarySettings settings;
    private final long seed;
    private final RandomStream bootstrap = new RandomStream();

    /** What the proposal in hand brings; takes turns with that of the chain. */
    private StateImage proposed = new StateImage();

    private final RaySample sample = new RaySample();
    private final SplatBuffer found = new SplatBuffer();
    private final double width;
    private final double height;
    private final double perPixel;

    /** Numbers of the candidate in hand. */
    final PrimarySample candidate;

    /** Factor on the target. */
    ImageImportance importance = ImageImportance.UNIFORM;

    PrimaryWorker(Camera camera, PrimarySettings settings, long seed) {
        this.settings = settings;
        this.seed = seed;
        width = camera.width();
        height = camera.height();
        perPixel = 1 / (width * height);
        candidate = new PrimarySample(settings.step());
    }

    /**
     * Computes what a vector of numbers brings to the image.
     *
     * @param numbers to be read
     * @param edges of the chain
     * @param image receives it
     * @return false if something was not finite and has been left out
     */
    abstract boolean evaluate(PrimarySample numbers, int edges, StateImage image);

    @Override
    public final void setImportance(ImageImportance newImportance) {
        importance = newImportance;
    }

    @Override
    public final Chain newChain(int number) {
        return new PrimaryChain(seed, number, settings.step());
    }

    /** Lets the numbers be those of a candidate. */
    final void begin(PrimarySample numbers, long index) {
        bootstrap.seat(seed, StreamDomain.BOOTSTRAP, index, 0);
        numbers.begin(bootstrap);
    }

    /** Gathers what one sample brings: its radiance at a film position, and its splats. */
    final void gather(double filmX, double filmY, double factor, StateImage image) {
        image.clear();
        image.add(filmX, filmY, factor * sample.radiance.r, factor * sample.radiance.g, factor * sample.radiance.b);
        // A splat reaches one pixel of all.
        double share = factor * perPixel;
        for (int i = 0; i < found.size(); i++) {
            image.add(
                    found.filmX(i),
                    found.filmY(i),
                    share * found.value(i, 0),
                    share * found.value(i, 1),
                    share * found.value(i, 2));
        }
    }

    /** For the radiance of a sample. */
    final RaySample sample() {
        return sample;
    }

    /** For the splats of a sample; empty. */
    final SplatBuffer splats() {
        found.clear();
        return found;
    }

    /** Film position in pixels, of a number in [0,1). */
    final double filmX(double u) {
        return u * width;
    }

    /** Film position in pixels, downwards, of a number in [0,1). */
    final double filmY(double u) {
        return u * height;
    }

    /** Part of the image that a pixel is. */
    final double perPixel() {
        return perPixel;
    }

    @Override
    public final void advance(Chain chain, long steps, SplatBuffer splats, ChainStatistics statistics) {
        PrimaryChain current = (PrimaryChain) chain;
        double target = current.image.target(importance);
        // In how many steps the state has been without having been splatted.
        double waiting = 0;
        for (long i = 0; i < steps; i++) {
            boolean large = current.random.nextDouble() < settings.largeStep();
            int move = large ? LARGE : SMALL;
            current.numbers.propose(large, current.random);
            double proposedTarget =
                    evaluate(current.numbers, current.edges, proposed) ? proposed.target(importance) : Double.NaN;
            if (!(proposedTarget < Double.POSITIVE_INFINITY)) {
                statistics.nonFinite++;
                proposedTarget = 0;
            }
            boolean light = proposedTarget > 0;
            statistics.count(move, light ? Outcome.PROPOSED : Outcome.BLACK);
            double acceptance = light ? Math.min(1, proposedTarget / target) : 0;
            statistics.addAcceptance(move, acceptance);
            double share = settings.expectedValues() ? acceptance : 0;
            waiting += 1 - share;
            if (current.random.nextDouble() < acceptance) {
                if (!settings.expectedValues()) {
                    waiting--;
                    share = 1;
                }
                splat(current.image, waiting, target, splats, statistics);
                statistics.countAccepted(move, target > 0 ? distance(current.image, proposed) : 0);
                StateImage old = current.image;
                current.image = proposed;
                proposed = old;
                current.numbers.accept();
                current.rejections = 0;
                target = proposedTarget;
                waiting = share;
            } else {
                if (share > 0) {
                    splat(proposed, share, proposedTarget, splats, statistics);
                }
                current.rejections++;
                statistics.longestRejection = Math.max(statistics.longestRejection, current.rejections);
            }
        }
        splat(current.image, waiting, target, splats, statistics);
        current.steps += steps;
        statistics.steps += steps;
    }

    /** Splats a state that counts as so many steps. */
    private static void splat(
            StateImage image, double steps, double target, SplatBuffer splats, ChainStatistics statistics) {
        if (steps > 0 && target > 0) {
            statistics.nonFinite += image.splat(steps / target, splats);
        }
    }

    private static double distance(StateImage from, StateImage to) {
        return Math.hypot(to.filmX() - from.filmX(), to.filmY() - from.filmY());
    }
}
