package org.daybreak.core.render;

import java.util.List;

/** A rendering algorithm as users see it. Implementations are found by {@link java.util.ServiceLoader}. */
public interface RendererFactory {
    /** Identifier on the command line and in scene files: {@code path}. */
    String id();

    /** One line on what it does. */
    String description();

    /** Its parameters, in the order they should be shown. */
    List<Parameter> parameters();

    /**
     * Creates a renderer.
     *
     * @param values values for exactly {@link #parameters()}
     */
    Renderer create(ParameterValues values);
}
