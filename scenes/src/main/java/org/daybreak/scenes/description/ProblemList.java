package org.daybreak.scenes.description;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.daybreak.core.render.NearestName;

/** Collects errors and warnings while a scene is read. Not thread-safe. */
public final class ProblemList {
    /** Further errors are only counted: nobody reads more, and generated files can have millions. */
    public static final int LISTED_ERRORS = 200;

    /** Longer ones are no misspelt names. */
    private static final int LONGEST_NAME = 200;

    private final List<SceneProblem> errors = new ArrayList<>();
    private final List<SceneProblem> warnings = new ArrayList<>();
    private long unlisted;

    /** Creates an empty list. */
    public ProblemList() {}

    /** Adds an error. */
    public void error(SourceLocation location, String message) {
        SceneProblem problem = new SceneProblem(location, message);
        if (errors.size() >= LISTED_ERRORS) {
            unlisted++;
        } else if (!errors.contains(problem)) {
            errors.add(problem);
        }
    }

    /** Adds an error about a name that does not exist, with the nearest of the names that do. */
    public void unknownName(SourceLocation location, String message, String name, Collection<String> known) {
        // The hint takes time for each known name, of which there may be as many as there are unknown ones.
        error(location, errors.size() < LISTED_ERRORS ? message + hint(name, known) : message);
    }

    /** Adds a warning about a name that does not exist, with the nearest of the names that do. */
    public void unknownNameWarning(SourceLocation location, String message, String name, Collection<String> known) {
        if (warnings.size() < LISTED_ERRORS) {
            warning(location, message + hint(name, known));
        }
    }

    private static String hint(String name, Collection<String> known) {
        return name.length() > LONGEST_NAME ? "" : NearestName.hint(name, known);
    }

    /** Adds a warning. */
    public void warning(SourceLocation location, String message) {
        if (warnings.size() < LISTED_ERRORS) {
            warnings.add(new SceneProblem(location, message));
        }
    }

    /** True if there is an error. */
    public boolean hasErrors() {
        return !errors.isEmpty();
    }

    /** The errors found so far, in order; the last one says how many are left out, if any are. */
    public List<SceneProblem> errors() {
        if (unlisted == 0) {
            return List.copyOf(errors);
        }
        List<SceneProblem> all = new ArrayList<>(errors);
        SourceLocation last =
                SourceLocation.of(errors.get(errors.size() - 1).location().file());
        all.add(new SceneProblem(last, unlisted + " further errors are not listed"));
        return List.copyOf(all);
    }

    /** The warnings found so far, in order. */
    public List<SceneProblem> warnings() {
        return List.copyOf(warnings);
    }

    /**
     * Ends the work if there is an error.
     *
     * @throws SceneException with all errors
     */
    public void throwIfErrors() throws SceneException {
        if (hasErrors()) {
            throw new SceneException(errors());
        }
    }
}
