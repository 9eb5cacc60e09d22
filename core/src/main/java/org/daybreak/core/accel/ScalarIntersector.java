package org.daybreak.core.accel;

import java.util.Locale;

/**
 * Scalar traversal of a {@link WideBvh} with four children: runs anywhere, and is what the vector kernels are checked
 * against. Four was faster than two (by a quarter), as fast as six and faster than eight.
 *
 * <p>Distances are compared as int bits, as in the vector kernels: with {@code Math.min} and {@code max} of floats the
 * same traversal took a quarter longer.
 */
final class ScalarIntersector implements Intersector {
    private static final int W = 4;
    private static final long REFERENCE = 0xffffffffL;

    private final WideBvh bvh;
    private final float[] data;
    private final OtherPrimitives others;
    private final int root;
    private final int stackSize;
    private final double scale;

    private ScalarIntersector(WideBvh bvh) {
        this.bvh = bvh;
        data = bvh.data();
        others = bvh.others();
        root = bvh.root();
        stackSize = bvh.stackSize();
        scale = bvh.scale();
    }

    static ScalarIntersector build(PrimitiveSet set, int threads) {
        return new ScalarIntersector(WideBvh.build(set, W, threads));
    }

    @Override
    public boolean intersect(Ray ray) {
        return traverse(ray, false);
    }

    @Override
    public boolean occluded(Ray ray) {
        return traverse(ray, true);
    }

    /** Finds the closest hit, or with {@code any} only whether there is one. */
    private boolean traverse(Ray ray, boolean any) {
        if (!any) {
            ray.primitive = -1;
            ray.instance = -1;
            ray.t = ray.tMax;
        }
        if (root == WideBvh.EMPTY) {
            return false;
        }
        PreparedRay p = ray.prepare(scale);
        float[] d = data;
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
        int nearX = p.nearPlanesX(W);
        int nearY = p.nearPlanesY(W);
        int nearZ = p.nearPlanesZ(W);
        int farX = 3 * W - nearX;
        int farY = 5 * W - nearY;
        int farZ = 7 * W - nearZ;
        int best = Float.floatToRawIntBits(p.tMax);
        int bestBlock = 0;
        int bestLane = -1;
        boolean found = false;
        int sp = 0;
        int reference = root;
        while (true) {
            if (reference >= 0) {
                int at = reference;
                int bottom = sp;
                for (int lane = 0; lane < W; lane++) {
                    int near = Math.max(
                            Math.max(
                                    Float.floatToRawIntBits(d[at + nearX + lane] * ix + nx),
                                    Float.floatToRawIntBits(d[at + nearY + lane] * iy + ny)),
                            Math.max(Float.floatToRawIntBits(d[at + nearZ + lane] * iz + nz), 0));
                    int far = Math.min(
                            Math.min(
                                    Float.floatToRawIntBits(d[at + farX + lane] * ix + fx),
                                    Float.floatToRawIntBits(d[at + farY + lane] * iy + fy)),
                            Math.min(Float.floatToRawIntBits(d[at + farZ + lane] * iz + fz), best));
                    if (near <= far + PreparedRay.ULPS) {
                        long entry = (long) near << 32 | (Float.floatToRawIntBits(d[at + 6 * W + lane]) & REFERENCE);
                        if (any) {
                            // Whichever hit comes first will do, and sorting costs a quarter of such queries.
                            stack[sp++] = entry;
                        } else {
                            sp = WideBvh.insert(stack, bottom, sp, entry);
                        }
                    }
                }
                if (sp > bottom) {
                    reference = (int) stack[--sp];
                    continue;
                }
            } else if ((reference & 1) != 0) {
                int block = ~reference;
                int lanes = bvh.laneCount(block);
                for (int lane = 0; lane < lanes; lane++) {
                    int t = triangle(d, block + lane, p);
                    if (t > 0 && t < best) {
                        if (any) {
                            return true;
                        }
                        best = t;
                        bestBlock = block;
                        bestLane = lane;
                        found = true;
                    }
                }
            } else if (any) {
                if (others.occluded(ray, ~reference >> 1, ray.tMax)) {
                    return true;
                }
            } else {
                double tMax = bestLane >= 0 ? p.parameter(Float.intBitsToFloat(best)) : found ? ray.t : ray.tMax;
                if (others.intersect(ray, ~reference >> 1, tMax)) {
                    found = true;
                    bestLane = -1;
                    best = Float.floatToRawIntBits(p.distance(ray.t));
                }
            }
            long entry;
            do {
                if (sp == 0) {
                    if (bestLane >= 0) {
                        bvh.report(ray, p, best, bestBlock, bestLane);
                    }
                    return found;
                }
                entry = stack[--sp];
                reference = (int) entry;
            } while ((int) (entry >>> 32) > best);
        }
    }

    /** Bits of T of the hit with a triangle; negative if there is none. */
    private static int triangle(float[] d, int at, PreparedRay p) {
        int u = at + W * p.axisU;
        int v = at + W * p.axisV;
        int w = at + W * p.axisW;
        float ou = p.originU;
        float ov = p.originV;
        float ow = p.originW;
        float su = p.shearU;
        float sv = p.shearV;
        float aw = d[w] - ow;
        float bw = d[w + 3 * W] - ow;
        float cw = d[w + 6 * W] - ow;
        float au = d[u] - ou - su * aw;
        float av = d[v] - ov - sv * aw;
        float bu = d[u + 3 * W] - ou - su * bw;
        float bv = d[v + 3 * W] - ov - sv * bw;
        float cu = d[u + 6 * W] - ou - su * cw;
        float cv = d[v + 6 * W] - ov - sv * cw;
        float ea = cu * bv - cv * bu;
        float eb = au * cv - av * cu;
        float ec = bu * av - bv * au;
        float inverse = 1 / (ea + eb + ec);
        // The sum with zero turns -0 into +0, so that the sign bit tells inside from outside.
        float wa = ea * inverse + 0f;
        float wb = eb * inverse + 0f;
        float wc = ec * inverse + 0f;
        int t = Float.floatToRawIntBits((wa * aw + wb * bw + wc * cw) * p.inverseW);
        int signs = Float.floatToRawIntBits(wa) | Float.floatToRawIntBits(wb) | Float.floatToRawIntBits(wc);
        return signs < 0 ? -1 : t;
    }

    @Override
    public void bounds(float[] target) {
        bvh.bounds(target);
    }

    @Override
    public String describe() {
        return String.format(
                Locale.ROOT, "bvh%d scalar, %d triangles, %.1f MB", W, bvh.triangleCount(), memoryBytes() / 1e6);
    }

    @Override
    public long memoryBytes() {
        return bvh.memoryBytes();
    }
}
