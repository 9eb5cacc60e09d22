package org.daybreak.scenes.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.light.ImageEnvironment;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.SceneReader;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.view.AutoView.UpAxis;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class AutoViewTest {
    /** Largest of |x| and |y| over the half image, of all points; 1 is the border. */
    private static double reach(Group root, CameraSettings camera, double aspect) {
        Transform toView = Transform.of(camera.toWorld()).inverse();
        double tan = Math.tan(Math.toRadians(camera.fieldOfViewDegrees() / 2));
        double[] p = new double[3];
        double[] reach = {0};
        ScenePoints.visit(root, (x, y, z) -> {
            toView.applyPoint(x, y, z, p);
            assertTrue(p[2] > 0, "a point lies behind the camera");
            reach[0] = Math.max(reach[0], Math.abs(p[0]) / (p[2] * tan * Math.max(1, aspect)));
            reach[0] = Math.max(reach[0], Math.abs(p[1]) / (p[2] * tan * Math.max(1, 1 / aspect)));
        });
        return reach[0];
    }

    @ParameterizedTest
    @CsvSource({"1, 1, 1, 1.5", "1, 9, 1, 1.5", "20, 1, 3, 0.6", "1e-4, 2e-4, 3e-4, 1", "3e6, 1e6, 1e6, 2"})
    void modelJustFits(double x, double y, double z, double aspect) {
        Group root = new Group();
        ShapeNode node = root.add(new ShapeNode(new Sphere(new Point3d(3, 0, 0), 1), AutoView.neutralMaterial()));
        node.setTransform(Transform.scale(x, y, z).toMatrix4d());
        for (UpAxis up : UpAxis.values()) {
            assertEquals(0.9, reach(root, AutoView.fit(root, up, aspect), aspect), 1e-6);
        }
    }

    @Test
    void instancesAndGroupsCount() {
        Group plant = new Group();
        plant.add(new ShapeNode(new Cylinder(new Point3d(), new Point3d(0, 1, 0), 0.1), AutoView.neutralMaterial()));
        Group pair = new Group();
        pair.add(new Instance(plant));
        pair.add(new Instance(plant)).setTransform(Transform.translate(5, 0, 0).toMatrix4d());
        Group root = new Group();
        root.add(new Instance(pair)).setTransform(Transform.translate(0, 0, 7).toMatrix4d());
        double[] sum = new double[2];
        ScenePoints.visit(root, (x, y, z) -> {
            sum[0] = Math.max(sum[0], x);
            sum[1] = Math.max(sum[1], z);
        });
        assertEquals(5.1, sum[0], 1e-12);
        assertEquals(7.1, sum[1], 1e-12);
        pair.add(new Instance(pair));
        assertThrows(IllegalArgumentException.class, () -> AutoView.fit(root, UpAxis.Y, 1));
    }

    @ParameterizedTest
    @EnumSource
    void looksFromTheFrontAndAbove(UpAxis up) {
        Group root = new Group();
        root.add(new ShapeNode(new Sphere(new Point3d(), 1), AutoView.neutralMaterial()));
        Matrix4d m = AutoView.fit(root, up, 1).toWorld();
        boolean y = up == UpAxis.Y;
        double[] at = {m.m03, y ? m.m13 : -m.m23, y ? m.m23 : -m.m13};
        assertTrue(at[0] > 0 && at[2] > at[0]);
        assertTrue(y ? m.m13 > 0 && m.m11 > 0.9 : m.m23 > 0 && m.m21 > 0.9);
    }

    @Test
    void degenerateModelsHaveAView() {
        Group point = new Group();
        point.add(new ShapeNode(
                new TriangleMesh(new float[] {1, 1, 1, 1, 1, 1, 1, 1, 1}, new int[] {0, 1, 2}, null, null),
                AutoView.neutralMaterial()));
        assertTrue(AutoView.fit(point, UpAxis.Y, 1).focusDistance() > 0);
        assertThrows(IllegalArgumentException.class, () -> AutoView.complete(new SceneGraph(), UpAxis.Y));
    }

    /** The lamp is where it is said to be, as bright as it is said to be, whatever the camera. */
    @Test
    void lampShinesOverTheLeftShoulder() {
        Matrix4d camera = Transform.lookAt(1, 2, 3, -4, 0, 2, 0.1, 1, 0).toMatrix4d();
        LightNode node = AutoView.light(camera);
        LightSource.ImageEnvironment source = (LightSource.ImageEnvironment) node.source();
        ImageEnvironment light =
                new ImageEnvironment(source.image(), source.scale(), Transform.of(node.transform()), 0, 0, 0, 1);
        Vector3d lamp = new Vector3d(0.55, 0.65, -0.6);
        camera.transform(lamp);
        lamp.normalize();
        // Irradiance of a surface that faces the lamp or turns away from it, by the midpoint rule.
        assertEquals(Math.PI * 0.35 + 2, irradiance(light, lamp), 0.02);
        lamp.negate();
        assertEquals(Math.PI * 0.35, irradiance(light, lamp), 0.01);
    }

    private static double irradiance(ImageEnvironment light, Vector3d normal) {
        Spectrum radiance = new Spectrum();
        SurfacePoint nowhere = new SurfacePoint();
        int steps = 1000;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double y = -1 + 2 * (i + 0.5) / steps;
            double r = Math.sqrt(1 - y * y);
            for (int k = 0; k < steps; k++) {
                double phi = 2 * Math.PI * (k + 0.5) / steps;
                Vector3d d = new Vector3d(r * Math.cos(phi), y, r * Math.sin(phi));
                double cosine = d.dot(normal);
                if (cosine > 0) {
                    light.radiance(nowhere, -d.x, -d.y, -d.z, radiance);
                    sum += radiance.g * cosine;
                }
            }
        }
        return sum * 4 * Math.PI / ((double) steps * steps);
    }

    @Test
    void whatIsThereStays() {
        SceneGraph graph = new SceneGraph();
        graph.root()
                .add(new ShapeNode(new Sphere(new Point3d(), 1), AutoView.neutralMaterial()))
                .setRadiance(org.daybreak.core.material.ConstantTexture.grey(1));
        Group lit = graph.root().add(new Group());
        lit.add(new LightNode(new LightSource.Point(new javax.vecmath.Color3f(1, 1, 1))));
        CameraSettings camera = new CameraSettings(Transform.translate(0, 0, -9).toMatrix4d(), 20);
        graph.setCamera(camera);
        AutoView.complete(graph, UpAxis.Y);
        assertSame(camera, graph.camera());
        assertEquals(2, graph.root().children().size());
        lit.remove(lit.children().get(0));
        AutoView.complete(graph, UpAxis.Y);
        assertEquals(3, graph.root().children().size(), "a shape that glows does not light the scene");
    }

    @Test
    void meshesLoadAsScenes(@TempDir Path folder) throws IOException, SceneException {
        for (String ending : new String[] {"obj", "OBJ", "stl"}) {
            String text = ending.equals("stl")
                    ? org.daybreak.scenes.mesh.StlReaderTest.FACET
                    : "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
            SceneFile file = new SceneReader().load(Files.writeString(folder.resolve("m." + ending), text), Map.of());
            assertEquals(2, file.graph().root().children().size(), "the shape and the light");
            assertTrue(file.graph().camera() != null && file.graph().film() != null);
            assertTrue(file.warnings().isEmpty());
        }
        Path bad = Files.writeString(folder.resolve("b.obj"), "v 0 0 0\nf 1 2 3\n");
        SceneException e = assertThrows(SceneException.class, () -> new SceneReader().load(bad, Map.of("n", "1")));
        assertEquals(2, e.problems().size(), e.getMessage());
        assertTrue(String.valueOf(e.getMessage()).contains("b.obj:2: "), e.getMessage());
    }
}
