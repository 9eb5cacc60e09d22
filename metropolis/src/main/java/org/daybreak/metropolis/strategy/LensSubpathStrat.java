package org.daybreak.metropolis.strategy;

import org.daybreak.core.sampling.RandomStream;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Replaces the lens subpath (L|D)S*E of a path by one through a new image point, which spreads the proposals of all chains over the
 * film (the thesis' class of that name; Veach 1997, §11.4.2).
 *
 * <p>The walk goes on by delta lobes with their probabilities and stops where it chooses none; T has these probabilities, and the
 * image density that {@link FilmStrata} makes even.
 */
public final class LensSubpathStrat extends MutationStrategy {
    private final PathLimits limits;
    private final FilmStrata strata;

    /**
     * Creates the strategy.
     *
     * @param weight relative probability of choosing it
     * @param limits which paths count
     * @param strata how image points are spread
     */
    public LensSubpathStrat(double weight, PathLimits limits, FilmStrata strata) {
        super(weight);
        this.limits = limits;
        this.strata = strata;
    }

    @Override
    public String id() {
        return "lensSubpath";
    }

    @Override
    public boolean usesStrata() {
        return true;
    }

    @Override
    protected boolean applies(LightPath x) {
        int d = LensPiece.diffuse(x);
        return d == 0 ? !x.deltaLight : x.joins(d - 1);
    }

    @Override
    public boolean propose(
            LightPath x, LightPath y, Move move, PathBuilder builder, RandomStream random, long stratum) {
        int kept = LensPiece.diffuse(x) - 1;
        LightPath walk = builder.scratchPath();
        int k = walk.length - 1;
        long longest = Math.min(k, limits.maxVertices() - (kept + 1));
        builder.lens().sample(walk, random);
        long pixel = strata.pixel(stratum);
        double filmX = strata.x(pixel, random.nextDouble());
        double filmY = strata.y(pixel, random.nextDouble());
        boolean met = builder.lens().look(walk, k, filmX, filmY, random);
        int at = k - 1;
        while (met && builder.walk().chooseLobe(walk, at, random)) {
            if (k - at + 1 > longest) {
                return builder.fail(Outcome.BLACK);
            }
            met = builder.walk().follow(walk, at, true) && builder.walk().traceToLight(walk, at, random);
            at--;
        }
        if (!met && !(kept < 0 && builder.escaped())) {
            return false;
        }
        int vertices = k - at + 1;
        int d = kept + 1;
        move.set(kept, x.length, d + vertices);
        y.length = d + vertices;
        y.copy(walk, at, vertices, d);
        y.copyLens(walk);
        if (d == 0 ? !builder.light().land(y, met, random) : !y.bsdfs[d].connectable()) {
            return builder.fail(d == 0 ? Outcome.BLACK : Outcome.KIND_CHANGED);
        }
        return LensPiece.join(x, y, d, builder) && (limits.admit(y) || builder.fail(Outcome.BLACK));
    }

    @Override
    public double transition(LightPath from, LightPath to, Move move, PathBuilder builder) {
        int d = move.kept + 1;
        double walk = WalkDensities.fromEye(to, to.length, d) * builder.walk().stopProbability(to, d);
        return d == 0 ? walk / builder.light().landings(to) : walk;
    }
}
