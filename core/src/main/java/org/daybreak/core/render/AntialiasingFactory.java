package org.daybreak.core.render;

import java.util.List;

/** An antialiasing method as users see it. Implementations are found by {@link java.util.ServiceLoader}. */
public interface AntialiasingFactory {
    /** Identifier on the command line: {@code sobol}. */
    String id();

    /** One line on what it does. */
    String description();

    /** Its parameters, in the order they should be shown. */
    List<Parameter> parameters();

    /**
     * Creates the method.
     *
     * @param values values for exactly {@link #parameters()}
     */
    Antialiasing create(ParameterValues values);
}
