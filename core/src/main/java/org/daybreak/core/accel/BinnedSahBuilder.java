package org.daybreak.core.accel;

import java.util.Arrays;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveTask;
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
    private static final int FORK_SIZE = 4096;

    private static final int MAX_BINS = 16;

    /** Beyond this depth ranges are halved by number, which bounds the depth by this plus 27. */
    private static final int MAX_SAH_DEPTH = 48;

    private final PrimitiveRecords records;
    private final float[] data;
    private final int leafWidth;
    private final int triangleCount;
    private final boolean onlyTriangles;

    private BinnedSahBuilder(PrimitiveRecords records, int leafWidth) {
        this.records = records;
        this.data = records.data;
        this.leafWidth = leafWidth;
        this.triangleCount = records.set.triangleCount();
        this.onlyTriangles = records.set.quadricCount() + records.set.instanceCount() == 0;
    }

    /**
     * Builds the tree and sorts the records into the order of its leaves.
     *
     * @return the root, or null if there are no records
     */
    static @Nullable BinaryNode build(PrimitiveRecords records, int leafWidth, int threads) {
        if (records.count == 0) {
            return null;
        }
        BinnedSahBuilder builder = new BinnedSahBuilder(records, leafWidth);
        BinaryNode root = new BinaryNode();
        root.start = 0;
        root.count = records.count;
        if (threads <= 1 || records.count < FORK_SIZE) {
            builder.subdivide(root, 0, new Scratch(), false);
            return root;
        }
        ForkJoinPool pool = new ForkJoinPool(threads);
        try {
            pool.invoke(builder.new Task(root, 0));
        } finally {
            pool.shutdown();
        }
        return root;
    }

    private final class Task extends RecursiveTask<BinaryNode> {
        private static final long serialVersionUID = 1L;
        private final transient BinaryNode node;
        private final int depth;

        Task(BinaryNode node, int depth) {
            this.node = node;
            this.depth = depth;
        }

        @Override
        protected BinaryNode compute() {
            subdivide(node, depth, new Scratch(), true);
            return node;
        }
    }

    /** Bins of one node; reused from node to node within a task. */
    private static final class Scratch {
        /** For each axis and bin: minimum x, y, z, unused, maximum x, y, z, unused. */
        final float[] boxes = new float[3 * MAX_BINS * 8];

        final int[] counts = new int[3 * MAX_BINS];
        final float[] rightArea = new float[MAX_BINS];
        final int[] rightCount = new int[MAX_BINS];
        final float[] centroids = new float[6];
        int splitAxis;
        int splitBin;
    }

    private void subdivide(BinaryNode node, int depth, Scratch scratch, boolean fork) {
        fit(node, scratch);
        int others = onlyTriangles ? 0 : countOthers(node);
        boolean homogeneous = others == 0 || others == node.count;
        int leafMaximum = others == 0 ? leafWidth : 1;
        if (homogeneous && node.count <= leafMaximum) {
            return;
        }
        int middle;
        if (!homogeneous && node.count - others <= leafWidth) {
            middle = partitionByKind(node);
        } else if (depth >= MAX_SAH_DEPTH || !findSplit(node, scratch)) {
            middle = node.start + node.count / 2;
        } else {
            middle = partition(node, scratch);
        }
        BinaryNode left = new BinaryNode();
        left.start = node.start;
        left.count = middle - node.start;
        BinaryNode right = new BinaryNode();
        right.start = middle;
        right.count = node.count - left.count;
        node.left = left;
        node.right = right;
        if (fork && node.count >= FORK_SIZE) {
            Task task = new Task(left, depth + 1);
            task.fork();
            subdivide(right, depth + 1, scratch, true);
            task.join();
        } else {
            subdivide(left, depth + 1, scratch, false);
            subdivide(right, depth + 1, scratch, false);
        }
    }

    private int countOthers(BinaryNode node) {
        int others = 0;
        for (int i = node.start; i < node.start + node.count; i++) {
            if (records.number(i) >= triangleCount) {
                others++;
            }
        }
        return others;
    }

    /** Bounds of the node, and of (twice) the centroids in it. */
    private void fit(BinaryNode node, Scratch scratch) {
        float minX = Float.POSITIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float minZ = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        float maxZ = Float.NEGATIVE_INFINITY;
        float lowX = Float.POSITIVE_INFINITY;
        float lowY = Float.POSITIVE_INFINITY;
        float lowZ = Float.POSITIVE_INFINITY;
        float highX = Float.NEGATIVE_INFINITY;
        float highY = Float.NEGATIVE_INFINITY;
        float highZ = Float.NEGATIVE_INFINITY;
        float[] d = data;
        int end = PrimitiveRecords.STRIDE * (node.start + node.count);
        for (int i = PrimitiveRecords.STRIDE * node.start; i < end; i += PrimitiveRecords.STRIDE) {
            float x0 = d[i];
            float y0 = d[i + 1];
            float z0 = d[i + 2];
            float x1 = d[i + 4];
            float y1 = d[i + 5];
            float z1 = d[i + 6];
            minX = x0 < minX ? x0 : minX;
            minY = y0 < minY ? y0 : minY;
            minZ = z0 < minZ ? z0 : minZ;
            maxX = x1 > maxX ? x1 : maxX;
            maxY = y1 > maxY ? y1 : maxY;
            maxZ = z1 > maxZ ? z1 : maxZ;
            float cx = x0 + x1;
            float cy = y0 + y1;
            float cz = z0 + z1;
            lowX = cx < lowX ? cx : lowX;
            lowY = cy < lowY ? cy : lowY;
            lowZ = cz < lowZ ? cz : lowZ;
            highX = cx > highX ? cx : highX;
            highY = cy > highY ? cy : highY;
            highZ = cz > highZ ? cz : highZ;
        }
        node.minX = minX;
        node.minY = minY;
        node.minZ = minZ;
        node.maxX = maxX;
        node.maxY = maxY;
        node.maxZ = maxZ;
        scratch.centroids[0] = lowX;
        scratch.centroids[1] = lowY;
        scratch.centroids[2] = lowZ;
        scratch.centroids[3] = highX;
        scratch.centroids[4] = highY;
        scratch.centroids[5] = highZ;
    }

    /** Finds the cheapest of the planes between bins; false if all centroids coincide. */
    private boolean findSplit(BinaryNode node, Scratch scratch) {
        int bins = Math.min(MAX_BINS, 4 + node.count / 16);
        float[] low = scratch.centroids;
        bin(node, scratch, bins);
        float best = Float.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            if (!(low[axis + 3] > low[axis])) {
                continue;
            }
            best = sweep(scratch, axis, bins, best);
        }
        return best < Float.POSITIVE_INFINITY;
    }

    private static float binFactor(float low, float high, int bins) {
        float extent = high - low;
        float factor = bins * (1 - 0x1p-20f) / extent;
        return extent > 0 && factor < Float.POSITIVE_INFINITY ? factor : 0;
    }

    private void bin(BinaryNode node, Scratch scratch, int bins) {
        float[] boxes = scratch.boxes;
        int[] counts = scratch.counts;
        for (int i = 0; i < 3 * MAX_BINS * 8; i += 8) {
            boxes[i] = Float.POSITIVE_INFINITY;
            boxes[i + 1] = Float.POSITIVE_INFINITY;
            boxes[i + 2] = Float.POSITIVE_INFINITY;
            boxes[i + 4] = Float.NEGATIVE_INFINITY;
            boxes[i + 5] = Float.NEGATIVE_INFINITY;
            boxes[i + 6] = Float.NEGATIVE_INFINITY;
        }
        Arrays.fill(counts, 0);
        float[] c = scratch.centroids;
        float lowX = c[0];
        float lowY = c[1];
        float lowZ = c[2];
        float factorX = binFactor(lowX, c[3], bins);
        float factorY = binFactor(lowY, c[4], bins);
        float factorZ = binFactor(lowZ, c[5], bins);
        float[] d = data;
        int end = PrimitiveRecords.STRIDE * (node.start + node.count);
        for (int i = PrimitiveRecords.STRIDE * node.start; i < end; i += PrimitiveRecords.STRIDE) {
            float x0 = d[i];
            float y0 = d[i + 1];
            float z0 = d[i + 2];
            float x1 = d[i + 4];
            float y1 = d[i + 5];
            float z1 = d[i + 6];
            int binX = (int) ((x0 + x1 - lowX) * factorX);
            int binY = MAX_BINS + (int) ((y0 + y1 - lowY) * factorY);
            int binZ = 2 * MAX_BINS + (int) ((z0 + z1 - lowZ) * factorZ);
            counts[binX]++;
            counts[binY]++;
            counts[binZ]++;
            extend(boxes, 8 * binX, x0, y0, z0, x1, y1, z1);
            extend(boxes, 8 * binY, x0, y0, z0, x1, y1, z1);
            extend(boxes, 8 * binZ, x0, y0, z0, x1, y1, z1);
        }
    }

    /** Branches are better than min and max here: boxes soon stop growing, so they are all predicted. */
    private static void extend(float[] boxes, int at, float x0, float y0, float z0, float x1, float y1, float z1) {
        if (x0 < boxes[at]) {
            boxes[at] = x0;
        }
        if (y0 < boxes[at + 1]) {
            boxes[at + 1] = y0;
        }
        if (z0 < boxes[at + 2]) {
            boxes[at + 2] = z0;
        }
        if (x1 > boxes[at + 4]) {
            boxes[at + 4] = x1;
        }
        if (y1 > boxes[at + 5]) {
            boxes[at + 5] = y1;
        }
        if (z1 > boxes[at + 6]) {
            boxes[at + 6] = z1;
        }
    }

    private float sweep(Scratch scratch, int axis, int bins, float bestSoFar) {
        float[] boxes = scratch.boxes;
        int[] counts = scratch.counts;
        float[] rightArea = scratch.rightArea;
        int[] rightCount = scratch.rightCount;
        float best = bestSoFar;
        float minX = Float.POSITIVE_INFINITY;
        float minY = Float.POSITIVE_INFINITY;
        float minZ = Float.POSITIVE_INFINITY;
        float maxX = Float.NEGATIVE_INFINITY;
        float maxY = Float.NEGATIVE_INFINITY;
        float maxZ = Float.NEGATIVE_INFINITY;
        int count = 0;
        for (int bin = bins - 1; bin > 0; bin--) {
            int at = 8 * (axis * MAX_BINS + bin);
            minX = boxes[at] < minX ? boxes[at] : minX;
            minY = boxes[at + 1] < minY ? boxes[at + 1] : minY;
            minZ = boxes[at + 2] < minZ ? boxes[at + 2] : minZ;
            maxX = boxes[at + 4] > maxX ? boxes[at + 4] : maxX;
            maxY = boxes[at + 5] > maxY ? boxes[at + 5] : maxY;
            maxZ = boxes[at + 6] > maxZ ? boxes[at + 6] : maxZ;
            count += counts[axis * MAX_BINS + bin];
            float x = maxX - minX;
            float y = maxY - minY;
            float z = maxZ - minZ;
            rightArea[bin] = x * (y + z) + y * z;
            rightCount[bin] = count;
        }
        minX = Float.POSITIVE_INFINITY;
        minY = Float.POSITIVE_INFINITY;
        minZ = Float.POSITIVE_INFINITY;
        maxX = Float.NEGATIVE_INFINITY;
        maxY = Float.NEGATIVE_INFINITY;
        maxZ = Float.NEGATIVE_INFINITY;
        count = 0;
        for (int bin = 1; bin < bins; bin++) {
            int at = 8 * (axis * MAX_BINS + bin - 1);
            minX = boxes[at] < minX ? boxes[at] : minX;
            minY = boxes[at + 1] < minY ? boxes[at + 1] : minY;
            minZ = boxes[at + 2] < minZ ? boxes[at + 2] : minZ;
            maxX = boxes[at + 4] > maxX ? boxes[at + 4] : maxX;
            maxY = boxes[at + 5] > maxY ? boxes[at + 5] : maxY;
            maxZ = boxes[at + 6] > maxZ ? boxes[at + 6] : maxZ;
            count += counts[axis * MAX_BINS + bin - 1];
            if (count == 0 || rightCount[bin] == 0) {
                continue;
            }
            float x = maxX - minX;
            float y = maxY - minY;
            float z = maxZ - minZ;
            float cost = (x * (y + z) + y * z) * blocks(count) + rightArea[bin] * blocks(rightCount[bin]);
            if (cost < best) {
                best = cost;
                scratch.splitAxis = axis;
                scratch.splitBin = bin;
            }
        }
        return best;
    }

    private int blocks(int count) {
        return (count + leafWidth - 1) / leafWidth;
    }

    private int partition(BinaryNode node, Scratch scratch) {
        int axis = scratch.splitAxis;
        int bins = Math.min(MAX_BINS, 4 + node.count / 16);
        float low = scratch.centroids[axis];
        float factor = binFactor(low, scratch.centroids[axis + 3], bins);
        int splitBin = scratch.splitBin;
        float[] d = data;
        int left = PrimitiveRecords.STRIDE * node.start;
        int right = PrimitiveRecords.STRIDE * (node.start + node.count - 1);
        while (true) {
            while (left <= right && (int) ((d[left + axis] + d[left + 4 + axis] - low) * factor) < splitBin) {
                left += PrimitiveRecords.STRIDE;
            }
            while (left <= right && (int) ((d[right + axis] + d[right + 4 + axis] - low) * factor) >= splitBin) {
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
            while (left <= right && records.number(left) < triangleCount) {
                left++;
            }
            while (left <= right && records.number(right) >= triangleCount) {
                right--;
            }
            if (left >= right) {
                return left;
            }
            swap(PrimitiveRecords.STRIDE * left, PrimitiveRecords.STRIDE * right);
        }
    }

    private void swap(int a, int b) {
        float[] d = data;
        for (int k = 0; k < PrimitiveRecords.STRIDE; k++) {
            float t = d[a + k];
            d[a + k] = d[b + k];
            d[b + k] = t;
        }
    }
}
