package org.daybreak.metropolis.strategy;

import org.daybreak.core.sampling.RandomStream;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Moves the image point, follows ideal reflections and refractions to the first other vertex, tilts the direction there and goes on
 * so for each further chain, until a vertex can be joined to the rest: a path …(L|D)DS⁺D…S*E (thesis §5.4; Veach
 * 1997, §11.4.3).
 *
 * <p>Besides, it goes on over edges that are short beside the way to the lens, as in the corner of a room, though they could be joined: their geometry
 * term grows without bound as their ends come together, and where only one end moves, nothing leads away from such a path. Here
 * the density of the new vertex grows likewise. What was short must be so in the new path.
 *
 * <p>The range of angles is that of image distances between the given bounds, scaled with the length of the path from the lens to the
 * vertex over that of the chain; short edges count as if they were of the length from which on they are not.
 */
public final class MultiChainPerturbationStrat extends MutationStrategy {
    private final double smallestJump;
    private final double largestJump;
    private final double smallest;
    private final double largest;
    private final double shortEdges;

    /**
     * Creates the strategy.
     *
     * @param weight relative probability of choosing it
     * @param smallestJump of the image point, in pixels
     * @param largestJump of the image point, in pixels
     * @param smallest of the further chains' directions, in pixels that it corresponds to
     * @param largest of the further chains' directions, in pixels that it corresponds to
     * @param shortEdges an edge is short below this part of the way from its end to the lens
     */
    public MultiChainPerturbationStrat(
            double weight,
            double smallestJump,
            double largestJump,
            double smallest,
            double largest,
            double shortEdges) {
        super(weight);
        this.smallestJump = smallestJump;
        this.largestJump = largestJump;
        this.smallest = smallest;
        this.largest = largest;
        this.shortEdges = shortEdges;
    }

    @Override
    public String id() {
        return "multiChain";
    }

    @Override
    protected boolean applies(LightPath x) {
        int d = LensPiece.diffuse(x);
        if (d == 0 || !goesOn(x, d) || x.filmPerSolidAngle == 0) {
            return false;
        }
        int end = end(x, d);
        return end > 0 || !(x.deltaLight || x.infinite);
    }

    /** True if the way on from a vertex towards the light is not one that the path is joined by: a chain, or a short edge. */
    private boolean goesOn(LightPath x, int vertex) {
        if (!x.joins(vertex - 1)) {
            return true;
        }
        double edge = x.squared[vertex - 1];
        double before = shortEdges * wayToLens(x, vertex);
        return edge < before * before;
    }

    private static double wayToLens(LightPath x, int vertex) {
        double way = 0;
        for (int i = vertex; i < x.length - 1; i++) {
            way += Math.sqrt(x.squared[i]);
        }
        return way;
    }

    /** The vertex that the last chain or short edge leads to. */
    private int end(LightPath x, int firstDiffuse) {
        int d = firstDiffuse;
        while (d > 0 && goesOn(x, d)) {
            d = LensPiece.nextDiffuse(x, d);
        }
        return d;
    }

    /** Factor from distances on the film to angles at a vertex that a chain or a short edge starts from towards another one. */
    private double scale(LightPath x, int start, int end) {
        if (x.joins(start - 1)) {
            return 1 / (shortEdges * Math.sqrt(x.filmPerSolidAngle));
        }
        double chain = 0;
        for (int i = end; i < start; i++) {
            chain += Math.sqrt(x.squared[i]);
        }
        return wayToLens(x, start) / (chain * Math.sqrt(x.filmPerSolidAngle));
    }

    @Override
    public boolean propose(
            LightPath x, LightPath y, Move move, PathBuilder builder, RandomStream random, long stratum) {
        int d = LensPiece.diffuse(x);
        int last = end(x, d);
        move.set(last - 1, x.length, x.length);
        if (!LensPiece.perturbFilm(x, y, smallestJump, largestJump, builder, random)) {
            return false;
        }
        while (d > last) {
            int next = LensPiece.nextDiffuse(x, d);
            if (!Tilt.tilt(
                    -x.dx[d - 1],
                    -x.dy[d - 1],
                    -x.dz[d - 1],
                    smallest,
                    largest,
                    scale(x, d, next),
                    random,
                    builder.walk())) {
                return builder.fail(Outcome.MISSED);
            }
            boolean met = builder.walk().traceToLight(y, d, random);
            if (!LensPiece.follow(x, y, d - 1, next, met, builder, random)) {
                return false;
            }
            d = next;
        }
        if (last == 0 && y.infinite) {
            return builder.fail(Outcome.KIND_CHANGED);
        }
        return LensPiece.join(x, y, last, builder)
                && (end(y, LensPiece.diffuse(y)) == last || builder.fail(Outcome.KIND_CHANGED));
    }

    @Override
    public double transition(LightPath from, LightPath to, Move move, PathBuilder builder) {
        int d = LensPiece.diffuse(from);
        int last = move.kept + 1;
        double density = LensPiece.density(to, to.length, d);
        while (d > last) {
            int next = LensPiece.nextDiffuse(from, d);
            density *= Tilt.density(
                    -from.dx[d - 1],
                    -from.dy[d - 1],
                    -from.dz[d - 1],
                    -to.dx[d - 1],
                    -to.dy[d - 1],
                    -to.dz[d - 1],
                    smallest,
                    largest,
                    scale(from, d, next));
            density *= WalkDensities.towardsLight(to, d - 1) * to.clear[d - 1] * to.opacity[d - 1];
            density *= LensPiece.density(to, d - 1, next);
            d = next;
        }
        return density;
    }
}
