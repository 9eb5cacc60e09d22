package org.daybreak.core.testing;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;

/**
 * Pearson's χ² test of a sampling method against its density.
 *
 * <p>Samples are counted in the cells of a grid; the density is integrated over each cell by adaptive quadrature.
 * Directions are counted in (cos θ, φ), with an odd number of cells each way so that symmetries of the density do not
 * fall on their borders. What the sampler rejects is a cell of its own, with the rest of the probability. The test
 * fails at once if the density integrates to more than 1, is negative or not finite, or if a sample falls where its
 * density is 0 throughout the cell.
 *
 * <p>What it finds: a density that is wrong by a relative ε throughout raises χ² by samples · ε², against a standard
 * deviation of √(2 · cells). With the defaults that is visible from about ε = 0.03.
 */
public final class ChiSquareTest {
    /** Cells with fewer expected samples are pooled. */
    private static final double LEAST_EXPECTED = 5;

    /** Nodes and weights of Gauss-Legendre quadrature of order 3 on [0, 1]. */
    private static final double[] NODES = {0.5 - Math.sqrt(0.15), 0.5, 0.5 + Math.sqrt(0.15)};

    private static final double[] WEIGHTS = {5.0 / 18, 8.0 / 18, 5.0 / 18};

    private final String name;
    private final PointSampler sampler;
    private final PointDensity density;
    private final boolean directional;
    private double x0;
    private double x1;
    private double y0;
    private double y1;
    private int columns = 51;
    private int rows = 25;
    private boolean equalAngles;
    private int samples = 200_000;
    private long seed = 1;
    private int leastDepth = 2;
    private int mostDepth = 9;

    /**
     * The result.
     *
     * @param statistic χ²
     * @param degreesOfFreedom cells after pooling, less one
     * @param pValue probability of a statistic at least as large if the sampler follows the density
     * @param message the figures, or the reason why the p-value is 0
     */
    public record Result(double statistic, int degreesOfFreedom, double pValue, String message) {}

    private ChiSquareTest(String name, PointSampler sampler, PointDensity density, boolean directional) {
        this.name = name;
        this.sampler = sampler;
        this.density = density;
        this.directional = directional;
    }

    /** A test of random directions. */
    public static ChiSquareTest ofDirections(String name, DirectionSampler sampler, DirectionDensity density) {
        ChiSquareTest test = new ChiSquareTest(name, spherical(name, sampler), spherical(density), true);
        test.x0 = -Math.PI;
        test.x1 = Math.PI;
        test.y0 = -1;
        test.y1 = 1;
        return test;
    }

    /** A test of random points of a rectangle of the plane. */
    public static ChiSquareTest ofPoints(
            String name, PointSampler sampler, PointDensity density, double x0, double x1, double y0, double y1) {
        ChiSquareTest test = new ChiSquareTest(name, sampler, density, false);
        test.x0 = x0;
        test.x1 = x1;
        test.y0 = y0;
        test.y1 = y1;
        return test;
    }

    /** Sets the cells: columns along φ or x, rows along cos θ or y. The default is 51 × 25. */
    public ChiSquareTest cells(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
        return this;
    }

    /** Makes the rows equal in θ instead of cos θ, for lobes near the poles. */
    public ChiSquareTest equalAngles() {
        equalAngles = directional;
        return this;
    }

    /** Sets the number of samples. The default is 200,000. */
    public ChiSquareTest samples(int samples) {
        this.samples = samples;
        return this;
    }

    /** Sets the seed of the uniform numbers. */
    public ChiSquareTest seed(long seed) {
        this.seed = seed;
        return this;
    }

    /**
     * Sets the halvings of a cell in quadrature: {@code least} are always done, so that a narrow lobe within a cell is
     * found; up to {@code most} where the density is rough. The default is 2 and 9.
     */
    public ChiSquareTest depth(int least, int most) {
        leastDepth = least;
        mostDepth = most;
        return this;
    }

    /**
     * Runs the test and fails if it rejects.
     *
     * @param significance the false-alarm rate; divide it among several tests by {@link Significance#sidak}
     */
    public void assertAgrees(double significance) {
        Result result = run();
        if (!(result.pValue() >= significance)) {
            fail(result.message());
        }
    }

    /** Runs the test. */
    public Result run() {
        long[] observed = new long[columns * rows + 1];
        double[] expected = new double[observed.length];
        String error = count(observed);
        if (error.isEmpty()) {
            error = integrate(observed, expected);
        }
        return error.isEmpty() ? compare(name, observed, expected) : new Result(Double.NaN, 0, 0, name + ": " + error);
    }

    /**
     * Compares counts with their expectations. Cells with an expectation below 5 are pooled, smallest first.
     *
     * @param name what is tested, for the message
     * @param observed counts; their expected total is that of {@code expected}
     * @param expected expected counts
     */
    public static Result compare(String name, long[] observed, double[] expected) {
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < observed.length; i++) {
            if (expected[i] == 0 && observed[i] > 0) {
                String message = name + ": " + observed[i] + " samples in cell " + i + " of density 0";
                return new Result(Double.POSITIVE_INFINITY, 0, 0, message);
            }
            order.add(i);
        }
        order.sort(Comparator.comparingDouble(i -> expected[i]));
        double statistic = 0;
        int cells = 0;
        int worst = -1;
        double worstPart = 0;
        double poolExpected = 0;
        long poolObserved = 0;
        for (int i : order) {
            poolExpected += expected[i];
            poolObserved += observed[i];
            // The pool is never left with little: what follows in this order is larger still.
            if (poolExpected >= LEAST_EXPECTED) {
                double difference = poolObserved - poolExpected;
                double part = difference * difference / poolExpected;
                statistic += part;
                cells++;
                if (part > worstPart) {
                    worstPart = part;
                    worst = i;
                }
                poolExpected = 0;
                poolObserved = 0;
            }
        }
        if (cells < 2) {
            return new Result(statistic, cells - 1, 0, name + ": fewer than two cells with enough samples");
        }
        double pValue = Significance.chiSquare(statistic, cells - 1);
        String message = String.format(
                Locale.ROOT,
                "%s: χ² = %.1f at %d degrees of freedom, p = %.3g; worst cell %d with %d of %.1f expected",
                name,
                statistic,
                cells - 1,
                pValue,
                worst,
                worst < 0 ? 0 : observed[worst],
                worst < 0 ? 0 : expected[worst]);
        return new Result(statistic, cells - 1, pValue, message);
    }

    private String count(long[] observed) {
        RandomStream random = new RandomStream(seed, StreamDomain.SELF_CHECK, 0, 0);
        double[] point = new double[3];
        for (int i = 0; i < samples; i++) {
            random.seat(seed, StreamDomain.SELF_CHECK, i, 0);
            if (!sampler.sample(random.nextDouble(), random.nextDouble(), random.nextDouble(), point)) {
                observed[observed.length - 1]++;
                continue;
            }
            double x = (point[0] - x0) / (x1 - x0);
            double y = equalAngles
                    ? 1 - Math.acos(Math.min(Math.max(point[1], -1), 1)) / Math.PI
                    : (point[1] - y0) / (y1 - y0);
            if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) {
                return String.format(Locale.ROOT, "sample (%s, %s) lies outside the domain", point[0], point[1]);
            }
            int column = Math.min((int) (x * columns), columns - 1);
            int row = Math.min((int) (y * rows), rows - 1);
            observed[row * columns + column]++;
        }
        return "";
    }

    private String integrate(long[] observed, double[] expected) {
        double sum = 0;
        for (int row = 0; row < rows; row++) {
            double bottom = rowEdge(row);
            double top = rowEdge(row + 1);
            for (int column = 0; column < columns; column++) {
                double left = x0 + (x1 - x0) * column / columns;
                double right = x0 + (x1 - x0) * (column + 1) / columns;
                double coarse = quadrature(left, right, bottom, top);
                // An error of a fiftieth of the noise of the count shifts χ² by some 4e-4 of its cells: nothing.
                double tolerance = 0.02 * Math.sqrt(Math.max(1, samples / (double) expected.length)) / samples;
                double mass = refine(left, right, bottom, top, coarse, tolerance, 0);
                if (!(mass >= 0) || mass == Double.POSITIVE_INFINITY) {
                    return "the density of cell " + column + ", " + row + " integrates to " + mass;
                }
                expected[row * columns + column] = mass * samples;
                sum += mass;
            }
        }
        double outside = 1 - sum;
        // Beyond the error of the quadrature; what is statistically visible of a smaller excess, χ² shows.
        if (outside < -1e-3) {
            return "the density integrates to " + sum;
        }
        // Within the error of the quadrature the rest is unknown, and only too many rejections can be told.
        double unknown = 0.02 * Math.sqrt(samples);
        if (outside * samples >= unknown) {
            expected[expected.length - 1] = outside * samples;
            return "";
        }
        long rejected = observed[observed.length - 1];
        observed[observed.length - 1] = 0;
        // Ten over and six standard deviations: a false alarm of less than 1e-8.
        return rejected <= unknown + 6 * Math.sqrt(unknown) + 10
                ? ""
                : rejected + " of " + samples + " samples rejected, but the density integrates to " + sum;
    }

    private double rowEdge(int row) {
        double y = (double) row / rows;
        return equalAngles ? -Math.cos(Math.PI * y) : y0 + (y1 - y0) * y;
    }

    private double refine(
            double left, double right, double bottom, double top, double coarse, double tolerance, int depth) {
        if (depth >= mostDepth) {
            return coarse;
        }
        double x = 0.5 * (left + right);
        double y = 0.5 * (bottom + top);
        double a = quadrature(left, x, bottom, y);
        double b = quadrature(x, right, bottom, y);
        double c = quadrature(left, x, y, top);
        double d = quadrature(x, right, y, top);
        double fine = a + b + c + d;
        if (depth >= leastDepth && Math.abs(fine - coarse) <= tolerance) {
            return fine;
        }
        double part = 0.5 * tolerance;
        return refine(left, x, bottom, y, a, part, depth + 1)
                + refine(x, right, bottom, y, b, part, depth + 1)
                + refine(left, x, y, top, c, part, depth + 1)
                + refine(x, right, y, top, d, part, depth + 1);
    }

    private double quadrature(double left, double right, double bottom, double top) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double x = left + NODES[i] * (right - left);
            for (int j = 0; j < 3; j++) {
                double y = bottom + NODES[j] * (top - bottom);
                double value = density.density(x, y);
                sum += WEIGHTS[i] * WEIGHTS[j] * (value >= 0 ? value : Double.NaN);
            }
        }
        return sum * (right - left) * (top - bottom);
    }

    private static PointSampler spherical(String name, DirectionSampler sampler) {
        double[] direction = new double[3];
        return (u, v, w, point) -> {
            if (!sampler.sample(u, v, w, direction)) {
                return false;
            }
            double x = direction[0];
            double y = direction[1];
            double z = direction[2];
            if (!(Math.abs(x * x + y * y + z * z - 1) < 1e-6)) {
                fail(name + ": the direction (" + x + ", " + y + ", " + z + ") is not a unit vector");
            }
            point[0] = Math.atan2(y, x);
            point[1] = Math.min(Math.max(z, -1), 1);
            return true;
        };
    }

    private static PointDensity spherical(DirectionDensity density) {
        return (phi, cosTheta) -> {
            double sinTheta = Math.sqrt((1 - cosTheta) * (1 + cosTheta));
            return density.density(sinTheta * Math.cos(phi), sinTheta * Math.sin(phi), cosTheta);
        };
    }
}
