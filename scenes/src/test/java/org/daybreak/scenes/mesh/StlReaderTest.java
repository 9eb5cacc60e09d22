package org.daybreak.scenes.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.daybreak.core.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** STL files of both kinds, told apart by size rather than by their first word. */
public class StlReaderTest {
    /** A solid of one facet. */
    public static final String FACET = """
            solid name with blanks
              facet normal 0 0 nan
                outer loop
                  vertex 0 0 0
                  vertex 1.5e0 0 0
                  vertex 0 -2 0.25
                endloop
              endfacet
            endsolid name with blanks
            """;

    @TempDir
    Path folder;

    /** A binary file of facets (0, 0, i) (1, 0, i) (0, 1, i). */
    public static byte[] binary(String header, int facets, int extraBytes) {
        ByteBuffer b = ByteBuffer.allocate(84 + 50 * facets + extraBytes).order(ByteOrder.LITTLE_ENDIAN);
        b.put(header.getBytes(StandardCharsets.US_ASCII)).position(80);
        b.putInt(facets);
        for (int i = 0; i < facets; i++) {
            for (float f : new float[] {0, 0, 0, 0, 0, i, 1, 0, i, 0, 1, i}) {
                b.putFloat(f);
            }
            b.putShort((short) 7);
        }
        return b.array();
    }

    private TriangleMesh read(byte[] bytes) throws IOException {
        return StlReader.read(Files.write(folder.resolve("t.stl"), bytes));
    }

    private TriangleMesh read(String text) throws IOException {
        return read(text.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void readsText() throws IOException {
        TriangleMesh mesh = read(FACET.toUpperCase(java.util.Locale.ROOT).replace("\n", "\r\n") + FACET);
        assertArrayEquals(new float[] {0, 0, 0, 1.5f, 0, 0, 0, -2, 0.25f}, mesh.positions());
        assertArrayEquals(new int[] {0, 1, 2, 0, 1, 2}, mesh.triangles());
        assertNull(mesh.normals());
    }

    /** Many programs write "solid" into the header of binary files; some append bytes. */
    @ParameterizedTest
    @CsvSource({"binary, 0", "solid, 0", "exported by, 4"})
    void readsBinary(String header, int extraBytes) throws IOException {
        TriangleMesh mesh = read(binary(header, 2, extraBytes));
        assertEquals(2, mesh.triangleCount());
        assertArrayEquals(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, java.util.Arrays.copyOf(mesh.positions(), 9));
        assertEquals(6, mesh.vertexCount());
    }

    @Test
    void sharesVerticesAtNegativeZero() throws IOException {
        assertEquals(
                3,
                read(FACET + FACET.replace("vertex 0 0 0", "vertex -0 0 -0.0")).vertexCount());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "vertex 0 0 0 | vertx 0 0 0 | 4 | 'vertx' where vertex or endloop must follow; did you mean 'vertex'?",
                "1.5e0 | 1e99 | 5 | x of a vertex '1e99' is not a finite number in single precision",
                "vertex 0 0 0 |  | 7 | a facet has 2 vertices but needs 3",
                "endfacet | facet | 8 | 'facet' where endfacet must follow; did you mean 'facet'?",
            })
    void namesLineAndWord(String from, String to, int line, String message) throws IOException {
        MeshFormatException e =
                assertThrows(MeshFormatException.class, () -> read(FACET.replaceFirst(from, to == null ? "" : to)));
        assertTrue(String.valueOf(e.getMessage()).startsWith(message), e.getMessage());
        assertEquals(line, e.line());
    }

    @Test
    void refusesWhatIsCutOff() {
        byte[] whole = binary("b", 3, 0);
        for (int size : new int[] {1, 83, 84, 133, whole.length - 1}) {
            assertThrows(MeshFormatException.class, () -> read(java.util.Arrays.copyOf(whole, size)), size + " bytes");
        }
        assertThrows(MeshFormatException.class, () -> read(binary("empty", 0, 0)));
        assertThrows(MeshFormatException.class, () -> read("solid empty\nendsolid\n"));
        assertThrows(MeshFormatException.class, () -> read(FACET.substring(0, 60)));
    }
}
