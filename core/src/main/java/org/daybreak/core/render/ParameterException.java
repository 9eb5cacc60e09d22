package org.daybreak.core.render;

import org.jspecify.annotations.Nullable;

/** A parameter or other render setting has an unknown name or an inadmissible value. The message says which and why. */
public final class ParameterException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /** Creates the exception with a message fit for users. */
    public ParameterException(String message) {
        super(message);
    }

    /** Creates the exception with a message fit for users and the reason behind it. */
    public ParameterException(String message, @Nullable Throwable cause) {
        super(message, cause);
    }
}
