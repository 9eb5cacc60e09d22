package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * How the light is divided between bidirectional samples and chains: by kinds of paths, as direct lighting is rendered apart because
 * samples find it better (thesis, section 5.4; Veach 1997, §11.5). Diffuse light may be the samples' and caustics the chains'.
 *
 * <p>A pilot shows what either would make of each kind. With L, the luminance around a path's film position, the squared error of a pixel
 * relative to L² is
 *
 * <ul>
 *   <li>A/n for n samples per pixel: A is the variance of Σ w/L over the samples' kinds of paths, taken from pairs of small blocks of
 *       samples in the same pixel;
 *   <li>τ·B/m for m steps per pixel: B = (mean of Σ w)·(mean of Σ w/L²) over the chains' kinds of paths is that of independent points with
 *       the chains' density, and τ steps count as one of these.
 * </ul>
 *
 * Where a sample costs c steps and samples have the part s of the time, it all comes to c·A/s + τ·B/(1−s), which is least for
 * s = √(c·A)/(√(c·A) + √(τ·B)); chains alone come to τ·B over all kinds. The kinds go to the samples one after another, those first in which samples
 * are better; the best number of them is taken, by the smaller of the gains in relative and in plain squared error. Decision 21 tells where the constants
 * come from. The plan decides what is noise where, never what is right: any division that does not depend on the samples and chains that
 * follow gives the same mean.
 *
 * @param ofSamples kinds of paths that are the samples'; none if chains find all but what is lit directly
 * @param gain foreseen: squared error of chains alone over that of both in the same time
 * @param timeShare part of the time that is for samples, of direct lighting alone if no other kinds are theirs; 0 if it is not known
 * @param stepsPerSample c, of such a sample
 */
record SamplePlan(PatternSet ofSamples, double gain, double timeShare, double stepsPerSample) {
    /** Samples have nothing to do with it. */
    static final SamplePlan CHAINS_ALONE = new SamplePlan(PatternSet.NONE, 1, 0, 1);

    /** Below, what is foreseen is not sure enough: it was 1.45 where samples made it worse (decision 21). */
    private static final double LEAST_GAIN = 1.6;

    /** What samples find without any noise is not worth more than that. */
    private static final double LARGEST_GAIN = 1000;

    /** A sample takes so many steps' time for each of its rays that is not for occlusion. Measured: 0.34 to 0.58. */
    private static final double STEPS_PER_RAY = 0.45;

    /** More samples of a pixel than the pilot's are spread better, and so have less noise. */
    private static final double SPREAD = 0.5;

    /** τ. Measured: 3.2 to 7.5. */
    private static final double STEPS_PER_POINT = 5;

    /** Samples have a kind of paths only if they find so much of it. */
    private static final double LEAST_FOUND = 0.7;

    /** And only if it was found so many times, each with a similar weight: what is rare may have a larger error than is seen. */
    private static final double LEAST_EVIDENCE = 16;

    /** Chains are to find what no sample of the pilot has shown, too, and take their time to begin. */
    private static final double MOST_TIME = 0.8;

    /** Rays of a sample of direct lighting alone that are not for occlusion. */
    private static final double RAYS_OF_DIRECT = 2;

    /** Bounds of the time for direct lighting alone: the pilot may have missed what is small and bright. */
    private static final double LEAST_TIME_OF_DIRECT = 0.04;

    private static final double MOST_TIME_OF_DIRECT = 0.5;

    /** Squared errors are relative to L² + (0.3 of the mean)²: nobody sees the noise of what is black. */
    private static final double FLOOR = 0.3;

    /** Makes a plan; chains alone if nothing else is wanted or pays. */
    static SamplePlan of(PilotGrid grid, PilotPaths paths, Sharing sharing) {
        if (sharing == Sharing.NEVER || paths.surveys() == 0) {
            return CHAINS_ALONE;
        }
        return new Planner(grid, paths).plan(sharing == Sharing.ALWAYS ? 0 : LEAST_GAIN);
    }

    /** What a pilot shows of a kind of paths. */
    private static final class Kind {
        final long pattern;

        /** The paths. */
        final List<Integer> paths = new ArrayList<>();

        /** Mean luminance, by candidates and by samples. */
        double brightness;

        double bySamples;

        /** Mean of luminance over L². */
        double relative;

        /** Variance of the samples' luminance over L. */
        double variance;

        /** (Σ w)²/Σ w² of the halves of surveys: how many of equal weight tell as much. */
        double evidence;

        Kind(long pattern) {
            this.pattern = pattern;
        }

        /** Whether samples find it nearly all, as without light subpaths at the lens they may miss most, and often enough to tell. */
        boolean isForSamples() {
            return bySamples > LEAST_FOUND * brightness && evidence > LEAST_EVIDENCE;
        }

        /** Small where samples are better. */
        double preference() {
            return variance / relative;
        }
    }

    /** Sums of what both halves of each survey bring, with which the variance between them grows path by path. */
    private static final class Halves {
        private final double[] differences;
        private double squares;

        Halves(int surveys) {
            differences = new double[surveys];
        }

        void add(int survey, double difference) {
            double before = differences[survey];
            differences[survey] = before + difference;
            squares += difference * (2 * before + difference);
        }

        double variance() {
            return Math.max(0, squares) / 2 / differences.length;
        }
    }

    /** Finds the plan. */
    private static final class Planner {
        private final PilotPaths paths;

        /** √(L² + floor²) around each path. */
        private final double[] scale;

        /** In the order in which they go to the samples. */
        private final List<Kind> kinds;

        Planner(PilotGrid grid, PilotPaths paths) {
            this.paths = paths;
            scale = scales(grid, paths);
            Map<Long, Kind> all = new HashMap<>();
            for (int i = 0; i < paths.size(); i++) {
                if (paths.pattern(i) != PilotWorker.SHORT) {
                    all.computeIfAbsent(paths.pattern(i), Kind::new).paths.add(i);
                }
            }
            all.values().forEach(this::measure);
            kinds = all.values().stream()
                    .filter(kind -> kind.brightness > 0)
                    .sorted(Comparator.comparing(Kind::isForSamples)
                            .reversed()
                            .thenComparingDouble(Kind::preference)
                            .thenComparingLong(kind -> kind.pattern))
                    .toList();
        }

        private static double[] scales(PilotGrid grid, PilotPaths paths) {
            double[] luminance = new double[grid.cells()];
            int[] cell = new int[paths.size()];
            double mean = 0;
            for (int i = 0; i < cell.length; i++) {
                cell[i] = grid.cell(paths.filmX(i), paths.filmY(i));
                double weight = paths.by(i) == PilotWorker.By.CANDIDATES ? paths.weight(i) / paths.surveys() : 0;
                luminance[cell[i]] += weight * grid.cells();
                mean += weight;
            }
            double floor = FLOOR * mean;
            return Arrays.stream(cell)
                    .mapToDouble(c -> Math.hypot(luminance[c], floor))
                    .toArray();
        }

        private void measure(Kind kind) {
            Halves halves = new Halves(paths.surveys());
            double[] sums = new double[2 * paths.surveys()];
            for (int path : kind.paths) {
                double weight = paths.weight(path) / paths.surveys();
                if (paths.by(path) == PilotWorker.By.CANDIDATES) {
                    kind.brightness += weight;
                    kind.relative += weight / (scale[path] * scale[path]);
                } else {
                    kind.bySamples += weight / 2;
                    sums[2 * paths.survey(path) + (paths.by(path) == PilotWorker.By.FIRST ? 0 : 1)] += weight;
                    halves.add(paths.survey(path), signed(path) / scale[path]);
                }
            }
            kind.variance = halves.variance();
            double sum = Arrays.stream(sums).sum();
            double squares = Arrays.stream(sums).map(x -> x * x).sum();
            kind.evidence = squares == 0 ? 0 : sum * sum / squares;
        }

        private double signed(int path) {
            return paths.by(path) == PilotWorker.By.FIRST ? paths.weight(path) : -paths.weight(path);
        }

        SamplePlan plan(double leastGain) {
            double brightness =
                    kinds.stream().mapToDouble(kind -> kind.brightness).sum();
            double relative = kinds.stream().mapToDouble(kind -> kind.relative).sum();
            double raysPerSample = paths.rays() / (2.0 * PilotWorker.BLOCK * paths.surveys());
            // The variance of one half is that of the mean of a block.
            double stepsPerSample = STEPS_PER_RAY * raysPerSample;
            double cost = SPREAD * PilotWorker.BLOCK * stepsPerSample;
            Halves ofRelative = new Halves(paths.surveys());
            Halves ofAbsolute = new Halves(paths.surveys());
            double restBrightness = brightness;
            double restRelative = relative;
            SamplePlan best = new SamplePlan(
                    PatternSet.NONE, 1, timeOfDirect(brightness * relative), STEPS_PER_RAY * RAYS_OF_DIRECT);
            for (int count = 1; count <= kinds.size() && kinds.get(count - 1).isForSamples(); count++) {
                Kind kind = kinds.get(count - 1);
                for (int path : kind.paths) {
                    if (paths.by(path) != PilotWorker.By.CANDIDATES) {
                        ofRelative.add(paths.survey(path), signed(path) / scale[path]);
                        ofAbsolute.add(paths.survey(path), signed(path));
                    }
                }
                restBrightness = Math.max(0, restBrightness - kind.brightness);
                restRelative = Math.max(0, restRelative - kind.relative);
                double samples = Math.sqrt(cost * ofRelative.variance());
                double chains = Math.sqrt(STEPS_PER_POINT * restBrightness * restRelative);
                double share = samples == 0 && chains == 0 ? 0 : samples / (samples + chains);
                share = Math.min(MOST_TIME, Math.max(1 - MOST_TIME, share));
                double gain = Math.min(
                        gain(brightness * relative, restBrightness * restRelative, cost * ofRelative.variance(), share),
                        gain(
                                brightness * brightness,
                                restBrightness * restBrightness,
                                cost * ofAbsolute.variance(),
                                share));
                if (gain > (best.ofSamples.isEmpty() ? leastGain : best.gain)) {
                    best = new SamplePlan(patterns(count), gain, share, stepsPerSample);
                }
            }
            return best;
        }

        /** Part of the time that direct lighting alone should have. */
        private double timeOfDirect(double ofChains) {
            Halves halves = new Halves(paths.surveys());
            for (int i = 0; i < paths.size(); i++) {
                if (paths.pattern(i) == PilotWorker.SHORT && paths.by(i) != PilotWorker.By.CANDIDATES) {
                    halves.add(paths.survey(i), signed(i) / scale[i]);
                }
            }
            double cost = SPREAD * PilotWorker.BLOCK * STEPS_PER_RAY * RAYS_OF_DIRECT;
            double samples = Math.sqrt(cost * halves.variance());
            double chains = Math.sqrt(STEPS_PER_POINT * ofChains);
            double share = samples == 0 ? 0 : samples / (samples + chains);
            return Math.min(MOST_TIME_OF_DIRECT, Math.max(LEAST_TIME_OF_DIRECT, share));
        }

        /** Error of chains alone over that of both. */
        private static double gain(double alone, double rest, double samples, double share) {
            double both = samples / share + STEPS_PER_POINT * rest / (1 - share);
            return Math.min(LARGEST_GAIN, STEPS_PER_POINT * alone / both);
        }

        private PatternSet patterns(int count) {
            return new PatternSet(kinds.subList(0, count).stream()
                    .mapToLong(kind -> kind.pattern)
                    .toArray());
        }
    }
}
