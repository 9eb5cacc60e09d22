package org.daybreak.scenes.gltf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.PrincipledThin;
import org.daybreak.core.material.TangentFrame;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.SceneReader;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** glTF files all the way to the scene graph. */
class LoadedSceneTest {
    @TempDir
    Path folder;

    private SceneFile load(GltfText text) throws IOException, SceneException {
        return new SceneReader().load(text.write(folder), Map.of());
    }

    private ShapeNode shape(String material) throws IOException, SceneException {
        Node node = load(MaterialTest.text("'POSITION':0,'TEXCOORD_0':1,'COLOR_0':2", material))
                .graph()
                .root()
                .children()
                .get(0);
        return assertInstanceOf(ShapeNode.class, node);
    }

    @Test
    void cameraAndLightAreAddedWhereThereAreNone() throws IOException, SceneException {
        SceneFile file = load(MaterialTest.text("'POSITION':0", "{}"));
        assertNotNull(file.graph().camera());
        assertEquals(960, file.graph().film().width());
        assertInstanceOf(LightNode.class, file.graph().root().children().get(1));
        assertEquals(List.of(), file.warnings());
        Scene scene = SceneCompiler.compile(file.graph());
        assertEquals(1, scene.lightCount());
    }

    @Test
    void cameraOfTheFileIsUsed() throws IOException, SceneException {
        SceneFile file = load(MaterialTest.text("'POSITION':0", "{'emissiveFactor':[1,1,1]}")
                .with("cameras", "[{'type':'perspective','perspective':{'yfov':0.5,'znear':0.1,'aspectRatio':2}}]")
                .with("nodes", "[{'mesh':0},{'camera':0,'translation':[1,2,3]}]"));
        assertEquals(Math.toDegrees(0.5), file.graph().camera().fieldOfViewDegrees(), 1e-9);
        assertEquals(1440, file.graph().film().width());
        // A thing that glows is a light, but hardly one to see the model by: the view adds its own.
        assertEquals(2, file.graph().root().children().size());
    }

    /** The picture shows 2·xmag across and 2·ymag down of the plane through the camera, along its −z. */
    @Test
    void orthographicCamerasSeeTheirMagnification() throws IOException, SceneException {
        SceneFile file = load(MaterialTest.text("'POSITION':0", "{}")
                .with("cameras", "[{'type':'orthographic','orthographic':{'xmag':3,'ymag':1.5,'znear':0,'zfar':9}}]")
                .with("nodes", "[{'mesh':0},{'camera':0,'translation':[10,20,30],'scale':[1,1,2]}]"));
        Camera camera = SceneCompiler.compile(file.graph()).camera();
        assertEquals(1440, camera.width());
        assertEquals(720, camera.height());
        CameraRay ray = new CameraRay();
        for (double[] fraction : new double[][] {{0, 0}, {1, 0}, {0.5, 0.75}}) {
            assertTrue(camera.sampleRay(1440 * fraction[0], 720 * fraction[1], 0.5, 0.5, ray));
            assertEquals(10 + 3 * (2 * fraction[0] - 1), ray.ox, 1e-9);
            assertEquals(20 + 1.5 * (1 - 2 * fraction[1]), ray.oy, 1e-9);
            assertEquals(-1, ray.dz, 1e-12);
        }
    }

    @Test
    void materialsAreBuilt() throws IOException, SceneException {
        String textured = "'pbrMetallicRoughness':{'baseColorFactor':[0.5,1,1,0.5],'baseColorTexture':{'index':1},"
                + "'metallicRoughnessTexture':{'index':0}},'normalTexture':{'index':0,'scale':2}";
        assertInstanceOf(TwoSided.class, shape("{" + textured + "}").material());
        assertInstanceOf(
                Mask.class, shape("{'alphaMode':'BLEND'," + textured + "}").material());
        assertInstanceOf(
                Mask.class, shape("{'alphaMode':'MASK'," + textured + "}").material());
        assertInstanceOf(
                PrincipledThin.class,
                shape("{'extensions':{'KHR_materials_transmission':{'transmissionFactor':1}}}")
                        .material());
        assertTrue(shape("{'emissiveFactor':[1,0,0],'emissiveTexture':{'index':0}}")
                        .radiance()
                        .maximum()
                > 0);
    }

    @Test
    void instancesShareTheirPrototype() throws IOException, SceneException {
        List<Node> nodes = load(MaterialTest.text("'POSITION':0", "{}")
                        .with("nodes", "[{'mesh':0},{'mesh':0,'translation':[0,0,5]}]"))
                .graph()
                .root()
                .children();
        Instance first = assertInstanceOf(Instance.class, nodes.get(0));
        assertSame(
                first.prototype(),
                assertInstanceOf(Instance.class, nodes.get(1)).prototype());
    }

    /** Whether a render goes on from a state depends on all files that the scene came from. */
    @Test
    void buffersAndImagesBelongToTheScene() throws IOException, SceneException {
        GltfText text = MaterialTest.text(
                        "'POSITION':0,'TEXCOORD_0':1", "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}")
                .with("images", "[{'uri':'a%20picture.png'}]");
        Files.write(folder.resolve("a picture.png"), Base64.getDecoder().decode(MaterialTest.PNG));
        SceneFile file = new SceneReader().load(text.writeSeparate(folder, "data.bin", "data.bin"), Map.of());
        assertEquals(
                List.of("model.gltf", "data.bin", "a picture.png"),
                file.files().stream().map(f -> folder.relativize(f).toString()).toList());
    }

    /** The tangents of a file reach the mesh that is rendered, and the material asks for its coordinates. */
    @Test
    void tangentsAndSecondCoordinatesReachTheMesh() throws IOException, SceneException {
        GltfText text = MaterialTest.text(
                        "'POSITION':0,'NORMAL':2,'TEXCOORD_1':3,'TANGENT':4",
                        "{'normalTexture':{'index':0,'texCoord':1}}")
                .floats("VEC4", 1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1);
        ShapeNode shape = assertInstanceOf(
                ShapeNode.class, load(text).graph().root().children().get(0));
        TriangleMesh mesh = assertInstanceOf(TriangleMesh.class, shape.shape());
        assertArrayEquals(new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1}, mesh.tangents());
        assertArrayEquals(new float[] {0, 0, 5, 0, 0, 5}, mesh.secondUvs());
        assertEquals(TangentFrame.SECOND_UVS, shape.material().tangentFrame());
    }

    @Test
    void anEmptySceneIsAnError() throws IOException {
        SceneException e = assertThrows(SceneException.class, () -> load(new GltfText()));
        assertEquals(
                folder.resolve("model.gltf") + ": the scene is empty: there is nothing to look at", e.getMessage());
    }
}
