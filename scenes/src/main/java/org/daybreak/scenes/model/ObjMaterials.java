package org.daybreak.scenes.model;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * What an OBJ file says about materials.
 *
 * @param libraries the material files it names
 * @param names the materials that have faces, in their order; "" for faces before the first {@code usemtl}
 */
record ObjMaterials(Set<String> libraries, Set<String> names) {
    /** Longer lines are no statements about materials. */
    private static final int LONGEST_LINE = 1 << 12;

    /**
     * Scans a file.
     *
     * @throws IOException if it cannot be read
     */
    static ObjMaterials of(Path file) throws IOException {
        Set<String> libraries = new LinkedHashSet<>();
        Set<String> names = new LinkedHashSet<>();
        String current = "";
        try (BufferedReader reader =
                new BufferedReader(new InputStreamReader(Files.newInputStream(file), StandardCharsets.ISO_8859_1))) {
            StringBuilder line = new StringBuilder();
            boolean more = true;
            while (more) {
                int c = reader.read();
                more = c != -1;
                if (more && c != '\n') {
                    if (line.length() < LONGEST_LINE) {
                        line.append((char) c);
                    }
                    continue;
                }
                String statement = line.toString().strip();
                line.setLength(0);
                if (statement.startsWith("f ") || statement.startsWith("f\t")) {
                    names.add(current);
                } else if (statement.startsWith("usemtl")) {
                    current = argument(statement, 6);
                } else if (statement.startsWith("mtllib")) {
                    libraries.add(argument(statement, 6));
                }
            }
        }
        return new ObjMaterials(libraries, names);
    }

    private static String argument(String statement, int from) {
        return new String(
                statement.substring(from).strip().getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    }
}
