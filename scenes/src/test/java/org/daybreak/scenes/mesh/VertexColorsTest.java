package org.daybreak.scenes.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.daybreak.core.color.ColorSpaces;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class VertexColorsTest {
    @TempDir
    Path folder;

    private float[] ply(String type, String names, String values) throws IOException {
        StringBuilder text = new StringBuilder("ply\nformat ascii 1.0\nelement vertex 3\n");
        for (String name : names.split(" ", -1)) {
            text.append("property ").append(type).append(' ').append(name).append('\n');
        }
        text.append("property float x\nproperty float y\nproperty float z\n")
                .append("element face 1\nproperty list uchar int vertex_index\nend_header\n");
        for (String v : new String[] {"0 0 0", "1 0 0", "0 1 0"}) {
            text.append(values).append(' ').append(v).append('\n');
        }
        text.append("3 0 1 2\n");
        return PlyReader.read(Files.writeString(folder.resolve("t.ply"), text), false)
                .colors();
    }

    @Test
    void plyBytesAreSrgbAndFloatsLinear() throws IOException {
        float linear = (float) ColorSpaces.srgbToLinear(128 / 255.0);
        float[] c = {0, linear, 1};
        assertArrayEquals(repeat(c), ply("uchar", "red green blue", "0 128 255"), 1e-6f);
        assertArrayEquals(repeat(new float[] {1, linear, 0}), ply("uchar", "blue g diffuse_red", "0 128 255"), 1e-6f);
        assertArrayEquals(repeat(new float[] {0, 0.5f, 1}), ply("float", "r g b", "-1 0.5 7"), 1e-6f);
        assertNull(ply("uchar", "red green", "1 2"));
    }

    @Test
    void objColorsFollowTheirVertices() throws IOException {
        String text = "v 0 0 0\nv 1 0 0 0 0.5 1\nv 0 1 0 1.0\nv 1 1 0 1 0 0 # c\nf 2 3 1\nf 4 3 1\n";
        float linear = (float) ColorSpaces.srgbToLinear(0.5);
        assertArrayEquals(
                new float[] {0, linear, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0},
                ObjReader.read(Files.writeString(folder.resolve("t.obj"), text), false)
                        .colors(),
                1e-6f);
    }

    @Test
    void plyTriangleStripsTurnEveryOtherTriangle() throws IOException {
        String text = """
                ply
                format ascii 1.0
                element vertex 4
                property float x
                property float y
                property float z
                element tristrips 1
                property list int int vertex_indices
                end_header
                0 0 0 1 0 0 0 1 0 1 1 0
                8 0 1 2 3 -1 3 2 1
                """;
        assertArrayEquals(
                new int[] {0, 1, 2, 2, 1, 3, 3, 2, 1},
                PlyReader.read(Files.writeString(folder.resolve("t.ply"), text), false)
                        .triangles());
    }

    private static float[] repeat(float[] rgb) {
        float[] all = new float[9];
        for (int i = 0; i < 9; i++) {
            all[i] = rgb[i % 3];
        }
        return all;
    }
}
