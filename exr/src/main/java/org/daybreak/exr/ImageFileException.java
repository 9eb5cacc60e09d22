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
        this(file.toString(), reason);
    }

    /**
     * Creates the exception for an image that is not in a file of its own.
     *
     * @param name what the image is to be called in the message
     * @param reason what is wrong, without the name
     */
    public ImageFileException(String name, String reason) {
        super(name + ": " + reason);
        this.file = name;
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
        this(file.toString(), reason, cause);
    }

    /**
     * Creates the exception, with its cause, for an image that is not in a file of its own.
     *
     * @param name what the image is to be called in the message
     * @param reason what is wrong, without the name
     * @param cause the error underneath
     */
    public ImageFileException(String name, String reason, Throwable cause) {
        super(name + ": " + reason, cause);
        this.file = name;
        this.reason = reason;
    }

    /**
     * Returns the name of the file, or of the image in memory, as the caller gave it.
     *
     * @return the path or name as text
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
