package org.daybreak.metropolis.strategy;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Builds a piece of a path anew by walks from both of its ends, each of which goes on until it has made a number of {@link Joints}: mirrors
 * and glass on its way are passed and not counted. One object per worker.
 */
final class PieceBuilder {
    /** Largest number of vertices of a walk: between walls of glass it might never end. */
    static final int LONGEST_WALK = 63;

    private final Scene scene;
    private final Camera camera;
    private final LightEnd light;
    private final LensEnd lens;
    private final RandomWalk walk;
    private final Failure failure;

    /** The walk from the lens' side, whose length is not known beforehand: it ends here, where its last vertex is the one that stays or the lens. */
    private final LightPath fromLens = new LightPath();

    /** First vertex of it. */
    private int first;

    /** Whether that lies on a surface. */
    private boolean met;

    /** The vertex behind which the two walks are joined; -1 if that from the lens has come to a light. */
    private int joined;

    PieceBuilder(Scene scene, Camera camera, LightEnd light, LensEnd lens, RandomWalk walk, Failure failure) {
        this.scene = scene;
        this.camera = camera;
        this.light = light;
        this.lens = lens;
        this.walk = walk;
        this.failure = failure;
        fromLens.reserve(LONGEST_WALK + 1);
        fromLens.length = LONGEST_WALK + 1;
    }

    /**
     * Places the vertices of a new piece.
     *
     * @param x where the piece is replaced
     * @param y receives the path but for its measures
     * @param move which piece; receives its new end
     * @param byLight number of joints from the side of the light; with 1 where the light does not stay, x₀ is sampled for x₁
     * @param byLens number of joints from the side of the lens, the lens included where it does not stay
     * @return false if there is no path
     */
    boolean build(LightPath x, LightPath y, Move move, int byLight, int byLens, RandomStream random) {
        int kept = move.kept;
        if (kept >= 0) {
            y.copy(x, 0, kept + 1, 0);
            y.copyLight(x);
        }
        boolean sampleLight = kept < 0 && byLight == 1;
        boolean landing = kept < 0 && byLight == 0;
        joined = sampleLight ? 0 : kept;
        if (!sampleLight && !walkFromLight(y, byLight, random)) {
            return false;
        }
        if (!walkFromLens(x, move.oldEnd, byLens, landing, random)) {
            return false;
        }
        assemble(x, y, move);
        if (landing) {
            return light.land(y, met, random);
        }
        return (!sampleLight || light.sample(y, random)) && join(y, joined);
    }

    /**
     * The vertex of the last path built that is joined to the next one, on an edge that no ray was traced along; -1 if the walk from the
     * lens has come to a light.
     */
    int joined() {
        return joined;
    }

    /** Adds joints from the light's side. */
    private boolean walkFromLight(LightPath y, int joints, RandomStream random) {
        int kept = joined;
        int left = joints;
        if (kept < 0 && left > 0) {
            y.reserve(2);
            if (!light.emit(y, random)) {
                return false;
            }
            joined = 1;
            left -= y.connectable[1] ? 2 : 1;
        }
        while (left > 0) {
            if (joined - kept == LONGEST_WALK) {
                return failure.because(Outcome.BLACK);
            }
            y.reserve(joined + 2);
            if (!walk.scatter(y, joined, false, random) || !walk.traceToEye(y, joined, random)) {
                return false;
            }
            joined++;
            left -= y.connectable[joined] ? 1 : 0;
        }
        return true;
    }

    /**
     * Makes joints from the lens' side.
     *
     * @param landing whether the last one is to be on a light
     */
    private boolean walkFromLens(LightPath x, int end, int joints, boolean landing, RandomStream random) {
        boolean replaced = end == x.length;
        int last = fromLens.length - 1;
        int left = joints;
        first = last;
        if (replaced) {
            lens.sample(fromLens, random);
            fromLens.setEnd(last);
            left--;
        } else {
            fromLens.copy(x, end, 1, last);
            fromLens.copyLens(x);
        }
        boolean atLens = end >= x.length - 1;
        while (left > 0) {
            if (first == 0) {
                return failure.because(Outcome.BLACK);
            }
            met = (first == last && atLens)
                    ? lens.look(
                            fromLens,
                            last,
                            random.nextDouble() * camera.width(),
                            random.nextDouble() * camera.height(),
                            random)
                    : walk.scatter(fromLens, first, true, random) && walk.traceToLight(fromLens, first, random);
            first--;
            if (!met) {
                return landing && left == 1 && failure.escaped();
            }
            boolean counts = (landing && left == 1) ? landsOn(first, random) : fromLens.connectable[first];
            if (counts) {
                left--;
            }
        }
        return true;
    }

    /** Whether a walk that is to come to a light ends at a surface, and does not go on through mirrors and glass. */
    private boolean landsOn(int vertex, RandomStream random) {
        int shape = fromLens.points[vertex].shape;
        return !isPassed(shape) || (scene.lightOf(shape) >= 0 && random.nextDouble() < 0.5);
    }

    /** Whether walks pass a surface that they meet. */
    private boolean isPassed(int shape) {
        return scene.bsdf(shape).scattersByDeltasOnly();
    }

    /**
     * Probability with which a walk from the lens that is to come to a light takes the light of a path for its end: it may have gone on
     * through surfaces that shine and reflect, too, and chooses among several lights at infinity.
     *
     * @param from vertex of the last joint that it had to make before
     */
    double landing(LightPath y, int from) {
        double probability = 1.0 / light.landings(y);
        for (int i = y.infinite ? 1 : 0; i < from; i++) {
            int shape = y.points[i].shape;
            if (scene.lightOf(shape) >= 0 && isPassed(shape)) {
                probability *= 0.5;
            }
        }
        return probability;
    }

    /** Puts the walk from the lens' side and what stays there behind the vertex that it is joined to. */
    private void assemble(LightPath x, LightPath y, Move move) {
        int last = fromLens.length - 1;
        boolean replaced = move.oldEnd == x.length;
        int made = replaced ? last + 1 - first : last - first;
        int end = joined + 1 + made;
        move.newEnd = end;
        y.length = replaced ? end : end + x.length - move.oldEnd;
        y.reserve(y.length);
        y.copy(fromLens, first, made, joined + 1);
        if (!replaced) {
            y.copy(x, move.oldEnd, x.length - move.oldEnd, end);
            if (made > 0) {
                // It was scattered at anew, or is the lens, which looks elsewhere.
                y.lobe[end] = fromLens.lobe[last];
                y.points[end].set(fromLens.points[last]);
            }
        }
        y.copyLens(fromLens);
    }

    /** Joins two vertices whose sides are there. */
    private boolean join(LightPath y, int vertex) {
        y.lobe[vertex] = -1;
        y.lobe[vertex + 1] = -1;
        if (vertex + 1 == y.length - 1 && !lens.aim(y, vertex + 1)) {
            return false;
        }
        y.clear[vertex] = 1;
        if (vertex == 0 && y.infinite) {
            y.squared[0] = Double.POSITIVE_INFINITY;
            return true;
        }
        y.setEdge(vertex);
        return y.squared[vertex] > 0 || failure.because(Outcome.BLACK);
    }
}
