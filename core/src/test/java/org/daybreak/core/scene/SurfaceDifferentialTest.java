package org.daybreak.core.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Cone;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.HeightField;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfaceDifferential;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.geometry.Tubes;
import org.daybreak.core.material.Blend;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.NormalMap;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.api.Test;

/** Derivatives of normals against those of rays that hit the surface beside the point. */
class SurfaceDifferentialTest {
    private static final Bsdf GREY = new Diffuse(ConstantTexture.grey(0.5));

    private final SurfacePoint hit = new SurfacePoint();
    private final SurfacePoint before = new SurfacePoint();
    private final SurfacePoint after = new SurfacePoint();
    private final SurfaceDifferential d = new SurfaceDifferential();

    private static Scene scene(Node... nodes) {
        SceneGraph graph = new SceneGraph();
        Matrix4d camera = new Matrix4d();
        camera.setIdentity();
        graph.setCamera(new CameraSettings(camera, 40));
        graph.setFilm(new FilmSettings(4, 4, ReconstructionFilter.BOX));
        for (Node node : nodes) {
            graph.root().add(node);
        }
        return SceneCompiler.compile(graph);
    }

    private static Scene scene(Shape shape, Transform transform, boolean instanced, boolean flipped) {
        ShapeNode node = new ShapeNode(shape, GREY);
        node.setFlipNormals(flipped);
        Node top = node;
        if (instanced) {
            Group group = new Group();
            // Within the level the shape is placed by a map of its own.
            node.setTransform(Transform.ofRows(0.9, 0.2, 0, 0.1, 0, 1.1, 0, 0, 0, 0.1, 1, 0)
                    .toMatrix4d());
            group.add(node);
            top = new Instance(group);
        }
        top.setTransform(transform.toMatrix4d());
        // Another shape first, so that numbers of primitives and shapes differ.
        ShapeNode far = new ShapeNode(new Rectangle(), GREY);
        far.setTransform(transform.multiply(Transform.translate(0, 0, 100)).toMatrix4d());
        return scene(far, top);
    }

    /** A sheet of two triangles with normals that need not be unit, or none. */
    private static TriangleMesh sheet(boolean normals) {
        return new TriangleMesh(
                new float[] {-1, -1, 0, 1, -1, 0.3f, 1, 1, 0, -1, 1.5f, 0.2f},
                new int[] {0, 1, 2, 2, 3, 0},
                normals ? new float[] {-0.2f, 0, 1, 0.3f, 0, 2, 0, 0.1f, 1, 0, -0.3f, 0.7f} : null,
                null);
    }

    private static List<Shape> shapes() {
        List<Shape> shapes = new ArrayList<>(List.of(
                new Sphere(new Point3d(0.1, 0, 0.2), 0.9),
                new Disk(),
                new Cylinder(new Point3d(0, 0, -1), new Point3d(0, 0.2, 1), 0.7),
                new Cone(new Point3d(0, -1, 0), new Point3d(0, 1, 0.2), 0.9, 0.3),
                new Cone(new Point3d(0, -1, 0), new Point3d(0, 1, 0.2), 0, 0.8),
                new Rectangle(),
                new Cube(),
                sheet(true),
                sheet(false)));
        shapes.add(Tubes.linear(new double[][] {{-1, 0, 0, 0.5, 1, 0.3, 0, 0.3}}, 16));
        shapes.add(Tubes.bspline(
                new double[][] {{-2, 0, 0, 0.5, -1, 0.5, 0, 0.4, 0, -0.4, 0.2, 0.5, 1, 0, 0, 0.5, 2, 0, 0, 0.4}}, 12));
        float[] heights = new float[25];
        for (int i = 0; i < 25; i++) {
            heights[i] = (float) Math.sin(i * i);
        }
        shapes.add(HeightField.mesh(heights, 5, 5, 0.2));
        return shapes;
    }

    private static List<Transform> transforms() {
        return List.of(
                Transform.identity(),
                Transform.ofRows(2, 0.3, 0.1, 0.5, 0, 1.5, -0.2, -1, 0.4, 0, 0.8, 0.2),
                Transform.ofRows(-0.7, 0.1, 0, 0.5, 0, 2, 0.2, -1, 0.4, 0, 0.8, 0.2));
    }

    @Test
    void derivativesAreThoseOfTheNormalsOfRaysBeside() {
        for (Shape shape : shapes()) {
            for (Transform transform : transforms()) {
                for (boolean instanced : new boolean[] {false, true}) {
                    for (boolean flipped : new boolean[] {false, true}) {
                        check(shape, transform, instanced, flipped);
                    }
                }
            }
        }
    }

    private void check(Shape shape, Transform transform, boolean instanced, boolean flipped) {
        Scene scene = scene(shape, transform, instanced, flipped);
        RayCaster caster = new RayCaster(scene);
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        String where = shape + " " + transform + (instanced ? ", instance" : "") + (flipped ? ", flipped" : "");
        double[] origin = new double[3];
        double[] target = new double[3];
        int checked = 0;
        for (int i = 0; i < 400 && checked < 40; i++) {
            transform.applyPoint(
                    10 * (random.nextDouble() - 0.5),
                    10 * (random.nextDouble() - 0.5),
                    10 * (random.nextDouble() - 0.5),
                    origin);
            transform.applyPoint(
                    1.6 * (random.nextDouble() - 0.5),
                    1.6 * (random.nextDouble() - 0.5),
                    1.6 * (random.nextDouble() - 0.5),
                    target);
            if (!cast(caster, origin, target, hit)) {
                continue;
            }
            assertTrue(scene.differential(hit, d), where);
            checkTangents(where);
            boolean along = beside(caster, d.pux, d.puy, d.puz);
            if (along) {
                checkDerivative(where, d.gux, d.guy, d.guz, d.nux, d.nuy, d.nuz);
            }
            if (along && beside(caster, d.pvx, d.pvy, d.pvz)) {
                checkDerivative(where, d.gvx, d.gvy, d.gvz, d.nvx, d.nvy, d.nvz);
                checked++;
            }
        }
        assertTrue(checked >= 40, where + ": " + checked);
    }

    private static boolean cast(RayCaster caster, double[] o, double[] p, SurfacePoint into) {
        double dx = p[0] - o[0];
        double dy = p[1] - o[1];
        double dz = p[2] - o[2];
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return caster.trace(o[0], o[1], o[2], dx / length, dy / length, dz / length, RayKind.CAMERA, into);
    }

    private void checkTangents(String where) {
        assertEquals(1, d.pux * d.pux + d.puy * d.puy + d.puz * d.puz, 1e-12, where);
        assertEquals(hit.gx, d.puy * d.pvz - d.puz * d.pvy, 1e-12, where);
        assertEquals(hit.gy, d.puz * d.pvx - d.pux * d.pvz, 1e-12, where);
        assertEquals(hit.gz, d.pux * d.pvy - d.puy * d.pvx, 1e-12, where);
    }

    /** Casts rays along the normal at the distance ±h along a tangent; false if they hit another primitive. */
    private boolean beside(RayCaster caster, double tx, double ty, double tz) {
        return beside(caster, H * tx, H * ty, H * tz, after) && beside(caster, -H * tx, -H * ty, -H * tz, before);
    }

    private static final double H = 1e-4;

    private boolean beside(RayCaster caster, double x, double y, double z, SurfacePoint into) {
        double above = 0.01;
        return caster.trace(
                        hit.x + x + above * hit.gx,
                        hit.y + y + above * hit.gy,
                        hit.z + z + above * hit.gz,
                        -hit.gx,
                        -hit.gy,
                        -hit.gz,
                        RayKind.CAMERA,
                        into)
                && into.primitive == hit.primitive
                && into.instance == hit.instance
                && Math.abs(into.x - hit.x - x) + Math.abs(into.y - hit.y - y) + Math.abs(into.z - hit.z - z) < 0.1 * H;
    }

    /** Normals turn by less than 20 per unit in these shapes, so that the third order is below 1e-4 of that. */
    private void checkDerivative(String where, double gx, double gy, double gz, double nx, double ny, double nz) {
        assertEquals((after.gx - before.gx) / (2 * H), gx, 2e-4, where);
        assertEquals((after.gy - before.gy) / (2 * H), gy, 2e-4, where);
        assertEquals((after.gz - before.gz) / (2 * H), gz, 2e-4, where);
        assertEquals((after.nx - before.nx) / (2 * H), nx, 2e-4, where);
        assertEquals((after.ny - before.ny) / (2 * H), ny, 2e-4, where);
        assertEquals((after.nz - before.nz) / (2 * H), nz, 2e-4, where);
    }

    @Test
    void curvaturesOfSphereAndCylinderAreInverseRadii() {
        for (double scale : new double[] {1e-9, 1, 1e9}) {
            Transform transform = Transform.scale(scale, scale, scale);
            for (boolean flipped : new boolean[] {false, true}) {
                double curvature = (flipped ? -1 : 1) / (0.5 * scale);
                Scene scene = scene(new Sphere(new Point3d(0, 0, 0), 0.5), transform, false, flipped);
                assertTrue(cast(
                        new RayCaster(scene), new double[] {3 * scale, scale, 2 * scale}, new double[] {0, 0, 0}, hit));
                assertTrue(scene.differential(hit, d));
                assertEquals(d.pux * curvature, d.nux, 1e-9 / scale);
                assertEquals(d.pvy * curvature, d.nvy, 1e-9 / scale);
                assertEquals(d.pvz * curvature, d.gvz, 1e-9 / scale);
                Cylinder tube = new Cylinder(new Point3d(0, 0, -1), new Point3d(0, 0, 1), 0.5);
                scene = scene(tube, transform, false, flipped);
                assertTrue(cast(
                        new RayCaster(scene), new double[] {3 * scale, scale, scale}, new double[] {0, 0, 0}, hit));
                assertTrue(scene.differential(hit, d));
                assertEquals(d.pux * curvature, d.nux, 1e-9 / scale);
                assertEquals(d.puy * curvature, d.nuy, 1e-9 / scale);
                assertEquals(0, d.nuz, 1e-9 / scale);
                assertEquals(0, d.nvz, 1e-9 / scale);
            }
        }
    }

    /** With smooth normals the curvature of a mesh scales as that of the surface that it stands for. */
    @Test
    void derivativesOfVertexNormalsScale() {
        double[] unit = new double[6];
        for (double scale : new double[] {1, 1e-9, 1e9}) {
            Scene scene = scene(sheet(true), Transform.scale(scale, scale, scale), true, false);
            double[] o = {0.3 * scale, -0.2 * scale, scale};
            assertTrue(cast(new RayCaster(scene), o, new double[] {0.3 * scale, -0.2 * scale, 0}, hit));
            assertTrue(scene.differential(hit, d));
            double[] now = {d.nux, d.nuy, d.nuz, d.nvx, d.nvy, d.nvz};
            for (int i = 0; i < 6; i++) {
                if (scale == 1) {
                    unit[i] = now[i];
                }
                assertEquals(unit[i], now[i] * scale, 1e-5);
            }
        }
    }

    @Test
    void saysWhereItIsNotKnown() {
        Bsdf mapped = new NormalMap(ConstantTexture.grey(0.9), GREY, false);
        for (Bsdf material : new Bsdf[] {
            mapped,
            new Mask(ConstantTexture.grey(0.5), mapped),
            new TwoSided(GREY, mapped),
            new Blend(ConstantTexture.grey(0.5), GREY, mapped)
        }) {
            Scene scene = scene(new ShapeNode(new Rectangle(), material));
            assertTrue(new RayCaster(scene).trace(0, 0.1, 1, 0, 0, -1, RayKind.CAMERA, hit));
            assertFalse(scene.differential(hit, d));
        }
        Scene scene = scene(sheet(true), Transform.identity(), false, false);
        assertTrue(new RayCaster(scene).trace(0.3, -0.2, 1, 0, 0, -1, RayKind.CAMERA, hit));
        hit.primitive = 0;
        assertFalse(scene.differential(hit, d));
        hit.primitive = -1;
        assertFalse(scene.differential(hit, d));
        hit.primitive = 1000;
        assertFalse(scene.differential(hit, d));
    }
}
