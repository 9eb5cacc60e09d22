package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.Plugins.NO_EFFECT;
import static org.daybreak.scenes.build.Plugins.join;
import static org.daybreak.scenes.build.Plugins.plugin;
import static org.daybreak.scenes.build.PropertyDefinition.optional;
import static org.daybreak.scenes.build.PropertyDefinition.value;

import java.util.List;
import org.daybreak.scenes.description.ObjectKind;

/** The types of integrators. {@link IntegratorReader} says what they ask of the renderer. */
final class IntegratorPlugins {
    private static final List<PropertyDefinition> COMMON = List.of(
            value("hide_emitters", ValueType.BOOLEAN, "false", "Has no effect: lights are always visible."),
            optional("samples_per_pass", ValueType.INTEGER, NO_EFFECT),
            optional("block_size", ValueType.INTEGER, NO_EFFECT));

    private static final List<PropertyDefinition> DEPTHS = List.of(
            value(
                            "max_depth",
                            ValueType.INTEGER,
                            "-1",
                            "Longest path in edges: 1 shows lights only, 2 direct light; -1 is unlimited.")
                    .between(-1, Integer.MAX_VALUE),
            value("rr_depth", ValueType.INTEGER, "5", "Length from which Russian roulette may end a path.")
                    .between(1, Integer.MAX_VALUE));

    /** What Mitsuba 0.6's Markov chains have in common. */
    private static final List<PropertyDefinition> CHAINS = List.of(
            value(
                            "direct_samples",
                            ValueType.INTEGER,
                            "16",
                            "Samples per pixel of direct light, which is rendered apart; -1 leaves it to the chains.")
                    .between(-1, Integer.MAX_VALUE),
            optional(
                            "luminance_samples",
                            ValueType.INTEGER,
                            "Samples for the start of the chains; default the renderer's.")
                    .between(1, 100_000_000),
            value("two_stage", ValueType.BOOLEAN, "false", "Whether a rough image comes first and guides the chains."),
            optional(
                            "first_stage_size_reduction",
                            ValueType.INTEGER,
                            "Edge in pixels of the cells of the rough image; default the renderer's.")
                    .between(1, 1 << 16));

    private IntegratorPlugins() {}

    /** Adds them to the table. */
    static void addTo(List<PluginDefinition> list) {
        list.add(integrator("path", "Path tracer: renderer 'path'.", join(DEPTHS)));
        list.add(integrator(
                "direct",
                "Direct light: renderer 'path' with paths of at most 2 edges.",
                optional("shading_samples", ValueType.INTEGER, NO_EFFECT),
                optional("emitter_samples", ValueType.INTEGER, NO_EFFECT),
                optional("bsdf_samples", ValueType.INTEGER, NO_EFFECT)));
        list.add(integrator(
                "ptracer",
                "Particle tracer: renderer 'light'. It cannot show what only specular paths reach.",
                join(DEPTHS)));
        list.add(integrator(
                "bdpt",
                "Bidirectional path tracer: renderer 'bidirectional'.",
                join(
                        DEPTHS,
                        value(
                                "light_image",
                                ValueType.BOOLEAN,
                                "true",
                                "Whether light paths are joined to the lens."))));
        list.add(integrator(
                "mlt",
                "Metropolis light transport: renderer 'metropolis', the sampler's count as its mutations per pixel.",
                join(
                        DEPTHS,
                        join(
                                CHAINS,
                                strategy("bidirectional_mutation", "true", "replaces pieces of paths."),
                                strategy("lens_subpath_mutation", "false", "sends paths through other image points."),
                                strategy("lens_perturbation", "true", "moves the image point a little."),
                                strategy("caustic_perturbation", "true", "tilts rays that make a caustic."),
                                strategy(
                                        "multi_chain_perturbation", "true", "moves caustics seen in mirrors or glass."),
                                strategy("manifold_perturbation", "false", "moves a vertex between mirrors or glass."),
                                optional("lambda", ValueType.FLOAT, NO_EFFECT)))));
        list.add(integrator(
                "pssmlt",
                "Metropolis light transport over random numbers: renderer 'pssmlt', the sampler's count as its mutations"
                        + " per pixel.",
                join(
                        DEPTHS,
                        join(
                                CHAINS,
                                value("p_large", ValueType.FLOAT, "0.3", "Probability of a new sample.")
                                        .between(0, 1),
                                value(
                                                "mutation_size_low",
                                                ValueType.FLOAT,
                                                "0.0009765625",
                                                "Smallest change of a random number.")
                                        .between(1e-9, 0.5),
                                value(
                                                "mutation_size_high",
                                                ValueType.FLOAT,
                                                "0.015625",
                                                "Largest change of a random number.")
                                        .between(1e-9, 0.5)))));
    }

    private static PropertyDefinition strategy(String name, String given, String doc) {
        return value(name, ValueType.BOOLEAN, given, "Whether there is the strategy that " + doc);
    }

    private static PluginDefinition integrator(String type, String doc, PropertyDefinition... own) {
        return plugin(ObjectKind.INTEGRATOR, type, doc, join(COMMON, own));
    }
}
