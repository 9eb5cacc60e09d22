package org.daybreak.core.accel;

import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * Binary BVH traversed with scalar code: runs anywhere, and is what the vector kernels are checked against.
 *
 * <p>A node is a run of 16 floats: six bounds of the left child, six of the right one (minimum x, y, z, maximum x, y,
 * z), two child references as int bits, two unused. A reference ≥ 0 is the offset of an inner node; a negative one is
 * {@code ~leaf}, see {@link #triangleLeaf} and {@link #otherLeaf}. A triangle is a run of nine floats: three vertices.
 */
final class ScalarIntersector implements Intersector {
    static final int LEAF_WIDTH = 4;
    private static final int NODE = 16;
    private static final int TRIANGLE = 9;

    /** A leaf with no triangles. */
    private static final int EMPTY = Integer.MIN_VALUE;

    private final float[] nodes;
    private final float[] triangles;
    private final int[] triangleNumbers;
    private final OtherPrimitives others;
    private final int root;
    private final int stackSize;
    private final double scale;
    private final float[] bounds;
    private final int primitiveCount;

    private ScalarIntersector(Layout layout, PrimitiveRecords records) {
        nodes = layout.nodes;
        triangles = layout.triangles;
        triangleNumbers = layout.numbers;
        others = new OtherPrimitives(records.set);
        root = layout.root;
        stackSize = layout.depth + 2;
        scale = records.scale;
        bounds = records.bounds;
        primitiveCount = records.set.size();
    }

    static ScalarIntersector build(PrimitiveSet set, int threads) {
        return ForkJoinRange.inPool(threads, () -> {
            PrimitiveRecords records = new PrimitiveRecords(set);
            try {
                return new ScalarIntersector(new Layout(records, BinnedSahBuilder.build(records, LEAF_WIDTH)), records);
            } catch (ArithmeticException e) {
                throw new IllegalArgumentException("too many primitives for one index: " + set.size(), e);
            }
        });
    }

    private static int triangleLeaf(int start, int count) {
        return ~(start << 4 | (count - 1) << 1);
    }

    private static int otherLeaf(int index) {
        return ~(index << 1 | 1);
    }

    /** Writes nodes depth-first, left child next to its parent. */
    private static final class Layout {
        final float[] nodes;
        final float[] triangles;
        final int[] numbers;
        final int root;
        int depth;
        private final PrimitiveRecords records;
        private final int triangleCount;
        private int nodeEnd;
        private int triangleEnd;

        Layout(PrimitiveRecords records, @Nullable BinaryNode tree) {
            this.records = records;
            triangleCount = records.set.triangleCount();
            nodes = new float[Math.multiplyExact(NODE, tree == null ? 0 : innerNodes(tree))];
            int kept = 0;
            for (int i = 0; i < records.count; i++) {
                if (records.isTriangle(i)) {
                    kept++;
                }
            }
            triangles = new float[Math.multiplyExact(TRIANGLE, kept)];
            numbers = new int[kept];
            root = tree == null ? EMPTY : write(tree, 1);
        }

        private static int innerNodes(BinaryNode node) {
            return node.isLeaf() ? 0 : 1 + innerNodes(node.left()) + innerNodes(node.right());
        }

        private int write(BinaryNode node, int level) {
            depth = Math.max(depth, level);
            if (node.isLeaf()) {
                return writeLeaf(node);
            }
            BinaryNode left = node.left();
            BinaryNode right = node.right();
            int at = nodeEnd;
            nodeEnd += NODE;
            writeBox(at, left);
            writeBox(at + 6, right);
            nodes[at + 12] = Float.intBitsToFloat(write(left, level + 1));
            nodes[at + 13] = Float.intBitsToFloat(write(right, level + 1));
            return at;
        }

        private int writeLeaf(BinaryNode node) {
            if (!records.isTriangle(node.start)) {
                return otherLeaf(records.number(node.start) - triangleCount);
            }
            int start = triangleEnd;
            float[] positions = records.set.positions();
            int[] corners = records.set.triangles();
            for (int i = 0; i < node.count; i++) {
                int number = records.number(node.start + i);
                numbers[triangleEnd] = number;
                for (int corner = 0; corner < 3; corner++) {
                    int vertex = 3 * corners[3 * number + corner];
                    for (int axis = 0; axis < 3; axis++) {
                        triangles[TRIANGLE * triangleEnd + 3 * corner + axis] =
                                records.scaled(positions[vertex + axis]);
                    }
                }
                triangleEnd++;
            }
            return triangleLeaf(start, node.count);
        }

        private void writeBox(int at, BinaryNode node) {
            float margin = BoxWidening.margin(node.maxX - node.minX, node.maxY - node.minY, node.maxZ - node.minZ);
            nodes[at] = BoxWidening.down(node.minX, margin);
            nodes[at + 1] = BoxWidening.down(node.minY, margin);
            nodes[at + 2] = BoxWidening.down(node.minZ, margin);
            nodes[at + 3] = BoxWidening.up(node.maxX, margin);
            nodes[at + 4] = BoxWidening.up(node.maxY, margin);
            nodes[at + 5] = BoxWidening.up(node.maxZ, margin);
        }
    }

    @Override
    public boolean intersect(Ray ray) {
        return traverse(ray, false);
    }

    @Override
    public boolean occluded(Ray ray) {
        return traverse(ray, true);
    }

    private boolean traverse(Ray ray, boolean any) {
        ray.primitive = -1;
        ray.instance = -1;
        ray.t = ray.tMax;
        if (root == EMPTY) {
            return false;
        }
        PreparedRay p = ray.prepare(scale);
        float[] n = nodes;
        long[] stack = ray.stack(stackSize);
        float ix = p.inverseX;
        float iy = p.inverseY;
        float iz = p.inverseZ;
        float nx = p.nearX;
        float ny = p.nearY;
        float nz = p.nearZ;
        float fx = p.farX;
        float fy = p.farY;
        float fz = p.farZ;
        int sx = ix < 0 ? 3 : 0;
        int sy = iy < 0 ? 4 : 1;
        int sz = iz < 0 ? 5 : 2;
        int ex = 3 - sx;
        int ey = 5 - sy;
        int ez = 7 - sz;
        float best = p.tMax;
        int bestTriangle = -1;
        boolean found = false;
        int sp = 0;
        int reference = root;
        while (true) {
            if (reference >= 0) {
                int at = reference;
                float near0 = Math.max(
                        Math.max(n[at + sx] * ix + nx, n[at + sy] * iy + ny), Math.max(n[at + sz] * iz + nz, 0));
                float far0 = Math.min(
                        Math.min(n[at + ex] * ix + fx, n[at + ey] * iy + fy), Math.min(n[at + ez] * iz + fz, best));
                float near1 = Math.max(
                        Math.max(n[at + 6 + sx] * ix + nx, n[at + 6 + sy] * iy + ny),
                        Math.max(n[at + 6 + sz] * iz + nz, 0));
                float far1 = Math.min(
                        Math.min(n[at + 6 + ex] * ix + fx, n[at + 6 + ey] * iy + fy),
                        Math.min(n[at + 6 + ez] * iz + fz, best));
                boolean hit0 = near0 <= far0 * RAISE;
                boolean hit1 = near1 <= far1 * RAISE;
                int ref0 = Float.floatToRawIntBits(n[at + 12]);
                int ref1 = Float.floatToRawIntBits(n[at + 13]);
                if (hit0) {
                    reference = ref0;
                    if (hit1) {
                        if (near1 < near0) {
                            reference = ref1;
                            stack[sp++] = (long) Float.floatToRawIntBits(near0) << 32 | (ref0 & 0xffffffffL);
                        } else {
                            stack[sp++] = (long) Float.floatToRawIntBits(near1) << 32 | (ref1 & 0xffffffffL);
                        }
                    }
                    continue;
                }
                if (hit1) {
                    reference = ref1;
                    continue;
                }
            } else {
                int leaf = ~reference;
                if ((leaf & 1) != 0) {
                    double tMax = found ? ray.t : ray.tMax;
                    if (any) {
                        if (others.occluded(ray, leaf >> 1, tMax)) {
                            return true;
                        }
                    } else if (others.intersect(ray, leaf >> 1, tMax)) {
                        found = true;
                        bestTriangle = -1;
                        best = (float) (ray.t * p.fromParameter);
                    }
                } else {
                    int first = leaf >> 4;
                    int end = first + (leaf >> 1 & 7) + 1;
                    for (int i = first; i < end; i++) {
                        float t = triangle(p, i);
                        if (t > 0 && t < best) {
                            if (any) {
                                return true;
                            }
                            best = t;
                            bestTriangle = i;
                            found = true;
                            ray.t = t * p.toParameter;
                        }
                    }
                }
            }
            do {
                if (sp == 0) {
                    if (bestTriangle >= 0) {
                        ray.primitive = triangleNumbers[bestTriangle];
                        ray.instance = -1;
                    }
                    return found;
                }
                long entry = stack[--sp];
                reference = (int) entry;
                if (Float.intBitsToFloat((int) (entry >>> 32)) <= best) {
                    break;
                }
            } while (true);
        }
    }

    private static final float RAISE = 1 + PreparedRay.ULPS * 0x1p-23f;

    /** T of the hit with a triangle, NaN or anything not positive if there is none. */
    private float triangle(PreparedRay p, int index) {
        float[] v = triangles;
        int at = TRIANGLE * index;
        int u = at + p.axisU;
        int w = at + p.axisW;
        int k = at + p.axisV;
        float ou = p.originU;
        float ov = p.originV;
        float ow = p.originW;
        float su = p.shearU;
        float sv = p.shearV;
        float aw = v[w] - ow;
        float bw = v[w + 3] - ow;
        float cw = v[w + 6] - ow;
        float au = v[u] - ou - su * aw;
        float av = v[k] - ov - sv * aw;
        float bu = v[u + 3] - ou - su * bw;
        float bv = v[k + 3] - ov - sv * bw;
        float cu = v[u + 6] - ou - su * cw;
        float cv = v[k + 6] - ov - sv * cw;
        float ea = cu * bv - cv * bu;
        float eb = au * cv - av * cu;
        float ec = bu * av - bv * au;
        if ((ea < 0 || eb < 0 || ec < 0) && (ea > 0 || eb > 0 || ec > 0)) {
            return -1;
        }
        float inverse = 1 / (ea + eb + ec);
        return (ea * inverse * aw + eb * inverse * bw + ec * inverse * cw) * p.sign;
    }

    @Override
    public void bounds(float[] target) {
        System.arraycopy(bounds, 0, target, 0, 6);
    }

    @Override
    public String describe() {
        return String.format(Locale.ROOT, "bvh2 scalar, %d primitives, %.1f MB", primitiveCount, memoryBytes() / 1e6);
    }

    @Override
    public long memoryBytes() {
        return 4L * nodes.length + 4L * triangles.length + 4L * triangleNumbers.length + others.memoryBytes();
    }
}
