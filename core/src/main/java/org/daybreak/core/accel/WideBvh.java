package org.daybreak.core.accel;

import org.jspecify.annotations.Nullable;

/**
 * Layout of a BVH with W children for each node and blocks of W triangles, as vector kernels of W lanes read it: one
 * array of floats with all nodes, then all blocks.
 *
 * <ul>
 *   <li>A node is a run of 7 W floats: minimum x of the W children, then minimum y, z, maximum x, y, z, then the child
 *       references as int bits. Unused children have the minimum +∞ and the maximum −∞.
 *   <li>A block is a run of 9 W floats: x of the first vertex of W triangles, then its y, z, then the second and the third
 *       vertex. Unused lanes hold zeros, which no ray hits.
 *   <li>A reference ≥ 0 is the offset of a node. A negative one is {@code ~leaf}: if {@code leaf} is even it is the offset
 *       of a block; if it is odd, {@code leaf >> 1} is the number of one of the {@link #others}.
 * </ul>
 *
 * <p>The data start at offset {@link #START}. Together with the 16 bytes of an array's header that makes 64, so that no
 * vector straddles two cache lines if the array itself is aligned to a line; G1 does that for every array of at least half
 * a region, and {@code -XX:ObjectAlignmentInBytes=64} for all. Measured to be worth 6 to 8 per cent.
 *
 * <p>The array is shared with the kernels and must not be written to.
 */
public final class WideBvh {
    /** Root reference of an index without primitives: a block that does not exist. */
    public static final int EMPTY = Integer.MIN_VALUE;

    /** Offset of the first node or block. */
    public static final int START = 12;

    private final int width;
    private final float[] data;
    private final int blockStart;
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
        blockStart = Math.addExact(START, Math.multiplyExact(7 * width, counts[0]));
        data = new float[Math.addExact(blockStart, Math.multiplyExact(9 * width, counts[1]))];
        numbers = new int[width * counts[1]];
        nodeEnd = START;
        blockEnd = blockStart;
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
                    ? ~writeBlock(node, records)
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
                data[at + plane * width + i] = plane < 3 ? Float.POSITIVE_INFINITY : Float.NEGATIVE_INFINITY;
            }
        }
        for (int i = 0; i < n; i++) {
            data[at + 6 * width + i] = Float.intBitsToFloat(write(children[i], records, level + 1));
        }
        return at;
    }

    private void writeBox(int at, BinaryNode node) {
        float margin = BoxWidening.margin(node.maxX - node.minX, node.maxY - node.minY, node.maxZ - node.minZ);
        data[at] = BoxWidening.down(node.minX, margin);
        data[at + width] = BoxWidening.down(node.minY, margin);
        data[at + 2 * width] = BoxWidening.down(node.minZ, margin);
        data[at + 3 * width] = BoxWidening.up(node.maxX, margin);
        data[at + 4 * width] = BoxWidening.up(node.maxY, margin);
        data[at + 5 * width] = BoxWidening.up(node.maxZ, margin);
    }

    private int writeBlock(BinaryNode node, PrimitiveRecords records) {
        int block = blockEnd;
        blockEnd += 9 * width;
        int first = triangle(block);
        float[] positions = records.set.positions();
        int[] corners = records.set.triangles();
        for (int lane = 0; lane < node.count; lane++) {
            int number = records.number(node.start + lane);
            numbers[first + lane] = number;
            int at = block + lane;
            for (int corner = 0; corner < 3; corner++) {
                int vertex = 3 * corners[3 * number + corner];
                for (int axis = 0; axis < 3; axis++) {
                    data[at] = PrimitiveRecords.scaled(positions[vertex + axis], scale);
                    at += width;
                }
            }
        }
        return block;
    }

    /** Nodes and blocks; see the class comment. */
    public float[] data() {
        return data;
    }

    private int triangle(int block) {
        return (block - blockStart) / 9;
    }

    /**
     * Number of a triangle in the set.
     *
     * @param block offset of its block
     * @param lane where in the block it is
     */
    public int number(int block, int lane) {
        return numbers[triangle(block) + lane];
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
        return 4L * data.length + 4L * numbers.length + others.memoryBytes();
    }
}
