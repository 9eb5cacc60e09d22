package org.daybreak.metropolis.manifold;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
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

    /** Solid angle at the start per area on the end's plane, by tracing four rays beside. */
    private double tracedStartPerEnd(RayCaster caster, SpecularChain c, double h) {
        SurfacePoint end = c.end.point;
        SurfacePoint o = c.start.point;
        SurfacePoint first = c.points[0];
        double[] d = unit(first.x - o.x, first.y - o.y, first.z - o.z);
        double[] s = unit(d[1], -d[0], 0);
        double[] t = {
            d[1] * s[2] - d[2] * s[1], d[2] * s[0] - d[0] * s[2], d[0] * s[1] - d[1] * s[0],
        };
        int[] lobes = java.util.Arrays.copyOf(c.lobes, c.length());
        moved.start.set(c.start);
        moved.mode = c.mode;
        double[][] p = new double[4][];
        for (int i = 0; i < 4; i++) {
            double[] a = i < 2 ? s : t;
            double e = i % 2 == 0 ? h : -h;
            assertTrue(trace(caster, moved, d[0] + e * a[0], d[1] + e * a[1], d[2] + e * a[2], 1, lobes));
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

    /** A ball of glass, and one mirror after another, against rays traced beside. */
    @Test
    void tangentsAreThoseOfTracedRays() {
        RayCaster caster = new RayCaster(
                scene(sphere(0, 0, 0, 1, GLASS), sphere(3, 0, -3, 1, MIRROR), sphere(0.5, 4, 0.2, 1.5, MIRROR)));
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        int[][] chains = {
            {REFRACT, REFRACT},
            {REFLECT},
            {REFRACT, REFLECT, REFRACT},
            {REFRACT, REFLECT, REFLECT, REFRACT},
            {REFRACT, REFRACT, REFLECT},
            {REFLECT, REFLECT}
        };
        int[] checked = new int[chains.length];
        for (int i = 0; i < 40000; i++) {
            int[] lobes = chains[i % chains.length];
            chain.mode = random.nextDouble() < 0.5 ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
            chain.start.setFree(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 3 + random.nextDouble());
            if (checked[i % chains.length] >= 30
                    || !trace(
                            caster,
                            chain,
                            4 * random.nextDouble() - 2,
                            4 * random.nextDouble() - 2,
                            -3,
                            1 + random.nextDouble(),
                            lobes)) {
                continue;
            }
            endOnPlane(chain, random.nextDouble() - 0.5, random.nextDouble() - 0.5, 1);
            double expected;
            try {
                expected = tracedStartPerEnd(caster, chain, 1e-6);
            } catch (AssertionError e) {
                // A ray beside has left the chain: an edge is near.
                continue;
            }
            double coarser = tracedStartPerEnd(caster, chain, 5e-7);
            if (Math.abs(expected - coarser) > 1e-4 * expected) {
                // Near a caustic differences are not derivatives.
                continue;
            }
            assertEquals(expected, startPerEnd(caster, chain), 3e-4 * expected, java.util.Arrays.toString(lobes));
            checked[i % chains.length]++;
        }
        for (int i = 0; i < chains.length; i++) {
            assertTrue(checked[i] >= 20, java.util.Arrays.toString(chains[i]) + ": " + checked[i]);
        }
    }
}
