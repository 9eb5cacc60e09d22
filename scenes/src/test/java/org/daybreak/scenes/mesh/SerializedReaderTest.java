package org.daybreak.scenes.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

public class SerializedReaderTest {
    @TempDir
    Path folder;

    /** A file of meshes of one triangle (0, 0, i) (1, 0, i) (0, 1, i), written as the documentation of Mitsuba 0.6 says. */
    public static byte[] file(int version, int flags, int meshes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        int[] offsets = new int[meshes];
        for (int i = 0; i < meshes; i++) {
            offsets[i] = out.size();
            out.write(new byte[] {0x1C, 0x04, (byte) version, 0});
            DeflaterOutputStream deflater = new DeflaterOutputStream(out);
            deflater.write(content(version, flags, i));
            deflater.finish();
        }
        ByteBuffer table = ByteBuffer.allocate(8 * meshes + 4).order(ByteOrder.LITTLE_ENDIAN);
        for (int offset : offsets) {
            if (version == 4) {
                table.putLong(offset);
            } else {
                table.putInt(offset);
            }
        }
        table.putInt(meshes);
        out.write(table.array(), 0, table.position());
        return out.toByteArray();
    }

    private static byte[] content(int version, int flags, int i) {
        ByteBuffer b = ByteBuffer.allocate(1000).order(ByteOrder.LITTLE_ENDIAN);
        b.putInt(flags);
        if (version == 4) {
            b.put(("m\u00e9sh" + i + "\0").getBytes(StandardCharsets.UTF_8));
        }
        b.putLong(3).putLong(1);
        boolean wide = (flags & 0x2000) != 0;
        put(b, wide, 0, 0, i, 1, 0, i, 0, 1, i);
        if ((flags & 1) != 0) {
            put(b, wide, 0, 0, 1, 0, 0, 1, 0, 0.6, 0.8);
        }
        if ((flags & 2) != 0) {
            put(b, wide, 0, 0, 1, 0, 0, 1);
        }
        if ((flags & 8) != 0) {
            put(b, wide, 0, 0.25, 1, 0, 0, 0, 1, 1, 2);
        }
        b.putInt(0).putInt(1).putInt(2);
        return Arrays.copyOf(b.array(), b.position());
    }

    private static void put(ByteBuffer b, boolean wide, double... values) {
        for (double v : values) {
            if (wide) {
                b.putDouble(v);
            } else {
                b.putFloat((float) v);
            }
        }
    }

    private SerializedReader.Mesh read(byte[] bytes, int index) throws IOException {
        return SerializedReader.read(Files.write(folder.resolve("t.serialized"), bytes), index);
    }

    @ParameterizedTest
    @CsvSource({"3, 1000", "3, 200b", "4, 1001", "4, 2002", "4, 100b", "4, 1013"})
    void readsEveryMesh(int version, String hex) throws IOException {
        int flags = Integer.parseInt(hex, 16);
        for (int i = 0; i < 3; i++) {
            SerializedReader.Mesh mesh = read(file(version, flags, 3), i);
            assertEquals(version == 4 ? "m\u00e9sh" + i : "", mesh.name());
            assertArrayEquals(
                    new float[] {0, 0, i, 1, 0, i, 0, 1, i}, mesh.mesh().positions());
            assertArrayEquals(new int[] {0, 1, 2}, mesh.mesh().triangles());
            assertEquals((flags & 0x10) != 0, mesh.flat());
            float[] normals = mesh.mesh().normals();
            if ((flags & 1) != 0 && !mesh.flat()) {
                assertNotNull(normals);
                assertEquals(0.6f, normals[7]);
            } else {
                assertNull(normals);
            }
            if ((flags & 2) != 0) {
                assertArrayEquals(new float[] {0, 0, 1, 0, 0, 1}, mesh.mesh().uvs());
            }
            if ((flags & 8) != 0) {
                assertArrayEquals(
                        new float[] {0, 0.25f, 1, 0, 0, 0, 1, 1, 1}, mesh.mesh().colors());
            } else {
                assertNull(mesh.mesh().colors());
            }
        }
    }

    @Test
    void refusesWhatIsWrong() throws IOException {
        byte[] good = file(4, 0x1000, 2);
        assertTrue(message(good, 2).contains("there is no mesh 2: the file has 2"));
        byte[] version = good.clone();
        version[2] = 5;
        assertTrue(message(version, 0).contains("version 5"));
        byte[] magic = good.clone();
        magic[0] = 0;
        assertTrue(message(magic, 0).contains("no serialized mesh"));
        byte[] damaged = good.clone();
        damaged[8] ^= 0x55;
        assertTrue(message(damaged, 0).contains("damaged"));
        assertTrue(message(file(4, 0x1040, 1), 0).contains("flags 1040"));
        assertTrue(message(new byte[] {1, 2}, 0).contains("too short"));
    }

    private String message(byte[] bytes, int index) {
        return String.valueOf(assertThrows(MeshFormatException.class, () -> read(bytes, index))
                .getMessage());
    }
}
