package org.daybreak.accel.vector;

import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.OtherPrimitives;
import org.daybreak.core.accel.PreparedRay;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.accel.WideBvh;

/**
 * Traversal of a {@link WideBvh} step by step as the vector kernels do it, with the same roundings and in the same order,
 * but one lane at a time. It answers while the kernels are not compiled, and gives the same bits, so that an image does
 * not depend on when they are.
 */
final class ColdTraversal implements Intersector {
    private static final long REFERENCE = 0xffffffffL;

    private final WideBvh bvh;
    private final float[] data;
    private final OtherPrimitives others;
    private final int width;

    ColdTraversal(WideBvh bvh, int width) {
        this.bvh = bvh;
        this.width = width;
        data = bvh.data();
        others = bvh.others();
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
        if (bvh.root() == WideBvh.EMPTY) {
            return false;
        }
        PreparedRay p = ray.prepare(bvh.scale());
        float[] d = data;
        int w = width;
        long[] stack = ray.stack(bvh.stackSize());
        float ix = p.inverseX;
        float iy = p.inverseY;
        float iz = p.inverseZ;
        float nx = p.nearX;
        float ny = p.nearY;
        float nz = p.nearZ;
        float fx = p.farX;
        float fy = p.farY;
        float fz = p.farZ;
        int nearX = p.nearPlanesX(w);
        int nearY = p.nearPlanesY(w);
        int nearZ = p.nearPlanesZ(w);
        int farX = 3 * w - nearX;
        int farY = 5 * w - nearY;
        int farZ = 7 * w - nearZ;
        int best = Float.floatToRawIntBits(p.tMax);
        int bestBlock = 0;
        int bestLane = -1;
        boolean found = false;
        int sp = 0;
        int reference = bvh.root();
        while (true) {
            if (reference >= 0) {
                int at = reference;
                int bottom = sp;
                for (int lane = 0; lane < w; lane++) {
                    int near = Math.max(
                            Math.max(
                                    Float.floatToRawIntBits(Math.fma(d[at + nearX + lane], ix, nx)),
                                    Float.floatToRawIntBits(Math.fma(d[at + nearY + lane], iy, ny))),
                            Math.max(Float.floatToRawIntBits(Math.fma(d[at + nearZ + lane], iz, nz)), 0));
                    int far = Math.min(
                            Math.min(
                                    Float.floatToRawIntBits(Math.fma(d[at + farX + lane], ix, fx)),
                                    Float.floatToRawIntBits(Math.fma(d[at + farY + lane], iy, fy))),
                            Math.min(Float.floatToRawIntBits(Math.fma(d[at + farZ + lane], iz, fz)), best));
                    if (near <= far + PreparedRay.ULPS) {
                        long entry = (long) near << 32 | (Float.floatToRawIntBits(d[at + 6 * w + lane]) & REFERENCE);
                        sp = WideBvh.insert(stack, bottom, sp, entry);
                    }
                }
                if (sp > bottom) {
                    reference = (int) stack[--sp];
                    continue;
                }
            } else if ((reference & 1) != 0) {
                int block = ~reference;
                for (int lane = 0; lane < w; lane++) {
                    int t = triangle(block + lane, p);
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
    private int triangle(int at, PreparedRay p) {
        float[] d = data;
        int u = at + width * p.axisU;
        int v = at + width * p.axisV;
        int w = at + width * p.axisW;
        int next = 3 * width;
        float aw = d[w] - p.originW;
        float bw = d[w + next] - p.originW;
        float cw = d[w + 2 * next] - p.originW;
        float au = Math.fma(aw, -p.shearU, d[u] - p.originU);
        float av = Math.fma(aw, -p.shearV, d[v] - p.originV);
        float bu = Math.fma(bw, -p.shearU, d[u + next] - p.originU);
        float bv = Math.fma(bw, -p.shearV, d[v + next] - p.originV);
        float cu = Math.fma(cw, -p.shearU, d[u + 2 * next] - p.originU);
        float cv = Math.fma(cw, -p.shearV, d[v + 2 * next] - p.originV);
        float ea = cu * bv - cv * bu;
        float eb = au * cv - av * cu;
        float ec = bu * av - bv * au;
        // Outside with or without the division; it is the dearest operation here.
        if (Math.min(ea, Math.min(eb, ec)) < 0 && Math.max(ea, Math.max(eb, ec)) > 0) {
            return -1;
        }
        float inverse = 1 / (ea + eb + ec);
        float wa = Math.fma(ea, inverse, 0f);
        float wb = Math.fma(eb, inverse, 0f);
        float wc = Math.fma(ec, inverse, 0f);
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
        return "bvh" + width + " one lane at a time";
    }

    @Override
    public long memoryBytes() {
        return bvh.memoryBytes();
    }
}
