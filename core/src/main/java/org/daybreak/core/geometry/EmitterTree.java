package org.daybreak.core.geometry;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * A binary tree over emitters for choosing one in proportion to an estimate of what it contributes to a point, in time
 * logarithmic in their number (Conty Estevez and Kulla 2018). From the root on, one of two children is chosen by an estimate from
 * box, cone and intensity; the way to each leaf is stored as bits, so that the probability of a given emitter costs as much as
 * a choice. Immutable.
 *
 * <p>The estimate of a node is 0 only if nothing in it can contribute: every emitter that contributes can be chosen.
 */
public final class EmitterTree {
    /** Centre and half extents of the box, axis, cosine and sine of the cone, cosine of the spread, intensity. */
    private static final int STRIDE = 13;

    private static final int HALF = 3;
    private static final int AXIS = 6;
    private static final int CONE = 9;
    private static final int SPREAD = 11;
    private static final int INTENSITY = 12;

    /** More than what rounding to single precision does. */
    private static final float ROUNDING = 1e-6f;

    /** Bound of single estimates, so that sums stay finite next to a point light. */
    private static final double LARGEST = 1e200;

    /** Least emitter cosine in estimates, so that what is on the edge stays possible. */
    private static final double LEAST_COSINE = 1e-3;

    private final float[] nodes;
    /** First of two children, which are neighbours; for a leaf the complement of its first position in {@link #order}. */
    private final int[] child;

    private final int[] leafSize;
    /** Way from the root to each node, the first choice in the lowest bit. */
    private final long[] trail;

    private final int[] order;
    /** Leaf of each emitter, -1 for emitters without intensity. */
    private final int[] leafOf;
    /** Nodes that together hold all emitters, for the estimate of the whole. */
    private final int[] frontier;

    private final @Nullable EmissionBounds bounds;
    /** Intensity of the whole; the nodes hold shares of it. */
    private final double scale;

    EmitterTree(EmitterTreeBuilder builder) {
        int count = builder.nodeCount();
        nodes = new float[STRIDE * count];
        child = Arrays.copyOf(builder.child(), count);
        leafSize = Arrays.copyOf(builder.leafSize(), count);
        trail = Arrays.copyOf(builder.trail(), count);
        order = builder.order();
        leafOf = builder.leafOf();
        scale = count == 0 ? 0 : builder.bounds(0).intensity();
        for (int node = 0; node < count; node++) {
            write(node, builder.bounds(node));
        }
        bounds = count == 0 ? null : builder.bounds(0);
        frontier = count == 0 ? new int[0] : frontier(8);
    }

    /**
     * Builds a tree. Emitters without intensity are left out of it.
     *
     * @param emitters bounds of the emitters; their indices are those of the tree
     * @param leafSize largest number of emitters in a leaf, at least 1
     */
    public static EmitterTree of(EmissionBounds[] emitters, int leafSize) {
        return new EmitterTree(new EmitterTreeBuilder(emitters, leafSize));
    }

    private void write(int node, EmissionBounds b) {
        int at = STRIDE * node;
        nodes[at] = (float) b.box().centerX();
        nodes[at + 1] = (float) b.box().centerY();
        nodes[at + 2] = (float) b.box().centerZ();
        nodes[at + HALF] = half(b.box().minX(), b.box().maxX());
        nodes[at + HALF + 1] = half(b.box().minY(), b.box().maxY());
        nodes[at + HALF + 2] = half(b.box().minZ(), b.box().maxZ());
        nodes[at + AXIS] = (float) b.axisX();
        nodes[at + AXIS + 1] = (float) b.axisY();
        nodes[at + AXIS + 2] = (float) b.axisZ();
        nodes[at + CONE] = b.normalAngle() >= Math.PI ? -1 : (float) Math.cos(b.normalAngle());
        nodes[at + CONE + 1] = b.normalAngle() >= Math.PI ? 0 : (float) Math.sin(b.normalAngle());
        nodes[at + SPREAD] = (float) Math.cos(b.spread()) - ROUNDING;
        nodes[at + INTENSITY] = Math.max((float) (b.intensity() / scale), Float.MIN_NORMAL);
    }

    /** Half of an interval, wide enough for what rounding does to its centre. */
    private static float half(double from, double to) {
        return (float) (0.5 * (to - from) * (1 + ROUNDING) + ROUNDING * Math.max(Math.abs(from), Math.abs(to)));
    }

    private int[] frontier(int most) {
        int[] found = new int[most];
        int size = 1;
        boolean grown = true;
        while (grown && size < most) {
            grown = false;
            int before = size;
            for (int i = 0; i < before && size < most; i++) {
                int first = child[found[i]];
                if (first >= 0) {
                    found[i] = first;
                    found[size++] = first + 1;
                    grown = true;
                }
            }
        }
        return Arrays.copyOf(found, size);
    }

    /** Bounds of all emitters; null if none has intensity. */
    public @Nullable EmissionBounds bounds() {
        return bounds;
    }

    /** True if no emitter has intensity. */
    public boolean isEmpty() {
        return child.length == 0;
    }

    /** Number of emitters that have intensity: positions run below it. */
    public int size() {
        return order.length;
    }

    /**
     * Chooses a leaf.
     *
     * @param nx normal at the point, or the zero vector where there is none
     * @param u uniform number in [0,1)
     * @param dest receives the probability of the leaf and a number in [0,1) that is uniform again
     * @return the leaf, or -1 if no emitter can contribute
     */
    public int choose(double px, double py, double pz, double nx, double ny, double nz, double u, double[] dest) {
        if (child.length == 0) {
            return -1;
        }
        double left = u;
        double probability = 1;
        int node = 0;
        int first = child[0];
        while (first >= 0) {
            double a = importance(first, px, py, pz, nx, ny, nz);
            double b = importance(first + 1, px, py, pz, nx, ny, nz);
            double sum = a + b;
            if (!(sum > 0)) {
                return -1;
            }
            double share = a / sum;
            if (left < share) {
                left /= share;
                probability *= share;
                node = first;
            } else {
                left = (left - share) / (1 - share);
                probability *= b / sum;
                node = first + 1;
            }
            first = child[node];
        }
        dest[0] = probability;
        dest[1] = Math.min(left, Math.nextDown(1.0));
        return node;
    }

    /** Leaf of an emitter; -1 if it has no intensity. */
    public int leafOf(int emitter) {
        return leafOf[emitter];
    }

    /** Probability with which {@link #choose} returns a leaf at a point. */
    public double probability(int leaf, double px, double py, double pz, double nx, double ny, double nz) {
        double probability = 1;
        long way = trail[leaf];
        int first = child[0];
        while (first >= 0) {
            double a = importance(first, px, py, pz, nx, ny, nz);
            double b = importance(first + 1, px, py, pz, nx, ny, nz);
            int turn = (int) (way & 1);
            double own = turn == 0 ? a : b;
            if (!(own > 0)) {
                return 0;
            }
            probability *= own / (a + b);
            first = child[first + turn];
            way >>>= 1;
        }
        return probability;
    }

    /** First position of a leaf. */
    public int leafStart(int leaf) {
        return ~child[leaf];
    }

    /** Number of emitters in a leaf; they have successive positions. */
    public int leafSize(int leaf) {
        return leafSize[leaf];
    }

    /** The emitter at a position. */
    public int emitter(int position) {
        return order[position];
    }

    /** Estimate of what all emitters together contribute to a point: irradiance, or fluence for a zero normal. */
    public double importance(double px, double py, double pz, double nx, double ny, double nz) {
        double sum = 0;
        for (int node : frontier) {
            sum += importance(node, px, py, pz, nx, ny, nz);
        }
        return scale * sum;
    }

    /**
     * Estimate for a node: intensity over squared distance of the centre, times bounds of the emitter's and the receiver's
     * cosine (as in sections 4.1 and 5.1 of the paper). The bounds are those of the box and not of a sphere about it: how high
     * the box reaches above a plane, over its distance. So rows and ceilings of lamps are not taken for balls of lamps.
     */
    private double importance(int node, double px, double py, double pz, double nx, double ny, double nz) {
        int at = STRIDE * node;
        double dx = nodes[at] - px;
        double dy = nodes[at + 1] - py;
        double dz = nodes[at + 2] - pz;
        double ex = nodes[at + HALF];
        double ey = nodes[at + HALF + 1];
        double ez = nodes[at + HALF + 2];
        double gapX = Math.max(0, Math.abs(dx) - ex);
        double gapY = Math.max(0, Math.abs(dy) - ey);
        double gapZ = Math.max(0, Math.abs(dz) - ez);
        double gap = Math.sqrt(gapX * gapX + gapY * gapY + gapZ * gapZ);
        double squaredDistance = dx * dx + dy * dy + dz * dz;
        double squaredRadius = ex * ex + ey * ey + ez * ez;
        double value = nodes[at + INTENSITY] / Math.max(squaredDistance, squaredRadius);
        if (nodes[at + CONE] > -1) {
            double ax = nodes[at + AXIS];
            double ay = nodes[at + AXIS + 1];
            double az = nodes[at + AXIS + 2];
            double height = Math.abs(ax) * ex + Math.abs(ay) * ey + Math.abs(az) * ez - (dx * ax + dy * ay + dz * az);
            double cosine = height >= gap
                    ? 1
                    : height > 0 ? height / gap : height / (Math.sqrt(squaredDistance) + Math.sqrt(squaredRadius));
            cosine = cosineLess(cosine, nodes[at + CONE], nodes[at + CONE + 1]);
            if (cosine < nodes[at + SPREAD]) {
                return 0;
            }
            value *= Math.max(cosine, LEAST_COSINE);
        }
        if (nx != 0 || ny != 0 || nz != 0) {
            double height = Math.abs(nx) * ex + Math.abs(ny) * ey + Math.abs(nz) * ez + dx * nx + dy * ny + dz * nz;
            if (!(height > 0)) {
                return 0;
            }
            if (height < gap) {
                value *= height / gap;
            }
        }
        return Math.min(LARGEST, value);
    }

    /** Cosine of max(0, θ − α), given the cosine of θ and cosine and sine of α. */
    private static double cosineLess(double cosTheta, double cosAlpha, double sinAlpha) {
        return cosTheta >= cosAlpha
                ? 1
                : cosTheta * cosAlpha + Math.sqrt(Math.max(0, 1 - cosTheta * cosTheta)) * sinAlpha;
    }
}
