package org.daybreak.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The page {@code docs/formulas.md} names classes and members that exist. */
class FormulasPageTest {
    private static final Path ROOT = Path.of(System.getProperty("daybreak.root"));
    private static final Pattern NAME = Pattern.compile("`(?:core\\.\\w+\\.)?([A-Z]\\w+)(?:\\.(\\w+))?`");

    @Test
    void everyClassAndMemberExists() throws IOException {
        Map<String, String> sources = sources();
        List<String> missing = new ArrayList<>();
        Matcher name = NAME.matcher(Files.readString(ROOT.resolve("docs/formulas.md")));
        int found = 0;
        while (name.find()) {
            found++;
            String source = sources.get(name.group(1));
            String member = name.group(2);
            if (source == null
                    || (member != null
                            && !Pattern.compile("\\b" + member + "\\b")
                                    .matcher(source)
                                    .find())) {
                missing.add(name.group());
            }
        }
        assertEquals(List.of(), missing);
        assertTrue(found > 100, found + " names");
    }

    /** Sources of all modules by the simple name of their class. */
    private static Map<String, String> sources() throws IOException {
        Map<String, String> sources = new HashMap<>();
        try (Stream<Path> modules = Files.list(ROOT)) {
            for (Path module : modules.toList()) {
                Path main = module.resolve("src/main/java");
                if (Files.isDirectory(main)) {
                    try (Stream<Path> files = Files.walk(main)) {
                        for (Path file : files.filter(f -> f.toString().endsWith(".java"))
                                .toList()) {
                            String name = file.getFileName().toString();
                            sources.put(name.substring(0, name.length() - ".java".length()), Files.readString(file));
                        }
                    }
                }
            }
        }
        return sources;
    }
}
