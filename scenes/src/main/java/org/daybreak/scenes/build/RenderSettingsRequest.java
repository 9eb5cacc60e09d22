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

    /** Name of the renderer parameter for whether Markov chains leave direct light to ordinary sampling. */
    public static final String SEPARATE_DIRECT = "separateDirect";

    /** Name of the renderer parameter for the samples per pixel of direct light beside Markov chains. */
    public static final String DIRECT_SAMPLES = "directSamples";

    /** Name of the renderer parameter for the number of samples for the start of Markov chains. */
    public static final String BOOTSTRAP_SAMPLES = "bootstrapSamples";

    /** Name of the renderer parameter for whether a rough image guides Markov chains. */
    public static final String TWO_STAGE = "twoStage";

    /** Name of the renderer parameter for the edge in pixels of the cells of that image. */
    public static final String REDUCTION = "reduction";

    /** Name of the renderer parameter for the probability of a new sample, in chains over random numbers. */
    public static final String LARGE_STEP = "largeStep";

    /** Name of the renderer parameter for the smallest change of a random number. */
    public static final String SMALLEST_STEP = "smallestStep";

    /** Name of the renderer parameter for the largest change of a random number. */
    public static final String LARGEST_STEP = "largestStep";

    /** Name of the renderer parameter for the relative probability of the bidirectional mutation. */
    public static final String BIDIRECTIONAL_MUTATION = "bidirectional";

    /** Name of the renderer parameter for that of the lens subpath mutation. */
    public static final String LENS_SUBPATH_MUTATION = "lensSubpath";

    /** Name of the renderer parameter for that of the lens perturbation. */
    public static final String LENS_PERTURBATION = "lens";

    /** Name of the renderer parameter for that of the caustic perturbation. */
    public static final String CAUSTIC_PERTURBATION = "caustic";

    /** Name of the renderer parameter for that of the multi-chain perturbation. */
    public static final String MULTI_CHAIN_PERTURBATION = "multiChain";

    /** Name of the renderer parameter for that of the manifold perturbation. */
    public static final String MANIFOLD_PERTURBATION = "manifold";

    /** Copies the map. */
    public RenderSettingsRequest {
        parameters = Collections.unmodifiableMap(new LinkedHashMap<>(parameters));
    }
}
