package org.daybreak.metropolis.chains;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.film.FilmSettings;

/** What the chains that make the image have shown so far: what their moves came to, and whether the chains agree. */
final class ChainTally {
    private final ChainAlgorithm algorithm;
    private final ChainStatistics statistics;
    private final ChainConvergence convergence;

    /** Creates an empty tally. */
    ChainTally(ChainAlgorithm algorithm, FilmSettings film, ChainLanes lanes) {
        this.algorithm = algorithm;
        statistics = new ChainStatistics(algorithm.moves().size());
        convergence = new ChainConvergence(film, lanes.first(), lanes.end());
    }

    /** Adds a chain in a round. */
    void add(ChainRounds.Unit unit) {
        statistics.add(unit.statistics);
        convergence.add(unit.chain, unit.splats, unit.steps);
    }

    /** NaN if chains are not comparable. */
    private double rHat() {
        return algorithm.hasOneTarget() ? convergence.rHat() : Double.NaN;
    }

    /** Figures for the report. */
    Map<String, Double> figures() {
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("longestRejection", (double) statistics.longestRejection);
        figures.put("rHat", rHat());
        figures.put("regionError", convergence.regionError());
        figures.putAll(ChainReports.moveFigures(algorithm.moves(), statistics));
        return figures;
    }

    /**
     * What the user should know.
     *
     * @param brightness that the image has with these chains
     * @param stepsOfChain steps that a chain has taken on average
     */
    List<String> warnings(Brightness brightness, double stepsOfChain) {
        return ChainReports.warnings(
                brightness.mean(),
                brightness.standardError(),
                rHat(),
                convergence.regionError(),
                statistics.longestRejection,
                stepsOfChain);
    }

    /** Writes all of it. */
    void save(StateWriter out) {
        statistics.save(out);
        convergence.save(out);
    }

    /** Reads what {@link #save} has written. */
    void load(StateReader in) {
        statistics.load(in);
        convergence.load(in);
    }
}
