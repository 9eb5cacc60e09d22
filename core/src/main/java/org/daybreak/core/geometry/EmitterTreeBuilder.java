package org.daybreak.core.geometry;

import java.util.Arrays;

/**
 * Builds an {@link EmitterTree} from the top by the surface area orientation heuristic (Conty Estevez and Kulla 2018, section
 * 4.4), with the squared diagonal in place of the area, which is 0 for lamps in a row. Sequential and deterministic.
 */
final class EmitterTreeBuilder {
    private static final int BUCKETS = 12;

    /** Below this depth nodes are halved, so that the way to a leaf fits into the bits of a long. */
    private static final int DEEP = 32;

    private final EmissionBounds[] emitters;
    private final int largestLeaf;
    private final int[] order;
    private final int[] leafOf;
    private final EmissionBounds[] bounds;
    private final int[] child;
    private final int[] leafSize;
    private final long[] trail;
    private int nodeCount;

    EmitterTreeBuilder(EmissionBounds[] emitters, int largestLeaf) {
        this.emitters = emitters;
        this.largestLeaf = largestLeaf;
        leafOf = new int[emitters.length];
        Arrays.fill(leafOf, -1);
        int[] shining = new int[emitters.length];
        int count = 0;
        for (int i = 0; i < emitters.length; i++) {
            if (emitters[i].intensity() > 0) {
                shining[count++] = i;
            }
        }
        order = Arrays.copyOf(shining, count);
        int most = Math.max(0, 2 * count - 1);
        bounds = new EmissionBounds[most];
        child = new int[most];
        leafSize = new int[most];
        trail = new long[most];
        if (count > 0) {
            nodeCount = 1;
            build(0, 0, count, 0, 0);
        }
    }

    int nodeCount() {
        return nodeCount;
    }

    EmissionBounds bounds(int node) {
        return bounds[node];
    }

    int[] child() {
        return child;
    }

    int[] leafSize() {
        return leafSize;
    }

    long[] trail() {
        return trail;
    }

    int[] order() {
        return order;
    }

    int[] leafOf() {
        return leafOf;
    }

    private void build(int node, int from, int to, long way, int depth) {
        EmissionBounds all = emitters[order[from]];
        for (int i = from + 1; i < to; i++) {
            all = all.union(emitters[order[i]]);
        }
        bounds[node] = all;
        trail[node] = way;
        if (to - from <= largestLeaf) {
            child[node] = ~from;
            leafSize[node] = to - from;
            for (int i = from; i < to; i++) {
                leafOf[order[i]] = node;
            }
            return;
        }
        int middle = depth < DEEP ? split(all, from, to) : (from + to) >>> 1;
        int first = nodeCount;
        nodeCount += 2;
        child[node] = first;
        build(first, from, middle, way, depth + 1);
        build(first + 1, middle, to, way | 1L << depth, depth + 1);
    }

    /** Parts the emitters of a node and returns where the second part starts. */
    private int split(EmissionBounds all, int from, int to) {
        double longest = Math.max(extent(all, 0), Math.max(extent(all, 1), extent(all, 2)));
        double best = Double.POSITIVE_INFINITY;
        int bestAxis = -1;
        int bestBucket = 0;
        double[] range = new double[2];
        for (int axis = 0; axis < 3; axis++) {
            centres(axis, from, to, range);
            if (!(range[1] > range[0])) {
                continue;
            }
            EmissionBounds[] buckets = new EmissionBounds[BUCKETS];
            for (int i = from; i < to; i++) {
                EmissionBounds e = emitters[order[i]];
                int bucket = bucket(e, axis, range);
                EmissionBounds before = buckets[bucket];
                buckets[bucket] = before == null ? e : before.union(e);
            }
            double[] below = costs(buckets, false);
            double[] above = costs(buckets, true);
            double regularity = longest / extent(all, axis);
            for (int i = 0; i < BUCKETS - 1; i++) {
                double cost = regularity * (below[i] + above[i + 1]);
                if (cost < best) {
                    best = cost;
                    bestAxis = axis;
                    bestBucket = i;
                }
            }
        }
        if (bestAxis < 0) {
            return (from + to) >>> 1;
        }
        centres(bestAxis, from, to, range);
        return partition(from, to, bestAxis, range, bestBucket);
    }

    /** Cost of buckets 0 … i for each i, or of i … last. Buckets at the ends are never empty. */
    private static double[] costs(EmissionBounds[] buckets, boolean fromTheEnd) {
        double[] costs = new double[BUCKETS];
        EmissionBounds sum = null;
        for (int k = 0; k < BUCKETS; k++) {
            int i = fromTheEnd ? BUCKETS - 1 - k : k;
            EmissionBounds bucket = buckets[i];
            if (bucket != null) {
                sum = sum == null ? bucket : sum.union(bucket);
            }
            costs[i] = sum == null ? 0 : sum.intensity() * sum.squaredDiagonal() * sum.orientationMeasure();
        }
        return costs;
    }

    /** Moves what lies up to a bucket to the front, and keeps the order of each part. */
    private int partition(int from, int to, int axis, double[] range, int lastBucket) {
        int[] behind = new int[to - from];
        int front = from;
        int count = 0;
        for (int i = from; i < to; i++) {
            int emitter = order[i];
            if (bucket(emitters[emitter], axis, range) <= lastBucket) {
                order[front++] = emitter;
            } else {
                behind[count++] = emitter;
            }
        }
        System.arraycopy(behind, 0, order, front, count);
        return front;
    }

    private void centres(int axis, int from, int to, double[] range) {
        range[0] = Double.POSITIVE_INFINITY;
        range[1] = Double.NEGATIVE_INFINITY;
        for (int i = from; i < to; i++) {
            double centre = centre(emitters[order[i]], axis);
            range[0] = Math.min(range[0], centre);
            range[1] = Math.max(range[1], centre);
        }
    }

    private static int bucket(EmissionBounds e, int axis, double[] range) {
        double position = (centre(e, axis) - range[0]) / (range[1] - range[0]);
        return Math.min(BUCKETS - 1, (int) (BUCKETS * position));
    }

    private static double centre(EmissionBounds e, int axis) {
        return axis == 0
                ? e.box().centerX()
                : axis == 1 ? e.box().centerY() : e.box().centerZ();
    }

    private static double extent(EmissionBounds e, int axis) {
        return axis == 0
                ? e.box().maxX() - e.box().minX()
                : axis == 1
                        ? e.box().maxY() - e.box().minY()
                        : e.box().maxZ() - e.box().minZ();
    }
}
