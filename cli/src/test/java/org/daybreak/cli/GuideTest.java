package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.daybreak.scenes.InputFormats;
import org.daybreak.scenes.build.PluginDefinition;
import org.daybreak.scenes.description.ObjectKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The user guide shows scenes that exist and load, and all materials and lights; the scenes that Mitsuba is compared on load. */
class GuideTest {
    private static final Path ROOT = Path.of(System.getProperty("daybreak.root"));
    private static final Path GUIDE = ROOT.resolve("docs/guide");
    private static final Path AGREEMENT = ROOT.resolve("src/test/resources/agreement");
    /** A picture, and the scene that made it. */
    private static final Pattern EXAMPLE =
            Pattern.compile("src=\"guide/(\\w+)\\.png\"[^>]*>.*?```xml\\R(.*?)```", Pattern.DOTALL);

    static List<Path> scenes() throws IOException {
        try (Stream<Path> guide = Files.list(GUIDE);
                Stream<Path> agreement = Files.list(AGREEMENT);
                Stream<Path> differs = Files.list(AGREEMENT.resolve("differs"))) {
            return Stream.of(guide, agreement, differs)
                    .flatMap(files -> files)
                    .filter(file -> file.toString().endsWith(".xml"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void loadsWithoutComplaint(Path scene) {
        Cli.Result result = Cli.run("info", scene);
        assertAll(() -> assertEquals("", result.err()), () -> assertEquals(0, result.code()));
    }

    @Test
    void showsTheScenesAsTheyAre() throws IOException {
        Map<String, String> shown = new HashMap<>();
        Matcher example = EXAMPLE.matcher(Files.readString(ROOT.resolve("docs/guide.md")));
        while (example.find()) {
            shown.put(example.group(1), example.group(2));
            assertTrue(Files.exists(GUIDE.resolve(example.group(1) + ".png")), example.group(1));
        }
        Map<String, String> files = new HashMap<>();
        for (Path scene : scenes()) {
            if (scene.startsWith(GUIDE)) {
                files.put(scene.getFileName().toString().replace(".xml", ""), Files.readString(scene));
            }
        }
        assertEquals(files, shown);
    }

    @Test
    void showsEveryMaterialAndLight() throws IOException {
        StringBuilder text = new StringBuilder();
        for (Path scene : scenes()) {
            if (scene.startsWith(GUIDE)) {
                text.append(Files.readString(scene));
            }
        }
        for (PluginDefinition plugin : InputFormats.plugins()) {
            if (plugin.kind() == ObjectKind.BSDF || plugin.kind() == ObjectKind.EMITTER) {
                String type = "type=\"" + plugin.type() + "\"";
                assertTrue(text.indexOf(type) >= 0, "no scene of the guide has " + type);
            }
        }
    }
}
