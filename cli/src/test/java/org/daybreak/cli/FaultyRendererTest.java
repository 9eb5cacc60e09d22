package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FaultyRendererTest {
    @TempDir
    private Path folder;

    @Test
    void nonFiniteSamplesAreToldWithTheirAddress() throws IOException {
        Cli.Result result = run("nonFinite");
        assertEquals(6, result.code());
        assertTrue(result.messages().get(0).contains("pixel (1, 2), sample 0"), result.err());
        JsonNode statistics =
                new ObjectMapper().readTree(folder.resolve("s.json").toFile());
        assertEquals(3, statistics.get("nonFinite").get("count").asInt());
        assertEquals(1, statistics.get("nonFinite").get("addresses").size());
        assertEquals(1, statistics.get("warnings").size());
        assertEquals(List.of("out.exr", "s.json", "tiny.xml"), Cli.files(folder));
    }

    @Test
    void internalErrorsShowWhereTheyComeFrom() throws IOException {
        Cli.Result result = run("crash");
        assertEquals(1, result.code());
        assertTrue(result.err().contains("please report it"), result.err());
        assertTrue(result.err().contains("IllegalStateException: on purpose"), result.err());
        assertTrue(result.err().contains("\tat "), result.err());
        assertEquals(List.of("tiny.xml"), Cli.files(folder));
    }

    @Test
    void memoryOfAWorkerRunsOut() throws IOException {
        Cli.Result result = run("memory");
        assertEquals(7, result.code());
        assertEquals(1, result.err().lines().count(), result.err());
        assertFalse(result.err().contains("\tat "), result.err());
        assertEquals(List.of("tiny.xml"), Cli.files(folder));
    }

    @Test
    void settingsThatDoNotFitTheScene() throws IOException {
        Cli.Result result = run("settings");
        assertEquals(2, result.code());
        assertEquals(
                "daybreak: these settings do not fit the scene", result.err().trim());
        assertEquals(List.of("tiny.xml"), Cli.files(folder));
    }

    private Cli.Result run(String fault) throws IOException {
        Path scene = TestScenes.write(folder, TestScenes.usual());
        return Cli.run(
                "render",
                scene,
                "-o",
                folder.resolve("out.exr"),
                "--renderer",
                "faulty",
                "-P",
                "fault=" + fault,
                "--stats",
                folder.resolve("s.json"));
    }
}
