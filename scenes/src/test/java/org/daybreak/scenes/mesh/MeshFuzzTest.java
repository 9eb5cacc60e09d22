package org.daybreak.scenes.mesh;

import com.code_intelligence.jazzer.junit.DictionaryFile;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.zip.DeflaterOutputStream;
import org.daybreak.scenes.MemoryFolder;
import org.daybreak.scenes.WhereJazzerAttaches;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * Feeds arbitrary bytes to the readers of meshes: each file must be read or refused by {@link MeshFormatException}, in
 * bounded time and memory. In an ordinary build the inputs beside this class are run; docs/fuzzing.md tells how to search
 * for new ones.
 */
@Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@ExtendWith(WhereJazzerAttaches.class)
class MeshFuzzTest {
    @TempDir
    static Path scratch;

    private static MemoryFolder folder;

    private interface Reading {
        void read(Path file) throws IOException;
    }

    @BeforeAll
    static void open() throws IOException {
        folder = new MemoryFolder(scratch);
    }

    @AfterAll
    static void close() throws IOException {
        folder.close();
    }

    @DictionaryFile(resourcePath = "/org/daybreak/scenes/mesh/ply.dict")
    @FuzzTest(maxDuration = "")
    void ply(byte[] input) throws IOException {
        isReadOrRefused(input, file -> PlyReader.read(file, true));
    }

    @DictionaryFile(resourcePath = "/org/daybreak/scenes/obj.dict")
    @FuzzTest(maxDuration = "")
    void obj(byte[] input) throws IOException {
        isReadOrRefused(input, file -> ObjReader.readByMaterial(file, true));
    }

    @DictionaryFile(resourcePath = "/org/daybreak/scenes/mesh/stl.dict")
    @FuzzTest(maxDuration = "")
    void stl(byte[] input) throws IOException {
        isReadOrRefused(input, StlReader::read);
    }

    /** A file, or what stands in for one that does not begin as all do: version and content of its only mesh. */
    @FuzzTest(maxDuration = "")
    void serialized(byte[] input) throws IOException {
        boolean complete = input.length > 1 && input[0] == 0x1c && input[1] == 4;
        byte[] bytes = complete ? input : serializedMesh(input);
        isReadOrRefused(bytes, file -> SerializedReader.read(file, 0));
    }

    private static byte[] serializedMesh(byte[] input) throws IOException {
        int version = input.length > 0 && input[0] % 2 != 0 ? 3 : 4;
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(new byte[] {0x1c, 4, (byte) version, 0});
        try (DeflaterOutputStream deflater = new DeflaterOutputStream(out)) {
            deflater.write(input, Math.min(1, input.length), Math.max(0, input.length - 1));
        }
        int entry = version == 3 ? Integer.BYTES : Long.BYTES;
        out.write(new byte[entry]);
        out.write(ByteBuffer.allocate(Integer.BYTES)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(1)
                .array());
        return out.toByteArray();
    }

    @FuzzTest(maxDuration = "")
    void curves(byte[] input) throws IOException {
        isReadOrRefused(input, CurveReader::read);
    }

    private static void isReadOrRefused(byte[] bytes, Reading reading) throws IOException {
        Path file = folder.write("mesh", bytes);
        try {
            reading.read(file);
        } catch (MeshFormatException e) {
            if (String.valueOf(e.getMessage()).isBlank()) {
                throw new AssertionError("refused without a reason", e);
            }
        }
    }
}
