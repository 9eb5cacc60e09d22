package org.daybreak.scenes.build;

import java.util.LinkedHashMap;
import java.util.Map;

/** Reads what an integrator asks of the renderer: its identifier and those parameters that the file gives. */
final class IntegratorReader {
    /** Switches of the strategies of {@code mlt}, and the renderer's parameters for their probabilities. */
    private static final Map<String, String> STRATEGIES = strategies();

    private final BuildContext context;
    private final Properties properties;
    private final Map<String, String> parameters = new LinkedHashMap<>();

    private IntegratorReader(BuildContext context, Properties properties) {
        this.context = context;
        this.properties = properties;
    }

    /**
     * What is asked for.
     *
     * @param rendererId renderer
     * @param parameters texts of renderer parameters by name
     */
    record Request(String rendererId, Map<String, String> parameters) {}

    /** Reads the properties of an integrator; problems go to the context. */
    static Request read(BuildContext context, Properties properties) {
        IntegratorReader reader = new IntegratorReader(context, properties);
        return new Request(reader.read(), reader.parameters);
    }

    private static Map<String, String> strategies() {
        Map<String, String> names = new LinkedHashMap<>();
        names.put("bidirectional_mutation", RenderSettingsRequest.BIDIRECTIONAL_MUTATION);
        names.put("lens_subpath_mutation", RenderSettingsRequest.LENS_SUBPATH_MUTATION);
        names.put("lens_perturbation", RenderSettingsRequest.LENS_PERTURBATION);
        names.put("caustic_perturbation", RenderSettingsRequest.CAUSTIC_PERTURBATION);
        names.put("multi_chain_perturbation", RenderSettingsRequest.MULTI_CHAIN_PERTURBATION);
        names.put("manifold_perturbation", RenderSettingsRequest.MANIFOLD_PERTURBATION);
        return names;
    }

    private String read() {
        if (properties.truth("hide_emitters")) {
            context.warning(properties.location("hide_emitters"), "'hide_emitters' has no effect: lights stay visible");
        }
        switch (properties.object().type()) {
            case "direct" -> {
                parameters.put(RenderSettingsRequest.MAX_DEPTH, "2");
                return "path";
            }
            case "ptracer" -> {
                readDepths();
                return "light";
            }
            case "bdpt" -> {
                readDepths();
                truth("light_image", RenderSettingsRequest.CAUSTIC_MAP);
                return "bidirectional";
            }
            case "mlt" -> {
                readDepths();
                readChains();
                readStrategies();
                return "metropolis";
            }
            case "pssmlt" -> {
                readDepths();
                readChains();
                readSteps();
                return "pssmlt";
            }
            default -> {
                readDepths();
                return "path";
            }
        }
    }

    private void readDepths() {
        forbidZero("max_depth", "unlimited");
        integer("max_depth", RenderSettingsRequest.MAX_DEPTH);
        integer("rr_depth", RenderSettingsRequest.ROULETTE_DEPTH);
    }

    private void readChains() {
        forbidZero("direct_samples", "leaving direct light to the chains");
        if (properties.has("direct_samples") && properties.integer("direct_samples") < 0) {
            parameters.put(RenderSettingsRequest.SEPARATE_DIRECT, "false");
        } else {
            integer("direct_samples", RenderSettingsRequest.DIRECT_SAMPLES);
        }
        integer("luminance_samples", RenderSettingsRequest.BOOTSTRAP_SAMPLES);
        truth("two_stage", RenderSettingsRequest.TWO_STAGE);
        integer("first_stage_size_reduction", RenderSettingsRequest.REDUCTION);
    }

    /** Strategies that are on have the probabilities that are the renderer's defaults. */
    private void readStrategies() {
        STRATEGIES.forEach((property, parameter) -> {
            if (!properties.truth(property)) {
                parameters.put(parameter, "0");
            }
        });
        if (parameters.keySet().containsAll(STRATEGIES.values())) {
            context.error(properties.location(), "all mutation strategies are switched off");
        }
        if (properties.has("lambda")) {
            context.warning(
                    properties.location("lambda"),
                    "'lambda' has no effect: the jumps of the manifold perturbation follow from the renderer's own"
                            + " parameters");
        }
    }

    private void readSteps() {
        number("p_large", RenderSettingsRequest.LARGE_STEP);
        number("mutation_size_low", RenderSettingsRequest.SMALLEST_STEP);
        number("mutation_size_high", RenderSettingsRequest.LARGEST_STEP);
        double low = properties.number("mutation_size_low");
        double high = properties.number("mutation_size_high");
        if (low > high) {
            String given = properties.has("mutation_size_low") ? "mutation_size_low" : "mutation_size_high";
            context.error(
                    properties.location(given),
                    "'mutation_size_low' is " + low + " but must be at most 'mutation_size_high', which is " + high);
        }
    }

    private void forbidZero(String property, String lessMeans) {
        if (properties.has(property) && properties.integer(property) == 0) {
            context.error(
                    properties.location(property),
                    "'" + property + "' must be -1 for " + lessMeans + " or at least 1 but is 0");
        }
    }

    private void integer(String property, String parameter) {
        if (properties.has(property)) {
            parameters.put(parameter, Integer.toString(properties.integer(property)));
        }
    }

    private void number(String property, String parameter) {
        if (properties.has(property)) {
            parameters.put(parameter, Double.toString(properties.number(property)));
        }
    }

    private void truth(String property, String parameter) {
        if (properties.has(property)) {
            parameters.put(parameter, Boolean.toString(properties.truth(property)));
        }
    }
}
