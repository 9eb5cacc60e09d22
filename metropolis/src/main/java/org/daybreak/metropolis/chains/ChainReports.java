package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Figures and warnings of a render by chains. */
final class ChainReports {
    /** Chains that are shorter say nothing about being stuck. */
    private static final double LEAST_STEPS = 1000;

    private static final double LONG_REJECTION = 1.0 / 3;
    private static final double LARGE_ERROR = 0.1;

    private ChainReports() {}

    /** What the moves of chains came to, by names like {@code move.lensPerturbation.accepted}. */
    static Map<String, Double> moveFigures(List<String> moves, ChainStatistics statistics) {
        Map<String, Double> figures = new LinkedHashMap<>();
        for (int i = 0; i < moves.size(); i++) {
            String prefix = "move." + moves.get(i) + ".";
            figures.put(prefix + "tried", (double) statistics.tried(i));
            for (Outcome outcome : Outcome.values()) {
                figures.put(prefix + camelCase(outcome.name()), (double) statistics.outcomes(i, outcome));
            }
            figures.put(prefix + "accepted", (double) statistics.accepted(i));
            figures.put(prefix + "acceptance", statistics.meanAcceptance(i));
            figures.put(prefix + "distance", statistics.meanDistance(i));
        }
        return figures;
    }

    private static String camelCase(String constant) {
        StringBuilder text = new StringBuilder();
        for (String word : constant.toLowerCase(Locale.ROOT).split("_", -1)) {
            text.append(text.isEmpty() ? word : word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1));
        }
        return text.toString();
    }

    /**
     * What the user should know of the chains.
     *
     * @param rHat see {@link ChainConvergence#rHat}
     * @param regionError see {@link ChainConvergence#regionError}
     * @param stepsOfChain steps that a chain has taken on average
     */
    static List<String> warnings(
            double b,
            double standardError,
            double rHat,
            double regionError,
            long longestRejection,
            double stepsOfChain) {
        List<String> warnings = new ArrayList<>();
        if (standardError > LARGE_ERROR * b) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "the brightness of the image is known to %.0f %% only: raise bootstrapSamples",
                    100 * standardError / b));
        }
        if (rHat > ChainConvergence.LIMIT && regionError > ChainConvergence.ERROR_LIMIT) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "the chains differ from each other more than they should (R-hat %.3g): even where it looks smooth"
                            + " the image has not converged, the brightness of a part of it is known to %.0f %% only; raise"
                            + " mutationsPerPixel",
                    rHat,
                    100 * regionError));
        }
        if (stepsOfChain >= LEAST_STEPS && longestRejection > LONG_REJECTION * stepsOfChain) {
            warnings.add(String.format(
                    Locale.ROOT,
                    "a chain was stuck for %d of about %.0f steps: there may be bright dots in the image",
                    longestRejection,
                    stepsOfChain));
        }
        return warnings;
    }
}
