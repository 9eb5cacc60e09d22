package org.daybreak.scenes.model;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.SourceLocation;

/**
 * Reads Wavefront MTL files. What cannot be understood in them is a warning, since exporters write much that is wrong; a
 * model is then shown without.
 */
final class MtlReader {
    /** Material files are short; a larger one is none. */
    private static final long LARGEST_FILE = 1 << 24;

    private MtlReader() {}

    /**
     * The materials of a library that an OBJ file names; none if it cannot be read, which is reported as a warning.
     *
     * @param files receives the library if it has been read
     */
    static List<MtlMaterial> read(Path obj, String library, ProblemList problems, List<Path> files) {
        SourceLocation usedAt = SourceLocation.of(obj);
        String text;
        Path file;
        try {
            file = obj.resolveSibling(library.replace('\\', '/'));
            if (!Files.isRegularFile(file)) {
                problems.warning(usedAt, "the material file '" + library + "' does not exist");
                return List.of();
            }
            if (Files.size(file) > LARGEST_FILE) {
                problems.warning(usedAt, "the material file '" + library + "' is too large");
                return List.of();
            }
            text = Files.readString(file, StandardCharsets.ISO_8859_1);
        } catch (InvalidPathException | IOException e) {
            problems.warning(usedAt, "the material file '" + library + "' cannot be read: " + e.getMessage());
            return List.of();
        }
        files.add(file);
        return parse(file, text, problems);
    }

    static List<MtlMaterial> parse(Path file, String text, ProblemList problems) {
        List<MtlMaterial> materials = new ArrayList<>();
        int number = 0;
        for (String raw : text.split("\n", -1)) {
            number++;
            String line = raw.strip();
            if (line.isEmpty() || line.startsWith("#")) {
                continue;
            }
            String[] words = line.split("\\s+", 2);
            String argument = words.length < 2
                    ? ""
                    : new String(words[1].getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
            SourceLocation location = new SourceLocation(file, number, 0);
            if (words[0].equalsIgnoreCase("newmtl")) {
                materials.add(new MtlMaterial(argument, location));
            } else if (!materials.isEmpty()) {
                materials
                        .get(materials.size() - 1)
                        .set(words[0].toLowerCase(Locale.ROOT), argument, location, problems);
            }
        }
        return materials;
    }
}
