package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the program writes as JSON is what the schemas in {@code docs/schemas} say. */
class SchemaTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"path", "light", "faulty"})
    void statisticsAndProgress(String renderer) throws IOException {
        Path stats = folder.resolve("stats.json");
        Cli.Result result = Cli.run(
                "render",
                TestScenes.write(folder, TestScenes.usual()),
                "--renderer",
                renderer,
                "--progress",
                "json",
                "--stats",
                stats,
                "-o",
                folder.resolve("a.pfm"));
        JsonSchema statistics = JsonSchema.read("stats.schema.json");
        JsonNode document = JSON.readTree(stats.toFile());
        assertEquals(List.of(), statistics.problems(document));
        JsonSchema progress = JsonSchema.read("progress.schema.json");
        int lines = 0;
        for (String line : result.err().lines().toList()) {
            if (line.startsWith("{")) {
                assertEquals(List.of(), progress.problems(JSON.readTree(line)), line);
                lines++;
            }
        }
        assertTrue(lines >= 1, result.err());

        ObjectNode less = document.deepCopy();
        less.remove("seed");
        assertFalse(statistics.problems(less).isEmpty(), "a missing field is found");
        ObjectNode more = document.deepCopy();
        more.put("speed", 3);
        assertFalse(statistics.problems(more).isEmpty(), "an unknown field is found");
        ObjectNode other = document.deepCopy();
        other.put("threads", "two");
        assertFalse(statistics.problems(other).isEmpty(), "a wrong type is found");
    }
}
