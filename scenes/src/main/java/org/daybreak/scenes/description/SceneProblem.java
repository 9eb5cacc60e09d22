package org.daybreak.scenes.description;

/**
 * An error or a warning about an input file.
 *
 * @param location where it is
 * @param message what is wrong and, where there is one, the nearest valid name
 */
public record SceneProblem(SourceLocation location, String message) {
    /** {@code file:line:column: message}. */
    @Override
    public String toString() {
        return location + ": " + message;
    }
}
