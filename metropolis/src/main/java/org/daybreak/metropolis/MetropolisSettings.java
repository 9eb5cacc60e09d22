package org.daybreak.metropolis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.metropolis.chains.ChainSettings;
import org.daybreak.metropolis.chains.Sharing;

/**
 * Settings of Metropolis light transport, besides those of all chains.
 *
 * @param chains those of all chains
 * @param bidirectional how candidates for the starts are sampled, and with it which paths count
 * @param weights relative probabilities of the strategies, in the order of {@link #STRATEGIES}; 0 for those switched off
 * @param wholePaths probability with which the bidirectional mutation replaces all of a path
 * @param deleted p_d: relative probabilities of deleting 1, 2, … edges of it
 * @param added p_a: relative probabilities of a piece that is longer or shorter by 0, 1, … edges
 * @param importanceMutations whether deleted pieces are chosen by the density of what can build them
 * @param smallestJump r₁: smallest move of the image point, in pixels
 * @param largestJump r₂: largest move of the image point, as part of the image that a disk of this radius covers
 * @param smallestAngle the same for tilted directions, in pixels that they correspond to
 * @param largestAngle the same for tilted directions, as part of the image
 * @param shortEdges below which part of the way to the lens multi-chain perturbations go on over an edge
 * @param expectedValues whether each step deposits both of its paths
 * @param sharing whether bidirectional samples take a part of the light off the chains
 */
public record MetropolisSettings(
        ChainSettings chains,
        BidirectionalSettings bidirectional,
        List<Double> weights,
        double wholePaths,
        List<Double> deleted,
        List<Double> added,
        boolean importanceMutations,
        double smallestJump,
        double largestJump,
        double smallestAngle,
        double largestAngle,
        double shortEdges,
        boolean expectedValues,
        Sharing sharing) {
    /** Names of the strategies. */
    static final List<String> STRATEGIES =
            List.of("bidirectional", "lensSubpath", "lens", "caustic", "multiChain", "manifold");

    private static final List<String> LABELS = List.of(
            "Bidirectional mutation",
            "Lens subpath mutation",
            "Lens perturbation",
            "Caustic perturbation",
            "Multi-chain perturbation",
            "Manifold perturbation");

    /** Perturbations are cheap and mostly accepted; manifold walks are dear, and apply where others do, too. */
    private static final List<Double> WEIGHTS = List.of(0.5, 0.5, 1.0, 1.0, 1.0, 0.25);

    private static final List<String> DOCS = List.of(
            "replaces a piece of a path by one of any length. Only with it can a chain reach all paths",
            "sends the path through another image point, each pixel in turn",
            "moves the image point a little",
            "tilts a ray that makes a caustic",
            "moves the image point of a caustic that is seen in mirrors or glass",
            "moves a vertex and finds the mirrored or refracted way from it that leads to where the old one did");

    /** The parameters from which the settings are made. */
    static final List<Parameter> PARAMETERS = parameters();

    private static List<Parameter> parameters() {
        List<Parameter> all = new ArrayList<>(ChainSettings.PARAMETERS);
        for (int i = 0; i < STRATEGIES.size(); i++) {
            all.add(Parameter.real(
                    STRATEGIES.get(i),
                    LABELS.get(i),
                    WEIGHTS.get(i),
                    0,
                    1e6,
                    "Mutation strategy that " + DOCS.get(i)
                            + ". Relative probability of choosing it where it applies; 0" + " switches it off."));
        }
        all.add(Parameter.real(
                "wholePaths",
                "Whole paths",
                0.15,
                0.001,
                1,
                "Probability with which the bidirectional mutation replaces the whole path, and not a piece of it: chains leave by"
                        + " it where nothing else leads away from."));
        all.add(Parameter.reals(
                "deletedEdges",
                "Deleted edges",
                "0.25,0.5,0.125",
                0,
                1,
                "Relative probabilities with which the bidirectional mutation deletes pieces of 1, 2, … edges, where a chain of"
                        + " mirrors and glass counts as one; each further number of edges has half the probability of the one"
                        + " before."));
        all.add(Parameter.reals(
                "addedEdges",
                "Added edges",
                "0.5,0.15,0.05",
                0,
                1,
                "Relative probabilities with which the bidirectional mutation adds as many edges as it has deleted, one"
                        + " more or less, two more or less, …; each further difference has half the probability of the one"
                        + " before."));
        all.add(Parameter.flag(
                "importanceMutations",
                "Importance sampled mutations",
                false,
                "Whether the bidirectional mutation prefers to delete pieces that could easily be made anew."));
        all.add(Parameter.real(
                "smallestJump", "Smallest jump", 0.1, 1e-6, 1e6, "Smallest move of the image point, in pixels."));
        all.add(Parameter.real(
                "largestJump",
                "Largest jump",
                0.05,
                1e-12,
                1,
                "Largest move of the image point, as the part of the image that a disk of this radius covers."));
        all.add(Parameter.real(
                "smallestAngle",
                "Smallest angle",
                0.1,
                1e-6,
                1e6,
                "Smallest tilt of a direction, as the move in pixels that it corresponds to."));
        all.add(Parameter.real(
                "largestAngle",
                "Largest angle",
                0.05,
                1e-12,
                1,
                "Largest tilt of a direction, as the part of the image that a disk with the radius of the move it"
                        + " corresponds to covers."));
        all.add(Parameter.real(
                "shortEdges",
                "Short edges",
                0.2,
                0,
                1,
                "Below this part of the way to the lens an edge between two rough surfaces counts as a chain for the"
                        + " multi-chain perturbation: so paths move in the corners of rooms. 0 for no edge."));
        all.add(Parameter.flag(
                "expectedValues",
                "Expected values",
                true,
                "Whether each step deposits both of its paths, with the probabilities of going to them, and not only the one"
                        + " that it goes to. Does not change the mean."));
        all.add(Parameter.choice(
                "sharing",
                "Share with samples",
                "auto",
                Arrays.stream(Sharing.values())
                        .map(sharing -> sharing.name().toLowerCase(Locale.ROOT))
                        .toList(),
                "Whether samples of bidirectional path tracing take off the chains what they find as well, with direct lighting"
                        + " apart: auto (if a short pilot says that it pays, as in plainly lit rooms), always, or"
                        + " never. Then directSamples is their number. Does not change the mean."));
        all.addAll(BidirectionalSettings.SINGLE_SAMPLE_PARAMETERS);
        return List.copyOf(all);
    }

    /**
     * Checks what the ranges of the single values do not say.
     *
     * @throws ParameterException if all strategies are switched off, or a table has nothing but zeros
     */
    public MetropolisSettings {
        weights = List.copyOf(weights);
        deleted = List.copyOf(deleted);
        added = List.copyOf(added);
        if (weights.stream().allMatch(w -> w == 0)) {
            throw new ParameterException("all mutation strategies are switched off: one of "
                    + String.join(", ", STRATEGIES) + " must be above 0");
        }
        requirePositive("deletedEdges", deleted);
        requirePositive("addedEdges", added);
    }

    private static void requirePositive(String name, List<Double> table) {
        if (table.stream().anyMatch(p -> p == 0)) {
            throw new ParameterException("parameter '" + name + "' has a 0, which would keep paths from being reached");
        }
    }

    /** Settings from parameter values. */
    static MetropolisSettings of(ParameterValues values) {
        return new MetropolisSettings(
                ChainSettings.of(values),
                BidirectionalSettings.ofSingleSamples(values),
                STRATEGIES.stream().map(values::real).toList(),
                values.real("wholePaths"),
                list(values.reals("deletedEdges")),
                list(values.reals("addedEdges")),
                values.flag("importanceMutations"),
                values.real("smallestJump"),
                values.real("largestJump"),
                values.real("smallestAngle"),
                values.real("largestAngle"),
                values.real("shortEdges"),
                values.flag("expectedValues"),
                Sharing.valueOf(values.choice("sharing").toUpperCase(Locale.ROOT)));
    }

    private static List<Double> list(double[] numbers) {
        List<Double> list = new ArrayList<>();
        for (double number : numbers) {
            list.add(number);
        }
        return list;
    }

    /** True if chains can reach all paths. */
    boolean isErgodic() {
        return weights.get(0) > 0;
    }
}
