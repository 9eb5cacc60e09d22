package org.daybreak.metropolis.chains;

import java.util.function.LongFunction;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.RenderClock;
import org.daybreak.core.sampling.Mixing;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;

/**
 * What happens before the chains of a render make its image: the rough image of the first of two stages, the
 * candidates, and the starts that are drawn from them (Veach 1997, §11.3.1 and §11.5).
 */
final class ChainStartUp {
    /** The first of two stages has one in so many steps and candidates, and as much of the time. */
    private static final int FIRST_STAGE = 10;

    /** Part of the time that is left which the candidates may take. */
    private static final double BOOTSTRAP_SHARE = 0.2;

    /** What is enough of that if b is known well by then. */
    private static final double ENOUGH = 0.25;

    private final ChainSettings settings;
    private final FilmSettings film;
    private final int candidates;
    private final boolean limited;
    private final int moves;
    private final long seed;
    private final LongFunction<ChainWorkers> newWorkers;
    private final RenderClock clock;
    private final ChainProgress progress;

    /**
     * Creates the start-up of a render.
     *
     * @param candidates number of candidates, at most
     * @param limited whether their number ends the render, and not time alone
     * @param moves number of kinds of moves
     * @param seed of the render
     * @param newWorkers makes workers with a seed
     */
    ChainStartUp(
            ChainSettings settings,
            FilmSettings film,
            int candidates,
            boolean limited,
            int moves,
            long seed,
            LongFunction<ChainWorkers> newWorkers,
            RenderClock clock,
            ChainProgress progress) {
        this.settings = settings;
        this.film = film;
        this.candidates = candidates;
        this.limited = limited;
        this.moves = moves;
        this.seed = seed;
        this.newWorkers = newWorkers;
        this.clock = clock;
        this.progress = progress;
    }

    private long pixels() {
        return (long) film.width() * film.height();
    }

    /** Renders the rough image. Its random numbers are its own. */
    ImageImportance roughImage() {
        long ownSeed = Mixing.absorb(seed, FIRST_STAGE);
        ChainWorkers workers = newWorkers.apply(ownSeed);
        progress.endPhase("prepare");
        double end = clock.seconds() + clock.secondsLeft() / FIRST_STAGE;
        int least = Math.max(1, candidates / FIRST_STAGE);
        StartDistribution distribution = candidates(workers, ownSeed, least, BOOTSTRAP_SHARE / FIRST_STAGE);
        long total = Math.max(1, settings.steps(pixels()) / FIRST_STAGE);
        int count = (int) Math.min(settings.seedPaths(), total);
        RoughImage image = new RoughImage(film, settings.reduction());
        if (distribution.mean() > 0) {
            Chain[] rough = start(workers, distribution, ownSeed, 0, count, count);
            RoundSchedule rounds = new RoundSchedule(rough.length == 0 ? 0 : total, count, 0, count);
            new ChainRounds(workers, rounds, rough, 0, moves) {
                @Override
                boolean isStopped() {
                    return clock.shouldStop() || clock.seconds() > end;
                }

                @Override
                void commit(Unit unit) {
                    image.add(unit.splats, unit.steps);
                    progress.addNonFinite(unit, ownSeed);
                }

                @Override
                protected void watch() {
                    progress.show();
                }
            }.run(workers.count());
        }
        progress.endPhase("start");
        return image.importance(count);
    }

    /** Draws the candidates for the starts of the chains that make the image. */
    StartDistribution candidates(ChainWorkers workers) {
        return candidates(workers, seed, candidates, BOOTSTRAP_SHARE);
    }

    private StartDistribution candidates(ChainWorkers workers, long ownSeed, int count, double share) {
        double begin = clock.seconds();
        double most = clock.secondsLeft() * share;
        return new Bootstrap(
                        workers,
                        ownSeed,
                        count,
                        limited ? settings.enoughCandidates(count) : count,
                        () -> clock.shouldStop() || clock.seconds() - begin > most,
                        () -> clock.seconds() - begin > ENOUGH * most,
                        progress::show,
                        progress.nonFinite())
                .draw();
    }

    /** Puts the chains that make the image on their starts; none if it was stopped. */
    Chain[] start(ChainWorkers workers, StartDistribution distribution, ChainLanes lanes) {
        return start(workers, distribution, seed, lanes.first(), lanes.end(), lanes.chains());
    }

    private Chain[] start(
            ChainWorkers workers, StartDistribution distribution, long ownSeed, int first, int end, int all) {
        // No candidate has this index.
        double u = new RandomStream(ownSeed, StreamDomain.BOOTSTRAP, -1, 0).nextDouble();
        StartDistribution.Starts starts = distribution.draw(u, first, end, all);
        return new ChainStarts(workers, distribution, starts, first, clock::shouldStop, progress::show).start();
    }
}
