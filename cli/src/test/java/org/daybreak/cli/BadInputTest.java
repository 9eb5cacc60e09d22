package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Each kind of bad input: its exit code, one clear message, and nothing written. */
class BadInputTest {
    private static final String MESH = "<shape type=\"ply\"><string name=\"filename\" value=\"mesh.ply\"/></shape>";

    private static final String PLY_HEADER = """
            ply
            format ascii 1.0
            element vertex 4
            property float x
            property float y
            property float z
            element face 2
            property list uchar int vertex_indices
            end_header
            """;

    private static final String VERTICES = "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n";

    private static final String BOMB = """
            <!DOCTYPE scene [
              <!ENTITY a "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa">
              <!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">
              <!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;">
              <!ENTITY d "&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;">
              <!ENTITY e "&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;">
            ]>
            <scene version="3.0.0"><default name="x" value="&e;"/></scene>
            """;

    private static final String EXTERNAL = """
            <!DOCTYPE scene [<!ENTITY secret SYSTEM "secret.txt">]>
            <scene version="3.0.0"><default name="x" value="&secret;"/></scene>
            """;

    @TempDir
    private Path folder;

    static Stream<Arguments> scenes() {
        String tiny = "tiny.xml";
        return Stream.of(
                Arguments.of("", tiny),
                Arguments.of("<scene version=\"3.0.0\"", tiny + ":1"),
                Arguments.of(BOMB, "DOCTYPE"),
                Arguments.of(EXTERNAL, "DOCTYPE"),
                Arguments.of(
                        TestScenes.scene(TestScenes.SENSOR, TestScenes.LIGHT, MESH.replace("mesh.ply", "missing.ply")),
                        "missing.ply"),
                Arguments.of(
                        TestScenes.scene(
                                TestScenes.SENSOR, TestScenes.LIGHT.replace("scale value=\"0.5\"", "scale x=\"0\"")),
                        "singular"),
                Arguments.of(TestScenes.scene(TestScenes.LIGHT), "sensor"),
                Arguments.of(
                        TestScenes.scene("<integrator type=\"pth\"/>", TestScenes.SENSOR, TestScenes.LIGHT),
                        "did you mean 'path'"),
                Arguments.of(
                        TestScenes.scene(
                                TestScenes.INTEGRATOR.replace("\"3\"", "\"-5\""), TestScenes.SENSOR, TestScenes.LIGHT),
                        "max_depth"));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void wrongScenes(String text, String message) throws IOException {
        Path scene = TestScenes.write(folder, text);
        refused(scene, message);
        assertEquals(List.of("tiny.xml"), Cli.files(folder));
    }

    static Stream<Arguments> meshes() {
        return Stream.of(
                Arguments.of("", "mesh.ply"),
                Arguments.of(PLY_HEADER + "-1 -1 0\n1 nan 0\n1 1 0\n-1 1 0\n3 0 1 2\n3 0 2 3\n", "not a finite number"),
                Arguments.of(PLY_HEADER + VERTICES + "3 0 1 2\n3 0 2 4\n", "4"),
                Arguments.of(PLY_HEADER + VERTICES + "3 0 1 2\n3 0 2 -1\n", "-1"),
                Arguments.of(PLY_HEADER + VERTICES + "3 0 1 2\n", "mesh.ply"));
    }

    @ParameterizedTest
    @MethodSource("meshes")
    void wrongMeshes(String mesh, String message) throws IOException {
        Files.writeString(folder.resolve("mesh.ply"), mesh);
        Path scene = TestScenes.write(folder, TestScenes.scene(TestScenes.SENSOR, TestScenes.LIGHT, MESH));
        refused(scene, message);
        assertEquals(List.of("mesh.ply", "tiny.xml"), Cli.files(folder));
    }

    @Test
    void allErrorsInOneRun() throws IOException {
        String shapes = MESH.replace("mesh", "first") + MESH.replace("mesh", "second");
        Path scene = TestScenes.write(folder, TestScenes.scene(TestScenes.SENSOR, TestScenes.LIGHT, shapes));
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve("out.exr"));
        assertEquals(3, result.code());
        assertEquals(2, result.messages().size(), result.err());
        assertTrue(result.err().contains("first.ply") && result.err().contains("second.ply"), result.err());
    }

    @Test
    void emptyFilm() throws IOException {
        String sensor = TestScenes.SENSOR.replace("value=\"8\"", "value=\"0\"");
        Path scene = TestScenes.write(folder, TestScenes.scene(sensor, TestScenes.LIGHT));
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve("out.exr"));
        assertEquals(3, result.code());
        assertEquals(2, result.messages().size(), "width and height are both wrong: " + result.err());
        assertTrue(result.err().contains("must be an integer from 1 to 65536 but is 0"), result.err());
        assertEquals(List.of("tiny.xml"), Cli.files(folder));
    }

    @Test
    void directoryAndMissingFile() throws IOException {
        refused(folder, "directory");
        refused(folder.resolve("none.xml"), "does not exist");
        assertEquals(List.of(), Cli.files(folder));
    }

    @Test
    void unreadableFile() throws IOException {
        Path scene = TestScenes.write(folder, TestScenes.usual());
        assumeTrue(scene.toFile().setReadable(false), "permissions cannot be changed");
        assumeFalse(Files.isReadable(scene), "this user may read everything");
        refused(scene, "tiny.xml");
    }

    @Test
    void zeroAreaTrianglesAreLeftOut() throws IOException {
        Files.writeString(folder.resolve("mesh.ply"), PLY_HEADER + VERTICES + "3 0 1 2\n3 0 0 3\n");
        warned(TestScenes.scene(TestScenes.SENSOR, TestScenes.LIGHT, MESH), "1 triangle of zero area");
    }

    @Test
    void noLightIsBlack() throws IOException {
        ExrImage image = warned(
                TestScenes.scene(TestScenes.SENSOR, "<shape type=\"sphere\"/>"), "no light; the picture will be black");
        for (float value : image.samples("G")) {
            assertEquals(0, value);
        }
    }

    /** A limit on the size of files is the one full disk that every Unix user can have. */
    @Test
    void fullDiskLeavesTheOldPicture() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "no shell");
        Path scene = TestScenes.write(folder, TestScenes.usual());
        Path exr = Files.writeString(folder.resolve("out.exr"), "old");
        List<String> command = new ArrayList<>(List.of("/bin/sh", "-c", "ulimit -f 16 && exec \"$@\"", "sh"));
        command.addAll(ChildJvm.command(
                List.of("-XX:-UsePerfData"),
                List.of("render", scene.toString(), "-o", exr.toString(), "--size", "64x64", "--spp", "1")));
        ChildJvm.Result result = ChildJvm.start(folder, command).await();
        assertEquals(4, result.code(), result.err());
        assertTrue(result.err().contains("out.exr: cannot be written"), result.err());
        assertFalse(result.err().contains("\tat "), result.err());
        assertEquals("old", Files.readString(exr));
        assertEquals(List.of("out.exr", "tiny.xml"), ChildJvm.filesWithoutLogs(folder));
    }

    @Test
    void smallHeapIsNoInternalError() throws Exception {
        Path scene = TestScenes.write(folder, TestScenes.usual());
        ChildJvm.Result result = ChildJvm.start(
                        folder,
                        ChildJvm.command(
                                List.of("-Xmx32m"), List.of("render", scene.toString(), "--size", "3000x3000")))
                .await();
        assertEquals(7, result.code(), result.err());
        assertTrue(result.err().contains("not enough memory"), result.err());
        assertFalse(result.err().contains("\tat "), result.err());
        assertEquals(List.of("tiny.xml"), ChildJvm.filesWithoutLogs(folder));
    }

    private void refused(Path scene, String message) {
        for (String command : new String[] {"render", "info"}) {
            Cli.Result result = command.equals("render")
                    ? Cli.run(command, scene, "-o", folder.resolve("out.exr"))
                    : Cli.run(command, scene);
            assertEquals(3, result.code(), result.err());
            assertEquals(1, result.err().lines().count(), result.err());
            assertTrue(result.err().startsWith("daybreak: "), result.err());
            assertTrue(result.err().contains(message), result.err());
        }
    }

    private ExrImage warned(String text, String warning) throws IOException {
        Path scene = TestScenes.write(folder, text);
        Path exr = folder.resolve("out.exr");
        Cli.Result result = Cli.run("render", scene, "-o", exr);
        assertEquals(0, result.code(), result.err());
        assertEquals(1, result.messages().size(), result.err());
        assertTrue(result.messages().get(0).startsWith("daybreak: warning: "), result.err());
        assertTrue(result.messages().get(0).contains(warning), result.err());
        return ExrReader.read(exr);
    }
}
