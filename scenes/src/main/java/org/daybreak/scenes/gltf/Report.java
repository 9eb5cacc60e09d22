package org.daybreak.scenes.gltf;

import java.nio.file.Path;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.SourceLocation;

/** Collects what is wrong with a file, each with the JSON pointer of where it is. */
final class Report {
    private final Path file;
    private final boolean text;
    private final ProblemList problems;

    /**
     * Creates a report.
     *
     * @param text true if line and column in the document mean something to the author of the file
     */
    Report(Path file, boolean text, ProblemList problems) {
        this.file = file;
        this.text = text;
        this.problems = problems;
    }

    /** Where a value stands. */
    SourceLocation location(JsonValue value) {
        return text ? new SourceLocation(file, value.line(), value.column()) : SourceLocation.of(file);
    }

    void error(GltfException e) {
        problems.error(location(e.where()), e.where().path() + " " + e.problem());
    }

    void error(JsonValue value, String problem) {
        error(value.error(problem));
    }

    void warning(JsonValue value, String problem) {
        problems.warning(location(value), value.path() + " " + problem);
    }
}
