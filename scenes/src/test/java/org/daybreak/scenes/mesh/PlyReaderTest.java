package org.daybreak.scenes.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Stream;
import org.daybreak.core.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class PlyReaderTest {
    private static final String HEADER = """
            ply
            format ascii 1.0
            element vertex 4
            property float x
            property float y
            property float z
            element face 1
            property list uchar int vertex_indices
            end_header
            """;
    private static final String VERTICES = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

    @TempDir
    Path folder;

    private TriangleMesh read(byte[] bytes, boolean flip) throws IOException {
        return PlyReader.read(Files.write(folder.resolve("t.ply"), bytes), flip);
    }

    private TriangleMesh read(String text) throws IOException {
        return read(text.getBytes(StandardCharsets.ISO_8859_1), false);
    }

    /** A file with elements and properties to pass over, lists of all kinds, and a quadrilateral. */
    private static byte[] binary(ByteOrder order, PlyType index) throws IOException {
        String name = order == ByteOrder.BIG_ENDIAN ? "big" : "little";
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(("ply\r\nformat binary_" + name + "_endian 1.0\r\ncomment made by hand\r\nobj_info none\r\n"
                        + "element material 2\nproperty uchar r\nproperty list ushort double w\n"
                        + "element vertex 4\nproperty double x\nproperty uchar red\nproperty float y\n"
                        + "property short z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                        + "property float s\nproperty float t\n"
                        + "element face 2\nproperty int flags\nproperty list uint "
                        + index.name().toLowerCase(Locale.ROOT)
                        + " vertex_index\nend_header\n")
                .getBytes(StandardCharsets.US_ASCII));
        ByteBuffer b = ByteBuffer.allocate(1000).order(order);
        b.put((byte) 1).putShort((short) 2).putDouble(5).putDouble(6);
        b.put((byte) 2).putShort((short) 0);
        for (int i = 0; i < 4; i++) {
            b.putDouble(i < 2 ? 0 : 1).put((byte) 200).putFloat(i % 2 + 0.5f).putShort((short) -i);
            b.putFloat(0).putFloat(0).putFloat(i + 1).putFloat(i * 0.25f).putFloat(0.125f);
        }
        int[][] faces = {{0, 2, 3, 1}, {3, 2, 0}};
        for (int[] face : faces) {
            b.putInt(77).putInt(face.length);
            for (int v : face) {
                switch (index.bytes) {
                    case 1 -> b.put((byte) v);
                    case 2 -> b.putShort((short) v);
                    default -> b.putInt(v);
                }
            }
        }
        out.write(b.array(), 0, b.position());
        return out.toByteArray();
    }

    @ParameterizedTest
    @EnumSource(
            value = PlyType.class,
            names = {"INT8", "UINT8", "INT16", "UINT16", "INT32", "UINT32"})
    void readsBinaryOfBothByteOrders(PlyType index) throws IOException {
        for (ByteOrder order : new ByteOrder[] {ByteOrder.BIG_ENDIAN, ByteOrder.LITTLE_ENDIAN}) {
            TriangleMesh mesh = read(binary(order, index), true);
            assertArrayEquals(new float[] {0, 0.5f, 0, 0, 1.5f, -1, 1, 0.5f, -2, 1, 1.5f, -3}, mesh.positions());
            assertArrayEquals(new int[] {0, 2, 3, 0, 3, 1, 3, 2, 0}, mesh.triangles());
            assertArrayEquals(new float[] {0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4}, mesh.normals());
            assertArrayEquals(new float[] {0, 0.875f, 0.25f, 0.875f, 0.5f, 0.875f, 0.75f, 0.875f}, mesh.uvs());
        }
    }

    @Test
    void refusesEveryTruncation() throws IOException {
        byte[] whole = binary(ByteOrder.LITTLE_ENDIAN, PlyType.INT32);
        for (int length = 0; length < whole.length; length++) {
            byte[] part = Arrays.copyOf(whole, length);
            MeshFormatException e = assertThrows(MeshFormatException.class, () -> read(part, false));
            assertNotNull(e.getMessage());
        }
    }

    @Test
    void readsAscii() throws IOException {
        TriangleMesh mesh = read(HEADER + VERTICES + "4 0 1 2 3");
        assertArrayEquals(new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, mesh.positions());
        assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3}, mesh.triangles());
        assertNull(mesh.normals());
        assertNull(mesh.uvs());
    }

    @ParameterizedTest
    @ValueSource(strings = {"u v", "s t", "texture_u texture_v", "texture_s texture_t"})
    void knowsTheNamesOfTextureCoordinates(String names) throws IOException {
        String[] uv = names.split(" ", -1);
        String header = HEADER.replace(
                "property float z\n", "property float z\nproperty float " + uv[0] + "\nproperty float " + uv[1] + "\n");
        TriangleMesh mesh = read(header + "0 0 0 .1 .2 1 0 0 .3 .4 1 1 0 .5 .6 0 1 0 .7 .8\n3 0 1 2\n");
        assertArrayEquals(new float[] {.1f, .2f, .3f, .4f, .5f, .6f, .7f, .8f}, mesh.uvs());
    }

    /** Names as Assimp and others write them, and those of an attribute {@code vertex_uv1} that Mitsuba writes. */
    @ParameterizedTest
    @ValueSource(strings = {"u1 v1", "s1 t1", "texture_u1 texture_v1", "uv1_0 uv1_1"})
    void knowsTheNamesOfSecondTextureCoordinates(String names) throws IOException {
        String[] uv = names.split(" ", -1);
        String header = HEADER.replace(
                "property float z\n",
                "property float z\nproperty float s\nproperty float " + uv[0] + "\nproperty float t\nproperty double "
                        + uv[1] + "\n");
        String text = header + "0 0 0 .1 .5 .2 .75 1 0 0 .3 .25 .4 1 1 1 0 .5 0 .6 -1 0 1 0 .7 2 .8 0\n3 0 1 2\n";
        TriangleMesh mesh = read(text);
        assertArrayEquals(new float[] {.1f, .2f, .3f, .4f, .5f, .6f, .7f, .8f}, mesh.uvs());
        assertArrayEquals(new float[] {.5f, .75f, .25f, 1, 0, -1, 2, 0}, mesh.secondUvs());
        float[] flipped = read(text.getBytes(StandardCharsets.ISO_8859_1), true).secondUvs();
        assertArrayEquals(new float[] {.5f, .25f, .25f, 0, 0, 2, 2, 1}, flipped);
        assertNull(read(text.replace(" " + uv[1] + "\n", " other\n")).secondUvs());
    }

    @Test
    void acceptsFacesBeforeVertices() throws IOException {
        String header = """
                ply
                format ascii 1.0
                element face 1
                property list uchar int vertex_indices
                element vertex 3
                property float x
                property float y
                property float z
                end_header
                """;
        assertEquals(1, read(header + "3 0 1 2\n0 0 0 1 0 0 0 1 0").triangleCount());
        MeshFormatException e =
                assertThrows(MeshFormatException.class, () -> read(header + "3 0 1 3\n0 0 0 1 0 0 0 1 0"));
        assertTrue(String.valueOf(e.getMessage()).contains("refers to vertex 3 but there are 3"));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                arguments("", 1, "does not start with 'ply'"),
                arguments("plyx\n", 1, "does not start with 'ply'"),
                arguments("ply\n", 2, "no 'end_header'"),
                arguments("ply\nend_header\n", 2, "no 'format'"),
                arguments("ply\nformat ascii 2.0\n", 2, "version is '2.0'"),
                arguments("ply\nformat binary 1.0\n", 2, "unknown format 'binary'"),
                arguments("ply\nformat ascii 1.0\nelemnt vertex 3\n", 3, "did you mean 'element'?"),
                arguments("ply\nproperty float x\n", 2, "before the first 'element'"),
                arguments("ply\nelement vertex x\n", 2, "'x' is not a whole number"),
                arguments("ply\nelement vertex -1\n", 2, "not negative"),
                arguments(
                        "ply\nelement vertex 1\nproperty flaot x\n", 3, "unknown type 'flaot'; did you mean 'float'?"),
                arguments("ply\nelement face 1\nproperty list float int a\n", 3, "must be of an integer type"),
                arguments(HEADER.replace("vertex 4", "vertex 4000000000"), 3, "promises 4000000000 elements 'vertex'"),
                arguments(HEADER.replace("face 1", "face 999999") + VERTICES + "3 0 1 2\n", 7, "promises 999999"),
                arguments(HEADER.replace("float z", "float zz") + VERTICES + "3 0 1 2\n", 3, "no property 'z'"),
                arguments(HEADER.replace("float z", "float x") + VERTICES + "3 0 1 2\n", 3, "have 'x' twice"),
                arguments(
                        HEADER.replace("vertex_indices", "indices") + VERTICES + "3 0 1 2\n",
                        7,
                        "no list 'vertex_indices'"),
                arguments(HEADER.replace("uchar int", "uchar float") + VERTICES + "3 0 1 2\n", 7, "integer type"),
                arguments(
                        HEADER.replace("element face", "element tristrips") + VERTICES + "3 0 1 9\n",
                        14,
                        "refers to vertex 9"),
                arguments(
                        HEADER + "0 0 0\n1 nan 0\n1 1 0\n0 1 0\n3 0 1 2\n",
                        11,
                        "y of vertex 1 'nan' is not a finite number"),
                arguments(HEADER + VERTICES + "3 0 1 4\n", 14, "face 0 refers to vertex 4 but there are 4"),
                arguments(HEADER + VERTICES + "3 0 1 -1\n", 14, "face 0 refers to vertex -1"),
                arguments(HEADER + VERTICES + "2 0 1 1\n", 14, "face 0 has 2 vertices but needs at least 3"),
                arguments(HEADER + VERTICES + "3 0 1", 14, "a vertex index is missing"),
                arguments(HEADER.replace("face 1", "face 0") + VERTICES, 0, "the file has no faces"),
                arguments("ply\nformat ascii 1.0\nend_header\n", 0, "no element 'vertex'"));
    }

    @ParameterizedTest
    @MethodSource("mistakes")
    void namesLineAndReason(String text, int line, String message) {
        MeshFormatException e = assertThrows(MeshFormatException.class, () -> read(text));
        assertEquals(line, e.line(), e::getMessage);
        assertTrue(String.valueOf(e.getMessage()).contains(message), e::getMessage);
    }

    @Test
    void refusesNumbersThatAreNotFiniteInBinary() throws IOException {
        byte[] bytes = binary(ByteOrder.LITTLE_ENDIAN, PlyType.INT32);
        int data = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("end_header\n") + 11;
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putDouble(data + 22, Double.NaN);
        MeshFormatException e = assertThrows(MeshFormatException.class, () -> read(bytes, false));
        assertEquals("x of vertex 0 is not a finite number", e.getMessage());
        assertEquals(0, e.line());
    }
}
