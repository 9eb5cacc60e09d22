package org.daybreak.scenes.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Nodes, instances, cameras and lights. */
class SceneTest {
    private static final double HALF = Math.sqrt(0.5);

    @TempDir
    Path folder;

    private Descriptions read(GltfText text) throws IOException {
        return Descriptions.read(text, folder);
    }

    private static GltfText triangle(String nodes) {
        return GltfText.mesh("'POSITION':0", "").with("nodes", nodes).floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
    }

    private static void assertMaps(Matrix4d m, double[] from, double... to) {
        Point3d p = new Point3d(from);
        m.transform(p);
        assertTrue(p.epsilonEquals(new Point3d(to), 1e-12), () -> p + " instead of " + new Point3d(to));
    }

    /** A matrix, below it translation · rotation · scale: 90° about z takes x to y. */
    @Test
    void transformsAreMultipliedDownTheTree() throws IOException {
        Descriptions read = read(triangle("[{'matrix':[1,0,0,0, 0,1,0,0, 0,0,-1,0, 10,20,30,1],'children':[1]},"
                + "{'mesh':0,'translation':[1,2,3],'rotation':[0,0," + HALF + "," + HALF + "],'scale':[2,3,4]}]"));
        Matrix4d m = Descriptions.transform(read.only(ObjectKind.SHAPE));
        assertMaps(m, new double[] {0, 0, 0}, 11, 22, 27);
        assertMaps(m, new double[] {1, 0, 0}, 11, 24, 27);
        assertMaps(m, new double[] {0, 1, 0}, 8, 22, 27);
        assertMaps(m, new double[] {0, 0, 1}, 11, 22, 23);
    }

    @Test
    void theChosenSceneIsShown() throws IOException {
        GltfText text = triangle("[{'mesh':0},{'translation':[5,0,0],'children':[2]},{'mesh':0}]")
                .with("scenes", "[{'nodes':[0]},{'nodes':[1]}]");
        assertEquals(0, Descriptions.transform(read(text).only(ObjectKind.SHAPE)).m03);
        assertEquals(5, Descriptions.transform(read(text.with("scene", "1")).only(ObjectKind.SHAPE)).m03);
    }

    @Test
    void meshesThatAppearSeveralTimesAreInstanced() throws IOException {
        Descriptions read = read(triangle("[{'mesh':0},{'mesh':0,'translation':[1,0,0]},{'mesh':0,'scale':[-1,1,1]}]"));
        List<ObjectDescription> shapes = read.all(ObjectKind.SHAPE);
        assertEquals(
                List.of("instance", "instance", "instance"),
                shapes.stream().map(ObjectDescription::type).toList());
        ObjectDescription group = Descriptions.child(shapes.get(0), ObjectKind.SHAPE);
        assertEquals("shapegroup", group.type());
        assertSame(group, Descriptions.child(shapes.get(2), ObjectKind.SHAPE));
        assertEquals("mesh", Descriptions.child(group, ObjectKind.SHAPE).type());
        assertEquals(1, Descriptions.transform(shapes.get(1)).m03);
        assertEquals(-1, Descriptions.transform(shapes.get(2)).m00);
    }

    @Test
    void gpuInstances() throws IOException {
        GltfText text = triangle("[{'mesh':0,'scale':[2,2,2],'extensions':{'EXT_mesh_gpu_instancing':"
                        + "{'attributes':{'TRANSLATION':1,'ROTATION':2,'SCALE':3}}}}]")
                .with("extensionsUsed", "['EXT_mesh_gpu_instancing']")
                .with("extensionsRequired", "['EXT_mesh_gpu_instancing']")
                .floats("VEC3", 1, 2, 3, 4, 5, 6)
                .numbers(GltfText.BYTE, "VEC4", true, 0, 0, 0, 127, 0, 0, 127, 0)
                .floats("VEC3", 1, 1, 1, 1, 2, 3);
        List<ObjectDescription> shapes = read(text).all(ObjectKind.SHAPE);
        assertEquals(2, shapes.size());
        assertMaps(Descriptions.transform(shapes.get(0)), new double[] {1, 1, 1}, 4, 6, 8);
        // Half a turn about z, then the node's scale.
        assertMaps(Descriptions.transform(shapes.get(1)), new double[] {1, 1, 1}, 6, 6, 18);
    }

    @Test
    void whatIsScaledToNothingIsLeftOut() throws IOException {
        Descriptions read = read(triangle("[{'mesh':0},{'mesh':0,'scale':[0,0,0]}]"));
        assertEquals("mesh", read.only(ObjectKind.SHAPE).type());
        assertEquals(List.of("/nodes/1 is left out where its transform flattens it"), read.warnings());
    }

    @Test
    void perspectiveCameraLooksAlongMinusZ() throws IOException {
        GltfText text = new GltfText()
                .with("cameras", "[{'type':'perspective','perspective':{'yfov':0.5,'znear':0.1,'aspectRatio':2}}]")
                .with("nodes", "[{'camera':0,'translation':[1,2,3],'scale':[1,5,2]}]");
        ObjectDescription camera = read(text).only(ObjectKind.SENSOR);
        assertEquals("perspective", camera.type());
        assertEquals(Math.toDegrees(0.5), Descriptions.number(camera, "fov"), 1e-12);
        assertEquals("y", Descriptions.text(camera, "fov_axis"));
        Matrix4d m = Descriptions.transform(camera);
        assertMaps(m, new double[] {0, 0, 1}, 1, 2, 2);
        assertMaps(m, new double[] {0, 1, 0}, 1, 3, 3);
        assertMaps(m, new double[] {1, 0, 0}, 0, 2, 3);
        ObjectDescription film = Descriptions.child(camera, ObjectKind.FILM);
        assertEquals(1440, Descriptions.number(film, "width"));
        assertEquals(720, Descriptions.number(film, "height"));
    }

    @Test
    void orthographicCameraIsScaledToItsWidth() throws IOException {
        GltfText text = new GltfText()
                .with("cameras", "[{'type':'orthographic','orthographic':{'xmag':3,'ymag':6,'znear':0,'zfar':9}}]")
                .with("nodes", "[{'camera':0}]");
        ObjectDescription camera = read(text).only(ObjectKind.SENSOR);
        assertEquals("orthographic", camera.type());
        assertMaps(Descriptions.transform(camera), new double[] {1, 1, 1}, -3, 3, -1);
        ObjectDescription film = Descriptions.child(camera, ObjectKind.FILM);
        assertEquals(720, Descriptions.number(film, "width"));
        assertEquals(1440, Descriptions.number(film, "height"));
    }

    @Test
    void punctualLights() throws IOException {
        GltfText text = new GltfText()
                .with("extensionsUsed", "['KHR_lights_punctual']")
                .with(
                        "extensions",
                        "{'KHR_lights_punctual':{'lights':["
                                + "{'type':'point','color':[1,0.5,0],'intensity':4},"
                                + "{'type':'spot','intensity':2,'spot':{'innerConeAngle':0.1,'outerConeAngle':0.6}},"
                                + "{'type':'directional','intensity':3}]}}")
                .with(
                        "nodes",
                        "[{'translation':[1,2,3],'scale':[9,9,9],'extensions':{'KHR_lights_punctual':{'light':0}}},"
                                + "{'extensions':{'KHR_lights_punctual':{'light':1}}},"
                                + "{'rotation':[" + -HALF + ",0,0," + HALF
                                + "],'extensions':{'KHR_lights_punctual':{'light':2}}}]");
        List<ObjectDescription> lights = read(text).all(ObjectKind.EMITTER);
        assertEquals("point", lights.get(0).type());
        assertEquals(new Value.Color(4, 2, 0), Descriptions.value(lights.get(0), "intensity"));
        assertMaps(Descriptions.transform(lights.get(0)), new double[] {0, 0, 0}, 1, 2, 3);
        assertEquals("spot", lights.get(1).type());
        assertEquals(Math.toDegrees(0.6), Descriptions.number(lights.get(1), "cutoff_angle"), 1e-12);
        assertEquals(Math.toDegrees(0.1), Descriptions.number(lights.get(1), "beam_width"), 1e-12);
        assertMaps(Descriptions.transform(lights.get(1)), new double[] {0, 0, 1}, 0, 0, -1);
        assertEquals("directional", lights.get(2).type());
        assertEquals(new Value.Color(3, 3, 3), Descriptions.value(lights.get(2), "irradiance"));
        // Turned by −90° about x it shines down.
        assertMaps(Descriptions.transform(lights.get(2)), new double[] {0, 0, 1}, 0, -1, 0);
    }

    @Test
    void unknownExtensionsThatAreNotRequiredGiveAWarning() throws IOException {
        Descriptions read = read(triangle("[{'mesh':0}]").with("extensionsUsed", "['KHR_texture_transform','X_y']"));
        assertEquals(List.of("/extensionsUsed/1 uses the extension X_y, which is not supported"), read.warnings());
    }
}
