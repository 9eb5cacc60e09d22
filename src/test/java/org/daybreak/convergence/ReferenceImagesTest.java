package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Grids;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.exr.ImageFileException;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Path tracing and bidirectional path tracing against images that other programs rendered, block by block of 10×10 reference pixels and as a whole.
 *
 * <p><b>Test.</b> Independent runs give the mean of each block and its variance. The difference to the reference is divided
 * by the root of both variances and compared with Student's distribution; its degrees of freedom are those of the runs by
 * Welch's formula, the variance of the reference, which is smoothed over many pixels, counting as known. All blocks and
 * channels together have a false-alarm rate of 1e-4 per scene by Šidák's correction, which for the dependent channels is on
 * the safe side; the means of the image have another 1e-4.
 *
 * <p><b>Heavy tails.</b> Rare bright paths make a block's mean over some tens of runs far from normal: most often they are
 * missed or few, and mean and variance are both too small. Three things are done about that. The variance of a block is taken
 * no smaller than the mean of that of the 3×3 blocks around it, which have likely met such a path. A block is left out if a
 * single run holds more than two thirds of its sum of squares, of which the sign of the difference to the reference plays no
 * part. And where the mean is below the reference, in all scenes but the Cornell box, whose small lamp a diffuse surface meets
 * by mirror and glass with a probability of a per cent, four times the square of the largest jump that one run makes anywhere in
 * the mean of a block is added to the variance: with less than eleven such paths missing, which happens with probability
 * 2e-5 or more, there is no alarm. So there the blocks test sharply whether light is too much, and light that is missing is found by the
 * means of the image.
 *
 * <p>The number of blocks left out, these and those with a standard error of the reference over 10 %, is bounded.
 *
 * <p>In the ordinary build films are a fifth as wide and high: as both use the box filter and the same field of view, a
 * pixel is then the mean of 5×5 pixels of the reference. Variant {@code reference} renders at full size.
 */
class ReferenceImagesTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int RUNS = 32;
    private static final double LARGEST_REFERENCE_ERROR = 0.1;
    private static final double LARGEST_SHARE = 2.0 / 3;
    private static final double UNSEEN_PATHS = 4;

    /** Edge in pixels of the tiles where both images are ours. */
    private static final int TILE = 6;

    /**
     * What is compared, and how well it must agree.
     *
     * @param scene its name
     * @param block edge of a block in reference pixels
     * @param samplesPerPixel samples per pixel and run
     * @param rare whether there are paths so rare that a block may miss them all
     * @param uncertain largest part of the blocks that may be left out as the reference is too noisy there
     * @param outliers largest part of the blocks that may be left out as single runs rule there
     * @param detectable relative error of the brightness of the image that must be found
     */
    private record Row(
            String scene,
            int block,
            int samplesPerPixel,
            boolean rare,
            double uncertain,
            double outliers,
            double detectable) {
        /** The row in the last columns of a table. */
        static Row of(ArgumentsAccessor columns) {
            int first = columns.size() - 7;
            return new Row(
                    columns.getString(first),
                    columns.getInteger(first + 1),
                    columns.getInteger(first + 2),
                    columns.getBoolean(first + 3),
                    columns.getDouble(first + 4),
                    columns.getDouble(first + 5),
                    columns.getDouble(first + 6));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "cornell_spheres, 20, 16, false, 0.01, 0.05, 0.02",
        "gold_ring, 20, 64, true, 0.01, 0.25, 0.05",
        "veach_room, 25, 12, true, 0.03, 0.2, 0.05",
        "door_ajar, 25, 12, true, 0.35, 0.1, 0.05",
    })
    void pathTracingAgreesAtSmallSize(ArgumentsAccessor row) throws SceneException, ImageFileException {
        check("path", Map.of(), Row.of(row), 5);
    }

    /**
     * The same for bidirectional path tracing. Rare are the caustics of the ring, as few light paths start at the lamp that makes
     * them, and with equal weights the paths that a poor technique finds. The room with larger exponents is missing: a fifth of a per cent
     * of its light comes through glass twice (S D S) into single pixels of the egg, 0.16 % into one of them, and these runs find
     * none of it, while the noise of all else is less than that.
     */
    @ParameterizedTest
    @CsvSource({
        "2, cornell_spheres, 20, 4, false, 0.01, 0.05, 0.02",
        "2, gold_ring, 20, 48, true, 0.01, 0.1, 0.05",
        "2, door_ajar, 25, 4, false, 0.35, 0.1, 0.05",
        "1, cornell_spheres, 20, 4, false, 0.01, 0.05, 0.02",
        "0, veach_room, 25, 4, true, 0.03, 0.2, 0.1",
    })
    void bidirectionalPathTracingAgreesAtSmallSize(String exponent, ArgumentsAccessor row)
            throws SceneException, ImageFileException {
        check("bidirectional", Map.of("heuristicExponent", exponent), Row.of(row), 5);
    }

    /** As above, at full size. */
    @Tag("reference")
    @ParameterizedTest
    @CsvSource({
        "2, cornell_spheres, 10, 4, false, 0.01, 0.05, 0.01",
        "2, gold_ring, 20, 16, true, 0.05, 0.1, 0.05",
        "2, door_ajar, 10, 4, false, 0.35, 0.1, 0.03",
        "0, cornell_spheres, 10, 4, false, 0.01, 0.05, 0.02",
    })
    void bidirectionalPathTracingAgrees(String exponent, ArgumentsAccessor row)
            throws SceneException, ImageFileException {
        check("bidirectional", Map.of("heuristicExponent", exponent), Row.of(row), 1);
    }

    /** As above, at full size. */
    @Tag("reference")
    @ParameterizedTest
    @CsvSource({
        "cornell_spheres, 10, 32, false, 0.01, 0.05, 0.005",
        "gold_ring, 20, 64, true, 0.05, 0.25, 0.02",
        "veach_room, 10, 16, true, 0.35, 0.2, 0.02",
        "door_ajar, 10, 16, true, 0.35, 0.2, 0.02",
    })
    void pathTracingAgrees(ArgumentsAccessor row) throws SceneException, ImageFileException {
        check("path", Map.of(), Row.of(row), 1);
    }

    /** Path tracing against bidirectional path tracing, whose tile means take the place of the reference: each is a block. */
    @ParameterizedTest
    @CsvSource({
        "1, 10, 4, cornell_spheres, 1, 16, false, 0.2, 0.05, 0.03",
        "2, 10, 4, gold_ring, 1, 64, true, 0.2, 0.25, 0.1",
        "0, 10, 4, veach_room, 1, 16, true, 0.2, 0.2, 0.1",
        "1, 10, 8, door_ajar, 1, 16, true, 0.2, 0.2, 0.1",
    })
    void pathTracingAgreesWithBidirectional(
            String exponent, int shrink, int bidirectionalSamples, ArgumentsAccessor row)
            throws SceneException, ImageFileException {
        checkWithBidirectional(exponent, shrink, bidirectionalSamples, Row.of(row));
    }

    /** As above, with more samples, and with all exponents where equal weights leave a reference that is good enough. */
    @Tag("reference")
    @ParameterizedTest
    @CsvSource({
        "0, 5, 8, cornell_spheres, 1, 32, false, 0.2, 0.05, 0.02",
        "1, 5, 8, cornell_spheres, 1, 32, false, 0.2, 0.05, 0.02",
        "2, 5, 8, cornell_spheres, 1, 32, false, 0.2, 0.05, 0.02",
        "1, 5, 8, gold_ring, 1, 64, true, 0.2, 0.25, 0.1",
        "2, 5, 8, gold_ring, 1, 64, true, 0.2, 0.25, 0.1",
        "1, 5, 8, veach_room, 1, 32, true, 0.2, 0.2, 0.1",
        "2, 5, 8, veach_room, 1, 32, true, 0.2, 0.2, 0.1",
        "1, 5, 8, door_ajar, 1, 32, true, 0.2, 0.2, 0.1",
        "2, 5, 8, door_ajar, 1, 32, true, 0.2, 0.2, 0.1",
    })
    void pathTracingAgreesCloselyWithBidirectional(
            String exponent, int shrink, int bidirectionalSamples, ArgumentsAccessor row)
            throws SceneException, ImageFileException {
        checkWithBidirectional(exponent, shrink, bidirectionalSamples, Row.of(row));
    }

    /**
     * The same with equal weights, which let poor techniques scatter so much that most tiles are too noisy for a reference: that is
     * path tracing here, with so many samples, and bidirectional path tracing is what is tested.
     */
    @Tag("reference")
    @ParameterizedTest
    @CsvSource({
        "256, 5, gold_ring, 1, 64, true, 0.2, 0.25, 0.1",
        "128, 5, veach_room, 1, 32, true, 0.2, 0.2, 0.1",
        "128, 5, door_ajar, 1, 32, true, 0.2, 0.2, 0.1",
    })
    void equalWeightsAgreeCloselyWithPathTracing(int pathSamples, int shrink, ArgumentsAccessor columns)
            throws SceneException, ImageFileException {
        Row row = Row.of(columns);
        Scene scene = smallScene(row, shrink);
        Map<String, String> parameters = parameters(row);
        Runs path = Runs.of(Rendering.renderer("path", parameters), scene, 5500, RUNS, pathSamples);
        parameters.put("heuristicExponent", "0");
        Runs both = Runs.of(Rendering.renderer("bidirectional", parameters), scene, 6500, RUNS, row.samplesPerPixel);
        expectAgreement(row, both, TILE, ReferenceImage.of(path, TILE));
    }

    private static void checkWithBidirectional(String exponent, int shrink, int bidirectionalSamples, Row row)
            throws SceneException, ImageFileException {
        Scene scene = smallScene(row, shrink);
        Map<String, String> parameters = parameters(row);
        Runs path = Runs.of(Rendering.renderer("path", parameters), scene, 5500, RUNS, row.samplesPerPixel);
        parameters.put("heuristicExponent", exponent);
        Runs both = Runs.of(Rendering.renderer("bidirectional", parameters), scene, 6500, RUNS, bidirectionalSamples);
        expectAgreement(row, path, TILE, ReferenceImage.of(both, TILE));
    }

    private static Scene smallScene(Row row, int shrink) throws SceneException, ImageFileException {
        ReferenceImage size = ReferenceImage.of(row.scene);
        SceneFile file = ShippedScenes.read(row.scene + "/scene.xml");
        return ShippedScenes.compile(file.graph(), size.width() / shrink, size.height() / shrink);
    }

    /** Those that the scene asks for; may be changed. */
    private static Map<String, String> parameters(Row row) throws SceneException {
        return new HashMap<>(
                ShippedScenes.read(row.scene + "/scene.xml").request().parameters());
    }

    private static void check(String rendererId, Map<String, String> parameters, Row row, int shrink)
            throws SceneException, ImageFileException {
        SceneFile file = ShippedScenes.read(row.scene + "/scene.xml");
        ReferenceImage reference = ReferenceImage.of(row.scene);
        assertEquals(
                0, reference.width() % shrink + reference.height() % shrink + row.block % shrink, "pixels are whole");
        Scene scene = ShippedScenes.compile(file.graph(), reference.width() / shrink, reference.height() / shrink);
        Map<String, String> all = new HashMap<>(file.request().parameters());
        all.putAll(parameters);
        Renderer renderer = Rendering.renderer(rendererId, all);
        Runs runs = Runs.of(renderer, scene, 5000, RUNS, row.samplesPerPixel);
        expectAgreement(row, runs, row.block / shrink, reference);
    }

    private static void expectAgreement(Row row, Runs runs, int tile, ReferenceImage reference) {
        Outcome right = compare(row, runs, tile, reference, 1);
        System.out.println(row.scene + ": " + right);
        assertTrue(
                right.uncertain <= row.uncertain * right.blocks,
                () -> row.scene + ": too many blocks are left out: " + right);
        assertTrue(
                right.outliers <= row.outliers * right.blocks,
                () -> row.scene + ": too many blocks are left out: " + right);
        assertTrue(right.agrees(), () -> row.scene + ": " + right);
        for (double factor : new double[] {1 - row.detectable, 1 + row.detectable}) {
            assertTrue(
                    !compare(row, runs, tile, reference, factor).agrees(),
                    () -> String.format(
                            Locale.ROOT, "%s: an image %.3f times as bright is not found out", row.scene, factor));
        }
    }

    /**
     * Result of a comparison.
     *
     * @param blocks number of blocks of all channels
     * @param uncertain those left out as the reference is too noisy there
     * @param outliers those left out as single runs rule there
     * @param rejected those that differ
     * @param worst description of the block that differs most
     * @param smallest its p-value
     * @param meanPValue smallest p-value of the means of the image
     */
    private record Outcome(
            int blocks, int uncertain, int outliers, int rejected, String worst, double smallest, double meanPValue) {
        boolean agrees() {
            return rejected == 0 && meanPValue >= Significance.sidak(SIGNIFICANCE, Runs.CHANNELS.size());
        }
    }

    /**
     * Compares the runs, made brighter by a factor, with the reference.
     *
     * @param tile edge in pixels of what is a block of the reference
     */
    private static Outcome compare(Row row, Runs runs, int tile, ReferenceImage reference, double factor) {
        int block = row.block;
        int columns = Grids.tiles(reference.width(), block);
        int perChannel = columns * Grids.tiles(reference.height(), block);
        double level = Significance.sidak(SIGNIFICANCE, Runs.CHANNELS.size() * perChannel);
        int uncertain = 0;
        int outliers = 0;
        int rejected = 0;
        String worst = "";
        double smallest = 1;
        double meanPValue = 1;
        for (String channel : Runs.CHANNELS) {
            double[][] blocks = Arrays.stream(runs.tiles(channel, tile))
                    .map(run -> Arrays.stream(run).map(v -> factor * v).toArray())
                    .toArray(double[][]::new);
            double[] expected = Grids.tileMeans(reference.values(channel), reference.width(), block);
            double[] expectedVariance = Grids.tileMeans(reference.variances(channel), reference.width(), block);
            double[] variance = new double[perChannel];
            for (int i = 0; i < perChannel; i++) {
                variance[i] = Runs.moments(blocks, i).varianceOfMean();
                expectedVariance[i] *= reference.varianceOfMean(block * block);
            }
            double unseen = !row.rare ? 0 : UNSEEN_PATHS * square(largestJump(blocks));
            double[] around = ReferenceImage.boxMean(variance, columns, 3);
            double[] imageMeans = Arrays.stream(blocks)
                    .mapToDouble(run -> Arrays.stream(run).average().orElseThrow())
                    .toArray();
            for (int i = 0; i < perChannel; i++) {
                if (Math.sqrt(expectedVariance[i]) > LARGEST_REFERENCE_ERROR * expected[i]) {
                    uncertain++;
                    continue;
                }
                if (largestShare(blocks, i) > LARGEST_SHARE) {
                    outliers++;
                    continue;
                }
                double mean = Runs.moments(blocks, i).mean();
                double ours = Math.max(variance[i], around[i]);
                double known = expectedVariance[i] + (mean < expected[i] ? unseen : 0);
                double p = pValue(mean - expected[i], ours, known);
                rejected += p < level ? 1 : 0;
                if (p < smallest) {
                    smallest = p;
                    worst = String.format(
                            Locale.ROOT,
                            "%s of block (%d, %d): %.5g ± %.2g, expected %.5g ± %.2g",
                            channel,
                            i % columns,
                            i / columns,
                            mean,
                            Math.sqrt(ours),
                            expected[i],
                            Math.sqrt(known));
                }
            }
            double expectedMean = Arrays.stream(expected).average().orElseThrow();
            double expectedMeanVariance =
                    Arrays.stream(expectedVariance).average().orElseThrow() / perChannel;
            Moments mean = Moments.of(imageMeans);
            double p = pValue(mean.mean() - expectedMean, mean.varianceOfMean(), expectedMeanVariance);
            meanPValue = Math.min(meanPValue, p);
        }
        return new Outcome(
                Runs.CHANNELS.size() * perChannel, uncertain, outliers, rejected, worst, smallest, meanPValue);
    }

    /** p-value of a difference of the mean of the runs and a value with a known variance (Welch). */
    private static double pValue(double difference, double variance, double knownVariance) {
        double sum = variance + knownVariance;
        double degreesOfFreedom = sum * sum / (variance * variance / (RUNS - 1));
        return Significance.student(difference / Math.sqrt(sum), degreesOfFreedom);
    }

    /** By how much the brightest run of any block raises the mean of that block. */
    private static double largestJump(double[][] runs) {
        double largest = 0;
        for (int block = 0; block < runs[0].length; block++) {
            int column = block;
            double[] values =
                    Arrays.stream(runs).mapToDouble(run -> run[column]).sorted().toArray();
            double median = 0.5 * (values[(RUNS - 1) / 2] + values[RUNS / 2]);
            largest = Math.max(largest, values[RUNS - 1] - median);
        }
        return largest / RUNS;
    }

    private static double square(double x) {
        return x * x;
    }

    /** The largest part that one run has in the sum of squared deviations from the mean. */
    private static double largestShare(double[][] runs, int block) {
        double mean = Runs.moments(runs, block).mean();
        double sum = 0;
        double largest = 0;
        for (double[] run : runs) {
            double square = (run[block] - mean) * (run[block] - mean);
            sum += square;
            largest = Math.max(largest, square);
        }
        return sum == 0 ? 0 : largest / sum;
    }
}
