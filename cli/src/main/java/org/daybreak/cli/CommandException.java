package org.daybreak.cli;

/** A command cannot go on, for a reason that is not a fault of the program. The message is meant for users. */
final class CommandException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final ExitCode code;

    CommandException(ExitCode code, String message) {
        this(code, message, null);
    }

    CommandException(ExitCode code, String message, @org.jspecify.annotations.Nullable Throwable cause) {
        super(message, cause);
        this.code = code;
    }

    /** How the program ends. */
    ExitCode code() {
        return code;
    }

    /** The message; never null. */
    String text() {
        return String.valueOf(getMessage());
    }
}
