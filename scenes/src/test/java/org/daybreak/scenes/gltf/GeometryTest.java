package org.daybreak.scenes.gltf;

import static org.daybreak.scenes.gltf.GltfText.BYTE;
import static org.daybreak.scenes.gltf.GltfText.FLOAT;
import static org.daybreak.scenes.gltf.GltfText.SHORT;
import static org.daybreak.scenes.gltf.GltfText.UNSIGNED_BYTE;
import static org.daybreak.scenes.gltf.GltfText.UNSIGNED_INT;
import static org.daybreak.scenes.gltf.GltfText.UNSIGNED_SHORT;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.List;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Accessors, primitives, morph targets and skins. */
class GeometryTest {
    private static final double[] SQUARE = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

    @TempDir
    Path folder;

    private TriangleMesh mesh(GltfText text) throws IOException {
        return Descriptions.read(text, folder).mesh();
    }

    private static float[] floats(double... values) {
        float[] out = new float[values.length];
        for (int i = 0; i < out.length; i++) {
            out[i] = (float) values[i];
        }
        return out;
    }

    @ParameterizedTest
    @ValueSource(ints = {UNSIGNED_BYTE, UNSIGNED_SHORT, UNSIGNED_INT})
    void indicesOfAllTypes(int type) throws IOException {
        TriangleMesh mesh = mesh(GltfText.mesh("'POSITION':0,'NORMAL':1,'TEXCOORD_0':2", ",'indices':3")
                .floats("VEC3", SQUARE)
                .floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .floats("VEC2", 0, 1, 1, 1, 1, 0, 0, 0)
                .numbers(type, "SCALAR", false, 0, 1, 2, 2, 3, 0));
        assertArrayEquals(floats(SQUARE), mesh.positions());
        assertArrayEquals(new int[] {0, 1, 2, 2, 3, 0}, mesh.triangles());
        assertArrayEquals(floats(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1), mesh.normals());
        assertArrayEquals(floats(0, 1, 1, 1, 1, 0, 0, 0), mesh.uvs());
    }

    @Test
    void withoutIndicesAndNormals() throws IOException {
        TriangleMesh mesh = mesh(GltfText.mesh("'POSITION':0", "").floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0));
        assertArrayEquals(new int[] {0, 1, 2}, mesh.triangles());
        assertNull(mesh.normals());
        assertNull(mesh.uvs());
    }

    /** Tangents count with normals only; the sign of the bitangent is that of the texture coordinates. */
    @Test
    void tangentsAreKept() throws IOException {
        GltfText text = GltfText.mesh("'POSITION':0,'NORMAL':1,'TANGENT':2", "")
                .floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0)
                .floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .floats("VEC4", 1, 0, 0, 1, 0, 1, 0, -1, 0.5, 0.5, 0, 1);
        assertArrayEquals(floats(1, 0, 0, 0, 1, 0, 0.5, 0.5, 0), mesh(text).tangents());
        text.with("meshes", "[{'primitives':[{'attributes':{'POSITION':0,'TANGENT':2}}]}]");
        assertNull(mesh(text).tangents());
    }

    @Test
    void stripsKeepTheirWinding() throws IOException {
        GltfText text =
                GltfText.mesh("'POSITION':0", ",'mode':5").floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0);
        assertArrayEquals(new int[] {0, 1, 2, 1, 3, 2, 2, 3, 4}, mesh(text).triangles());
    }

    @Test
    void fansTurnAboutTheirFirstVertex() throws IOException {
        GltfText text = GltfText.mesh("'POSITION':0", ",'mode':6,'indices':1")
                .floats("VEC3", SQUARE)
                .numbers(UNSIGNED_BYTE, "SCALAR", false, 3, 0, 1, 2);
        assertArrayEquals(new int[] {0, 1, 3, 1, 2, 3}, mesh(text).triangles());
    }

    /** The degenerate corners by which strips jump make no triangles. */
    @Test
    void degenerateTrianglesOfStripsAreDropped() throws IOException {
        GltfText text = GltfText.mesh("'POSITION':0", ",'mode':5,'indices':1")
                .floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0)
                .numbers(UNSIGNED_BYTE, "SCALAR", false, 0, 1, 2, 2, 3, 3, 4, 5);
        assertArrayEquals(new int[] {0, 1, 2, 3, 5, 4}, mesh(text).triangles());
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void pointsAndLinesAreLeftOut(int mode) throws IOException {
        Descriptions read = Descriptions.read(
                GltfText.mesh("'POSITION':0", ",'mode':" + mode).floats("VEC3", SQUARE), folder);
        assertEquals(List.of(), read.all(ObjectKind.SHAPE));
        assertEquals(List.of("/meshes/0/primitives/0 is left out: points and lines have no surface"), read.warnings());
    }

    @Test
    void cornersLeftOverAreReported() throws IOException {
        Descriptions read = Descriptions.read(GltfText.mesh("'POSITION':0", "").floats("VEC3", SQUARE), folder);
        assertArrayEquals(new int[] {0, 1, 2}, read.mesh().triangles());
        assertEquals(List.of("/meshes/0/primitives/0 has corners that make no whole triangle: 1"), read.warnings());
    }

    @Test
    void stridesAndOffsets() throws IOException {
        // Four bytes of padding, then position and texture coordinate by turns.
        ByteBuffer data = ByteBuffer.allocate(4 + 3 * 20).order(ByteOrder.LITTLE_ENDIAN);
        data.putInt(-1);
        double[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        for (int i = 0; i < 3; i++) {
            for (int c = 0; c < 3; c++) {
                data.putFloat((float) positions[3 * i + c]);
            }
            data.putFloat(i).putFloat(-i);
        }
        GltfText text = GltfText.mesh("'POSITION':0,'TEXCOORD_0':1", "");
        int view = text.view(data.array(), 20);
        String tail = ",'componentType':5126,'count':3,'type':";
        text.accessor("{'bufferView':" + view + ",'byteOffset':4" + tail + "'VEC3'}");
        text.accessor("{'bufferView':" + view + ",'byteOffset':16" + tail + "'VEC2'}");
        TriangleMesh mesh = mesh(text);
        assertArrayEquals(floats(positions), mesh.positions());
        assertArrayEquals(floats(0, 0, 1, -1, 2, -2), mesh.uvs());
    }

    @Test
    void sparseAccessorsReplaceElements() throws IOException {
        GltfText text = GltfText.mesh("'POSITION':0", ",'indices':1");
        int base = text.view(GltfText.bytes(FLOAT, SQUARE), 0);
        int indices = text.view(GltfText.bytes(UNSIGNED_SHORT, 1, 3), 0);
        int values = text.view(GltfText.bytes(FLOAT, 9, 9, 9, 2, 0, 5, 0, 2, 6), 0);
        text.accessor("{'bufferView':" + base + ",'componentType':5126,'count':4,'type':'VEC3','sparse':{'count':2,"
                + "'indices':{'bufferView':" + indices + ",'componentType':5123},'values':{'bufferView':" + values
                + ",'byteOffset':12}}}");
        text.numbers(UNSIGNED_BYTE, "SCALAR", false, 0, 1, 2, 2, 3, 0);
        assertArrayEquals(floats(0, 0, 0, 2, 0, 5, 1, 1, 0, 0, 2, 6), mesh(text).positions());
    }

    @Test
    void sparseAccessorsWithoutViewStartFromZero() throws IOException {
        GltfText text = GltfText.mesh("'POSITION':0", "");
        int indices = text.view(GltfText.bytes(UNSIGNED_INT, 1, 2), 0);
        int values = text.view(GltfText.bytes(FLOAT, 1, 0, 0, 0, 1, 0), 0);
        text.accessor("{'componentType':5126,'count':3,'type':'VEC3','sparse':{'count':2,'indices':{'bufferView':"
                + indices + ",'componentType':5125},'values':{'bufferView':" + values + "}}}");
        assertArrayEquals(floats(0, 0, 0, 1, 0, 0, 0, 1, 0), mesh(text).positions());
    }

    /** The formulas of the specification, 3.6.2.2; the most negative integers are −1 as well. */
    @Test
    void normalizedIntegers() throws IOException {
        TriangleMesh bytes = mesh(GltfText.mesh("'POSITION':0,'NORMAL':1,'TEXCOORD_0':2", "")
                .numbers(BYTE, "VEC3", true, -128, 0, 0, 127, 0, 0, 0, 64, -127)
                .numbers(SHORT, "VEC3", true, 0, 0, 32767, 0, -32768, 0, 16384, 0, 1)
                .numbers(UNSIGNED_SHORT, "VEC2", true, 0, 65535, 32768, 1, 255, 256));
        assertArrayEquals(floats(-1, 0, 0, 1, 0, 0, 0, 64 / 127f, -1), bytes.positions());
        assertArrayEquals(floats(0, 0, 1, 0, -1, 0, 16384 / 32767f, 0, 1 / 32767f), bytes.normals());
        assertArrayEquals(floats(0, 1, 32768 / 65535f, 1 / 65535f, 255 / 65535f, 256 / 65535f), bytes.uvs());
    }

    /** KHR_mesh_quantization allows integers as they are. */
    @Test
    void quantizedPositionsAndCoordinates() throws IOException {
        TriangleMesh mesh = mesh(GltfText.mesh("'POSITION':0,'TEXCOORD_0':1", "")
                .with("extensionsRequired", "['KHR_mesh_quantization']")
                .with("extensionsUsed", "['KHR_mesh_quantization']")
                .numbers(SHORT, "VEC3", false, -300, 0, 7, 20000, 0, 0, 0, -32768, 1)
                .numbers(UNSIGNED_BYTE, "VEC2", false, 0, 1, 2, 255, 128, 3));
        assertArrayEquals(floats(-300, 0, 7, 20000, 0, 0, 0, -32768, 1), mesh.positions());
        assertArrayEquals(floats(0, 1, 2, 255, 128, 3), mesh.uvs());
    }

    @Test
    void onlyUsedVerticesAreKept() throws IOException {
        TriangleMesh mesh = mesh(GltfText.mesh("'POSITION':0,'TEXCOORD_0':1", ",'indices':2")
                .floats("VEC3", 9, 9, 9, 1, 0, 0, 8, 8, 8, 0, 1, 0, 0, 0, 0, 7, 7, 7)
                .floats("VEC2", 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5)
                .numbers(UNSIGNED_BYTE, "SCALAR", false, 4, 1, 3));
        assertArrayEquals(floats(1, 0, 0, 0, 1, 0, 0, 0, 0), mesh.positions());
        assertArrayEquals(floats(1, 1, 3, 3, 4, 4), mesh.uvs());
        assertArrayEquals(new int[] {2, 0, 1}, mesh.triangles());
    }

    @Test
    void morphTargetsActWithTheirWeights() throws IOException {
        GltfText text = new GltfText()
                .floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0)
                .floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .floats("VEC3", 0, 0, 2, 0, 0, 0, 0, 0, 0)
                .floats("VEC3", 0, 0, 0, 0, 4, 0, 0, 0, 0)
                .floats("VEC3", 1, 0, 0, 0, 0, 0, 0, 0, 0)
                .with(
                        "meshes",
                        "[{'weights':[0.5,0],'primitives':[{'attributes':{'POSITION':0,'NORMAL':1},"
                                + "'targets':[{'POSITION':2,'NORMAL':4},{'POSITION':3}]}]}]")
                .with("nodes", "[{'mesh':0},{'mesh':0,'weights':[0,0.25]}]");
        List<ObjectDescription> shapes = Descriptions.read(text, folder).all(ObjectKind.SHAPE);
        assertEquals(2, shapes.size());
        assertArrayEquals(
                floats(0, 0, 1, 1, 0, 0, 0, 1, 0),
                Descriptions.mesh(shapes.get(0)).positions());
        assertArrayEquals(
                floats(0.5, 0, 1, 0, 0, 1, 0, 0, 1),
                Descriptions.mesh(shapes.get(0)).normals());
        assertArrayEquals(
                floats(0, 0, 0, 1, 1, 0, 0, 1, 0),
                Descriptions.mesh(shapes.get(1)).positions());
    }

    /** Two joints, one moved by a parent; the middle vertex hangs on both. The mesh's own node does not count. */
    @Test
    void skinsStandInTheirRestPose() throws IOException {
        GltfText text = new GltfText()
                .floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0)
                .floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .numbers(UNSIGNED_BYTE, "VEC4", false, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0)
                .floats("VEC4", 1, 0, 0, 0, 0.5, 0.5, 0, 0, 1, 0, 0, 0)
                .floats(
                        "MAT4", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1,
                        0, 0, 1)
                .with(
                        "meshes",
                        "[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'JOINTS_0':2,'WEIGHTS_0':3}}]}]")
                .with("skins", "[{'joints':[1,3],'inverseBindMatrices':4}]")
                .with(
                        "nodes",
                        "[{'mesh':0,'skin':0,'translation':[100,0,0]},{'translation':[0,0,2]},"
                                + "{'translation':[0,5,0],'children':[3]},"
                                // A quarter turn about x: y to z, z to −y.
                                + "{'rotation':[0.7071067811865476,0,0,0.7071067811865476]}]");
        Descriptions read = Descriptions.read(text, folder);
        TriangleMesh mesh = read.mesh();
        // Vertex 1: half of (1, 0, 2) and half of (0, 5, 0). Vertex 2: (−1, 1, 0) turned, then up by 5.
        assertArrayEquals(floats(0, 0, 2, 0.5, 2.5, 1, -1, 5, 1), mesh.positions(), 1e-6f);
        assertEquals(0, mesh.normals()[6], 1e-6);
        assertEquals(-1, mesh.normals()[7], 1e-6);
        assertEquals(1, Descriptions.transform(read.only(ObjectKind.SHAPE)).m00);
        assertEquals(0, Descriptions.transform(read.only(ObjectKind.SHAPE)).m03);
    }

    @Test
    void primitivesOfTheSameDataShareTheirMesh() throws IOException {
        GltfText text = new GltfText()
                .floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0)
                .with(
                        "meshes",
                        "[{'primitives':[{'attributes':{'POSITION':0}}]},{'primitives':[{'attributes':{'POSITION':0}}]}]")
                .with("nodes", "[{'mesh':0},{'mesh':1}]");
        List<ObjectDescription> shapes = Descriptions.read(text, folder).all(ObjectKind.SHAPE);
        assertSame(Descriptions.mesh(shapes.get(0)), Descriptions.mesh(shapes.get(1)));
    }

    @Test
    void binaryAndSeparateFilesHoldTheSame() throws IOException {
        GltfText text = GltfText.mesh("'POSITION':0", "").floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0);
        float[] expected = floats(0, 0, 0, 1, 0, 0, 0, 1, 0);
        Path binary = java.nio.file.Files.write(folder.resolve("model.glb"), text.binary());
        assertArrayEquals(expected, Descriptions.read(binary).mesh().positions());
        Path separate = text.writeSeparate(folder, "größe 1.bin", "gr%C3%B6%C3%9Fe%201.bin");
        assertArrayEquals(expected, Descriptions.read(separate).mesh().positions());
        assertTrue(GltfReader.isGltf(binary) && GltfReader.isGltf(separate));
    }
}
