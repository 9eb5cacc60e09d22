package org.daybreak.core.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import javax.vecmath.Color3f;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.BoundingSphere;
import org.daybreak.core.geometry.Cone;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.SurfaceSampler;
import org.daybreak.core.geometry.SurfaceSamplers;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.NullBsdf;
import org.daybreak.core.math.Transform;
import org.junit.jupiter.api.Test;

/** Spheres around shapes, and those that a scene keeps for mirrors and glass. */
class DeltaSpheresTest {
    private static final Transform SHEARED = Transform.ofRows(1.2, 0.3, -0.1, 4, 0.2, 0.8, 0.4, -2, -0.3, 0.1, 1.5, 1);

    @Test
    void spheresHoldTheirShapes() {
        TriangleMesh mesh = new TriangleMesh(
                new float[] {0, 0, 0, 3, 0.5f, 0, 1, 2, 0.2f, -1, 0, 1}, new int[] {0, 1, 2, 1, 2, 3}, null, null);
        List<Shape> shapes = List.of(
                new Sphere(new Point3d(1, 2, 3), 0.7),
                new Disk(),
                new Rectangle(),
                new Cube(),
                new Cylinder(new Point3d(0, 0, 1), new Point3d(1, 1, 2), 0.4),
                mesh);
        for (Transform map : List.of(Transform.identity(), Transform.rotate(1, 2, 3, 40), SHEARED)) {
            for (Shape shape : shapes) {
                BoundingSphere sphere = BoundingSphere.of(shape, map);
                SurfaceSampler sampler = SurfaceSamplers.of(shape, map, false, 0, null);
                SurfacePoint point = new SurfacePoint();
                double farthest = 0;
                for (int i = 0; i < 32; i++) {
                    for (int j = 0; j < 32; j++) {
                        assertTrue(sampler.sampleArea(i / 31.5, j / 31.5, point) > 0);
                        farthest = Math.max(farthest, distance(sphere, point.x, point.y, point.z));
                    }
                }
                assertTrue(farthest <= sphere.radius() * (1 + 1e-6), () -> shape + " leaves its sphere");
                assertTrue(farthest >= 0.5 * sphere.radius(), () -> shape + " has too large a sphere");
            }
        }
        BoundingSphere cone =
                BoundingSphere.of(new Cone(new Point3d(0, 0, 0), new Point3d(0, 0, 2), 1, 0.2), Transform.identity());
        assertTrue(distance(cone, 1, 0, 0) <= cone.radius() && distance(cone, 0, 0.2, 2) <= cone.radius());
    }

    @Test
    void sphereOfASphereIsTight() {
        BoundingSphere sphere = BoundingSphere.of(
                new Sphere(new Point3d(1, 0, 0), 2), Transform.scale(-3, 3, 3).multiply(Transform.rotate(0, 1, 0, 30)));
        assertEquals(6, sphere.radius(), 1e-12);
    }

    @Test
    void fewSpheresHoldMany() {
        Random random = new Random(5);
        DeltaSpheres few = new DeltaSpheres();
        List<BoundingSphere> all = new ArrayList<>();
        for (int i = 0; i < 500; i++) {
            BoundingSphere sphere = new BoundingSphere(
                    random.nextGaussian(), random.nextGaussian(), random.nextGaussian(), 0.2 * random.nextDouble());
            all.add(sphere);
            few.add(sphere);
        }
        List<BoundingSphere> kept = few.build();
        assertEquals(8, kept.size());
        for (BoundingSphere sphere : all) {
            assertTrue(kept.stream()
                    .anyMatch(k -> distance(k, sphere.x(), sphere.y(), sphere.z()) + sphere.radius()
                            <= k.radius() * (1 + 1e-9)));
        }
    }

    @Test
    void sceneKnowsItsGlass() {
        SceneGraph graph = new SceneGraph();
        ConstantTexture white = ConstantTexture.grey(1);
        Dielectric glass = new Dielectric(1.5, 1, white, white);
        graph.root().add(new ShapeNode(new Sphere(new Point3d(0, 0, 0), 1), new Diffuse(white)));
        graph.root().add(new ShapeNode(new Sphere(new Point3d(3, 0, 0), 1), new NullBsdf()));
        graph.root().add(new ShapeNode(new Sphere(new Point3d(6, 0, 0), 1), glass));
        Group prototype = new Group();
        prototype.add(new ShapeNode(new Sphere(new Point3d(0, 0, 0), 1), glass));
        Instance instance = new Instance(prototype);
        Matrix4d moved = new Matrix4d();
        moved.setIdentity();
        moved.setTranslation(new Vector3d(0, 9, 0));
        instance.setTransform(moved);
        graph.root().add(instance);
        graph.root().add(new LightNode(new LightSource.Point(new Color3f(1, 1, 1))));
        graph.setCamera(
                new CameraSettings(Transform.lookAt(0, 0, 20, 0, 0, 0, 0, 1, 0).toMatrix4d(), 45));
        graph.setFilm(new FilmSettings(4, 4, ReconstructionFilter.BOX));
        List<BoundingSphere> spheres = SceneCompiler.compile(graph).deltaSpheres();
        assertEquals(2, spheres.size());
        assertEquals(new BoundingSphere(6, 0, 0, 1), spheres.get(0));
        assertEquals(0, distance(spheres.get(1), 0, 9, 0), 1e-5);
        assertTrue(spheres.get(1).radius() >= 1 && spheres.get(1).radius() < 1.8);
    }

    private static double distance(BoundingSphere sphere, double x, double y, double z) {
        return Math.sqrt((x - sphere.x()) * (x - sphere.x())
                + (y - sphere.y()) * (y - sphere.y())
                + (z - sphere.z()) * (z - sphere.z()));
    }
}
