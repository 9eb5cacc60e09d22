package org.daybreak.metropolis.manifold;

import static org.daybreak.metropolis.manifold.SpecularScenes.GLASS;
import static org.daybreak.metropolis.manifold.SpecularScenes.MIRROR;
import static org.daybreak.metropolis.manifold.SpecularScenes.REFLECT;
import static org.daybreak.metropolis.manifold.SpecularScenes.REFRACT;
import static org.daybreak.metropolis.manifold.SpecularScenes.WHITE;
import static org.daybreak.metropolis.manifold.SpecularScenes.balls;
import static org.daybreak.metropolis.manifold.SpecularScenes.plane;
import static org.daybreak.metropolis.manifold.SpecularScenes.scene;
import static org.daybreak.metropolis.manifold.SpecularScenes.smoothBalls;
import static org.daybreak.metropolis.manifold.TracedChains.CHAINS;
import static org.daybreak.metropolis.manifold.TracedChains.endOnPlane;
import static org.daybreak.metropolis.manifold.TracedChains.name;
import static org.daybreak.metropolis.manifold.TracedChains.reverse;
import static org.daybreak.metropolis.manifold.TracedChains.unit;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.ThinDielectric;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.RayCaster;
import org.junit.jupiter.api.Test;

/** Tangents of chains of delta lobes, against closed forms and traced rays. */
class ManifoldTangentsTest {
    private final SpecularChain chain = new SpecularChain();
    private final SpecularChain moved = new SpecularChain();
    private final TracedChains traced = new TracedChains();

    /** Where the last ray of a chain meets the plane through a point. */
    private static double[] onPlane(SpecularChain c, SurfacePoint plane) {
        SurfacePoint last = c.points[c.length() - 1];
        SurfacePoint end = c.end.point;
        double x = end.x - last.x;
        double y = end.y - last.y;
        double z = end.z - last.z;
        double t = ((plane.x - last.x) * plane.gx + (plane.y - last.y) * plane.gy + (plane.z - last.z) * plane.gz)
                / (x * plane.gx + y * plane.gy + z * plane.gz);
        return new double[] {last.x + t * x, last.y + t * y, last.z + t * z};
    }

    /**
     * Solid angle at the start per area on the end's plane, by tracing four rays beside; NaN if they leave the chain.
     */
    private double tracedStartPerEnd(RayCaster caster, SpecularChain c, double h) {
        SurfacePoint end = c.end.point;
        SurfacePoint o = c.start.point;
        SurfacePoint first = c.points[0];
        double[] d = unit(first.x - o.x, first.y - o.y, first.z - o.z);
        double[] s = unit(d[1], -d[0], 0);
        double[] t = {
            d[1] * s[2] - d[2] * s[1], d[2] * s[0] - d[0] * s[2], d[0] * s[1] - d[1] * s[0],
        };
        int[] lobes = Arrays.copyOf(c.lobes, c.length());
        moved.start.set(c.start);
        moved.mode = c.mode;
        double[][] p = new double[4][];
        for (int i = 0; i < 4; i++) {
            double[] a = i < 2 ? s : t;
            double e = i % 2 == 0 ? h : -h;
            if (!traced.trace(caster, moved, d[0] + e * a[0], d[1] + e * a[1], d[2] + e * a[2], 1, lobes)) {
                return Double.NaN;
            }
            for (int k = 0; k < lobes.length; k++) {
                if (moved.points[k].primitive != c.points[k].primitive) {
                    return Double.NaN;
                }
            }
            p[i] = onPlane(moved, end);
        }
        double[] u = {p[0][0] - p[1][0], p[0][1] - p[1][1], p[0][2] - p[1][2]};
        double[] v = {p[2][0] - p[3][0], p[2][1] - p[3][1], p[2][2] - p[3][2]};
        double nx = u[1] * v[2] - u[2] * v[1];
        double ny = u[2] * v[0] - u[0] * v[2];
        double nz = u[0] * v[1] - u[1] * v[0];
        return 4 * h * h / Math.sqrt(nx * nx + ny * ny + nz * nz);
    }

    @Test
    void mirrorIsTheStraightWayToTheImage() {
        RayCaster caster = new RayCaster(scene(plane(0, true, MIRROR)));
        chain.start.setFree(0.3, -0.2, 2);
        assertTrue(traced.trace(caster, chain, 1, 0.5, -1.2, 1.7, REFLECT));
        endOnPlane(chain, 0.1, 0.2, 1);
        SurfacePoint end = chain.end.point;
        double x = end.x - 0.3;
        double y = end.y + 0.2;
        double z = -end.z - 2;
        double squared = x * x + y * y + z * z;
        double cosine = Math.abs(x * end.gx + y * end.gy - z * end.gz) / Math.sqrt(squared);
        assertEquals(cosine / squared, traced.startPerEnd(caster, chain), 1e-6 * cosine / squared);
    }

    /** Through a pane at right angles the distance in glass counts as shorter by the index. */
    @Test
    void paneShortensTheWay() {
        RayCaster caster = new RayCaster(scene(plane(0, true, GLASS), plane(-3, false, GLASS)));
        chain.start.setFree(0.3, -0.2, 2);
        assertTrue(traced.trace(caster, chain, 1e-9, 0, -1, 4, REFRACT, REFRACT));
        endOnPlane(chain, 0, 0, 1);
        double way = 2 + 3 / 1.5 + 4;
        assertEquals(1 / (way * way), traced.startPerEnd(caster, chain), 1e-6 / (way * way));
    }

    /** Light passes a thin pane straight: there is no half vector, and nothing happens to the geometry term. */
    @Test
    void thinPaneChangesNothing() {
        RayCaster caster = new RayCaster(scene(plane(0, true, new ThinDielectric(1.5, 1, WHITE, WHITE))));
        chain.start.setFree(0.3, -0.2, 2);
        assertTrue(traced.trace(caster, chain, 1, 0.4, -2, 4, REFRACT));
        double x = chain.end.point.x - 0.3;
        double y = chain.end.point.y + 0.2;
        double z = chain.end.point.z - 2;
        double squared = x * x + y * y + z * z;
        assertEquals(1 / squared, traced.startPerEnd(caster, chain), 1e-6 / squared);
    }

    /**
     * Glass and mirrors one after another, against rays traced beside: surfaces, and triangles with normals that turn.
     */
    @Test
    void tangentsAreThoseOfTracedRays() {
        checkTangents(balls(), 1e-4);
        // Rays start 2e-6 off triangles, and mirrors of this curvature make that some hundred times as much.
        checkTangents(smoothBalls(), 2e-3);
    }

    private void checkTangents(RayCaster caster, double tolerance) {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        for (int[] lobes : CHAINS) {
            int checked = 0;
            for (int i = 0; i < 100_000 && checked < 30; i++) {
                if (!traced.random(caster, chain, random, lobes)) {
                    continue;
                }
                double expected = tracedStartPerEnd(caster, chain, 1e-6);
                double coarser = tracedStartPerEnd(caster, chain, 5e-7);
                // Near a caustic differences are not derivatives.
                if (Math.abs(expected - coarser) <= 3e-5 * expected) {
                    assertEquals(expected, traced.startPerEnd(caster, chain), tolerance * expected, name(lobes));
                    checked++;
                }
            }
            assertTrue(checked >= 30, name(lobes) + ": " + checked);
        }
    }

    /**
     * What a chain brings is the same from both of its ends: radiance traced from one, importance from the other.
     * Refraction scales radiance as it changes the geometry term, and shading normals change it as their adjoint
     * undoes.
     */
    @Test
    void chainsBringTheSameFromBothEnds() {
        for (RayCaster caster : new RayCaster[] {balls(), smoothBalls()}) {
            RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
            for (int[] lobes : new int[][] {
                {REFRACT}, {REFLECT}, {REFRACT, REFRACT}, {REFRACT, REFLECT}, {REFRACT, REFRACT, REFLECT}
            }) {
                int checked = 0;
                for (int i = 0; i < 20_000 && checked < 30; i++) {
                    if (!traced.random(caster, chain, random, lobes)) {
                        continue;
                    }
                    chain.end.setFree(chain.end.point.x, chain.end.point.y, chain.end.point.z);
                    double there = traced.startPerEnd(caster, chain) * chain.throughput.r;
                    reverse(chain, moved);
                    double back = traced.startPerEnd(caster, moved) * moved.throughput.r;
                    assertEquals(there, back, 1e-4 * there, name(lobes));
                    checked++;
                }
                assertTrue(checked >= 30, name(lobes) + ": " + checked);
            }
        }
    }

    /** Parallel rays at either end, through a ball: areas across them, and angles on the sphere of directions. */
    @Test
    void directionsCanBeEnds() {
        RayCaster caster = balls();
        double h = 1e-5;
        double[] d = unit(0.1, 0.2, -1);
        double[] s = unit(d[2], 0, -d[0]);
        double[] t = {d[1] * s[2] - d[2] * s[1], d[2] * s[0] - d[0] * s[2], d[0] * s[1] - d[1] * s[0]};
        double[][] p = new double[4][];
        SurfacePoint plane = null;
        for (int i = -1; i < 4; i++) {
            double[] a = i < 2 ? s : t;
            double e = i < 0 ? 0 : i % 2 == 0 ? h : -h;
            SpecularChain c = i < 0 ? chain : moved;
            c.start.setFree(0.3 + e * a[0] - 3 * d[0], 0.1 + e * a[1] - 3 * d[1], e * a[2] - 3 * d[2]);
            assertTrue(traced.trace(caster, c, d[0], d[1], d[2], 2, REFRACT, REFRACT));
            if (plane == null) {
                endOnPlane(c, 0.3, 0, 1);
                plane = c.end.point;
            } else {
                p[i] = onPlane(c, plane);
            }
        }
        double[] u = {p[0][0] - p[1][0], p[0][1] - p[1][1], p[0][2] - p[1][2]};
        double[] v = {p[2][0] - p[3][0], p[2][1] - p[3][1], p[2][2] - p[3][2]};
        double area = Math.sqrt(Math.pow(u[1] * v[2] - u[2] * v[1], 2)
                + Math.pow(u[2] * v[0] - u[0] * v[2], 2)
                + Math.pow(u[0] * v[1] - u[1] * v[0], 2));
        SurfacePoint o = chain.start.point;
        chain.start.setParallel(o.x, o.y, o.z, -d[0], -d[1], -d[2]);
        assertEquals(4 * h * h / area, traced.startPerEnd(caster, chain), 1e-5 * 4 * h * h / area);
        // The same rays seen from where they are not parallel: what is conserved is angle there times area here.
        reverse(chain, moved);
        chain.end.setFree(plane.x, plane.y, plane.z);
        double there = traced.startPerEnd(caster, chain);
        moved.start.setFree(plane.x, plane.y, plane.z);
        assertEquals(there, traced.startPerEnd(caster, moved), 1e-6 * there);
    }
}
