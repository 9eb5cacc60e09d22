package org.daybreak.accel.vector;

import java.util.Locale;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.OtherPrimitives;
import org.daybreak.core.accel.PreparedRay;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.accel.WideBvh;
import org.jspecify.annotations.Nullable;

/**
 * Traversal of a {@link WideBvh} with 512-bit vectors. Species must be constants of the kernel, so there is one class for
 * each width. The widest is written by hand; the build makes the other from it by replacing the number of bits
 * (docs/decisions/0011).
 *
 * <p>A query is one method without calls that take or return vectors: those would box them. It is the same method for both
 * kinds of query: compiled once, it is fast earlier. Distances are compared as
 * int bits, which order like the floats as long as one side is not negative; the float minimum of Java costs five
 * instructions.
 */
final class Vector512Intersector implements Intersector {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_512;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_512;
    private static final int W = FLOATS.length();
    private static final long REFERENCE = 0xffffffffL;

    private final WideBvh bvh;
    private final float[] data;
    private final OtherPrimitives others;
    private final int root;
    private final int stackSize;
    private final double scale;

    /** Null in the one that is used to warm up. */
    private final @Nullable WarmUp warmUp;

    private final ColdTraversal cold;

    private Vector512Intersector(WideBvh bvh, @Nullable WarmUp warmUp) {
        this.bvh = bvh;
        this.warmUp = warmUp;
        cold = new ColdTraversal(bvh, W);
        data = bvh.data();
        others = bvh.others();
        root = bvh.root();
        stackSize = bvh.stackSize();
        scale = bvh.scale();
    }

    static Intersector build(PrimitiveSet set, int threads, WarmUp warmUp) {
        return new Vector512Intersector(WideBvh.build(set, W, threads), warmUp);
    }

    /** Starts to get this kernel compiled. */
    static WarmUp warmUp() {
        return new WarmUp("vector512", W, bvh -> new Vector512Intersector(bvh, null));
    }

    @Override
    public boolean intersect(Ray ray) {
        return usesKernel() ? traverse(ray, false) : cold.intersect(ray);
    }

    @Override
    public boolean occluded(Ray ray) {
        return usesKernel() ? traverse(ray, true) : cold.occluded(ray);
    }

    private boolean usesKernel() {
        return warmUp == null || warmUp.isReady();
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
        int[] lanes = ray.lanes;
        FloatVector ix = FloatVector.broadcast(FLOATS, p.inverseX);
        FloatVector iy = FloatVector.broadcast(FLOATS, p.inverseY);
        FloatVector iz = FloatVector.broadcast(FLOATS, p.inverseZ);
        FloatVector nx = FloatVector.broadcast(FLOATS, p.nearX);
        FloatVector ny = FloatVector.broadcast(FLOATS, p.nearY);
        FloatVector nz = FloatVector.broadcast(FLOATS, p.nearZ);
        FloatVector fx = FloatVector.broadcast(FLOATS, p.farX);
        FloatVector fy = FloatVector.broadcast(FLOATS, p.farY);
        FloatVector fz = FloatVector.broadcast(FLOATS, p.farZ);
        int nearX = p.nearPlanesX(W);
        int nearY = p.nearPlanesY(W);
        int nearZ = p.nearPlanesZ(W);
        int farX = 3 * W - nearX;
        int farY = 5 * W - nearY;
        int farZ = 7 * W - nearZ;
        int axisU = W * p.axisU;
        int axisV = W * p.axisV;
        int axisW = W * p.axisW;
        FloatVector ou = FloatVector.broadcast(FLOATS, p.originU);
        FloatVector ov = FloatVector.broadcast(FLOATS, p.originV);
        FloatVector ow = FloatVector.broadcast(FLOATS, p.originW);
        FloatVector su = FloatVector.broadcast(FLOATS, -p.shearU);
        FloatVector sv = FloatVector.broadcast(FLOATS, -p.shearV);
        int best = Float.floatToRawIntBits(p.tMax);
        int bestBlock = 0;
        int bestLane = -1;
        boolean found = false;
        int sp = 0;
        int reference = root;
        while (true) {
            if (reference >= 0) {
                int at = reference;
                IntVector near = FloatVector.fromArray(FLOATS, d, at + nearX)
                        .fma(ix, nx)
                        .reinterpretAsInts()
                        .max(FloatVector.fromArray(FLOATS, d, at + nearY)
                                .fma(iy, ny)
                                .reinterpretAsInts())
                        .max(FloatVector.fromArray(FLOATS, d, at + nearZ)
                                .fma(iz, nz)
                                .reinterpretAsInts())
                        .max(IntVector.zero(INTS));
                IntVector far = FloatVector.fromArray(FLOATS, d, at + farX)
                        .fma(ix, fx)
                        .reinterpretAsInts()
                        .min(FloatVector.fromArray(FLOATS, d, at + farY)
                                .fma(iy, fy)
                                .reinterpretAsInts())
                        .min(FloatVector.fromArray(FLOATS, d, at + farZ)
                                .fma(iz, fz)
                                .reinterpretAsInts())
                        .min(IntVector.broadcast(INTS, best))
                        .add(IntVector.broadcast(INTS, PreparedRay.ULPS));
                long hits = near.compare(VectorOperators.LE, far).toLong();
                if (hits != 0) {
                    int references = at + 6 * W;
                    if (any) {
                        do {
                            stack[sp++] = Float.floatToRawIntBits(d[references + Long.numberOfTrailingZeros(hits)]);
                            hits &= hits - 1;
                        } while (hits != 0);
                        reference = (int) stack[--sp];
                        continue;
                    }
                    int lane = Long.numberOfTrailingZeros(hits);
                    hits &= hits - 1;
                    reference = Float.floatToRawIntBits(d[references + lane]);
                    if (hits == 0) {
                        continue;
                    }
                    near.intoArray(lanes, 0);
                    long entry0 = (long) lanes[lane] << 32 | (reference & REFERENCE);
                    lane = Long.numberOfTrailingZeros(hits);
                    hits &= hits - 1;
                    long entry1 =
                            (long) lanes[lane] << 32 | (Float.floatToRawIntBits(d[references + lane]) & REFERENCE);
                    long nearer = Math.min(entry0, entry1);
                    long farther = Math.max(entry0, entry1);
                    if (hits == 0) {
                        stack[sp++] = farther;
                        reference = (int) nearer;
                        continue;
                    }
                    int bottom = sp;
                    stack[sp] = farther;
                    stack[sp + 1] = nearer;
                    sp += 2;
                    do {
                        lane = Long.numberOfTrailingZeros(hits);
                        hits &= hits - 1;
                        long entry =
                                (long) lanes[lane] << 32 | (Float.floatToRawIntBits(d[references + lane]) & REFERENCE);
                        sp = WideBvh.insert(stack, bottom, sp, entry);
                    } while (hits != 0);
                    reference = (int) stack[--sp];
                    continue;
                }
            } else if ((reference & 1) != 0) {
                int at = ~reference;
                FloatVector aw = FloatVector.fromArray(FLOATS, d, at + axisW).sub(ow);
                FloatVector bw =
                        FloatVector.fromArray(FLOATS, d, at + 3 * W + axisW).sub(ow);
                FloatVector cw =
                        FloatVector.fromArray(FLOATS, d, at + 6 * W + axisW).sub(ow);
                FloatVector au =
                        aw.fma(su, FloatVector.fromArray(FLOATS, d, at + axisU).sub(ou));
                FloatVector av =
                        aw.fma(sv, FloatVector.fromArray(FLOATS, d, at + axisV).sub(ov));
                FloatVector bu = bw.fma(
                        su, FloatVector.fromArray(FLOATS, d, at + 3 * W + axisU).sub(ou));
                FloatVector bv = bw.fma(
                        sv, FloatVector.fromArray(FLOATS, d, at + 3 * W + axisV).sub(ov));
                FloatVector cu = cw.fma(
                        su, FloatVector.fromArray(FLOATS, d, at + 6 * W + axisU).sub(ou));
                FloatVector cv = cw.fma(
                        sv, FloatVector.fromArray(FLOATS, d, at + 6 * W + axisV).sub(ov));
                FloatVector ea = cu.mul(bv).sub(cv.mul(bu));
                FloatVector eb = au.mul(cv).sub(av.mul(cu));
                FloatVector ec = bu.mul(av).sub(bv.mul(au));
                FloatVector zero = FloatVector.zero(FLOATS);
                FloatVector inverse =
                        FloatVector.broadcast(FLOATS, 1).div(ea.add(eb).add(ec));
                // The sum with zero turns -0 into +0, so that the sign bit tells inside from outside.
                FloatVector wa = ea.fma(inverse, zero);
                FloatVector wb = eb.fma(inverse, zero);
                FloatVector wc = ec.fma(inverse, zero);
                IntVector t = wa.mul(aw)
                        .add(wb.mul(bw))
                        .add(wc.mul(cw))
                        .mul(FloatVector.broadcast(FLOATS, p.inverseW))
                        .reinterpretAsInts();
                IntVector signs = wa.reinterpretAsInts()
                        .or(wb.reinterpretAsInts())
                        .or(wc.reinterpretAsInts())
                        .or(t)
                        .or(t.sub(1));
                // T must be positive: if it is zero, T − 1 has the sign bit.
                VectorMask<Integer> inside = signs.compare(VectorOperators.GE, 0)
                        .and(t.compare(VectorOperators.LT, IntVector.broadcast(INTS, best)));
                long hits = inside.toLong();
                if (hits != 0) {
                    if (any) {
                        return true;
                    }
                    t.intoArray(lanes, 0);
                    do {
                        int lane = Long.numberOfTrailingZeros(hits);
                        hits &= hits - 1;
                        int bits = lanes[lane];
                        if (bits < best) {
                            best = bits;
                            bestBlock = at;
                            bestLane = lane;
                            found = true;
                        }
                    } while (hits != 0);
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

    @Override
    public void bounds(float[] target) {
        bvh.bounds(target);
    }

    @Override
    public String describe() {
        String state = warmUp == null ? "" : warmUp.state();
        double megabytes = memoryBytes() / 1e6;
        return String.format(
                Locale.ROOT, "bvh%d-512, %d triangles, %.1f MB%s", W, bvh.triangleCount(), megabytes, state);
    }

    @Override
    public long memoryBytes() {
        return bvh.memoryBytes();
    }
}
