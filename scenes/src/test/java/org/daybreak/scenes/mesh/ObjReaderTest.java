package org.daybreak.scenes.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.daybreak.core.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ObjReaderTest {
    private static final String SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    @TempDir
    Path folder;

    private TriangleMesh read(String text, boolean flip) throws IOException {
        return ObjReader.read(Files.writeString(folder.resolve("t.obj"), text), flip);
    }

    @Test
    void readsFacesInAllForms() throws IOException {
        String attributes = SQUARE + "vt 0 0\nvt 1 0.25\nvn 0 0 1\n";
        for (String face : new String[] {"1 2 3", "1/1 2/2 3/1", "1//1 2//1 3//1", "1/1/1 2/2/1 3/1/1"}) {
            TriangleMesh mesh = read(attributes + "f " + face + "\n", false);
            assertArrayEquals(new int[] {0, 1, 2}, mesh.triangles());
            assertArrayEquals(new float[] {0, 0, 0, 1, 0, 0, 1, 1, 0}, mesh.positions());
            float[] uvs = mesh.uvs();
            float[] normals = mesh.normals();
            if (face.contains("/1 ") && face.startsWith("1/1")) {
                assertArrayEquals(new float[] {0, 0, 1, 0.25f, 0, 0}, uvs);
            } else {
                assertNull(uvs);
            }
            if (face.endsWith("/1") && !face.endsWith(" 3/1")) {
                assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1}, normals);
            } else {
                assertNull(normals);
            }
        }
    }

    @Test
    void countsNegativeIndicesFromTheEndSoFar() throws IOException {
        TriangleMesh mesh = read("v 9 9 9\n" + SQUARE + "f -4 -3 -2 -1\nv 5 5 5\nf -1 2 3\n", false);
        assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3, 4, 0, 1}, mesh.triangles());
        assertEquals(5f, mesh.positions()[12]);
    }

    @Test
    void cutsPolygonsIntoFans() throws IOException {
        TriangleMesh mesh = read(SQUARE + "v -1 0.5 0\nf 1 2 3 4 5\n", false);
        assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3, 0, 3, 4}, mesh.triangles());
    }

    @Test
    void sharesVerticesThatAgreeInEverything() throws IOException {
        TriangleMesh mesh = read(SQUARE + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\nf 1/2 3/1 4/1\n", false);
        assertEquals(5, mesh.vertexCount());
        assertArrayEquals(new int[] {0, 1, 2, 0, 2, 3, 4, 2, 3}, mesh.triangles());
    }

    @Test
    void sharesVerticesOfLargeMeshes() throws IOException {
        int n = 60;
        StringBuilder text = new StringBuilder();
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++) {
                text.append("v ").append(i).append(' ').append(j).append(" 0.5\n");
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                int a = i * (n + 1) + j + 1;
                text.append("f ")
                        .append(a)
                        .append(' ')
                        .append(a + 1)
                        .append(' ')
                        .append(a + n + 2)
                        .append(' ');
                text.append(a + n + 1).append('\n');
            }
        }
        TriangleMesh mesh = read(text.toString(), false);
        assertEquals(2 * n * n, mesh.triangleCount());
        assertEquals((n + 1) * (n + 1), mesh.vertexCount());
    }

    @Test
    void flipsTextureRowsIfAsked() throws IOException {
        float[] uvs =
                read(SQUARE + "vt 0.25 0.75\nvt 0.5\nf 1/1 2/1 3/2\n", true).uvs();
        assertArrayEquals(new float[] {0.25f, 0.25f, 0.25f, 0.25f, 0.5f, 1}, uvs);
    }

    @Test
    void passesOverWhatIsNoGeometry() throws IOException {
        TriangleMesh mesh = read(
                "# comment\n\nmtllib a.mtl\no thing\ng one two\ns off\nusemtl red\n" + SQUARE
                        + "l 1 2\np 1\n\tf 1  2\t3 # three\r\nf 1 \\\n 3 4",
                false);
        assertEquals(2, mesh.triangleCount());
    }

    @Test
    void readsNumbersExactly() throws IOException {
        String[] numbers = {
            "0.1",
            "-.5",
            "+7.",
            "1e3",
            "1.5E-3",
            "123456789.123456789",
            "0.333333333333333333333333",
            "16777217",
            "1.00000005960464477539",
            "3.4028234e38",
            "1e-45",
            "1.17549435e-38",
            "-0.0",
            "0000000000000000000000000012.5"
        };
        StringBuilder text = new StringBuilder();
        for (String n : numbers) {
            text.append("v ").append(n).append(" 1 2\n");
        }
        for (int i = 0; i + 2 < numbers.length; i++) {
            text.append("f ")
                    .append(i + 1)
                    .append(' ')
                    .append(i + 2)
                    .append(' ')
                    .append(i + 3)
                    .append('\n');
        }
        float[] p = read(text.toString(), false).positions();
        for (int i = 0; i < numbers.length; i++) {
            assertEquals(Float.parseFloat(numbers[i]), p[3 * i], numbers[i]);
        }
    }

    @Test
    void missingNormalsAreComputedWhereOthersAreGiven() throws IOException {
        TriangleMesh mesh = read(SQUARE + "vn 1 0 0\nf 1//1 2//1 3\n", false);
        assertArrayEquals(new float[] {1, 0, 0, 1, 0, 0, 0, 0, 1}, mesh.normals());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                arguments("v 0 0 0\nv 1 x 0\n", 2, "y of a vertex 'x' is not a finite number"),
                arguments("v 0 0 nan\n", 1, "z of a vertex 'nan' is not a finite number"),
                arguments("v 0 0 inf\n", 1, "'inf'"),
                arguments("v 0 0 1e39\n", 1, "'1e39' is not a finite number in single precision"),
                arguments("v 0 0 -.\n", 1, "'-.'"),
                arguments("v 0 0 +\n", 1, "'+'"),
                arguments("v 0 0 .\n", 1, "'.'"),
                arguments("v 0 0 0x10\n", 1, "'0x10'"),
                arguments("v 0 0\n", 1, "z of a vertex is missing"),
                arguments("vn 1 2\n", 1, "z of a normal is missing"),
                arguments("vt\n", 1, "u of a texture coordinate is missing"),
                arguments(SQUARE + "f 1 2 5\n", 5, "refers to vertex 5 but 4 are defined before it"),
                arguments(SQUARE + "f 1 2 0\n", 5, "refers to vertex 0"),
                arguments(SQUARE + "f 1 2 -5\n", 5, "refers to vertex -5"),
                arguments(SQUARE + "f 1 2 99999999999999\n", 5, "refers to vertex 99999999999999"),
                arguments(SQUARE + "f 1/1 2/1 3/1\n", 5, "refers to texture coordinate 1 but 0 are defined"),
                arguments(SQUARE + "f 1//2 2//1 3//1\n", 5, "refers to normal 2"),
                arguments(SQUARE + "f 1 2\n", 5, "a face needs at least 3 vertices but has 2"),
                arguments(SQUARE + "f 1 2 a\n", 5, "the index of a vertex 'a' is not a whole number"),
                arguments(SQUARE + "f 1/ 2/ 3/\n", 5, "the index of a texture coordinate is missing"),
                arguments(SQUARE + "\\\n\nfoo 1\n", 7, "unknown statement 'foo'"),
                arguments("curv2 1 2\n", 1, "free-form"),
                arguments(SQUARE, 0, "the file has no faces"),
                arguments("", 0, "the file has no faces"),
                arguments("v " + "1".repeat(5000) + " 0 0\n", 1, "a word is longer than"));
    }

    @ParameterizedTest
    @MethodSource("mistakes")
    void namesLineAndReason(String text, int line, String message) {
        MeshFormatException e = assertThrows(MeshFormatException.class, () -> read(text, false));
        assertEquals(line, e.line(), e::getMessage);
        assertNotNull(e.getMessage());
        assertTrue(e.getMessage().contains(message), e::getMessage);
    }
}
