package org.daybreak.scenes.build;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * What a scene file asks of the renderer. Requests only: the user's options go first, and the renderer's own parameter
 * definitions check the values.
 *
 * @param rendererId renderer, if the file has an integrator
 * @param parameters texts of renderer parameters by name, only those the file gives
 * @param samplesPerPixel samples per pixel, if the file says
 * @param seed seed of the random numbers, if the file says
 */
public record RenderSettingsRequest(
        Optional<String> rendererId, Map<String, String> parameters, OptionalInt samplesPerPixel, OptionalLong seed) {
    /** Name of the renderer parameter for the longest path in edges, −1 for unlimited. */
    public static final String MAX_DEPTH = "maxDepth";

    /** Name of the renderer parameter for the depth from which Russian roulette is played. */
    public static final String ROULETTE_DEPTH = "rrDepth";

    /** Name of the renderer parameter for whether light paths are joined to the lens. */
    public static final String CAUSTIC_MAP = "causticMap";

    /** Copies the map. */
    public RenderSettingsRequest {
        parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
    }
}
