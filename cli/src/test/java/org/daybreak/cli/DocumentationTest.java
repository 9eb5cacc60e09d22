package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The reference pages name what there is. */
class DocumentationTest {
    @TempDir
    private Path folder;

    @Test
    void everyExitCode() throws IOException {
        String page = page("cli.md");
        for (ExitCode code : ExitCode.values()) {
            assertTrue(page.contains("| " + code.number() + " | " + code.meaning() + " |"), code.toString());
        }
    }

    @Test
    void everyOptionOfRender() throws IOException {
        String page = page("cli.md");
        Matcher option = Pattern.compile("^ +(-\\w|(?=--))(?:, )?(--[\\w-]+)?", Pattern.MULTILINE)
                .matcher(Cli.run("render", "--help").out());
        int count = 0;
        while (option.find()) {
            String name = option.group(2) == null ? option.group(1) : option.group(2);
            if (!name.equals("--help")) {
                count++;
                assertTrue(page.contains("`" + name + " "), name);
            }
        }
        assertEquals(21, count);
    }

    @Test
    void everyFieldOfTheStatistics() throws IOException {
        Path stats = folder.resolve("stats.json");
        assertEquals(
                0,
                Cli.run(
                                "render",
                                TestScenes.write(folder, TestScenes.usual()),
                                "-o",
                                folder.resolve("out.exr"),
                                "--stats",
                                stats)
                        .code());
        String page = page("stats.md");
        for (Map.Entry<String, JsonNode> field :
                new ObjectMapper().readTree(stats.toFile()).properties()) {
            assertTrue(
                    page.contains("`" + field.getKey() + "`") || page.contains("`" + field.getKey() + "."),
                    field.getKey());
        }
        for (String phase : new String[] {"load", "compile", "render", "write", "total"}) {
            assertTrue(page.contains("`" + phase + "`"), phase);
        }
    }

    private static String page(String name) throws IOException {
        return Files.readString(Path.of(System.getProperty("daybreak.root"), "docs", name));
    }
}
