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
 *       samples in the same pixel. What is gained there by being spread evenly, beside as many independent samples, is gained by more
 *       samples once again;
 *   <li>τ·B/m for m steps per pixel: B = (mean of Σ w)·(mean of Σ w/L²) over the chains' kinds of paths is that of independent points with
 *       the chains' density, and τ steps count as one of these. Steps of the kinds that are left take κ times as long as those of all.
 * </ul>
 *
 * Where a sample costs c steps and samples have the part s of the time, it all comes to c·A/s + κ·τ·B/(1−s), which is least for
 * s = √(c·A)/(√(c·A) + √(κ·τ·B)); chains alone come to τ·B over all kinds. The kinds go to the samples one after another, those first in which samples
 * are better; the best number of them is taken, by the smaller of the gains in relative and in plain squared error. Decision 21 tells where the constants
 * come from. The plan decides what is noise where, never what is right: any division that does not depend on the samples and chains that
 * follow gives the same mean.
 *
 * @param ofSamples kinds of paths that are the samples'; none if chains find all but what is lit directly
 * @param gain foreseen: squared error of chains alone over that of both in the same time
 * @param timeShare part of the time that is for samples, of direct lighting alone if no other kinds are theirs; 0 if it is not known
 * @param stepsPerSample c, of such a sample, in steps of chains with all kinds
 * @param stepCost κ
 */
record SamplePlan(PatternSet ofSamples, double gain, double timeShare, double stepsPerSample, double stepCost) {
    /** Samples have nothing to do with it. */
    static final SamplePlan CHAINS_ALONE = new SamplePlan(PatternSet.NONE, 1, 0, 1, 1);

    /** Below, what is foreseen is not sure enough: it was up to 1.3 where samples made it worse (decision 21). */
    private static final double LEAST_GAIN = 1.35;

    /** What samples find without any noise is not worth more than that. */
    private static final double LARGEST_GAIN = 1000;

    /** Work of a step where no step was tried. */
    private static final double TYPICAL_STEP = 2.5;

    /** What is left to chains may be so rare that none of its steps was tried: so much of those of all kinds counts with them. */
    private static final double STEPS_OF_ALL = 0.002;

    /** More samples never gain more than that by being spread. */
    private static final double LEAST_SPREAD = 0.25;

    /** τ. Measured: 3.2 to 7.5. */
    private static final double STEPS_PER_POINT = 5;

    /** Samples have a kind of paths only if they find so much of it. */
    private static final double LEAST_FOUND = 0.7;

    /** And only if it was found so many times, each with a similar weight: what is rare may have a larger error than is seen. */
    private static final double LEAST_EVIDENCE = 16;

    /** Chains are to find what no sample of the pilot has shown, too, and take their time to begin. */
    private static final double MOST_TIME = 0.8;

    /** Work of a sample of direct lighting alone. */
    private static final double WORK_OF_DIRECT = 2;

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

        /** A of the kind alone. */
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

    /** Sums of what is found twice, with which the variance between them grows path by path. */
    private static final class Halves {
        private final double[] differences;
        private double squares;

        Halves(int number) {
            differences = new double[number];
        }

        void add(int place, double difference) {
            double before = differences[place];
            differences[place] = before + difference;
            squares += difference * (2 * before + difference);
        }

        double variance() {
            return Math.max(0, squares) / 2 / differences.length;
        }
    }

    /** How samples scatter. */
    private static final class Scatter {
        private final Halves blocks;
        private final Halves samples;

        Scatter(int surveys) {
            blocks = new Halves(surveys);
            samples = new Halves(PilotWorker.BLOCK * surveys);
        }

        /** Adds a path of a sample with what it brings to the mean of its block, negative in second halves. */
        void add(int survey, int sample, double difference) {
            blocks.add(survey, difference);
            samples.add(PilotWorker.BLOCK * survey + sample, PilotWorker.BLOCK * difference);
        }

        /** A: the variance of n samples' mean times n, for n larger than that of a block. */
        double perSample() {
            double ofBlocks = PilotWorker.BLOCK * blocks.variance();
            double spread = ofBlocks / Math.max(samples.variance(), ofBlocks);
            return ofBlocks == 0 ? 0 : Math.max(LEAST_SPREAD, spread) * ofBlocks;
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
            Scatter scatter = new Scatter(paths.surveys());
            double[] sums = new double[2 * paths.surveys()];
            for (int path : kind.paths) {
                double weight = paths.weight(path) / paths.surveys();
                if (paths.by(path) == PilotWorker.By.CANDIDATES) {
                    kind.brightness += weight;
                    kind.relative += weight / (scale[path] * scale[path]);
                } else {
                    kind.bySamples += weight / 2;
                    sums[2 * paths.survey(path) + (paths.by(path) == PilotWorker.By.FIRST ? 0 : 1)] += weight;
                    scatter.add(paths.survey(path), paths.sample(path), signed(path) / scale[path]);
                }
            }
            kind.variance = scatter.perSample();
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
            double stepsPerSample = paths.work() / (2.0 * PilotWorker.BLOCK * paths.surveys()) / workPerStep();
            Scatter ofRelative = new Scatter(paths.surveys());
            Scatter ofAbsolute = new Scatter(paths.surveys());
            double restWeight = paths.steps().weight();
            double restWork = paths.steps().work();
            double restBrightness = brightness;
            double restRelative = relative;
            SamplePlan best = new SamplePlan(
                    PatternSet.NONE, 1, timeOfDirect(brightness * relative), WORK_OF_DIRECT / workPerStep(), 1);
            for (int count = 1; count <= kinds.size() && kinds.get(count - 1).isForSamples(); count++) {
                Kind kind = kinds.get(count - 1);
                for (int path : kind.paths) {
                    if (paths.by(path) != PilotWorker.By.CANDIDATES) {
                        ofRelative.add(paths.survey(path), paths.sample(path), signed(path) / scale[path]);
                        ofAbsolute.add(paths.survey(path), paths.sample(path), signed(path));
                    }
                }
                restBrightness = Math.max(0, restBrightness - kind.brightness);
                restRelative = Math.max(0, restRelative - kind.relative);
                restWeight = Math.max(0, restWeight - paths.steps().weight(kind.pattern));
                restWork = Math.max(0, restWork - paths.steps().work(kind.pattern));
                double stepCost = stepCost(restWeight, restWork);
                double relativeOfSamples = stepsPerSample * ofRelative.perSample();
                double share =
                        share(relativeOfSamples, stepCost * restBrightness * restRelative, 1 - MOST_TIME, MOST_TIME);
                double gain = Math.min(
                        gain(brightness * relative, stepCost * restBrightness * restRelative, relativeOfSamples, share),
                        gain(
                                brightness * brightness,
                                stepCost * restBrightness * restBrightness,
                                stepsPerSample * ofAbsolute.perSample(),
                                share));
                if (gain > (best.ofSamples.isEmpty() ? leastGain : best.gain)) {
                    best = new SamplePlan(patterns(count), gain, share, stepsPerSample, stepCost);
                }
            }
            return best;
        }

        /** Work of a step of chains with all kinds. */
        private double workPerStep() {
            double weight = paths.steps().weight();
            return weight == 0 ? TYPICAL_STEP : paths.steps().work() / weight;
        }

        /** κ, from sums over the steps of the kinds that are left. */
        private double stepCost(double restWeight, double restWork) {
            double weight = restWeight + STEPS_OF_ALL * paths.steps().weight();
            double work = restWork + STEPS_OF_ALL * paths.steps().work();
            return weight == 0 ? 1 : work / weight / workPerStep();
        }

        /** Part of the time that direct lighting alone should have. */
        private double timeOfDirect(double ofChains) {
            Scatter scatter = new Scatter(paths.surveys());
            for (int i = 0; i < paths.size(); i++) {
                if (paths.pattern(i) == PilotWorker.SHORT && paths.by(i) != PilotWorker.By.CANDIDATES) {
                    scatter.add(paths.survey(i), paths.sample(i), signed(i) / scale[i]);
                }
            }
            double ofSamples = WORK_OF_DIRECT / workPerStep() * scatter.perSample();
            return share(ofSamples, ofChains, LEAST_TIME_OF_DIRECT, MOST_TIME_OF_DIRECT);
        }

        /** The part of the time for samples with which the error of both is least. */
        private static double share(double ofSamples, double ofChains, double least, double most) {
            double samples = Math.sqrt(ofSamples);
            double chains = Math.sqrt(STEPS_PER_POINT * ofChains);
            double share = samples == 0 ? 0 : samples / (samples + chains);
            return Math.min(most, Math.max(least, share));
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
