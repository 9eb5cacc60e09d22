package org.daybreak.metropolis.manifold;

import static org.daybreak.metropolis.manifold.SpecularScenes.GLASS;
import static org.daybreak.metropolis.manifold.SpecularScenes.GREY;
import static org.daybreak.metropolis.manifold.SpecularScenes.MIRROR;
import static org.daybreak.metropolis.manifold.SpecularScenes.REFLECT;
import static org.daybreak.metropolis.manifold.SpecularScenes.REFRACT;
import static org.daybreak.metropolis.manifold.SpecularScenes.balls;
import static org.daybreak.metropolis.manifold.SpecularScenes.plane;
import static org.daybreak.metropolis.manifold.SpecularScenes.scene;
import static org.daybreak.metropolis.manifold.SpecularScenes.smoothBalls;
import static org.daybreak.metropolis.manifold.SpecularScenes.smoothSphere;
import static org.daybreak.metropolis.manifold.SpecularScenes.sphere;
import static org.daybreak.metropolis.manifold.TracedChains.CHAINS;
import static org.daybreak.metropolis.manifold.TracedChains.name;
import static org.daybreak.metropolis.manifold.TracedChains.reverse;
import static org.daybreak.metropolis.manifold.TracedChains.unit;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.NormalMap;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.ShapeNode;
import org.junit.jupiter.api.Test;

/** Walks on the manifold of chains of delta lobes. */
class SpecularManifoldTest {
    private final SpecularChain chain = new SpecularChain();
    private final SpecularChain moved = new SpecularChain();
    private final ChainEnd target = new ChainEnd();
    private final TracedChains traced = new TracedChains();

    /** Where the last ray of a chain that starts through its first vertex passes the end, relative to the distance. */
    private double miss(RayCaster caster, SpecularChain c, ChainEnd end) {
        SurfacePoint o = c.start.point;
        SurfacePoint first = c.points[0];
        SpecularChain again = new SpecularChain();
        again.start.set(c.start);
        again.mode = c.mode;
        double x = first.x - o.x;
        double y = first.y - o.y;
        double z = first.z - o.z;
        assertTrue(traced.trace(caster, again, x, y, z, 1, Arrays.copyOf(c.lobes, c.length())));
        SurfacePoint last = again.points[c.length() - 1];
        SurfacePoint ahead = again.end.point;
        double[] d = {ahead.x - last.x, ahead.y - last.y, ahead.z - last.z};
        double[] e = {end.point.x - last.x, end.point.y - last.y, end.point.z - last.z};
        double along = d[0] * e[0] + d[1] * e[1] + d[2] * e[2];
        double rest =
                Math.pow(e[0] - along * d[0], 2) + Math.pow(e[1] - along * d[1], 2) + Math.pow(e[2] - along * d[2], 2);
        return Math.sqrt(rest) / along;
    }

    /** Sets the target to the end of the chain moved at random. */
    private void moveEnd(RandomStream random, double size) {
        SurfacePoint end = chain.end.point;
        target.setFree(
                end.x + size * (random.nextDouble() - 0.5),
                end.y + size * (random.nextDouble() - 0.5),
                end.z + size * (random.nextDouble() - 0.5));
    }

    /** Ends move by a tenth of their distance or less: nearly all walks arrive, and the rays really lead to the target. */
    @Test
    void walksLeadToTheTarget() {
        for (RayCaster caster : new RayCaster[] {balls(), smoothBalls()}) {
            RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
            SpecularManifold manifold = new SpecularManifold(caster);
            for (int[] lobes : CHAINS) {
                int walks = 0;
                int arrived = 0;
                for (int i = 0; i < 50_000 && walks < 100; i++) {
                    if (!traced.random(caster, chain, random, lobes)) {
                        continue;
                    }
                    moveEnd(random, 0.1);
                    assertTrue(manifold.follow(chain));
                    walks++;
                    if (manifold.walkReversibly(chain, target, moved) == WalkOutcome.CONVERGED) {
                        arrived++;
                        assertTrue(miss(caster, moved, target) < 1e-6, name(lobes));
                    }
                }
                // Some targets lie beyond the caustics of the glass, where no ray leads.
                assertTrue(arrived >= 60, name(lobes) + ": " + arrived);
                assertEquals(100, walks, name(lobes));
            }
        }
    }

    /** Once near, each step squares the error: a few lead from a hundredth to the tolerance of 1e-9. */
    @Test
    void walksConvergeQuadratically() {
        RayCaster caster = balls();
        RandomStream random = new RandomStream(4, StreamDomain.SELF_CHECK, 0, 0);
        SpecularManifold manifold = new SpecularManifold(caster);
        long sum = 0;
        int walks = 0;
        for (int i = 0; i < 2000; i++) {
            if (!traced.random(caster, chain, random, REFRACT, REFRACT)) {
                continue;
            }
            moveEnd(random, 0.01);
            assertTrue(manifold.follow(chain));
            if (manifold.walk(chain, target, moved) == WalkOutcome.CONVERGED) {
                sum += manifold.iterations();
                walks++;
            }
        }
        assertTrue(walks > 200, "walks: " + walks);
        assertTrue(sum < 4.0 * walks, "steps: " + (double) sum / walks);
    }

    /** A walk there and one back restore all of a chain. */
    @Test
    void walksLeadBack() {
        RayCaster caster = balls();
        RandomStream random = new RandomStream(5, StreamDomain.SELF_CHECK, 0, 0);
        SpecularManifold manifold = new SpecularManifold(caster);
        SpecularChain restored = new SpecularChain();
        int walks = 0;
        for (int i = 0; i < 1000; i++) {
            if (!traced.random(caster, chain, random, REFRACT, REFLECT, REFRACT)) {
                continue;
            }
            moveEnd(random, 0.02);
            assertTrue(manifold.follow(chain));
            double before = traced.startPerEnd(caster, chain);
            if (manifold.walkReversibly(chain, target, moved) != WalkOutcome.CONVERGED) {
                continue;
            }
            assertEquals(WalkOutcome.CONVERGED, manifold.walk(moved, chain.end, restored));
            for (int k = 0; k < 3; k++) {
                assertEquals(chain.points[k].x, restored.points[k].x, 1e-5);
                assertEquals(chain.points[k].y, restored.points[k].y, 1e-5);
                assertEquals(chain.points[k].z, restored.points[k].z, 1e-5);
            }
            assertEquals(before, traced.startPerEnd(caster, restored), 1e-4 * before);
            walks++;
        }
        assertTrue(walks > 20, "walks: " + walks);
    }

    /** From parallel rays to a moved point, and from a point to a turned direction. */
    @Test
    void walksBetweenDirectionsAndPositions() {
        RayCaster caster = balls();
        SpecularManifold manifold = new SpecularManifold(caster);
        double[] d = unit(0.1, 0.2, -1);
        chain.start.setFree(0.3 - 3 * d[0], 0.1 - 3 * d[1], -3 * d[2]);
        assertTrue(traced.trace(caster, chain, d[0], d[1], d[2], 2, REFRACT, REFRACT));
        SurfacePoint o = chain.start.point;
        chain.start.setParallel(o.x, o.y, o.z, -d[0], -d[1], -d[2]);
        assertTrue(manifold.follow(chain));
        SurfacePoint end = chain.end.point;
        target.setFree(end.x + 0.05, end.y - 0.05, end.z + 0.05);
        assertEquals(WalkOutcome.CONVERGED, manifold.walkReversibly(chain, target, moved));
        // The other way around: from the target to parallel rays that are turned back.
        double there = traced.startPerEnd(caster, moved);
        reverse(moved, chain);
        assertTrue(manifold.follow(chain));
        assertEquals(there, traced.startPerEnd(caster, chain), 1e-5 * there);
        double[] turned = unit(0.12, 0.18, -1);
        target.setParallel(0, 0, 0, -turned[0], -turned[1], -turned[2]);
        assertEquals(WalkOutcome.CONVERGED, manifold.walkReversibly(chain, target, moved));
        SurfacePoint from = moved.start.point;
        SurfacePoint first = moved.points[0];
        assertTrue(
                traced.trace(caster, moved, first.x - from.x, first.y - from.y, first.z - from.z, 1, REFRACT, REFRACT));
        SurfacePoint last = moved.points[1];
        assertEquals(-turned[0], moved.end.point.x - last.x, 1e-6);
        assertEquals(-turned[1], moved.end.point.y - last.y, 1e-6);
    }

    /** Lengths times ten to the ninth or over it: the same walk, step by step. */
    @Test
    void walksDoNotDependOnScale() {
        int[] steps = new int[3];
        double[] terms = new double[3];
        for (int i = 0; i < 3; i++) {
            double scale = new double[] {1, 1e-9, 1e9}[i];
            RayCaster caster = new RayCaster(scene(smoothSphere(GLASS, Transform.scale(scale, scale, scale))));
            SpecularManifold manifold = new SpecularManifold(caster);
            chain.start.setFree(0.2 * scale, 0.1 * scale, 3 * scale);
            assertTrue(traced.trace(caster, chain, 0.1, 0.05, -1, 2 * scale, REFRACT, REFRACT));
            SurfacePoint end = chain.end.point;
            target.setFree(end.x + 0.02 * scale, end.y - 0.01 * scale, end.z);
            assertTrue(manifold.follow(chain));
            assertEquals(WalkOutcome.CONVERGED, manifold.walkReversibly(chain, target, moved));
            steps[i] = manifold.iterations();
            terms[i] = traced.startPerEnd(caster, moved) * scale * scale;
        }
        assertEquals(steps[0], steps[1]);
        assertEquals(steps[0], steps[2]);
        assertEquals(terms[0], terms[1], 1e-4 * terms[0]);
        assertEquals(terms[0], terms[2], 1e-4 * terms[0]);
    }

    @Test
    void failuresSayWhy() {
        // A mirror of radius 1 amid a grey floor.
        ShapeNode disk = new ShapeNode(new Disk(), MIRROR);
        RayCaster caster = new RayCaster(scene(disk, plane(-0.01, true, GREY)));
        SpecularManifold manifold = new SpecularManifold(caster);
        chain.start.setFree(0, 0, 2);
        assertTrue(traced.trace(caster, chain, 0.1, 0, -1, 2, REFLECT));
        assertTrue(manifold.follow(chain));
        target.setFree(10, 0, 2);
        assertEquals(WalkOutcome.KIND_CHANGED, manifold.walk(chain, target, moved));
        target.setFree(0, 0, -2);
        assertEquals(WalkOutcome.BEHIND, manifold.walk(chain, target, moved));
        chain.lobes[0] = 1;
        assertFalse(manifold.follow(chain));

        caster = new RayCaster(scene(disk));
        manifold = new SpecularManifold(caster);
        assertTrue(traced.trace(caster, chain, 0.1, 0, -1, 2, REFLECT));
        assertTrue(manifold.follow(chain));
        target.setFree(10, 0, 2);
        assertEquals(WalkOutcome.MISSED, manifold.walk(chain, target, moved));

        Bsdf mapped = new NormalMap(new ConstantTexture(0.5, 0.5, 1), MIRROR, false);
        caster = new RayCaster(scene(plane(0, true, mapped)));
        manifold = new SpecularManifold(caster);
        assertTrue(traced.trace(caster, chain, 0.1, 0, -1, 2, REFLECT));
        assertTrue(manifold.follow(chain));
        assertEquals(WalkOutcome.SINGULAR, manifold.walk(chain, target, moved));
    }

    /** Inside a ball of mirror, other chains join the same ends: far walks do not all come back by the way that they went. */
    @Test
    void waysThatDoNotLeadBackAreNoticed() {
        ShapeNode inside = sphere(0, 0, 0, 1, MIRROR);
        inside.setFlipNormals(true);
        RayCaster caster = new RayCaster(scene(inside));
        SpecularManifold manifold = new SpecularManifold(caster);
        RandomStream random = new RandomStream(6, StreamDomain.SELF_CHECK, 0, 0);
        int lost = 0;
        int found = 0;
        for (int i = 0; i < 1000; i++) {
            chain.start.setFree(0.3, 0.1, 0);
            double x = random.nextDouble() - 0.5;
            double y = random.nextDouble() - 0.5;
            assertTrue(traced.trace(caster, chain, x, y, random.nextDouble() - 0.5, 0.7, REFLECT, REFLECT));
            assertTrue(manifold.follow(chain));
            moveEnd(random, 0.6);
            WalkOutcome outcome = manifold.walkReversibly(chain, target, moved);
            lost += outcome == WalkOutcome.NOT_REVERSIBLE ? 1 : 0;
            found += outcome == WalkOutcome.CONVERGED ? 1 : 0;
        }
        assertTrue(lost > 5, "lost: " + lost);
        assertTrue(found > 500, "found: " + found);
    }

    @Test
    void walksAllocateNothing() {
        RayCaster caster = balls();
        SpecularManifold manifold = new SpecularManifold(caster);
        chain.start.setFree(0.2, 0.1, 3);
        assertTrue(traced.trace(caster, chain, 0.1, 0.05, -3, 0.3, REFRACT, REFLECT, REFRACT));
        SurfacePoint end = chain.end.point;
        target.setFree(end.x + 0.02, end.y, end.z);
        ThreadMXBean bean = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long thread = Thread.currentThread().getId();
        long allocated = Long.MAX_VALUE;
        for (int round = 0; round < 5; round++) {
            long before = bean.getThreadAllocatedBytes(thread);
            for (int i = 0; i < 1000; i++) {
                assertTrue(manifold.follow(chain));
                assertEquals(WalkOutcome.CONVERGED, manifold.walkReversibly(chain, target, moved));
            }
            allocated = Math.min(allocated, bean.getThreadAllocatedBytes(thread) - before);
        }
        assertTrue(allocated < 1000, "bytes in 1000 walks: " + allocated);
    }
}
