package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.daybreak.exr.ExrReader;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Timeout(300)
class CheckpointTest {
    @TempDir
    private Path folder;

    private Path scene;
    private Path checkpoint;

    @BeforeEach
    void writeScene() throws IOException {
        scene = TestScenes.write(folder, TestScenes.usual());
        checkpoint = folder.resolve("c.daybreak");
    }

    private Cli.Result render(Object... options) {
        List<Object> args = new ArrayList<>(List.of("render", scene, "--progress", "none", "--size", "80x70"));
        args.addAll(Arrays.asList(options));
        return Cli.run(args.toArray());
    }

    private static Object[] with(List<Object> options, Object... more) {
        List<Object> all = new ArrayList<>(options);
        all.addAll(Arrays.asList(more));
        return all.toArray();
    }

    private static void assertDone(Cli.Result result) {
        assertEquals(0, result.code(), result.err());
    }

    private static String sums(Path file) {
        Cli.Result info = Cli.run("info", file);
        assertDone(info);
        return String.join(
                "\n",
                info.out().lines().filter(l -> l.matches("(sums|splats).*")).toList());
    }

    @ParameterizedTest
    @CsvSource({
        "path, 3",
        "raytracer, 2",
        "light, 5",
        "bidirectional, 4",
        "metropolis -P mutationsPerPixel=8 -P bootstrapSamples=3000 -P twoStage=true, 4",
        "metropolis -P mutationsPerPixel=8 -P bootstrapSamples=3000 -P sharing=always, 3"
    })
    void mergedPartsAreTheWholeImage(String rendererAndParameters, int parts) throws IOException {
        List<Object> same = new ArrayList<>(List.of("--renderer"));
        same.addAll(Arrays.asList(rendererAndParameters.split(" ")));
        same.addAll(List.of("--layers", "depth,variance"));
        Path whole = folder.resolve("whole.exr");
        assertDone(render(with(same, "-o", whole)));
        List<Object> merge = new ArrayList<>(List.of("merge"));
        for (int i = parts; i >= 1; i--) {
            Path part = folder.resolve(i + ".daybreak");
            assertDone(render(with(same, "--part", i + "/" + parts, "-o", part)));
            merge.add(part);
        }
        Path merged = folder.resolve("merged.exr");
        Path film = folder.resolve("merged.daybreak");
        merge.addAll(List.of("-o", merged, "-o", film));
        assertDone(Cli.run(merge.toArray()));
        for (String channel : new String[] {"R", "G", "B", "depth.Z", "variance.G"}) {
            assertArrayEquals(
                    ExrReader.read(whole).samples(channel),
                    ExrReader.read(merged).samples(channel),
                    channel);
        }
        for (String name : new String[] {"renderer", "parameters", "seed", "samples", "samplesPerPixel"}) {
            assertEquals(
                    ExrReader.read(whole).header().attributes().get(name),
                    ExrReader.read(merged).header().attributes().get(name),
                    name);
        }
        Path again = folder.resolve("again.exr");
        assertDone(Cli.run("merge", film, "-o", again));
        assertArrayEquals(
                ExrReader.read(whole).samples("R"), ExrReader.read(again).samples("R"));
        Path resumed = folder.resolve("resumed.exr");
        assertDone(render(with(same, "--resume", film, "-o", resumed)));
        assertArrayEquals(
                ExrReader.read(whole).samples("R"), ExrReader.read(resumed).samples("R"));
    }

    @Test
    void mergeSaysWhatIsWrong() {
        Path a = folder.resolve("a.daybreak");
        Path b = folder.resolve("b.daybreak");
        Path other = folder.resolve("other.daybreak");
        assertDone(render("--part", "1/3", "-o", a));
        assertDone(render("--part", "2/3", "-o", b));
        assertDone(render("--part", "3/3", "--seed", 5, "-o", other));
        Path out = folder.resolve("out.exr");
        assertMessage(3, "missing parts: 3/3", Cli.run("merge", a, b, "-o", out));
        assertMessage(3, "b.daybreak: is part 2/3, and so is", Cli.run("merge", a, b, b, "-o", out));
        assertMessage(
                3,
                "other.daybreak: cannot be merged: its seed is '5', that of",
                Cli.run("merge", a, b, other, "-o", out));
        assertMessage(3, "tiny.xml: is no partial film", Cli.run("merge", scene, "-o", out));
        assertMessage(
                3,
                "none.daybreak: there is no such file",
                Cli.run("merge", folder.resolve("none.daybreak"), "-o", out));
        assertMessage(2, "can only be written to a file with the ending daybreak", render("--part", "1/3", "-o", out));
        assertMessage(2, "there is no part 4 of 3", render("--part", "4/3", "-o", a));
        assertMessage(2, "must be of the form I/N", render("--part", "0/3", "-o", a));
        assertMessage(2, "cut into at most", render("--part", "1/99", "-o", a));
        assertMessage(
                2,
                "--target-error cannot be used with --part",
                render("--part", "1/3", "--target-error", "0.1", "-o", a));
        assertMessage(
                2,
                "renderer 'faulty' can neither be resumed nor cut into parts",
                render("--renderer", "faulty", "--checkpoint", checkpoint, "-o", out));
        assertFalse(Files.exists(out));
    }

    private static void assertMessage(int code, String message, Cli.Result result) {
        assertEquals(code, result.code(), result.err());
        assertEquals(1, result.messages().size(), result.err());
        assertTrue(result.err().contains(message), result.err());
    }

    @Test
    void aCompleteCheckpointWritesTheImageAgain() throws IOException {
        Path first = folder.resolve("first.exr");
        Path second = folder.resolve("second.exr");
        assertDone(render("--checkpoint", checkpoint, "-o", first));
        assertDone(render("--resume", checkpoint, "-o", second));
        assertArrayEquals(
                ExrReader.read(first).samples("G"), ExrReader.read(second).samples("G"));
        assertTrue(Cli.run("info", checkpoint).out().contains("complete         yes"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--seed 3 | its seed is '0', that of this render is '3'",
                "--spp 9 | its samples per pixel is '4', that of this render is '9'",
                "--renderer raytracer | its renderer is 'path', that of this render is 'raytracer'",
                "-P rrDepth=9 | its parameters is",
                "--crop 0,0,9,9 | its crop is",
                "--layers depth | its layers is '', that of this render is 'depth'",
                "--antialiasing grid | its antialiasing is 'sobol', that of this render is 'grid'",
                "--target-error 0.5 | its samples per pixel is",
                "--part 1/2 | it is the whole image, not part 1/2",
                "-D spp=5 | its scene is"
            })
    void otherRendersAreRefused(String options, String message) {
        assertDone(render("--checkpoint", checkpoint, "-o", folder.resolve("a.pfm")));
        List<Object> args = new ArrayList<>(List.of("--resume", checkpoint));
        args.addAll(List.of("-o", folder.resolve(options.contains("part") ? "b.daybreak" : "b.exr")));
        args.addAll(Arrays.asList(options.split(" ")));
        assertMessage(3, "c.daybreak: cannot be resumed here: " + message, render(args.toArray()));
    }

    @Test
    void anotherSceneIsRefused() throws IOException {
        assertDone(render("--checkpoint", checkpoint, "-o", folder.resolve("a.pfm")));
        Files.writeString(scene, TestScenes.usual().replace("value=\"4, 2, 1\"", "value=\"4, 2, 2\""));
        assertMessage(
                3,
                "cannot be resumed here: its scene is",
                render("--resume", checkpoint, "-o", folder.resolve("b.pfm")));
    }

    @Test
    void damagedFilesAreRefused() throws IOException {
        assertDone(render("--checkpoint", checkpoint, "-o", folder.resolve("a.pfm")));
        byte[] good = Files.readAllBytes(checkpoint);
        for (int at : new int[] {0, 9, 30, good.length / 2, good.length - 1}) {
            byte[] bad = good.clone();
            bad[at] ^= 1;
            Files.write(checkpoint, bad);
            Cli.Result result = render("--resume", checkpoint, "-o", folder.resolve("b.pfm"));
            assertEquals(3, result.code(), result.err());
            assertEquals(1, result.messages().size(), result.err());
        }
        for (int length : new int[] {0, 7, 12, 200, good.length - 8, good.length - 1}) {
            Files.write(checkpoint, Arrays.copyOf(good, length));
            assertMessage(3, "c.daybreak: is ", render("--resume", checkpoint, "-o", folder.resolve("b.pfm")));
        }
    }

    @Test
    void anInterruptedRenderGoesOnWithTheSameBits() throws IOException, InterruptedException {
        Path expected = folder.resolve("expected.daybreak");
        List<String> options = List.of("render", "tiny.xml", "--size", "80x70", "--spp", "1500", "--threads", "2");
        List<Object> uninterrupted = new ArrayList<>(options);
        uninterrupted.set(1, scene);
        uninterrupted.addAll(List.of("--progress", "none", "-o", expected));
        assertDone(Cli.run(uninterrupted.toArray()));
        List<String> args = new ArrayList<>(options);
        args.addAll(List.of(
                "--progress", "json", "--checkpoint", "c.daybreak", "--checkpoint-interval", "0.3", "-o", "x.pfm"));
        ChildJvm child = ChildJvm.start(folder, ChildJvm.command(List.of(), args));
        child.awaitMessage(Pattern.compile("\"event\":\"progress\""));
        child.signal("INT");
        assertEquals(130, child.await().code());
        assertTrue(Cli.run("info", checkpoint).out().contains("complete         no"));
        Path so = folder.resolve("so_far.pfm");
        Cli.Result soFar = Cli.run("merge", checkpoint, "-o", so);
        assertDone(soFar);
        assertTrue(soFar.err().contains("is not complete"), soFar.err());
        Path resumed = folder.resolve("resumed.daybreak");
        List<Object> rest = new ArrayList<>(options);
        rest.set(1, scene);
        rest.addAll(List.of("--progress", "none", "--resume", checkpoint, "-o", resumed));
        assertDone(Cli.run(rest.toArray()));
        assertEquals(sums(expected), sums(resumed));
    }

    /** A limit on the size of files stands for a full disk: the writes fail in the middle. */
    @Test
    void aFullDiskLeavesTheLastCheckpoint() throws IOException, InterruptedException {
        Assumptions.assumeTrue(Files.exists(Path.of("/bin/bash")), "no bash");
        assertDone(
                render("--spp", "100000", "--time", "0.5", "--checkpoint", checkpoint, "-o", folder.resolve("a.pfm")));
        byte[] before = Files.readAllBytes(checkpoint);
        List<String> command = new ArrayList<>(List.of("/bin/bash", "-c", "ulimit -f 64; exec \"$@\"", "bash"));
        command.addAll(ChildJvm.command(
                List.of(),
                List.of(
                        "render",
                        "tiny.xml",
                        "--size",
                        "80x70",
                        "--spp",
                        "100000",
                        "--time",
                        "60",
                        "--progress",
                        "none",
                        "--resume",
                        "c.daybreak",
                        "--checkpoint",
                        "c.daybreak",
                        "--checkpoint-interval",
                        "0.1",
                        "-o",
                        "x.pfm")));
        ChildJvm.Result result = ChildJvm.start(folder, command).await();
        assertEquals(4, result.code(), result.err());
        assertEquals(1, result.err().lines().count(), result.err());
        assertTrue(result.err().contains("c.daybreak: cannot be written: "), result.err());
        assertTrue(result.err().contains("is intact"), result.err());
        assertArrayEquals(before, Files.readAllBytes(checkpoint));
        assertFalse(Cli.files(folder).contains(".c.daybreak.tmp"));
    }

    @Test
    void checkpointsAreCheckedBeforeTheSceneIsRead() throws IOException {
        Path missing = folder.resolve("no").resolve("c.daybreak");
        assertMessage(4, "cannot be written", Cli.run("render", folder.resolve("x.xml"), "--checkpoint", missing));
        assertMessage(2, "is given twice", render("--checkpoint", checkpoint, "-o", checkpoint));
        assertMessage(2, "--checkpoint-interval needs --checkpoint", render("--checkpoint-interval", "5"));
        assertMessage(
                2,
                "--checkpoint-interval is -1.0 but must be greater",
                render("--checkpoint", checkpoint, "--checkpoint-interval", "-1"));
    }
}
