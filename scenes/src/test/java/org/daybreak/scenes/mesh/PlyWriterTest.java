package org.daybreak.scenes.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.daybreak.core.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PlyWriterTest {
    @TempDir
    Path folder;

    private TriangleMesh thereAndBack(TriangleMesh mesh) throws IOException {
        Path file = folder.resolve("mesh.ply");
        try (OutputStream out = Files.newOutputStream(file)) {
            PlyWriter.write(out, mesh);
        }
        return PlyReader.read(file, false);
    }

    private static float[] floats(SplittableRandom random, int count, boolean colors) {
        float[] values = new float[count];
        for (int i = 0; i < count; i++) {
            // All magnitudes, except for colours, which lie in [0, 1].
            values[i] = colors
                    ? (float) random.nextDouble()
                    : (float) (random.nextDouble(-1, 1) * Math.pow(10, random.nextInt(-30, 30)));
        }
        return values;
    }

    /** More vertices and faces than any buffer holds. */
    @Test
    void allAttributesKeepTheirBits() throws IOException {
        SplittableRandom random = new SplittableRandom(3);
        int vertices = 20_000;
        int[] triangles = random.ints(3 * 30_000, 0, vertices).toArray();
        TriangleMesh mesh = new TriangleMesh(
                floats(random, 3 * vertices, false),
                triangles,
                floats(random, 3 * vertices, false),
                floats(random, 2 * vertices, false),
                floats(random, 2 * vertices, false),
                floats(random, 3 * vertices, true));
        TriangleMesh back = thereAndBack(mesh);
        assertArrayEquals(mesh.positions(), back.positions());
        assertArrayEquals(triangles, back.triangles());
        assertArrayEquals(mesh.normals(), back.normals());
        assertArrayEquals(mesh.uvs(), back.uvs());
        assertArrayEquals(mesh.secondUvs(), back.secondUvs());
        assertArrayEquals(mesh.colors(), back.colors());
    }

    @Test
    void whatIsMissingStaysMissing() throws IOException {
        float[] positions = {0, 0, 0, 1, 0, 0, 0, 1, -0f};
        TriangleMesh back = thereAndBack(new TriangleMesh(positions, new int[] {0, 1, 2}, null, null));
        assertEquals(Float.floatToRawIntBits(-0f), Float.floatToRawIntBits(back.positions()[8]));
        assertNull(back.normals());
        assertNull(back.uvs());
        assertNull(back.secondUvs());
        assertNull(back.colors());
    }
}
