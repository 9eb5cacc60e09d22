package org.daybreak.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * One run of the program: where it writes to and how it is interrupted.
 *
 * @param out results
 * @param err messages and progress
 * @param interrupts signals
 */
record Session(PrintStream out, PrintStream err, Interrupts interrupts) {
    /** The launcher script tells by this property whether the error stream is a terminal. */
    private static final String TERMINAL_PROPERTY = "daybreak.stderr.terminal";

    /** Says why the program cannot go on. */
    void error(String message) {
        print("daybreak: ", message);
    }

    /** Says what the user should know although the program goes on. */
    void warning(String message) {
        print("daybreak: warning: ", message);
    }

    private void print(String prefix, String message) {
        for (String line : message.split("\n", -1)) {
            err.println(prefix + line);
        }
        err.flush();
    }

    /** True if messages go to a terminal, where a line can be rewritten. */
    boolean isTerminal() {
        if (err != System.err) {
            return false;
        }
        String told = System.getProperty(TERMINAL_PROPERTY);
        if (told != null) {
            return Boolean.parseBoolean(told);
        }
        // System.console() asks about other streams and, on recent releases, loads a line editor.
        try {
            String target = Files.readSymbolicLink(Path.of("/proc/self/fd/2")).toString();
            return target.startsWith("/dev/pts/") || target.startsWith("/dev/tty");
        } catch (IOException | UnsupportedOperationException e) {
            return false;
        }
    }
}
