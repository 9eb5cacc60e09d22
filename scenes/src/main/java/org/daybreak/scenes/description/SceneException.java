package org.daybreak.scenes.description;

import java.util.List;
import java.util.stream.Collectors;

/** A scene cannot be loaded. Carries every error that was found in its files; the message lists them one per line. */
public final class SceneException extends Exception {
    private static final long serialVersionUID = 1L;

    private final transient List<SceneProblem> problems;

    /**
     * Creates the exception.
     *
     * @param problems the errors in the order they were found; at least one
     */
    public SceneException(List<SceneProblem> problems) {
        super(problems.stream().map(SceneProblem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /** The errors in the order they were found; empty only after deserialisation. */
    public List<SceneProblem> problems() {
        return problems == null ? List.of() : problems;
    }
}
