package org.daybreak.core.accel;

import java.util.Arrays;
import java.util.concurrent.RecursiveAction;
import org.jspecify.annotations.Nullable;

/**
 * Builds a binary tree top-down with the binned surface area heuristic (Wald, "On fast Construction of SAH-based
 * Bounding Volume Hierarchies", 2007). Leaves are homogeneous: up to {@code leafWidth} triangles, whose cost counts in
 * whole blocks of that width, or one quadric or instance.
 *
 * <p>Every decision depends on the records of a node only, so the tree is the same for any number of threads.
 */
final class BinnedSahBuilder {
    /** Ranges smaller than this are built by one thread. */
    private static final int FORK_SIZE = 1 << 12;

    /** Ranges of at least twice this size are binned by several threads. */
    private static final int BIN_GRAIN = 1 << 16;

    private static final int MAX_BINS = 32;

    /** Ints of one bin: minimum x, y, z, number of records, maximum x, y, z, unused. */
    private static final int BIN = 8;

    /** Where in the bins those of the next axis start. */
    private static final int AXIS = MAX_BINS * BIN;

    /** Beyond this depth ranges are halved by number, which bounds the depth by this plus 27. */
    private static final int MAX_SAH_DEPTH = 48;

    private final PrimitiveRecords records;
    private final int[] data;
    private final int leafWidth;
    private final boolean onlyTriangles;

    private BinnedSahBuilder(PrimitiveRecords records, int leafWidth) {
        this.records = records;
        this.data = records.data;
        this.leafWidth = leafWidth;
        this.onlyTriangles = records.set.quadricCount() + records.set.instanceCount() == 0;
    }

    /**
     * Builds the tree, sorts the records into the order of its leaves, and computes the bounds of all nodes.
     *
     * @return the root, or null if there are no records
     */
    static @Nullable BinaryNode build(PrimitiveRecords records, int leafWidth) {
        if (records.count == 0) {
            return null;
        }
        BinnedSahBuilder builder = new BinnedSahBuilder(records, leafWidth);
        BinaryNode root = new BinaryNode(0, records.count);
        builder.subdivide(root, 0, new Scratch(), ForkJoinRange.isParallel());
        return root;
    }

    private final class Subdivision extends RecursiveAction {
        private static final long serialVersionUID = 1L;
        private final transient BinaryNode node;
        private final int depth;

        Subdivision(BinaryNode node, int depth) {
            this.node = node;
            this.depth = depth;
        }

        @Override
        protected void compute() {
            subdivide(node, depth, new Scratch(), true);
        }
    }

    /** What is known of one node; reused from node to node within a task. */
    private static final class Scratch {
        final int[] bins = new int[3 * AXIS];

        /** Least and greatest sum of the minimum and maximum along each axis: twice the centre of the box. */
        final int[] centres = new int[6];

        final double[] rightArea = new double[MAX_BINS];
        final int[] rightCount = new int[MAX_BINS];
        final float[] box = new float[6];
        int splitAxis;
        int splitBin;
    }

    private void subdivide(BinaryNode node, int depth, Scratch scratch, boolean fork) {
        int others = onlyTriangles ? 0 : countOthers(node);
        boolean homogeneous = others == 0 || others == node.count;
        if (homogeneous && node.count <= (others == 0 ? leafWidth : 1)) {
            node.fit(records, scratch.box);
            return;
        }
        int middle;
        if (!homogeneous && node.count - others <= leafWidth) {
            middle = partitionByKind(node);
        } else if (depth >= MAX_SAH_DEPTH || !findSplit(node, scratch, fork)) {
            middle = node.start + node.count / 2;
        } else {
            middle = partition(node, scratch);
        }
        node.split(middle);
        if (fork && node.count >= FORK_SIZE) {
            Subdivision left = new Subdivision(node.left(), depth + 1);
            left.fork();
            subdivide(node.right(), depth + 1, scratch, true);
            left.join();
        } else {
            subdivide(node.left(), depth + 1, scratch, false);
            subdivide(node.right(), depth + 1, scratch, false);
        }
        node.unite();
    }

    private int countOthers(BinaryNode node) {
        int others = 0;
        for (int i = node.start; i < node.start + node.count; i++) {
            if (!records.isTriangle(i)) {
                others++;
            }
        }
        return others;
    }

    private static int binCount(int count) {
        return Math.min(MAX_BINS, 4 + count / 16);
    }

    /** Finds the cheapest of the planes between bins; false if all centres coincide. */
    private boolean findSplit(BinaryNode node, Scratch scratch, boolean fork) {
        int end = node.start + node.count;
        int bins = binCount(node.count);
        if (fork && node.count >= 2 * BIN_GRAIN) {
            spanCentresInParallel(node, scratch);
            clear(scratch.bins);
            int[] centres = scratch.centres;
            ForkJoinRange.run(node.count, BIN_GRAIN, (from, to) -> {
                int[] part = new int[3 * AXIS];
                clear(part);
                bin(node.start + from, node.start + to, centres, part, bins);
                synchronized (scratch) {
                    merge(part, scratch.bins);
                }
            });
        } else {
            spanCentres(node.start, end, scratch.centres);
            clear(scratch.bins);
            bin(node.start, end, scratch.centres, scratch.bins, bins);
        }
        double best = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            if (scratch.centres[axis + 3] > scratch.centres[axis]) {
                best = sweep(scratch, axis, bins, best);
            }
        }
        return best < Double.POSITIVE_INFINITY;
    }

    private void spanCentresInParallel(BinaryNode node, Scratch scratch) {
        int[] whole = scratch.centres;
        Arrays.fill(whole, 0, 3, Integer.MAX_VALUE);
        Arrays.fill(whole, 3, 6, Integer.MIN_VALUE);
        ForkJoinRange.run(node.count, BIN_GRAIN, (from, to) -> {
            int[] part = new int[6];
            spanCentres(node.start + from, node.start + to, part);
            synchronized (scratch) {
                for (int axis = 0; axis < 3; axis++) {
                    whole[axis] = Math.min(whole[axis], part[axis]);
                    whole[axis + 3] = Math.max(whole[axis + 3], part[axis + 3]);
                }
            }
        });
    }

    private void spanCentres(int start, int end, int[] centres) {
        int lowX = Integer.MAX_VALUE;
        int lowY = Integer.MAX_VALUE;
        int lowZ = Integer.MAX_VALUE;
        int highX = Integer.MIN_VALUE;
        int highY = Integer.MIN_VALUE;
        int highZ = Integer.MIN_VALUE;
        int[] d = data;
        for (int i = PrimitiveRecords.STRIDE * start; i < PrimitiveRecords.STRIDE * end; i += PrimitiveRecords.STRIDE) {
            int x = d[i] + d[i + 4];
            int y = d[i + 1] + d[i + 5];
            int z = d[i + 2] + d[i + 6];
            lowX = Math.min(lowX, x);
            lowY = Math.min(lowY, y);
            lowZ = Math.min(lowZ, z);
            highX = Math.max(highX, x);
            highY = Math.max(highY, y);
            highZ = Math.max(highZ, z);
        }
        centres[0] = lowX;
        centres[1] = lowY;
        centres[2] = lowZ;
        centres[3] = highX;
        centres[4] = highY;
        centres[5] = highZ;
    }

    private static void clear(int[] bins) {
        for (int i = 0; i < 3 * AXIS; i += BIN) {
            bins[i] = Integer.MAX_VALUE;
            bins[i + 1] = Integer.MAX_VALUE;
            bins[i + 2] = Integer.MAX_VALUE;
            bins[i + 3] = 0;
            bins[i + 4] = Integer.MIN_VALUE;
            bins[i + 5] = Integer.MIN_VALUE;
            bins[i + 6] = Integer.MIN_VALUE;
        }
    }

    private static void merge(int[] from, int[] to) {
        for (int i = 0; i < 3 * AXIS; i += BIN) {
            to[i + 3] += from[i + 3];
            for (int axis = 0; axis < 3; axis++) {
                to[i + axis] = Math.min(to[i + axis], from[i + axis]);
                to[i + 4 + axis] = Math.max(to[i + 4 + axis], from[i + 4 + axis]);
            }
        }
    }

    /** A centre c is in the bin {@code ((c - low) * factor) >>> 32}, which is less than the number of bins. */
    private static long binFactor(int low, int high, int bins) {
        return ((long) bins << 32) / ((long) high - low + 1);
    }

    private void bin(int start, int end, int[] centres, int[] bins, int binCount) {
        int lowX = centres[0];
        int lowY = centres[1];
        int lowZ = centres[2];
        long factorX = binFactor(lowX, centres[3], binCount);
        long factorY = binFactor(lowY, centres[4], binCount);
        long factorZ = binFactor(lowZ, centres[5], binCount);
        int[] d = data;
        for (int i = PrimitiveRecords.STRIDE * start; i < PrimitiveRecords.STRIDE * end; i += PrimitiveRecords.STRIDE) {
            int x0 = d[i];
            int y0 = d[i + 1];
            int z0 = d[i + 2];
            int x1 = d[i + 4];
            int y1 = d[i + 5];
            int z1 = d[i + 6];
            int binX = (int) (((x0 + x1 - lowX) * factorX) >>> 32);
            int binY = (int) (((y0 + y1 - lowY) * factorY) >>> 32);
            int binZ = (int) (((z0 + z1 - lowZ) * factorZ) >>> 32);
            extend(bins, BIN * binX, x0, y0, z0, x1, y1, z1);
            extend(bins, AXIS + BIN * binY, x0, y0, z0, x1, y1, z1);
            extend(bins, 2 * AXIS + BIN * binZ, x0, y0, z0, x1, y1, z1);
        }
    }

    private static void extend(int[] bins, int at, int x0, int y0, int z0, int x1, int y1, int z1) {
        bins[at] = Math.min(bins[at], x0);
        bins[at + 1] = Math.min(bins[at + 1], y0);
        bins[at + 2] = Math.min(bins[at + 2], z0);
        bins[at + 3]++;
        bins[at + 4] = Math.max(bins[at + 4], x1);
        bins[at + 5] = Math.max(bins[at + 5], y1);
        bins[at + 6] = Math.max(bins[at + 6], z1);
    }

    private double sweep(Scratch scratch, int axis, int binCount, double bestSoFar) {
        int[] bins = scratch.bins;
        double[] rightArea = scratch.rightArea;
        int[] rightCount = scratch.rightCount;
        double best = bestSoFar;
        int minX = Integer.MAX_VALUE;
        int minY = Integer.MAX_VALUE;
        int minZ = Integer.MAX_VALUE;
        int maxX = Integer.MIN_VALUE;
        int maxY = Integer.MIN_VALUE;
        int maxZ = Integer.MIN_VALUE;
        int count = 0;
        for (int bin = binCount - 1; bin > 0; bin--) {
            int at = axis * AXIS + bin * BIN;
            minX = Math.min(minX, bins[at]);
            minY = Math.min(minY, bins[at + 1]);
            minZ = Math.min(minZ, bins[at + 2]);
            count += bins[at + 3];
            maxX = Math.max(maxX, bins[at + 4]);
            maxY = Math.max(maxY, bins[at + 5]);
            maxZ = Math.max(maxZ, bins[at + 6]);
            rightArea[bin] = halfArea(minX, minY, minZ, maxX, maxY, maxZ);
            rightCount[bin] = count;
        }
        minX = Integer.MAX_VALUE;
        minY = Integer.MAX_VALUE;
        minZ = Integer.MAX_VALUE;
        maxX = Integer.MIN_VALUE;
        maxY = Integer.MIN_VALUE;
        maxZ = Integer.MIN_VALUE;
        count = 0;
        for (int bin = 1; bin < binCount; bin++) {
            int at = axis * AXIS + (bin - 1) * BIN;
            minX = Math.min(minX, bins[at]);
            minY = Math.min(minY, bins[at + 1]);
            minZ = Math.min(minZ, bins[at + 2]);
            count += bins[at + 3];
            maxX = Math.max(maxX, bins[at + 4]);
            maxY = Math.max(maxY, bins[at + 5]);
            maxZ = Math.max(maxZ, bins[at + 6]);
            if (count == 0 || rightCount[bin] == 0) {
                continue;
            }
            double cost = halfArea(minX, minY, minZ, maxX, maxY, maxZ) * blocks(count)
                    + rightArea[bin] * blocks(rightCount[bin]);
            if (cost < best) {
                best = cost;
                scratch.splitAxis = axis;
                scratch.splitBin = bin;
            }
        }
        return best;
    }

    private static double halfArea(int minX, int minY, int minZ, int maxX, int maxY, int maxZ) {
        double x = (double) maxX - minX;
        double y = (double) maxY - minY;
        double z = (double) maxZ - minZ;
        return x * (y + z) + y * z;
    }

    private int blocks(int count) {
        return (count + leafWidth - 1) / leafWidth;
    }

    private int partition(BinaryNode node, Scratch scratch) {
        int axis = scratch.splitAxis;
        int low = scratch.centres[axis];
        // The least centre of the bin at which the right side starts.
        long factor = binFactor(low, scratch.centres[axis + 3], binCount(node.count));
        long split = low + (((long) scratch.splitBin << 32) + factor - 1) / factor;
        int[] d = data;
        int left = PrimitiveRecords.STRIDE * node.start;
        int right = PrimitiveRecords.STRIDE * (node.start + node.count - 1);
        while (true) {
            while (left <= right && d[left + axis] + d[left + 4 + axis] < split) {
                left += PrimitiveRecords.STRIDE;
            }
            while (left <= right && d[right + axis] + d[right + 4 + axis] >= split) {
                right -= PrimitiveRecords.STRIDE;
            }
            if (left >= right) {
                return left / PrimitiveRecords.STRIDE;
            }
            swap(left, right);
            left += PrimitiveRecords.STRIDE;
            right -= PrimitiveRecords.STRIDE;
        }
    }

    /** Moves the triangles before the other primitives. */
    private int partitionByKind(BinaryNode node) {
        int left = node.start;
        int right = node.start + node.count - 1;
        while (true) {
            while (left <= right && records.isTriangle(left)) {
                left++;
            }
            while (left <= right && !records.isTriangle(right)) {
                right--;
            }
            if (left >= right) {
                return left;
            }
            swap(PrimitiveRecords.STRIDE * left, PrimitiveRecords.STRIDE * right);
        }
    }

    private void swap(int a, int b) {
        int[] d = data;
        for (int k = 0; k < PrimitiveRecords.STRIDE; k++) {
            int t = d[a + k];
            d[a + k] = d[b + k];
            d[b + k] = t;
        }
    }
}
