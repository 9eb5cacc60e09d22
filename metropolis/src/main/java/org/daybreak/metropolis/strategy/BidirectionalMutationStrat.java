package org.daybreak.metropolis.strategy;

import org.daybreak.core.sampling.RandomStream;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Deletes a piece of a path and builds a new one, of another length maybe, from both of its ends (the thesis' class of that name;
 * Veach 1997, §11.4.1). The piece may reach the light or the lens, which are then sampled anew. It can make any path, so
 * it alone makes a chain ergodic.
 *
 * <p>Pieces end at {@link Joints}, and lengths are in edges from one to the next: a chain of mirrors and glass has no length of its own, as
 * walks pass it as they come. Otherwise a path with many of them could hardly be left, nor be reached from others (decision 23).
 *
 * <p>T = p_d[l,m] · p_a[k_a] · Σ_{l′} p_{l′}(y)/n: all ways in which the new piece could have been built count. Of a vertex on
 * a light that stays nothing is traced, as a direction cannot be sampled there by itself.
 */
public final class BidirectionalMutationStrat extends MutationStrategy {
    /** Lengths change by at most this. */
    private static final int LARGEST_CHANGE = 8;

    private final PathLimits limits;
    private final double whole;
    private final double[] deleted;
    private final double[] added;
    private final boolean importance;

    /**
     * Creates the strategy.
     *
     * @param weight relative probability of choosing it
     * @param limits which paths count
     * @param whole probability of replacing all of the path; above 0
     * @param deleted p_d: relative probability of deleting 1, 2, … edges of it; the last one is halved for each further edge
     * @param added p_a: relative probability of a piece longer or shorter by 0, 1, 2, … edges; the last one is halved further on
     * @param importance whether pieces are chosen by the density of what could build them, too (thesis eq. 5.6; Veach 1997, p. 356)
     */
    public BidirectionalMutationStrat(
            double weight, PathLimits limits, double whole, double[] deleted, double[] added, boolean importance) {
        super(weight);
        this.limits = limits;
        this.whole = whole;
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

    /**
     * Relative probability of deleting what is between two joints; not normalised. 0 if nothing could have made what is there, and for
     * the whole path.
     */
    private double deletion(LightPath x, Joints joints, int kept, int end, PathBuilder builder) {
        int count = joints.count();
        if (isWhole(joints, kept, end)) {
            return 0;
        }
        return shortest(count, kept, end, builder) <= longest(count, kept, end) && isReplaceable(x, joints, kept, end)
                ? table(deleted, end - kept - 1)
                : 0;
    }

    private static boolean isWhole(Joints joints, int kept, int end) {
        return kept < 0 && end == joints.count();
    }

    private static boolean isReplaceable(LightPath x, Joints joints, int kept, int end) {
        int most = mostFromLight(kept, end == joints.count(), end - kept, joints.count());
        if (kept < 0) {
            return !x.deltaLight || joints.hasSeam(0, most - 1);
        }
        return joints.hasSeam(kept, kept + most);
    }

    private double deletionSum(LightPath x, Joints joints, PathBuilder builder) {
        double sum = 0;
        for (int kept = -1; kept < joints.count() - 1; kept++) {
            for (int end = kept + 1; end <= joints.count(); end++) {
                sum += deletion(x, joints, kept, end, builder);
            }
        }
        return sum;
    }

    /** The same weighted with the densities of the ways to build the piece that is there; not normalised. */
    private double importantDeletion(LightPath x, Joints joints, int kept, int end, PathBuilder builder) {
        double plain = deletion(x, joints, kept, end, builder);
        if (plain == 0) {
            return 0;
        }
        double densities = 0;
        for (int s = kept + 1; s <= Math.min(end, joints.count() - 1); s++) {
            densities += way(x, joints, -1, joints.count(), s, builder);
        }
        return plain * densities;
    }

    private double importantSum(LightPath x, Joints joints, PathBuilder builder) {
        double sum = 0;
        for (int kept = -1; kept < joints.count() - 1; kept++) {
            for (int end = kept + 1; end <= joints.count(); end++) {
                sum += importantDeletion(x, joints, kept, end, builder);
            }
        }
        return sum;
    }

    /** p_d[l,m]: probability of the piece between two joints. */
    private double deletionProbability(LightPath x, Joints joints, int kept, int end, PathBuilder builder) {
        double pieces = deletionSum(x, joints, builder);
        if (isWhole(joints, kept, end)) {
            return pieces == 0 ? 1 : whole;
        }
        return pieces == 0 ? 0 : (1 - whole) * pieceProbability(x, joints, kept, end, pieces, builder);
    }

    private double pieceProbability(LightPath x, Joints joints, int kept, int end, double pieces, PathBuilder builder) {
        double plain = deletion(x, joints, kept, end, builder) / pieces;
        if (!importance) {
            return plain;
        }
        double sum = importantSum(x, joints, builder);
        return sum > 0 && sum < Double.POSITIVE_INFINITY
                ? 0.5 * (plain + importantDeletion(x, joints, kept, end, builder) / sum)
                : plain;
    }

    /** Chooses a piece: sets the joints at its ends. */
    private void chooseDeletion(LightPath x, Joints joints, PathBuilder builder, RandomStream random, Move move) {
        double sum = deletionSum(x, joints, builder);
        if (sum == 0 || random.nextDouble() < whole) {
            move.set(-1, joints.count(), 0);
            return;
        }
        boolean important = false;
        if (importance) {
            double importantSum = importantSum(x, joints, builder);
            boolean usable = importantSum > 0 && importantSum < Double.POSITIVE_INFINITY;
            if (usable && random.nextDouble() < 0.5) {
                important = true;
                sum = importantSum;
            }
        }
        double left = random.nextDouble() * sum;
        int lastKept = -1;
        int lastEnd = joints.count();
        for (int kept = -1; kept < joints.count() - 1; kept++) {
            for (int end = kept + 1; end <= joints.count(); end++) {
                double p = important
                        ? importantDeletion(x, joints, kept, end, builder)
                        : deletion(x, joints, kept, end, builder);
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

    /** Smallest number of edges of a new piece in a path of so many joints. */
    private int shortest(int joints, int kept, int end, PathBuilder builder) {
        int edges = end - kept;
        // Of a piece that reaches the light one vertex is sampled at least, in both directions: a point on a light does
        // not scatter.
        if (kept < 0 && end == 0) {
            return Integer.MAX_VALUE;
        }
        boolean lens = end == joints;
        int least = Math.max(kept < 0 || lens ? 2 : 1, edges - LARGEST_CHANGE);
        if (kept < 0 && lens) {
            least = Math.max(3, least);
        }
        // An emitter that is seen directly is not joined to the lens, but met: by a piece that reaches the light.
        int leastJoints = kept < 0 ? 2 : 3;
        if (!builder.hasDeltas()) {
            leastJoints = Math.max(leastJoints, limits.shortest() + 1);
        }
        return Math.max(least, leastJoints - (joints - edges));
    }

    /** Largest number of edges of a new piece in a path of so many joints. */
    private int longest(int joints, int kept, int end) {
        int edges = end - kept;
        return (int) Math.min(edges + LARGEST_CHANGE, limits.maxVertices() - (joints - edges));
    }

    private double lengthSum(int joints, int kept, int end, PathBuilder builder) {
        double sum = 0;
        int last = longest(joints, kept, end);
        for (int a = shortest(joints, kept, end, builder); a <= last; a++) {
            sum += table(added, Math.abs(a - (end - kept)));
        }
        return sum;
    }

    private int chooseLength(int joints, int kept, int end, PathBuilder builder, RandomStream random) {
        double left = random.nextDouble() * lengthSum(joints, kept, end, builder);
        int last = longest(joints, kept, end);
        for (int a = shortest(joints, kept, end, builder); a < last; a++) {
            left -= table(added, Math.abs(a - (end - kept)));
            if (left < 0) {
                return a;
            }
        }
        return last;
    }

    // How it is built

    /** Largest number of joints that can be added at the light's end of a piece. */
    private static int mostFromLight(int kept, boolean lens, int edges, int newJoints) {
        if (newJoints == 2) {
            // An emitter that is seen directly is not joined to the lens, but met.
            return kept < 0 ? 0 : -1;
        }
        // The lens, if it is not kept, is one of the new joints.
        int most = lens ? edges - 2 : edges - 1;
        return kept == 0 ? Math.min(0, most) : most;
    }

    /**
     * Density of building a piece with a number of joints from the light's end, the others from the lens' end.
     *
     * @param end the first joint that stays on the side of the lens; the number of joints if none does
     */
    private static double way(LightPath y, Joints joints, int kept, int end, int fromLight, PathBuilder builder) {
        int joined = kept + fromLight;
        int endVertex = joints.vertex(end);
        int vertex = joined < 0 ? -1 : joints.vertex(joined);
        int lens = end == joints.count() ? 1 : 0;
        if (endVertex - 1 - vertex - lens > PieceBuilder.LONGEST_WALK) {
            return 0;
        }
        if (joined < 0) {
            return y.deltaLight
                    ? 0
                    : WalkDensities.fromEye(y, endVertex, 0) * builder.pieces().landing(y, joints.vertex(1));
        }
        int keptVertex = joints.vertex(kept);
        if (!joints.isSeam(joined) || vertex - keptVertex > PieceBuilder.LONGEST_WALK) {
            return 0;
        }
        double eye = WalkDensities.fromEye(y, endVertex, vertex + 1);
        if (kept < 0 && fromLight == 1) {
            return y.nextEvent * eye;
        }
        return WalkDensities.fromLight(y, keptVertex, vertex) * eye;
    }

    @Override
    public double transition(LightPath from, LightPath to, Move move, PathBuilder builder) {
        Joints before = builder.jointsBefore();
        Joints after = builder.jointsAfter();
        before.of(from);
        after.of(to);
        int kept = before.at(move.kept);
        int oldEnd = before.at(move.oldEnd);
        int newEnd = after.at(move.newEnd);
        int edges = newEnd - kept;
        int count = before.count();
        if (edges < shortest(count, kept, oldEnd, builder) || edges > longest(count, kept, oldEnd)) {
            return 0;
        }
        int change = Math.abs(edges - (oldEnd - kept));
        double byLength = table(added, change) / lengthSum(count, kept, oldEnd, builder);
        int most = mostFromLight(kept, oldEnd == count, edges, after.count());
        double sum = 0;
        for (int l = 0; l <= most; l++) {
            sum += way(to, after, kept, newEnd, l, builder);
        }
        double piece = deletionProbability(from, before, kept, oldEnd, builder);
        return piece * byLength * sum / (most + 1);
    }

    @Override
    public boolean propose(
            LightPath x, LightPath y, Move move, PathBuilder builder, RandomStream random, long stratum) {
        Joints joints = builder.jointsBefore();
        joints.of(x);
        chooseDeletion(x, joints, builder, random, move);
        int kept = move.kept;
        int end = move.oldEnd;
        int edges = chooseLength(joints.count(), kept, end, builder, random);
        boolean lens = end == joints.count();
        int newJoints = joints.count() - (end - kept) + edges;
        int fromLight = random.nextInt(mostFromLight(kept, lens, edges, newJoints) + 1);
        move.set(joints.vertex(kept), joints.vertex(end), 0);
        PieceBuilder pieces = builder.pieces();
        if (!pieces.build(x, y, move, fromLight, edges - 1 - fromLight, random)) {
            return false;
        }
        if (!limits.admit(y)) {
            return builder.fail(Outcome.BLACK);
        }
        int joined = pieces.joined();
        return builder.contribution().measure(y, move.kept, move.newEnd)
                && (joined < 0 || builder.edges().reveal(y, joined));
    }
}
