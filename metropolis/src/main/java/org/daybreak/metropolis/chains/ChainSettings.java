package org.daybreak.metropolis.chains;

import java.util.List;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;

/**
 * Settings that all renderers by Markov chains have in common.
 *
 * @param seedPaths number of chains
 * @param mutationsPerPixel steps of all chains together per pixel of the whole film
 * @param separateDirect whether paths of at most two edges are rendered apart, by ordinary sampling
 * @param directSamples samples per pixel of that part; 0 to go by the number of steps
 * @param twoStage whether a first, short run makes a rough image by which the second spreads its steps more evenly
 * @param reduction edge in pixels of the cells of the rough image
 * @param bootstrapSamples number of candidates for the starts of the chains; 0 to go by the number of steps
 */
public record ChainSettings(
        int seedPaths,
        int mutationsPerPixel,
        boolean separateDirect,
        int directSamples,
        boolean twoStage,
        int reduction,
        int bootstrapSamples) {
    /** Name of the parameter that stands for the samples per pixel of other renderers. */
    public static final String MUTATIONS_PER_PIXEL = "mutationsPerPixel";

    /** Samples per pixel of direct lighting for each mutation per pixel, if nothing else says how many. */
    static final double SAMPLES_PER_MUTATION = 0.16;

    private static final int LEAST_CANDIDATES = 100_000;
    private static final int MOST_CANDIDATES = 20_000_000;
    private static final int STEPS_PER_CANDIDATE = 8;

    /** The parameters from which the settings are made. */
    public static final List<Parameter> PARAMETERS = List.of(
            Parameter.integer(
                    "seedPaths",
                    "Count of seed paths",
                    1000,
                    1,
                    1 << 20,
                    "Number of Markov chains. Many short ones scatter over all that the start has found; few long ones"
                            + " depend less on it. Does not change the mean."),
            Parameter.integer(
                    MUTATIONS_PER_PIXEL,
                    "Count of mutations per pixel",
                    100,
                    1,
                    Integer.MAX_VALUE,
                    "Steps of all chains together, per pixel of the whole film: dark pixels get fewer, bright ones more."
                            + " Takes the place of the samples per pixel of other renderers: where it is not given, samples"
                            + " per pixel that the command line or the scene asks for set it. A render that ends by time or"
                            + " error alone reports it instead."),
            Parameter.flag(
                    "separateDirect",
                    "Direct lighting apart",
                    true,
                    "Whether emitters seen directly and light that is scattered once are rendered by ordinary sampling,"
                            + " which does it better than chains. Does not change the mean."),
            Parameter.integer(
                    "directSamples",
                    "Samples per pixel of direct lighting",
                    0,
                    0,
                    Integer.MAX_VALUE,
                    "Samples per pixel of the direct lighting that is rendered apart; 0 for as many as a pilot says, or if"
                            + " there is none 16 for each 100 mutations per pixel. With a time limit, direct lighting gets"
                            + " the share of the time that the pilot says, or that these samples have among samples and"
                            + " mutations."),
            Parameter.flag(
                    "twoStage",
                    "Two-stage rendering",
                    false,
                    "Whether a short first run makes a rough image, by which the chains are then spread more evenly over"
                            + " dark and bright parts of the image. Does not change the mean."),
            Parameter.integer(
                    "reduction",
                    "Reduction of the first stage",
                    8,
                    1,
                    1 << 16,
                    "Edge in pixels of the square cells of the rough image."),
            Parameter.integer(
                    "bootstrapSamples",
                    "Samples for the start",
                    0,
                    0,
                    100_000_000,
                    "Number of bidirectional samples from which the brightness of the image is estimated, and from which"
                            + " the starts of the chains are drawn; 0 for an eighth of the mutations, at least 100000, or a"
                            + " quarter of that if they tell the brightness to 1 %. Each takes 8 bytes of memory. With a time"
                            + " limit they end after a fifth of the time, or a twentieth if the brightness is known to 1 % by"
                            + " then. Does not change the mean."));

    /** Settings from parameter values. */
    public static ChainSettings of(ParameterValues values) {
        return new ChainSettings(
                values.integer("seedPaths"),
                values.integer(MUTATIONS_PER_PIXEL),
                values.flag("separateDirect"),
                values.integer("directSamples"),
                values.flag("twoStage"),
                values.integer("reduction"),
                values.integer("bootstrapSamples"));
    }

    /** Steps of all chains together on a film with a number of pixels. */
    long steps(long pixels) {
        return Math.multiplyExact(pixels, mutationsPerPixel);
    }

    /**
     * Number of candidates for a number of steps of all chains together. The brightness is a factor on the whole image, so the more the chains
     * do the better it must be known. A candidate takes the time of some five steps.
     */
    int candidates(long steps) {
        if (bootstrapSamples > 0) {
            return bootstrapSamples;
        }
        return (int) Math.min(MOST_CANDIDATES, Math.max(LEAST_CANDIDATES, steps / STEPS_PER_CANDIDATE));
    }

    /** Number of candidates that are enough, of a larger number, if they tell the brightness well. */
    int enoughCandidates(int candidates) {
        return bootstrapSamples > 0 ? candidates : Math.max(Math.min(candidates, LEAST_CANDIDATES), candidates / 4);
    }

    /** What part of all work the direct light is if no plan says, counted in samples and mutations. */
    double directShare() {
        double samples = directSamples > 0 ? directSamples : SAMPLES_PER_MUTATION * mutationsPerPixel;
        return samples / (samples + mutationsPerPixel);
    }
}
