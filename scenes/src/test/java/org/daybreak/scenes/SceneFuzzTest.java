package org.daybreak.scenes;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;

import com.code_intelligence.jazzer.junit.DictionaryFile;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.description.SceneProblem;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.mitsuba.MitsubaReader;
import org.daybreak.scenes.model.ModelReader;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/**
 * Feeds arbitrary bytes to the readers of scenes: each file must be read or refused by {@link SceneException}, in bounded
 * time and memory. In an ordinary build the inputs beside this class are run; docs/fuzzing.md tells how to search for new
 * ones.
 */
@Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@ExtendWith(WhereJazzerAttaches.class)
class SceneFuzzTest {
    /** Whether inputs are made up, not only those run that are there. */
    private static final boolean SEARCHING = System.getenv("JAZZER_FUZZ") != null;

    private static final String MESH = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    private static final OneImage IMAGES = new OneImage();
    private static final SceneReader READER = new SceneReader(IMAGES);

    @TempDir
    static Path scratch;

    private static MemoryFolder folder;

    @BeforeAll
    static void writeFilesToReferTo() throws IOException {
        folder = new MemoryFolder(scratch);
        folder.write("i.png", "image");
        folder.write("m.obj", MESH + "f 1 2 3\n");
        folder.write("c.txt", "0 0 0 1\n1 0 0 1\n2 1 0 0.5\n3 1 1 0\n");
        folder.write("x.mtl", "newmtl a\nKd 0.5 0.6 0.7\nmap_Kd i.png\nnewmtl b\nKe 1 2 3\nd 0.5\n");
        folder.write("y.obj", "mtllib y.mtl\n" + MESH + "usemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n");
        folder.write("s.xml", "<bsdf version='3.0.0' type='diffuse' id='included'/>");
        folder.write("l.ies", "TILT=NONE\n1 1000 1 2 1 1 1 0 0 0\n1 1 30\n0 90\n0\n100 20\n");
    }

    @AfterAll
    static void close() throws IOException {
        folder.close();
    }

    /** A file, or what stands in for one whose first byte is no markup: a {@link SceneRecipe}. */
    @DictionaryFile(resourcePath = "/org/daybreak/scenes/mitsuba.dict")
    @FuzzTest(maxDuration = "")
    void mitsubaXml(byte[] input) throws IOException {
        boolean complete = input.length > 0 && (input[0] == '<' || input[0] == (byte) 0xef || input[0] == (byte) 0xff);
        byte[] text = complete ? input : SceneRecipe.text(input).getBytes(UTF_8);
        Path file = folder.write("scene.xml", text);
        if (isBuilt(text)) {
            isReadOrRefused(file);
        } else {
            MitsubaReader.read(file, Map.of(), new ProblemList());
        }
    }

    /**
     * Whether a file is built, not only read. Rough plastics tabulate their transmittance when they are built, which takes a
     * thousand times as long as all else: in a search most files with one are read only, chosen by what is in them, so that an
     * input always takes the same way.
     */
    private static boolean isBuilt(byte[] text) {
        return !SEARCHING || Arrays.hashCode(text) % 64 == 0 || !new String(text, ISO_8859_1).contains("roughplastic");
    }

    @DictionaryFile(resourcePath = "/org/daybreak/scenes/obj.dict")
    @FuzzTest(maxDuration = "")
    void objWithMaterials(byte[] input) throws IOException {
        isReadOrRefused(folder.write("x.obj", input));
    }

    /** Materials, as part of a model that is sound. */
    @DictionaryFile(resourcePath = "/org/daybreak/scenes/obj.dict")
    @FuzzTest(maxDuration = "")
    void mtl(byte[] input) throws IOException {
        Path file = folder.write("y.mtl", input).resolveSibling("y.obj");
        SceneDescription description = ModelReader.read(file, IMAGES, new ProblemList());
        // Nearly all materials that a search comes up with are rough plastics.
        if (!SEARCHING || Arrays.hashCode(input) % 1024 == 0 || !contains(description.root(), "roughplastic")) {
            isReadOrRefused(file);
        }
    }

    private static boolean contains(ObjectDescription object, String type) {
        for (PropertyDescription property : object.properties()) {
            if (property.value() instanceof Value.Nested nested && contains(nested.object(), type)) {
                return true;
            }
        }
        return object.type().equals(type);
    }

    private static void isReadOrRefused(Path file) {
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
