package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class UsageTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--sppp 4 | unknown option '--sppp'; did you mean '--spp'?",
                "--spp 0 | --spp is 0 but must be from 1",
                "--spp many | 'many' is not a long",
                "--time 0 | --time is 0.0 but must be greater than 0",
                "--time NaN | --time is NaN but must be greater than 0",
                "--target-error 0 | --target-error is 0.0 but must be between 0 and 1",
                "--threads 0 | --threads is 0 but must be from 1 to 1024",
                "--seed x | 'x' is not a long",
                "--size 8 | --size is '8' but must be of the form WxH",
                "--size 0x8 | must have 1 to 65536 pixels",
                "--size 65536x65536 | too large to be rendered in one piece",
                "--crop 1,2,3 | --crop is '1,2,3' but must be of the form X,Y,W,H",
                "--crop 1,2,8,8 | must lie within the film of 8x8",
                "--renderer pth | there is no renderer 'pth'; did you mean 'path'?",
                "-P maxDpth=3 | 'path' has no parameter 'maxDpth'; did you mean 'maxDepth'?",
                "-P maxDepth=-9 | parameter 'maxDepth' is '-9' but must be a whole number, at least -1",
                "--renderer light -P maxDepth=x | parameter 'maxDepth' is 'x' but must be a whole number",
                "-P maxDepth | -P",
                "--antialiasing sobl | there is no antialiasing method 'sobl'; did you mean 'sobol'?",
                "-A grid=3 | 'sobol' has no parameter 'grid'",
                "--antialiasing grid -A gridSize=-1 | parameter 'gridSize' is '-1' but must be",
                "--layers albdo | there is no layer 'albdo'; did you mean 'albedo'?",
                "--intersector vektor | there is no intersector 'vektor'",
                "--progress loud | there is no progress mode 'loud'",
                "another.xml | 'another.xml' is one argument too many"
            })
    void wrongOptions(String options, String message) throws IOException {
        Path scene = TestScenes.write(folder, TestScenes.usual());
        Path exr = folder.resolve("out.exr");
        List<Object> args = new ArrayList<>(List.of("render", scene, "-o", exr));
        args.addAll(Arrays.asList(options.split(" ")));
        Cli.Result result = Cli.run(args.toArray());
        assertEquals(2, result.code(), result.err());
        assertTrue(result.messages().get(0).contains(message), result.err());
        assertFalse(result.err().contains("\tat "), result.err());
        assertEquals(List.of("tiny.xml"), Cli.files(folder));
    }

    @ParameterizedTest
    @ValueSource(strings = {"out", "out.xpm", "exr", ".", "out.exr.gz"})
    void unknownEndings(String name) throws IOException {
        Path scene = TestScenes.write(folder, TestScenes.usual());
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve(name));
        assertEquals(2, result.code(), result.err());
        assertTrue(result.err().contains("(known: exr, pfm, png, hdr, jpg, daybreak)"), result.err());
    }

    @Test
    void layersNeedAnExr() throws IOException {
        Path scene = TestScenes.write(folder, TestScenes.usual());
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve("out.png"), "--layers", "depth");
        assertEquals(2, result.code());
        assertTrue(result.err().contains("--layers needs an output file with the ending exr"), result.err());
    }

    @Test
    void sameFileTwice() throws IOException {
        Path scene = TestScenes.write(folder, TestScenes.usual());
        Cli.Result result = Cli.run("render", scene, "-o", folder.resolve("a.exr"), "-o", folder.resolve("x/../a.exr"));
        assertEquals(2, result.code());
        assertTrue(result.err().contains("is given twice"), result.err());
    }

    @Test
    void commandsAndHelp() {
        assertEquals(2, Cli.run().code());
        Cli.Result unknown = Cli.run("rendr");
        assertEquals(2, unknown.code());
        assertTrue(unknown.err().contains("there is no command 'rendr'; did you mean 'render'?"), unknown.err());
        for (String command :
                new String[] {"render", "replay", "list", "info", "diff", "convert", "merge", "completion"}) {
            Cli.Result help = Cli.run(command, "--help");
            assertEquals(0, help.code());
            assertTrue(help.out().contains("Examples:"), help.out());
            assertTrue(help.out().contains("Exit codes:"), help.out());
        }
        assertTrue(Cli.run("--help").out().contains("Examples:"));
        assertEquals(2, Cli.run("render").code());
    }

    @Test
    void completionKnowsCommandsAndOptions() {
        for (String shell : new String[] {"bash", "zsh"}) {
            Cli.Result result = Cli.run("completion", shell);
            assertEquals(0, result.code(), result.err());
            assertTrue(result.out().contains("--checkpoint-interval"), shell);
            assertTrue(result.out().contains("complete -F"), shell);
        }
        assertEquals(2, Cli.run("completion", "fish").code());
    }

    @Test
    void versionNamesJvmAndIntersector() {
        Cli.Result version = Cli.run("--version");
        assertEquals(0, version.code(), version.err());
        assertTrue(version.out().contains("Daybreak"), version.out());
        assertTrue(version.out().contains(Runtime.version().toString()), version.out());
        assertTrue(version.out().contains("Intersector: "), version.out());
    }

    @Test
    void outputsAreCheckedBeforeTheSceneIsRead() throws IOException {
        Path missing = folder.resolve("missing.xml");
        Path directory = Files.createDirectory(folder.resolve("dir.exr"));
        for (Path output : new Path[] {directory, folder.resolve("no/such/out.exr")}) {
            Cli.Result result = Cli.run("render", missing, "-o", output);
            assertEquals(4, result.code(), result.err());
            assertEquals(1, result.messages().size(), result.err());
            assertTrue(result.err().contains("cannot be written"), result.err());
        }
        Cli.Result statistics =
                Cli.run("render", missing, "-o", folder.resolve("a.exr"), "--stats", folder.resolve("no/such/s.json"));
        assertEquals(4, statistics.code(), statistics.err());
    }

    @Test
    void devicesAreNoOutputs() throws IOException {
        Path device = folder.resolve("device.exr");
        Path full = Path.of("/dev/full");
        org.junit.jupiter.api.Assumptions.assumeTrue(Files.exists(full), "no /dev/full");
        Files.createSymbolicLink(device, full);
        Cli.Result result = Cli.run("render", TestScenes.write(folder, TestScenes.usual()), "-o", device);
        assertEquals(4, result.code(), result.err());
        assertTrue(result.err().contains("is not a regular file"), result.err());
    }
}
