package org.daybreak.metropolis.strategy;

import org.daybreak.core.sampling.RandomStream;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Deletes a piece of a path and builds a new one, of another length maybe, from both of its ends (the thesis' class of that name;
 * Veach 1997, §11.4.1). The piece may reach the light or the lens, which are then sampled anew. It can make any path, so
 * it alone makes a chain ergodic.
 *
 * <p>T = p_d[l,m] · p_a[k_a] · Σ_{l′} p_a[l′] p_{l′}(y): all ways in which the new piece could have been built count. Of a vertex on
 * a light that stays nothing is traced, as a direction cannot be sampled there by itself.
 */
public final class BidirectionalMutationStrat extends MutationStrategy {
    /** Lengths change by at most this. */
    private static final int LARGEST_CHANGE = 8;

    private final PathLimits limits;
    private final double[] deleted;
    private final double[] added;
    private final boolean importance;

    /**
     * Creates the strategy.
     *
     * @param weight relative probability of choosing it
     * @param limits which paths count
     * @param deleted p_d: relative probability of deleting 1, 2, … edges; the last one is halved for each further edge
     * @param added p_a: relative probability of a piece longer or shorter by 0, 1, 2, … edges; the last one is halved further on
     * @param importance whether pieces are chosen by the density of what could build them, too (thesis eq. 5.6; Veach 1997, p. 356)
     */
    public BidirectionalMutationStrat(
            double weight, PathLimits limits, double[] deleted, double[] added, boolean importance) {
        super(weight);
        this.limits = limits;
        this.deleted = deleted.clone();
        this.added = added.clone();
        this.importance = importance;
    }

    @Override
    public String id() {
        return "bidirectional";
    }

    @Override
    protected boolean applies(LightPath x) {
        return true;
    }

    private static double table(double[] table, int index) {
        int last = table.length - 1;
        return index <= last ? table[index] : Math.scalb(table[last], last - index);
    }

    // Which piece

    /** Relative probability of deleting what is between two vertices; not normalised. */
    private double deletion(LightPath x, int kept, int end) {
        return shortest(x.length, kept, end) <= longest(x.length, kept, end) ? table(deleted, end - kept - 1) : 0;
    }

    private double deletionSum(LightPath x) {
        double sum = 0;
        for (int kept = -1; kept < x.length - 1; kept++) {
            for (int end = kept + 1; end <= x.length; end++) {
                sum += deletion(x, kept, end);
            }
        }
        return sum;
    }

    /** The same weighted with the densities of the ways to build the piece that is there; not normalised. */
    private double importantDeletion(LightPath x, int kept, int end, PathBuilder builder) {
        double plain = deletion(x, kept, end);
        if (plain == 0) {
            return 0;
        }
        double densities = 0;
        for (int s = kept + 1; s <= end; s++) {
            densities += technique(x, s, builder);
        }
        return plain * densities;
    }

    private double importantSum(LightPath x, PathBuilder builder) {
        double sum = 0;
        for (int kept = -1; kept < x.length - 1; kept++) {
            for (int end = kept + 1; end <= x.length; end++) {
                sum += importantDeletion(x, kept, end, builder);
            }
        }
        return sum;
    }

    /** Density of all of a path when s vertices are sampled from the light. */
    private static double technique(LightPath x, int s, PathBuilder builder) {
        int t = x.length - s;
        return t < 1 ? 0 : way(x, -1, x.length, s, builder);
    }

    /** p_d[l,m]: probability of the piece between two vertices. */
    private double deletionProbability(LightPath x, int kept, int end, PathBuilder builder) {
        double plain = deletion(x, kept, end) / deletionSum(x);
        if (!importance) {
            return plain;
        }
        double sum = importantSum(x, builder);
        return sum > 0 && sum < Double.POSITIVE_INFINITY
                ? 0.5 * (plain + importantDeletion(x, kept, end, builder) / sum)
                : plain;
    }

    private void chooseDeletion(LightPath x, PathBuilder builder, RandomStream random, Move move) {
        double sum = deletionSum(x);
        boolean important = false;
        if (importance) {
            double importantSum = importantSum(x, builder);
            boolean usable = importantSum > 0 && importantSum < Double.POSITIVE_INFINITY;
            if (usable && random.nextDouble() < 0.5) {
                important = true;
                sum = importantSum;
            }
        }
        double left = random.nextDouble() * sum;
        int lastKept = -1;
        int lastEnd = x.length;
        for (int kept = -1; kept < x.length - 1; kept++) {
            for (int end = kept + 1; end <= x.length; end++) {
                double p = important ? importantDeletion(x, kept, end, builder) : deletion(x, kept, end);
                if (p > 0) {
                    lastKept = kept;
                    lastEnd = end;
                    left -= p;
                    if (left < 0) {
                        move.set(kept, end, 0);
                        return;
                    }
                }
            }
        }
        move.set(lastKept, lastEnd, 0);
    }

    // How long the new piece is

    /** Smallest number of edges of a new piece in a path of so many vertices. */
    private int shortest(int vertices, int kept, int end) {
        int edges = end - kept;
        // Of a piece that reaches the light one vertex is sampled at least, in both directions: a point on a light does
        // not scatter.
        if (kept < 0 && end == 0) {
            return Integer.MAX_VALUE;
        }
        boolean lens = end == vertices;
        int least = Math.max(kept < 0 || lens ? 2 : 1, edges - LARGEST_CHANGE);
        if (kept < 0 && lens) {
            least = Math.max(3, least);
        }
        // An emitter that is seen directly is not joined to the lens, but met: by a piece that reaches the light.
        int leastVertices = Math.max(kept < 0 ? 2 : 3, limits.shortest() + 1);
        return Math.max(least, leastVertices - (vertices - edges));
    }

    /** Largest number of edges of a new piece in a path of so many vertices. */
    private int longest(int vertices, int kept, int end) {
        int edges = end - kept;
        return (int) Math.min(edges + LARGEST_CHANGE, limits.maxVertices() - (vertices - edges));
    }

    private double lengthSum(LightPath x, int kept, int end) {
        double sum = 0;
        int last = longest(x.length, kept, end);
        for (int a = shortest(x.length, kept, end); a <= last; a++) {
            sum += table(added, Math.abs(a - (end - kept)));
        }
        return sum;
    }

    private int chooseLength(LightPath x, Move move, RandomStream random) {
        int edges = move.oldEnd - move.kept;
        double left = random.nextDouble() * lengthSum(x, move.kept, move.oldEnd);
        int last = longest(x.length, move.kept, move.oldEnd);
        for (int a = shortest(x.length, move.kept, move.oldEnd); a < last; a++) {
            left -= table(added, Math.abs(a - edges));
            if (left < 0) {
                return a;
            }
        }
        return last;
    }

    // How it is built

    /** Largest number of vertices that can be added at the light's end of a piece. */
    private static int mostFromLight(int kept, boolean lens, int edges, int newVertices) {
        if (newVertices == 2) {
            // An emitter that is seen directly is not joined to the lens, but met.
            return kept < 0 ? 0 : -1;
        }
        // The lens, if it is not kept, is one of the new vertices.
        int most = lens ? edges - 2 : edges - 1;
        return kept == 0 ? Math.min(0, most) : most;
    }

    /**
     * Density of building a piece with a number of vertices from the light's end, the others from the lens' end.
     *
     * @param end the first vertex that stays on the side of the lens; the number of vertices if none does
     */
    private static double way(LightPath y, int kept, int end, int fromLight, PathBuilder builder) {
        int joined = kept + fromLight;
        if (joined < 0) {
            return y.deltaLight
                    ? 0
                    : WalkDensities.fromEye(y, end, 0) / builder.light().landings(y);
        }
        if (!y.joins(joined) || !y.joins(joined + 1)) {
            return 0;
        }
        double eye = WalkDensities.fromEye(y, end, joined + 1);
        if (kept < 0 && fromLight == 1) {
            return y.nextEvent * eye;
        }
        return WalkDensities.fromLight(y, kept, joined) * eye;
    }

    @Override
    public double transition(LightPath from, LightPath to, Move move, PathBuilder builder) {
        int edges = move.newEnd - move.kept;
        boolean lens = move.oldEnd == from.length;
        int least = shortest(from.length, move.kept, move.oldEnd);
        if (edges < least || edges > longest(from.length, move.kept, move.oldEnd)) {
            return 0;
        }
        int change = Math.abs(edges - (move.oldEnd - move.kept));
        double byLength = table(added, change) / lengthSum(from, move.kept, move.oldEnd);
        int most = mostFromLight(move.kept, lens, edges, to.length);
        double sum = 0;
        for (int l = 0; l <= most; l++) {
            sum += way(to, move.kept, move.newEnd, l, builder);
        }
        double piece = deletionProbability(from, move.kept, move.oldEnd, builder);
        return piece * byLength * sum / (most + 1);
    }

    @Override
    public boolean propose(
            LightPath x, LightPath y, Move move, PathBuilder builder, RandomStream random, long stratum) {
        chooseDeletion(x, builder, random, move);
        int edges = chooseLength(x, move, random);
        int kept = move.kept;
        int oldEnd = move.oldEnd;
        int newEnd = kept + edges;
        move.newEnd = newEnd;
        boolean lens = oldEnd == x.length;
        y.length = x.length - oldEnd + newEnd;
        y.reserve(y.length);
        int fromLight = random.nextInt(mostFromLight(kept, lens, edges, y.length) + 1);
        int joined = kept + fromLight;
        if (kept >= 0) {
            y.copy(x, 0, kept + 1, 0);
            y.copyLight(x);
        }
        if (!lens) {
            y.copy(x, oldEnd, x.length - oldEnd, newEnd);
            y.copyLens(x);
        } else {
            builder.lens().sample(y, random);
        }
        if (!(kept < 0 && fromLight == 1) && !extendFromLight(y, kept, joined, builder, random)) {
            return false;
        }
        if (!extendFromEye(y, newEnd, joined + 1, builder, random)) {
            return false;
        }
        if (kept < 0 && fromLight == 1) {
            if (!joinable(y, 1, builder) || !builder.light().sample(y, random)) {
                return false;
            }
        }
        if (joined >= 0 && !join(y, joined, joined + 1 == y.length - 1, builder)) {
            return false;
        }
        if (!limits.admit(y)) {
            return builder.fail(Outcome.BLACK);
        }
        return builder.contribution().measure(y, kept, newEnd)
                && (joined < 0 || builder.edges().reveal(y, joined));
    }

    /** Adds vertices from the light's end up to one. */
    private static boolean extendFromLight(LightPath y, int kept, int to, PathBuilder builder, RandomStream random) {
        int at = kept;
        if (at < 0 && to >= 1) {
            if (!builder.light().emit(y, random)) {
                return false;
            }
            at = 1;
        }
        while (at < to) {
            if (!builder.walk().scatter(y, at, false, random) || !builder.walk().traceToEye(y, at, random)) {
                return false;
            }
            at++;
        }
        return true;
    }

    /** Adds vertices from the lens' end down to one, or only the vertices that another end is still to be joined to. */
    private static boolean extendFromEye(LightPath y, int end, int to, PathBuilder builder, RandomStream random) {
        int k = y.length - 1;
        int at = end;
        boolean met = true;
        if (at > k) {
            if (to == k) {
                // The lens alone: it is aimed at when the light's end is known.
                return true;
            }
            at = k;
        }
        while (at > to) {
            met = at == k
                    ? builder.lens()
                            .look(
                                    y,
                                    k,
                                    random.nextDouble() * builder.camera().width(),
                                    random.nextDouble() * builder.camera().height(),
                                    random)
                    : builder.walk().scatter(y, at, true, random)
                            && builder.walk().traceToLight(y, at, random);
            at--;
            if (!met && !(at == 0 && builder.escaped())) {
                return false;
            }
        }
        return to > 0 || builder.light().land(y, met, random);
    }

    private static boolean joinable(LightPath y, int vertex, PathBuilder builder) {
        if (vertex == 0 || vertex == y.length - 1) {
            return true;
        }
        y.lobe[vertex] = -1;
        return y.bsdfs[vertex].connectable() || builder.fail(Outcome.KIND_CHANGED);
    }

    /** Joins two vertices whose sides are there. */
    private static boolean join(LightPath y, int vertex, boolean aim, PathBuilder builder) {
        if (!joinable(y, vertex, builder) || !joinable(y, vertex + 1, builder)) {
            return false;
        }
        if (aim && !builder.lens().aim(y, vertex + 1)) {
            return false;
        }
        y.clear[vertex] = 1;
        if (vertex == 0 && y.infinite) {
            y.squared[0] = Double.POSITIVE_INFINITY;
            return true;
        }
        y.setEdge(vertex);
        return y.squared[vertex] > 0 || builder.fail(Outcome.BLACK);
    }
}
