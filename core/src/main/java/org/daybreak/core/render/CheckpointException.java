package org.daybreak.core.render;

/** A checkpoint could not be saved. The message is fit for users. */
public final class CheckpointException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** Creates the exception. */
    public CheckpointException(String message, Throwable cause) {
        super(message, cause);
    }
}
