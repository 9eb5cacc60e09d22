package org.daybreak.metropolis.chains;

import java.util.Arrays;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.SplatBuffer;

/**
 * Tells whether each chain has explored the image by itself, or all of them together only look as if: compares the scatter of the
 * chains' means with what the scatter along the chains makes expect.
 *
 * <p>Of each chain the mean luminance in each of {@value #GRID}×{@value #GRID} regions of the film is kept, and its scatter between
 * the chain's rounds. Let N be the steps of a chain, U its rounds. V̂ = Σ N·(mean of the chain − mean of all)²/(C − 1) estimates
 * the variance of a step, its correlation with later ones included, from the scatter between C chains; Ŵ = Σ n·(mean of a round of n
 * steps − mean of the chain)²/(U − 1) the same from within the chains. They agree if chains forget where they were within a
 * round; of chains that stay where they started V̂ is larger by orders of magnitude. R̂² = (U − 1)/U + V̂/(Ŵ·U) is the potential
 * scale reduction of Gelman and Rubin (Statistical Science 7(4), 1992) with rounds in the place of steps, which are too noisy to
 * tell anything. The largest R̂ of all regions with at least 1 % of the light counts.
 *
 * <p>Many chains may cover an image well that none of them has explored. Whether they do is told by the standard error that the
 * scatter of their means leaves in the brightness of a region, √(Σ(S − m·N)²·C/(C − 1))/Σ S with sums S of the chains and the mean m of
 * all: the largest one, again of regions with at least 1 % of the light.
 */
final class ChainConvergence {
    /** Above this, chains have not explored the image. */
    static final double LIMIT = 1.1;

    /** Above this, the brightness of a region is not known. */
    static final double ERROR_LIMIT = 0.05;

    private static final int GRID = 4;
    private static final int REGIONS = GRID * GRID;
    private static final double LEAST_SHARE = 0.01;
    private static final int LEAST_CHAINS = 4;
    private static final int LEAST_ROUNDS = 4;

    /** More chains tell no more. */
    private static final int MOST_CHAINS = 4096;

    private final int width;
    private final int height;
    private final int first;
    private final int chains;
    private final double[] sums;
    private final double[] squares;
    private final long[] steps;
    private final long[] rounds;
    private final double[] unit = new double[REGIONS];

    /**
     * Creates an empty test.
     *
     * @param first number of the first chain
     * @param end number after the last one
     */
    ChainConvergence(FilmSettings film, int first, int end) {
        width = film.width();
        height = film.height();
        this.first = first;
        chains = Math.min(MOST_CHAINS, end - first);
        sums = new double[chains * REGIONS];
        squares = new double[chains * REGIONS];
        steps = new long[chains];
        rounds = new long[chains];
    }

    /** Adds a round of a chain. */
    void add(int number, SplatBuffer splats, long taken) {
        int chain = number - first;
        if (chain >= chains || taken == 0) {
            return;
        }
        Arrays.fill(unit, 0);
        for (int i = 0; i < splats.size(); i++) {
            int x = region(splats.filmX(i), width);
            int y = region(splats.filmY(i), height);
            unit[y * GRID + x] += splats.luminance(i);
        }
        for (int r = 0; r < REGIONS; r++) {
            sums[chain * REGIONS + r] += unit[r];
            squares[chain * REGIONS + r] += unit[r] * unit[r] / taken;
        }
        steps[chain] += taken;
        rounds[chain]++;
    }

    private static int region(double position, int size) {
        return Math.min(GRID - 1, Math.max(0, (int) (position * GRID / size)));
    }

    /** R̂; NaN if there are fewer than {@value #LEAST_CHAINS} chains or {@value #LEAST_ROUNDS} rounds of each. */
    double rHat() {
        if (chains < LEAST_CHAINS || rounds[chains - 1] < LEAST_ROUNDS) {
            return Double.NaN;
        }
        return largest(this::rHat);
    }

    /** Relative standard error of the brightness of a region; NaN if there are fewer than two chains. */
    double regionError() {
        return chains < 2 || steps[chains - 1] == 0 ? Double.NaN : largest(this::error);
    }

    /** A figure of a region, from its number and the sum of its light. */
    private interface Figure {
        double of(int region, double light);
    }

    private double largest(Figure figure) {
        double[] light = new double[REGIONS];
        double total = 0;
        for (int i = 0; i < sums.length; i++) {
            light[i % REGIONS] += sums[i];
            total += sums[i];
        }
        double largest = Double.NaN;
        for (int r = 0; r < REGIONS; r++) {
            if (light[r] > 0 && light[r] >= LEAST_SHARE * total) {
                double value = figure.of(r, light[r]);
                largest = Double.isNaN(largest) ? value : Math.max(largest, value);
            }
        }
        return largest;
    }

    private double rHat(int region, double light) {
        double allSteps = 0;
        double allRounds = 0;
        for (int c = 0; c < chains; c++) {
            allSteps += steps[c];
            allRounds += rounds[c];
        }
        double mean = light / allSteps;
        double between = 0;
        double within = 0;
        for (int c = 0; c < chains; c++) {
            double sum = sums[c * REGIONS + region];
            double difference = sum / steps[c] - mean;
            between += steps[c] * difference * difference;
            // Rounding may leave a little less than nothing of a chain that brings the same in each step.
            within += squares[c * REGIONS + region] - sum * sum / steps[c];
        }
        if (!(within > 0)) {
            return between > 0 ? Double.POSITIVE_INFINITY : 1;
        }
        between /= chains - 1;
        within /= allRounds - chains;
        double perChain = allRounds / chains;
        return Math.sqrt((perChain - 1) / perChain + between / (within * perChain));
    }

    private double error(int region, double light) {
        long allSteps = 0;
        for (int c = 0; c < chains; c++) {
            allSteps += steps[c];
        }
        double squared = 0;
        for (int c = 0; c < chains; c++) {
            double difference = sums[c * REGIONS + region] - light * steps[c] / allSteps;
            squared += difference * difference;
        }
        return Math.sqrt(squared * chains / (chains - 1)) / light;
    }

    /** Writes all sums. */
    void save(StateWriter out) {
        for (int c = 0; c < chains; c++) {
            out.put(steps[c]);
            out.put(rounds[c]);
        }
        for (int i = 0; i < sums.length; i++) {
            out.put(sums[i]);
            out.put(squares[i]);
        }
    }

    /** Reads what {@link #save} has written. */
    void load(StateReader in) {
        for (int c = 0; c < chains; c++) {
            steps[c] = in.next();
            rounds[c] = in.next();
        }
        for (int i = 0; i < sums.length; i++) {
            sums[i] = in.nextDouble();
            squares[i] = in.nextDouble();
        }
    }
}
