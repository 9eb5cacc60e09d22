package org.daybreak.metropolis.primary;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;

/**
 * Settings of chains over random numbers.
 *
 * @param paths which paths there are, and how they are weighted
 * @param largeStep probability of a proposal that does not depend on the state
 * @param step law of the other proposals
 * @param expectedValues whether both the state and the proposal get their share in each step, rather than what the step ends at
 */
record PrimarySettings(BidirectionalSettings paths, double largeStep, SmallStep step, boolean expectedValues) {
    static final String SMALLEST_STEP = "smallestStep";
    static final String LARGEST_STEP = "largestStep";

    private static final String LARGE_STEP = "largeStep";
    private static final String EXPECTED_VALUES = "expectedValues";

    /** The parameters from which the settings are made. */
    static final List<Parameter> PARAMETERS = parameters();

    private static List<Parameter> parameters() {
        List<Parameter> all = new ArrayList<>(BidirectionalSettings.SINGLE_SAMPLE_PARAMETERS);
        all.add(Parameter.real(
                LARGE_STEP,
                "Probability of large steps",
                0.3,
                0,
                1,
                "Part of the mutations that propose a path independent of the one before, by which chains find what is"
                        + " far from where they are. With 0 each chain stays near its start and the mean holds over many"
                        + " chains only."));
        all.add(Parameter.real(
                SMALLEST_STEP,
                "Smallest change of a small step",
                1.0 / 1024,
                1e-9,
                0.5,
                "Small steps change each random number, between 0 and 1, by at least this. Does not change the mean."));
        all.add(Parameter.real(
                LARGEST_STEP,
                "Largest change of a small step",
                1.0 / 64,
                1e-9,
                0.5,
                "Small steps change each random number, between 0 and 1, by at most this; sizes of changes are spread evenly"
                        + " on a logarithmic scale. Does not change the mean."));
        all.add(Parameter.flag(
                EXPECTED_VALUES,
                "Expected values",
                true,
                "Whether each mutation adds to the image at the old and at the proposed path, in proportion to the"
                        + " probability of either, rather than at the one that is drawn. Less noise; does not change the"
                        + " mean."));
        return List.copyOf(all);
    }

    /**
     * Settings from parameter values.
     *
     * @throws ParameterException if they contradict each other
     */
    static PrimarySettings of(ParameterValues values) {
        return new PrimarySettings(
                BidirectionalSettings.ofSingleSamples(values),
                values.real(LARGE_STEP),
                new SmallStep(values.real(SMALLEST_STEP), values.real(LARGEST_STEP)),
                values.flag(EXPECTED_VALUES));
    }

    /** What the user should know before it starts. */
    List<String> warnings() {
        return largeStep > 0
                ? List.of()
                : List.of(
                        "without large steps (largeStep = 0) no chain can reach all of the image from where it starts");
    }
}
