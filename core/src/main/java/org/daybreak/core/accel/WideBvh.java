package org.daybreak.core.accel;

import org.jspecify.annotations.Nullable;

/**
 * Layout of a BVH with W children for each node and blocks of W triangles, as vector kernels of W lanes read it.
 *
 * <ul>
 *   <li>{@link #nodes}: a node is a run of 7 W floats: minimum x of the W children, then minimum y, z, maximum x, y, z,
 *       then the child references as int bits. Unused children have the minimum +∞ and the maximum −∞.
 *   <li>A reference ≥ 0 is the offset of an inner node. A negative one is {@code ~leaf}: if the lowest bit of {@code
 *       leaf} is 0, {@code leaf >> 1} is the number of a block; if it is 1, that of one of the {@link #others}.
 *   <li>{@link #blocks}: a block is a run of 9 W floats: x of the first vertex of W triangles, then its y, z, then the
 *       second and the third vertex. Unused lanes hold zeros, which no ray hits.
 *   <li>{@link #numbers}: W triangle numbers for each block.
 * </ul>
 *
 * <p>The arrays are shared with the kernels and must not be written to.
 */
public final class WideBvh {
    /** Root reference of an index without primitives: a block that does not exist. */
    public static final int EMPTY = Integer.MIN_VALUE;

    private final int width;
    private final float[] nodes;
    private final float[] blocks;
    private final int[] numbers;
    private final OtherPrimitives others;
    private final double scale;
    private final float[] bounds;
    private final int triangleCount;
    private int root;
    private int nodeEnd;
    private int blockEnd;
    private int depth;

    private WideBvh(int width, PrimitiveRecords records, @Nullable BinaryNode tree) {
        this.width = width;
        scale = records.scale;
        others = new OtherPrimitives(records.set);
        bounds = new float[6];
        for (int i = 0; i < 6; i++) {
            bounds[i] = (float) (records.bounds[i] / scale);
        }
        triangleCount = records.set.triangleCount();
        int[] counts = new int[2];
        if (tree != null) {
            count(tree, records, counts);
        }
        nodes = new float[Math.multiplyExact(7 * width, counts[0])];
        blocks = new float[Math.multiplyExact(9 * width, counts[1])];
        numbers = new int[width * counts[1]];
        root = tree == null ? EMPTY : write(tree, records, 1);
    }

    /**
     * Builds the tree and lays it out.
     *
     * @param width number of lanes
     * @throws IllegalArgumentException if a coordinate is not finite, a vertex index is out of range, or the set is too
     *     large
     */
    public static WideBvh build(PrimitiveSet set, int width, int threads) {
        PrimitiveRecords records = PrimitiveRecords.of(set);
        try {
            return new WideBvh(width, records, BinnedSahBuilder.build(records, width, threads));
        } catch (ArithmeticException e) {
            throw new IllegalArgumentException("too many primitives for one index: " + set.size(), e);
        }
    }

    private boolean isTriangle(BinaryNode node, PrimitiveRecords records) {
        return records.number(node.start) < triangleCount;
    }

    /** Children of a wide node: opens the child of largest area until there are as many as fit. */
    private int gather(BinaryNode node, BinaryNode[] children) {
        children[0] = node.left();
        children[1] = node.right();
        int count = 2;
        while (count < width) {
            int largest = -1;
            float area = Float.NEGATIVE_INFINITY;
            for (int i = 0; i < count; i++) {
                if (!children[i].isLeaf() && children[i].halfArea() > area) {
                    area = children[i].halfArea();
                    largest = i;
                }
            }
            if (largest < 0) {
                break;
            }
            BinaryNode opened = children[largest];
            children[largest] = opened.left();
            children[count++] = opened.right();
        }
        return count;
    }

    private void count(BinaryNode node, PrimitiveRecords records, int[] counts) {
        if (node.isLeaf()) {
            if (isTriangle(node, records)) {
                counts[1]++;
            }
            return;
        }
        counts[0]++;
        BinaryNode[] children = new BinaryNode[width];
        int n = gather(node, children);
        for (int i = 0; i < n; i++) {
            count(children[i], records, counts);
        }
    }

    private int write(BinaryNode node, PrimitiveRecords records, int level) {
        depth = Math.max(depth, level);
        if (node.isLeaf()) {
            return isTriangle(node, records)
                    ? ~(writeBlock(node, records) << 1)
                    : ~((records.number(node.start) - triangleCount) << 1 | 1);
        }
        int at = nodeEnd;
        nodeEnd += 7 * width;
        BinaryNode[] children = new BinaryNode[width];
        int n = gather(node, children);
        for (int i = 0; i < n; i++) {
            writeBox(at + i, children[i]);
        }
        for (int i = n; i < width; i++) {
            for (int plane = 0; plane < 6; plane++) {
                nodes[at + plane * width + i] = plane < 3 ? Float.POSITIVE_INFINITY : Float.NEGATIVE_INFINITY;
            }
        }
        for (int i = 0; i < n; i++) {
            nodes[at + 6 * width + i] = Float.intBitsToFloat(write(children[i], records, level + 1));
        }
        return at;
    }

    private void writeBox(int at, BinaryNode node) {
        float margin = BoxWidening.margin(node.maxX - node.minX, node.maxY - node.minY, node.maxZ - node.minZ);
        nodes[at] = BoxWidening.down(node.minX, margin);
        nodes[at + width] = BoxWidening.down(node.minY, margin);
        nodes[at + 2 * width] = BoxWidening.down(node.minZ, margin);
        nodes[at + 3 * width] = BoxWidening.up(node.maxX, margin);
        nodes[at + 4 * width] = BoxWidening.up(node.maxY, margin);
        nodes[at + 5 * width] = BoxWidening.up(node.maxZ, margin);
    }

    private int writeBlock(BinaryNode node, PrimitiveRecords records) {
        int block = blockEnd++;
        float[] positions = records.set.positions();
        int[] corners = records.set.triangles();
        for (int lane = 0; lane < node.count; lane++) {
            int number = records.number(node.start + lane);
            numbers[width * block + lane] = number;
            int at = 9 * width * block + lane;
            for (int corner = 0; corner < 3; corner++) {
                int vertex = 3 * corners[3 * number + corner];
                for (int axis = 0; axis < 3; axis++) {
                    blocks[at] = PrimitiveRecords.scaled(positions[vertex + axis], scale);
                    at += width;
                }
            }
        }
        return block;
    }

    /** Node storage; see the class comment. */
    public float[] nodes() {
        return nodes;
    }

    /** Triangle storage; see the class comment. */
    public float[] blocks() {
        return blocks;
    }

    /** Triangle numbers of the lanes of all blocks. */
    public int[] numbers() {
        return numbers;
    }

    /** The primitives that are no triangles. */
    public OtherPrimitives others() {
        return others;
    }

    /** Reference of the root, or {@link #EMPTY}. */
    public int root() {
        return root;
    }

    /** Number of entries that the traversal stack must hold: all but one child on each level. */
    public int stackSize() {
        return (width - 1) * depth + 1;
    }

    /** Factor by which coordinates were multiplied; a power of two. */
    public double scale() {
        return scale;
    }

    /** Number of triangles in the set. */
    public int triangleCount() {
        return triangleCount;
    }

    /** Writes the bounds as {@link Intersector#bounds} does. */
    public void bounds(float[] target) {
        System.arraycopy(bounds, 0, target, 0, 6);
    }

    /** Heap memory held, in bytes. */
    public long memoryBytes() {
        return 4L * nodes.length + 4L * blocks.length + 4L * numbers.length + others.memoryBytes();
    }
}
