package org.daybreak.cli;

/** What the program's exit code says. Documented in {@code docs/cli.md}; the numbers never change their meaning. */
enum ExitCode {
    /** All went well. */
    OK(0, "done"),
    /** A fault of the program. */
    INTERNAL(1, "internal error: a fault of the program, please report it"),
    /** The command line is wrong. */
    USAGE(2, "wrong command line: unknown option, renderer or parameter, or a value out of range"),
    /** An input file is wrong. */
    INPUT(3, "a scene or another input file is missing, unreadable or wrong"),
    /** An output file cannot be written. */
    OUTPUT(4, "an output file cannot be written"),
    /** Images cannot be compared. */
    DIFFERENT(5, "diff: the images have different sizes or no channel in common"),
    /** Values that are not numbers turned up. */
    NON_FINITE(6, "done, but some samples or pixels were infinite or not numbers and were left out"),
    /** The Java heap is full. */
    MEMORY(7, "not enough memory"),
    /** Ended by a hang-up. */
    HANG_UP(129, "hang-up (SIGHUP)"),
    /** Ended by Ctrl-C. */
    INTERRUPTED(130, "interrupted (Ctrl-C, SIGINT); a running render writes the image so far"),
    /** Ended by another program. */
    TERMINATED(143, "terminated (SIGTERM); a running render writes the image so far");

    private final int number;
    private final String meaning;

    ExitCode(int number, String meaning) {
        this.number = number;
        this.meaning = meaning;
    }

    /** The number handed to the operating system. */
    int number() {
        return number;
    }

    /** What it means, in a few words. */
    String meaning() {
        return meaning;
    }
}
