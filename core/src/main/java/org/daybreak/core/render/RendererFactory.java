package org.daybreak.core.render;

import java.util.List;
import java.util.Optional;

/** A rendering algorithm as users see it. Implementations are found by {@link java.util.ServiceLoader}. */
public interface RendererFactory {
    /** Identifier on the command line and in scene files: {@code path}. */
    String id();

    /** One line on what it does. */
    String description();

    /** Its parameters, in the order they should be shown. */
    List<Parameter> parameters();

    /**
     * Name of the parameter, a whole number, that stands for the samples per pixel; empty if {@link RenderBudget#samplesPerPixel()}
     * does, as it does for most. Whoever asks a renderer for samples per pixel sets it, unless it has been given a value of its own.
     */
    default Optional<String> samplesParameter() {
        return Optional.empty();
    }

    /**
     * Creates a renderer.
     *
     * @param values values for exactly {@link #parameters()}
     */
    Renderer create(ParameterValues values);
}
