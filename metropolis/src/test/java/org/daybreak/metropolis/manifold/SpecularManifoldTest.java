package org.daybreak.metropolis.manifold;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.NormalMap;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.ThinDielectric;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;
import org.junit.jupiter.api.Test;

/** Chains of delta lobes: their tangents against closed forms and traced rays, and walks. */
class SpecularManifoldTest {
    private static final int REFLECT = 0;
    private static final int REFRACT = 1;
    private static final ConstantTexture WHITE = ConstantTexture.grey(1);
    private static final Bsdf MIRROR = Conductor.mirror(WHITE);
    private static final Bsdf GLASS = new Dielectric(1.5, 1, WHITE, WHITE);
    private static final Bsdf GREY = new Diffuse(ConstantTexture.grey(0.5));

    private final SpecularChain chain = new SpecularChain();
    private final SpecularChain moved = new SpecularChain();
    private final ManifoldTangents tangents = new ManifoldTangents();
    private final ChainEnd target = new ChainEnd();
    private final BsdfSample scattered = new BsdfSample();

    private static Scene scene(ShapeNode... nodes) {
        SceneGraph graph = new SceneGraph();
        Matrix4d camera = new Matrix4d();
        camera.setIdentity();
        graph.setCamera(new CameraSettings(camera, 40));
        graph.setFilm(new FilmSettings(4, 4, ReconstructionFilter.BOX));
        for (ShapeNode node : nodes) {
            graph.root().add(node);
        }
        return SceneCompiler.compile(graph);
    }

    /** A square of side 20 at a height, its front up or down. */
    private static ShapeNode plane(double z, boolean up, Bsdf material) {
        ShapeNode node = new ShapeNode(new Rectangle(), material);
        node.setTransform(Transform.ofRows(10, 0, 0, 0, 0, up ? 10 : -10, 0, 0, 0, 0, up ? 1 : -1, z)
                .toMatrix4d());
        return node;
    }

    private static ShapeNode sphere(double x, double y, double z, double radius, Bsdf material) {
        return new ShapeNode(new Sphere(new Point3d(x, y, z), radius), material);
    }

    /** A unit sphere of triangles with the normals of the sphere. */
    private static ShapeNode smoothSphere(Bsdf material, Transform transform) {
        int rows = 12;
        int columns = 24;
        float[] positions = new float[3 * (rows + 1) * (columns + 1)];
        int[] triangles = new int[6 * rows * columns];
        for (int i = 0; i <= rows; i++) {
            for (int j = 0; j <= columns; j++) {
                double theta = Math.PI * i / rows;
                double phi = 2 * Math.PI * j / columns;
                int at = 3 * (i * (columns + 1) + j);
                positions[at] = (float) (Math.sin(theta) * Math.cos(phi));
                positions[at + 1] = (float) (Math.sin(theta) * Math.sin(phi));
                positions[at + 2] = (float) Math.cos(theta);
            }
        }
        int corner = 0;
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                int a = i * (columns + 1) + j;
                int b = a + columns + 1;
                int[] quad = {a, b, b + 1, a, b + 1, a + 1};
                System.arraycopy(quad, 0, triangles, corner, 6);
                corner += 6;
            }
        }
        ShapeNode node = new ShapeNode(new TriangleMesh(positions, triangles, positions.clone(), null), material);
        node.setTransform(transform.toMatrix4d());
        return node;
    }

    /** Traces a chain from its start along a direction, and sets its end where the last ray is at a distance. */
    private boolean trace(
            RayCaster caster, SpecularChain c, double dx, double dy, double dz, double distance, int... lobes) {
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double x = dx / length;
        double y = dy / length;
        double z = dz / length;
        c.setLength(lobes.length);
        SurfacePoint from = c.start.point;
        for (int i = 0; i < lobes.length; i++) {
            SurfacePoint here = c.points[i];
            c.lobes[i] = lobes[i];
            if (!caster.trace(from, x, y, z, RayKind.SCATTERED, here)
                    || !Scattering.deltaLobe(
                            caster.scene().bsdf(here.shape), here, -x, -y, -z, lobes[i], c.mode, scattered)) {
                return false;
            }
            x = scattered.wiX;
            y = scattered.wiY;
            z = scattered.wiZ;
            from = here;
        }
        c.end.setFree(from.x + distance * x, from.y + distance * y, from.z + distance * z);
        return true;
    }

    /** Makes a plane through the end of a chain the surface that it lies on. */
    private static void endOnPlane(SpecularChain c, double nx, double ny, double nz) {
        SurfacePoint p = new SurfacePoint();
        p.set(c.end.point);
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        p.gx = nx / length;
        p.gy = ny / length;
        p.gz = nz / length;
        c.end.setSurface(p);
    }

    private double startPerEnd(RayCaster caster, SpecularChain c) {
        assertTrue(new SpecularManifold(caster).follow(c));
        assertTrue(tangents.set(caster.scene(), c));
        return tangents.startPerEnd();
    }

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

    /** Solid angle at the start per area on the end's plane, by tracing four rays beside; NaN if they leave the chain. */
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
            if (!trace(caster, moved, d[0] + e * a[0], d[1] + e * a[1], d[2] + e * a[2], 1, lobes)) {
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

    private static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    @Test
    void mirrorIsTheStraightWayToTheImage() {
        RayCaster caster = new RayCaster(scene(plane(0, true, MIRROR)));
        chain.start.setFree(0.3, -0.2, 2);
        assertTrue(trace(caster, chain, 1, 0.5, -1.2, 1.7, REFLECT));
        endOnPlane(chain, 0.1, 0.2, 1);
        SurfacePoint end = chain.end.point;
        double x = end.x - 0.3;
        double y = end.y + 0.2;
        double z = -end.z - 2;
        double squared = x * x + y * y + z * z;
        double cosine = Math.abs(x * end.gx + y * end.gy - z * end.gz) / Math.sqrt(squared);
        assertEquals(cosine / squared, startPerEnd(caster, chain), 1e-6 * cosine / squared);
    }

    /** Through a pane at right angles the distance in glass counts as shorter by the index. */
    @Test
    void paneShortensTheWay() {
        RayCaster caster = new RayCaster(scene(plane(0, true, GLASS), plane(-3, false, GLASS)));
        chain.start.setFree(0.3, -0.2, 2);
        assertTrue(trace(caster, chain, 1e-9, 0, -1, 4, REFRACT, REFRACT));
        endOnPlane(chain, 0, 0, 1);
        double way = 2 + 3 / 1.5 + 4;
        assertEquals(1 / (way * way), startPerEnd(caster, chain), 1e-6 / (way * way));
    }

    /** Light passes a thin pane straight: there is no half vector, and nothing happens to the geometry term. */
    @Test
    void thinPaneChangesNothing() {
        RayCaster caster = new RayCaster(scene(plane(0, true, new ThinDielectric(1.5, 1, WHITE, WHITE))));
        chain.start.setFree(0.3, -0.2, 2);
        assertTrue(trace(caster, chain, 1, 0.4, -2, 4, REFRACT));
        double x = chain.end.point.x - 0.3;
        double y = chain.end.point.y + 0.2;
        double z = chain.end.point.z - 2;
        double squared = x * x + y * y + z * z;
        assertEquals(1 / squared, startPerEnd(caster, chain), 1e-6 / squared);
    }

    private static final int[][] CHAINS = {
        {REFRACT, REFRACT},
        {REFLECT},
        {REFRACT, REFLECT, REFRACT},
        {REFRACT, REFLECT, REFLECT, REFRACT},
        {REFRACT, REFRACT, REFLECT},
        {REFLECT, REFLECT}
    };

    private static RayCaster balls() {
        return new RayCaster(
                scene(sphere(0, 0, 0, 1, GLASS), sphere(3, 0, -4, 2, MIRROR), sphere(0.5, 4, 0.2, 2, MIRROR)));
    }

    private static RayCaster smoothBalls() {
        // Scaled unevenly, so that the normals are not those of the surface that the triangles stand for either.
        return new RayCaster(scene(
                smoothSphere(GLASS, Transform.scale(1, 1.2, 0.9)),
                smoothSphere(MIRROR, Transform.translate(3, 0, -4).multiply(Transform.scale(2, 2, 2))),
                smoothSphere(MIRROR, Transform.translate(0.5, 4, 0.2).multiply(Transform.scale(2, 2, -2)))));
    }

    /** Sets the chain to a random one, its end on a random plane; false if the rays went another way. */
    private boolean randomChain(RayCaster caster, RandomStream random, int... lobes) {
        chain.mode = random.nextDouble() < 0.5 ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
        chain.start.setFree(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 3 + random.nextDouble());
        double x = 4 * random.nextDouble() - 2;
        double y = 4 * random.nextDouble() - 2;
        if (!trace(caster, chain, x, y, -3, 1 + random.nextDouble(), lobes)) {
            return false;
        }
        endOnPlane(chain, random.nextDouble() - 0.5, random.nextDouble() - 0.5, 1);
        return true;
    }

    /** Glass and mirrors one after another, against rays traced beside: surfaces, and triangles with normals that turn. */
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
                if (!randomChain(caster, random, lobes)) {
                    continue;
                }
                double expected = tracedStartPerEnd(caster, chain, 1e-6);
                double coarser = tracedStartPerEnd(caster, chain, 5e-7);
                // Near a caustic differences are not derivatives.
                if (Math.abs(expected - coarser) <= 3e-5 * expected) {
                    assertEquals(expected, startPerEnd(caster, chain), tolerance * expected, name(lobes));
                    checked++;
                }
            }
            assertTrue(checked >= 30, name(lobes) + ": " + checked);
        }
    }

    private static String name(int... lobes) {
        return Arrays.toString(lobes);
    }

    private void reverse(SpecularChain c, SpecularChain into) {
        int n = c.length();
        into.setLength(n);
        into.start.set(c.end);
        into.end.set(c.start);
        into.mode = c.mode == TransportMode.RADIANCE ? TransportMode.IMPORTANCE : TransportMode.RADIANCE;
        for (int i = 0; i < n; i++) {
            into.points[i].set(c.points[n - 1 - i]);
            into.lobes[i] = c.lobes[n - 1 - i];
        }
    }

    /**
     * What a chain brings is the same from both of its ends: radiance traced from one, importance from the other. Refraction scales
     * radiance as it changes the geometry term, and shading normals change it as their adjoint undoes.
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
                    if (!randomChain(caster, random, lobes)) {
                        continue;
                    }
                    chain.end.setFree(chain.end.point.x, chain.end.point.y, chain.end.point.z);
                    double there = startPerEnd(caster, chain) * chain.throughput.r;
                    reverse(chain, moved);
                    double back = startPerEnd(caster, moved) * moved.throughput.r;
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
            assertTrue(trace(caster, c, d[0], d[1], d[2], 2, REFRACT, REFRACT));
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
        assertEquals(4 * h * h / area, startPerEnd(caster, chain), 1e-5 * 4 * h * h / area);
        // The same rays seen from where they are not parallel: what is conserved is angle there times area here.
        reverse(chain, moved);
        chain.end.setFree(plane.x, plane.y, plane.z);
        double there = startPerEnd(caster, chain);
        moved.start.setFree(plane.x, plane.y, plane.z);
        assertEquals(there, startPerEnd(caster, moved), 1e-6 * there);
    }

    /** Where the last ray of a chain that starts through its first vertex passes the end, relative to the distance. */
    private double miss(RayCaster caster, SpecularChain c, ChainEnd end) {
        SurfacePoint o = c.start.point;
        SurfacePoint first = c.points[0];
        SpecularChain traced = new SpecularChain();
        traced.start.set(c.start);
        traced.mode = c.mode;
        double x = first.x - o.x;
        double y = first.y - o.y;
        double z = first.z - o.z;
        assertTrue(trace(caster, traced, x, y, z, 1, Arrays.copyOf(c.lobes, c.length())));
        SurfacePoint last = traced.points[c.length() - 1];
        SurfacePoint ahead = traced.end.point;
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
                    if (!randomChain(caster, random, lobes)) {
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
            if (!randomChain(caster, random, REFRACT, REFRACT)) {
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
            if (!randomChain(caster, random, REFRACT, REFLECT, REFRACT)) {
                continue;
            }
            moveEnd(random, 0.02);
            assertTrue(manifold.follow(chain));
            double before = startPerEnd(caster, chain);
            if (manifold.walkReversibly(chain, target, moved) != WalkOutcome.CONVERGED) {
                continue;
            }
            assertEquals(WalkOutcome.CONVERGED, manifold.walk(moved, chain.end, restored));
            for (int k = 0; k < 3; k++) {
                assertEquals(chain.points[k].x, restored.points[k].x, 1e-5);
                assertEquals(chain.points[k].y, restored.points[k].y, 1e-5);
                assertEquals(chain.points[k].z, restored.points[k].z, 1e-5);
            }
            assertEquals(before, startPerEnd(caster, restored), 1e-4 * before);
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
        assertTrue(trace(caster, chain, d[0], d[1], d[2], 2, REFRACT, REFRACT));
        SurfacePoint o = chain.start.point;
        chain.start.setParallel(o.x, o.y, o.z, -d[0], -d[1], -d[2]);
        assertTrue(manifold.follow(chain));
        SurfacePoint end = chain.end.point;
        target.setFree(end.x + 0.05, end.y - 0.05, end.z + 0.05);
        assertEquals(WalkOutcome.CONVERGED, manifold.walkReversibly(chain, target, moved));
        // The other way around: from the target to parallel rays that are turned back.
        double there = startPerEnd(caster, moved);
        reverse(moved, chain);
        assertTrue(manifold.follow(chain));
        assertEquals(there, startPerEnd(caster, chain), 1e-5 * there);
        double[] turned = unit(0.12, 0.18, -1);
        target.setParallel(0, 0, 0, -turned[0], -turned[1], -turned[2]);
        assertEquals(WalkOutcome.CONVERGED, manifold.walkReversibly(chain, target, moved));
        SurfacePoint from = moved.start.point;
        SurfacePoint first = moved.points[0];
        assertTrue(trace(caster, moved, first.x - from.x, first.y - from.y, first.z - from.z, 1, REFRACT, REFRACT));
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
            assertTrue(trace(caster, chain, 0.1, 0.05, -1, 2 * scale, REFRACT, REFRACT));
            SurfacePoint end = chain.end.point;
            target.setFree(end.x + 0.02 * scale, end.y - 0.01 * scale, end.z);
            assertTrue(manifold.follow(chain));
            assertEquals(WalkOutcome.CONVERGED, manifold.walkReversibly(chain, target, moved));
            steps[i] = manifold.iterations();
            terms[i] = startPerEnd(caster, moved) * scale * scale;
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
        assertTrue(trace(caster, chain, 0.1, 0, -1, 2, REFLECT));
        assertTrue(manifold.follow(chain));
        target.setFree(10, 0, 2);
        assertEquals(WalkOutcome.KIND_CHANGED, manifold.walk(chain, target, moved));
        target.setFree(0, 0, -2);
        assertEquals(WalkOutcome.BEHIND, manifold.walk(chain, target, moved));
        chain.lobes[0] = 1;
        assertFalse(manifold.follow(chain));

        caster = new RayCaster(scene(disk));
        manifold = new SpecularManifold(caster);
        assertTrue(trace(caster, chain, 0.1, 0, -1, 2, REFLECT));
        assertTrue(manifold.follow(chain));
        target.setFree(10, 0, 2);
        assertEquals(WalkOutcome.MISSED, manifold.walk(chain, target, moved));

        Bsdf mapped = new NormalMap(new ConstantTexture(0.5, 0.5, 1), MIRROR, false);
        caster = new RayCaster(scene(plane(0, true, mapped)));
        manifold = new SpecularManifold(caster);
        assertTrue(trace(caster, chain, 0.1, 0, -1, 2, REFLECT));
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
            assertTrue(trace(caster, chain, x, y, random.nextDouble() - 0.5, 0.7, REFLECT, REFLECT));
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
        assertTrue(trace(caster, chain, 0.1, 0.05, -3, 0.3, REFRACT, REFLECT, REFRACT));
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
