package org.daybreak.exr;

import java.io.IOException;
import java.io.Serial;
import java.nio.file.Path;

/** An image file cannot be read or written. The message is one line: the file, a colon and the reason. */
public final class ImageFileException extends IOException {
    @Serial
    private static final long serialVersionUID = 1L;

    private final String file;
    private final String reason;

    /**
     * Creates the exception.
     *
     * @param file the file that was to be read or written
     * @param reason what is wrong, without the file name
     */
    public ImageFileException(Path file, String reason) {
        super(file + ": " + reason);
        this.file = file.toString();
        this.reason = reason;
    }

    /**
     * Creates the exception with its cause.
     *
     * @param file the file that was to be read or written
     * @param reason what is wrong, without the file name
     * @param cause the error underneath
     */
    public ImageFileException(Path file, String reason, Throwable cause) {
        super(file + ": " + reason, cause);
        this.file = file.toString();
        this.reason = reason;
    }

    /**
     * Returns the name of the file as the caller gave it.
     *
     * @return the path as text
     */
    public String file() {
        return file;
    }

    /**
     * Returns what is wrong, without the file name.
     *
     * @return the reason
     */
    public String reason() {
        return reason;
    }
}
