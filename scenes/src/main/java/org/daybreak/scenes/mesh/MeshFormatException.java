package org.daybreak.scenes.mesh;

import java.io.IOException;

/** A mesh file breaks the rules of its format. The message says what is wrong; the line, where there is one, is separate. */
public final class MeshFormatException extends IOException {
    private static final long serialVersionUID = 1L;

    private final int line;

    /**
     * Creates the exception.
     *
     * @param line line from 1, or 0 in the binary part of a file
     * @param message what is wrong
     */
    public MeshFormatException(int line, String message) {
        super(message);
        this.line = line;
    }

    /** Line from 1, or 0 in the binary part of a file. */
    public int line() {
        return line;
    }
}
