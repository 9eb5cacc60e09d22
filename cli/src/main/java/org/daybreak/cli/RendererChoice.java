package org.daybreak.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalLong;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.scenes.build.RenderSettingsRequest;
import org.jspecify.annotations.Nullable;

/**
 * The renderer with its parameters, as decided by the command line, the scene file and the defaults, in this order.
 *
 * @param factory the renderer
 * @param values all its parameters
 */
record RendererChoice(RendererFactory factory, ParameterValues values) {
    /**
     * Decides; {@link ExitCode#INPUT} if the scene sets a wrong value.
     *
     * @param renderer renderer of the command line, null if it names none
     * @param parameters those of the command line
     * @param scene the scene file, for messages
     * @param request what the scene asks for. Values for parameters that the renderer does not have are left out.
     * @param samplesPerPixel samples per pixel that are asked for, empty if none are: for renderers that have a parameter for them
     * @throws ParameterException if the command line sets a wrong parameter or value
     */
    static RendererChoice of(
            @Nullable String renderer,
            Map<String, String> parameters,
            Path scene,
            RenderSettingsRequest request,
            OptionalLong samplesPerPixel) {
        RendererFactory factory = Services.renderer(
                renderer != null ? renderer : request.rendererId().orElse(RenderPlan.DEFAULT_RENDERER));
        Map<String, String> texts = new LinkedHashMap<>();
        for (Parameter parameter : factory.parameters()) {
            String asked = request.parameters().get(parameter.name());
            if (asked != null && !parameters.containsKey(parameter.name())) {
                try {
                    parameter.parse(asked);
                } catch (ParameterException e) {
                    throw new CommandException(ExitCode.INPUT, scene + ": " + e.getMessage(), e);
                }
                texts.put(parameter.name(), asked);
            }
        }
        String samples = factory.samplesParameter().orElse(null);
        if (samples != null && samplesPerPixel.isPresent()) {
            texts.putIfAbsent(samples, Long.toString(samplesPerPixel.getAsLong()));
        }
        texts.putAll(parameters);
        return new RendererChoice(factory, ParameterValues.parse(factory.parameters(), texts, factory.id()));
    }

    /** The parameters that the image depends on: all but folders for further images, whose names are the machine's. */
    Map<String, Object> imageParameters() {
        Map<String, Object> map = new LinkedHashMap<>(values.asMap());
        for (Parameter parameter : factory.parameters()) {
            if (parameter.type() == Parameter.Type.FOLDER) {
                map.remove(parameter.name());
            }
        }
        return map;
    }
}
