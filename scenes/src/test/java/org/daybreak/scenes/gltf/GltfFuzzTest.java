package org.daybreak.scenes.gltf;

import com.code_intelligence.jazzer.junit.DictionaryFile;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.daybreak.scenes.MemoryFolder;
import org.daybreak.scenes.OneImage;
import org.daybreak.scenes.SceneReader;
import org.daybreak.scenes.WhereJazzerAttaches;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.description.SceneProblem;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * Feeds arbitrary bytes to the reader of glTF: each file must be read or refused by {@link SceneException}, in bounded time
 * and memory. In an ordinary build the inputs beside this class are run; docs/fuzzing.md tells how to search for new ones.
 */
@Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@ExtendWith(WhereJazzerAttaches.class)
class GltfFuzzTest {
    private static final SceneReader READER = new SceneReader(new OneImage());

    @TempDir
    static Path scratch;

    private static MemoryFolder folder;

    @BeforeAll
    static void open() throws IOException {
        folder = new MemoryFolder(scratch);
    }

    @AfterAll
    static void close() throws IOException {
        folder.close();
    }

    /** A file, or what stands in for one that begins neither as text nor as binary files do: a {@link GltfRecipe}. */
    @DictionaryFile(resourcePath = "/org/daybreak/scenes/gltf/gltf.dict")
    @FuzzTest(maxDuration = "")
    void gltf(byte[] input) throws IOException {
        boolean complete = input.length > 0 && (input[0] == '{' || input[0] == 'g');
        Path file = folder.write("fuzzed.gltf", complete ? input : GltfRecipe.file(input));
        try {
            READER.load(file, Map.of());
        } catch (SceneException e) {
            for (SceneProblem problem : e.problems()) {
                // Readers tell when memory runs out; a file as small as these must not bring that about.
                if (problem.message().isBlank() || problem.message().endsWith("does not fit into memory")) {
                    throw new AssertionError("not a proper refusal", e);
                }
            }
        }
    }
}
