package org.daybreak.scenes.gltf;

/** Part of a glTF file breaks the rules of the format or asks for what is not supported. */
final class GltfException extends Exception {
    private static final long serialVersionUID = 1L;

    private final transient JsonValue where;
    private final String problem;

    /**
     * Creates the exception.
     *
     * @param where what is wrong
     * @param problem the predicate of a sentence about it
     */
    GltfException(JsonValue where, String problem) {
        super(where.path() + " " + problem);
        this.where = where;
        this.problem = problem;
    }

    JsonValue where() {
        return where;
    }

    String problem() {
        return problem;
    }
}
