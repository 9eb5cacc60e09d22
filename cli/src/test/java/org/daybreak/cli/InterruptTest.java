package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A signal ends a render and keeps its picture; here on a process of its own, with the names it gives its files. */
class InterruptTest {
    @TempDir
    private Path folder;

    @BeforeEach
    void needsUnix() {
        assumeTrue(Files.isExecutable(Path.of("/bin/kill")) || Files.isExecutable(Path.of("/usr/bin/kill")), "no kill");
    }

    @Test
    void ctrlCWritesThePictureSoFar() throws Exception {
        assumeFalse(ignoresInterrupts(), "this process was started in the background and ignores SIGINT");
        interrupted("INT", 130);
    }

    @Test
    void killWritesThePictureSoFar() throws Exception {
        interrupted("TERM", 143);
    }

    @Test
    void beforeThereIsAPictureItEndsAtOnce() throws Exception {
        // Reading a pipe that nobody writes to takes until the signal comes.
        Path pipe = folder.resolve("scene.xml");
        assumeTrue(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0, "no mkfifo");
        ChildJvm child = ChildJvm.start(
                folder, ChildJvm.command(List.of("-Xlog:class+load:file=classes.log"), List.of("render", "scene.xml")));
        Path classes = folder.resolve("classes.log");
        long end = System.nanoTime() + 60_000_000_000L;
        while (System.nanoTime() < end
                && (!Files.exists(classes) || !Files.readString(classes).contains("org.daybreak.cli.RenderCommand"))) {
            Thread.sleep(50);
        }
        child.signal("TERM");
        assertEquals(143, child.await().code());
        assertEquals(List.of("classes.log", "scene.xml"), ChildJvm.filesWithoutLogs(folder));
    }

    private void interrupted(String signal, int code) throws Exception {
        TestScenes.write(folder, TestScenes.usual());
        ChildJvm child = ChildJvm.start(
                folder,
                ChildJvm.command(
                        List.of(),
                        List.of("render", "tiny.xml", "--time", "1000", "--progress", "json", "--stats", "s.json")));
        // An error estimate needs two samples in every pixel: then there is a whole picture.
        child.awaitMessage(Pattern.compile("\"relativeError\":[0-9]"));
        child.signal(signal);
        ChildJvm.Result result = child.await();
        assertEquals(code, result.code(), result.err());
        assertTrue(result.err().contains("interrupted: the image holds what was rendered so far"), result.err());
        assertEquals(List.of("s.json", "tiny.exr", "tiny.png", "tiny.xml"), ChildJvm.filesWithoutLogs(folder));
        ExrImage image = ExrReader.read(folder.resolve("tiny.exr"));
        assertEquals(4, image.samples("R")[3 * 8 + 3], 1e-6);
        assertEquals(8, ImageIO.read(folder.resolve("tiny.png").toFile()).getWidth());
        JsonNode statistics =
                new ObjectMapper().readTree(folder.resolve("s.json").toFile());
        assertTrue(statistics.get("cancelled").asBoolean());
        assertTrue(statistics.get("samples").asLong() >= 128);
    }

    /** Children inherit ignored signals, and shells ignore SIGINT for what they start in the background. */
    private static boolean ignoresInterrupts() throws IOException {
        Path status = Path.of("/proc/self/status");
        if (!Files.exists(status)) {
            return false;
        }
        for (String line : Files.readAllLines(status)) {
            if (line.startsWith("SigIgn:")) {
                long mask = Long.parseUnsignedLong(
                        line.substring("SigIgn:".length()).trim(), 16);
                return (mask & 2) != 0;
            }
        }
        return false;
    }
}
