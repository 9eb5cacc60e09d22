package org.daybreak.scenes.description;

import java.nio.file.Path;

/**
 * A place in an input file.
 *
 * @param file the file as the caller named it, or as an including file resolved it
 * @param line line from 1; 0 if the whole file is meant
 * @param column column from 1 in characters (a tab counts as one); 0 if the whole line is meant
 */
public record SourceLocation(Path file, int line, int column) {
    /** The whole file. */
    public static SourceLocation of(Path file) {
        return new SourceLocation(file, 0, 0);
    }

    /** {@code file:line:column}, without the parts that are 0. */
    @Override
    public String toString() {
        if (line == 0) {
            return file.toString();
        }
        return column == 0 ? file + ":" + line : file + ":" + line + ":" + column;
    }
}
