package org.daybreak.core.accel;

import java.util.Arrays;
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

    /** Subtrees of at least this many primitives are laid out by several threads. */
    private static final int FORK_SIZE = 1 << 14;

    private final int width;
    private final float[] data;
    private final int blockStart;
    private final int[] numbers;
    private final OtherPrimitives others;
    private final double scale;
    private final float[] bounds;
    private final int triangleCount;
    private final int root;
    private final int depth;

    private WideBvh(int width, PrimitiveRecords records, @Nullable BinaryNode tree) {
        this.width = width;
        scale = records.scale;
        others = new OtherPrimitives(records.set);
        bounds = records.bounds;
        triangleCount = records.set.triangleCount();
        depth = tree == null ? 0 : gather(tree, records, new BinaryNode[width]);
        int nodeCount = tree == null ? 0 : tree.wideNodes;
        int blockCount = tree == null ? 0 : tree.blocks;
        blockStart = Math.addExact(START, Math.multiplyExact(7 * width, nodeCount));
        data = new float[Math.addExact(blockStart, Math.multiplyExact(9 * width, blockCount))];
        numbers = new int[width * blockCount];
        root = tree == null ? EMPTY : write(tree, records, START, blockStart);
    }

    /**
     * Builds the tree and lays it out.
     *
     * @param width number of lanes
     * @throws IllegalArgumentException if a coordinate is not finite, a vertex index is out of range, or the set is too
     *     large
     */
    public static WideBvh build(PrimitiveSet set, int width, int threads) {
        return ForkJoinRange.inPool(set.size() < FORK_SIZE ? 1 : threads, () -> {
            PrimitiveRecords records = new PrimitiveRecords(set);
            try {
                return new WideBvh(width, records, BinnedSahBuilder.build(records, width));
            } catch (ArithmeticException e) {
                throw new IllegalArgumentException("too many primitives for one index: " + set.size(), e);
            }
        });
    }

    /**
     * Gathers the children of wide nodes, opening the child of largest area until there are as many as fit, and counts
     * nodes and blocks.
     *
     * @param scratch room for the children of one node
     * @return depth of the tree
     */
    private int gather(BinaryNode node, PrimitiveRecords records, BinaryNode[] scratch) {
        if (node.isLeaf()) {
            node.blocks = records.isTriangle(node.start) ? 1 : 0;
            return 1;
        }
        scratch[0] = node.left();
        scratch[1] = node.right();
        int count = 2;
        while (count < width) {
            int largest = -1;
            float area = Float.NEGATIVE_INFINITY;
            for (int i = 0; i < count; i++) {
                if (!scratch[i].isLeaf() && scratch[i].halfArea() > area) {
                    area = scratch[i].halfArea();
                    largest = i;
                }
            }
            if (largest < 0) {
                break;
            }
            BinaryNode opened = scratch[largest];
            scratch[largest] = opened.left();
            scratch[count++] = opened.right();
        }
        BinaryNode[] children = Arrays.copyOf(scratch, count);
        node.wideChildren = children;
        int[] depths = new int[count];
        if (node.count >= FORK_SIZE) {
            ForkJoinRange.run(count, 1, (from, to) -> {
                BinaryNode[] own = new BinaryNode[width];
                for (int i = from; i < to; i++) {
                    depths[i] = gather(children[i], records, own);
                }
            });
        } else {
            for (int i = 0; i < count; i++) {
                depths[i] = gather(children[i], records, scratch);
            }
        }
        node.wideNodes = 1;
        int deepest = 0;
        for (int i = 0; i < count; i++) {
            node.wideNodes += children[i].wideNodes;
            node.blocks += children[i].blocks;
            deepest = Math.max(deepest, depths[i]);
        }
        return 1 + deepest;
    }

    /**
     * Writes a subtree.
     *
     * @param at offset of its first node
     * @param block offset of its first block
     * @return reference to it
     */
    private int write(BinaryNode node, PrimitiveRecords records, int at, int block) {
        BinaryNode[] children = node.wideChildren;
        if (children == null) {
            if (!records.isTriangle(node.start)) {
                return ~((records.number(node.start) - triangleCount) << 1 | 1);
            }
            writeBlock(node, records, block);
            return ~block;
        }
        int n = children.length;
        int[] nodeOffsets = new int[n];
        int[] blockOffsets = new int[n];
        int nextNode = at + 7 * width;
        int nextBlock = block;
        for (int i = 0; i < n; i++) {
            writeBox(at + i, children[i]);
            nodeOffsets[i] = nextNode;
            blockOffsets[i] = nextBlock;
            nextNode += 7 * width * children[i].wideNodes;
            nextBlock += 9 * width * children[i].blocks;
        }
        for (int i = n; i < width; i++) {
            for (int plane = 0; plane < 6; plane++) {
                data[at + plane * width + i] = plane < 3 ? Float.POSITIVE_INFINITY : Float.NEGATIVE_INFINITY;
            }
        }
        ForkJoinRange.Body body = (from, to) -> {
            for (int i = from; i < to; i++) {
                int reference = write(children[i], records, nodeOffsets[i], blockOffsets[i]);
                data[at + 6 * width + i] = Float.intBitsToFloat(reference);
            }
        };
        if (node.count >= FORK_SIZE) {
            ForkJoinRange.run(n, 1, body);
        } else {
            body.run(0, n);
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

    private void writeBlock(BinaryNode node, PrimitiveRecords records, int block) {
        int first = triangle(block);
        Arrays.fill(numbers, first + node.count, first + width, -1);
        float[] positions = records.set.positions();
        int[] corners = records.set.triangles();
        for (int lane = 0; lane < node.count; lane++) {
            int number = records.number(node.start + lane);
            numbers[first + lane] = number;
            int at = block + lane;
            for (int corner = 0; corner < 3; corner++) {
                int vertex = 3 * corners[3 * number + corner];
                for (int axis = 0; axis < 3; axis++) {
                    data[at] = records.scaled(positions[vertex + axis]);
                    at += width;
                }
            }
        }
    }

    /** Nodes and blocks; see the class comment. */
    public float[] data() {
        return data;
    }

    private int triangle(int block) {
        return (block - blockStart) / 9;
    }

    /** Number in the set of the triangle in a lane of a block. */
    int number(int block, int lane) {
        return numbers[triangle(block) + lane];
    }

    /** Number of lanes in use; they come first. */
    int laneCount(int block) {
        int first = triangle(block);
        int count = 1;
        while (count < width && numbers[first + count] >= 0) {
            count++;
        }
        return count;
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

    /**
     * Inserts an entry into a traversal stack so that the nearest child of a node is on top. An entry has the distance's int
     * bits above the reference.
     *
     * @param bottom where the entries of this node begin
     * @param end where the stack ends
     * @return the new end
     */
    public static int insert(long[] stack, int bottom, int end, long entry) {
        int slot = end;
        while (slot > bottom && stack[slot - 1] < entry) {
            stack[slot] = stack[slot - 1];
            slot--;
        }
        stack[slot] = entry;
        return end + 1;
    }

    /**
     * Writes a hit with a triangle to the result fields of a ray.
     *
     * @param p the ray as it was prepared
     * @param bits int bits of the distance T
     */
    public void report(Ray ray, PreparedRay p, int bits, int block, int lane) {
        ray.t = p.parameter(Float.intBitsToFloat(bits));
        ray.primitive = number(block, lane);
        ray.instance = -1;
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
