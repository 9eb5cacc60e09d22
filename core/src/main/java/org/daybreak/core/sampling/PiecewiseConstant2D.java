package org.daybreak.core.sampling;

/**
 * Density on the unit square, constant on each cell of a grid, in proportion to given weights. Immutable.
 *
 * <p>For the image distribution of environment maps: a row is chosen by the marginal distribution, a column by that of
 * the row. Row 0 lies at y = 0, column 0 at x = 0.
 */
public final class PiecewiseConstant2D {
    private final int width;
    private final int height;
    /** Cumulative distribution of the rows. */
    private final Cumulative marginal;
    /** Cumulative distributions of the columns, one for each row. */
    private final Cumulative conditional;

    private final double average;

    /** The weight of a cell. */
    @FunctionalInterface
    public interface CellWeight {
        /** The weight of the cell in this column and row: finite and not negative. */
        double weight(int column, int row);
    }

    /**
     * Creates the distribution. If all weights are 0, it is uniform.
     *
     * @throws IllegalArgumentException if there is no cell, there are too many for an array, a weight is negative or
     *     not finite, or their sum overflows
     */
    public PiecewiseConstant2D(int width, int height, CellWeight weights) {
        if (width < 1 || height < 1 || (width + 1L) * height > Integer.MAX_VALUE - 8) {
            throw new IllegalArgumentException("no distribution on a grid of " + width + " by " + height + " cells");
        }
        this.width = width;
        this.height = height;
        marginal = new Cumulative(height, 1);
        conditional = new Cumulative(width, height);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                conditional.setWeight(row, column, weights.weight(column, row));
            }
            try {
                marginal.setWeight(0, row, conditional.accumulate(row));
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException("row " + row + ": " + e.getMessage(), e);
            }
        }
        average = marginal.accumulate(0) / width / height;
    }

    /** The mean of the weights: the integral over the unit square of the function that they describe. */
    public double average() {
        return average;
    }

    /**
     * Samples a point.
     *
     * @param u chooses x
     * @param v chooses y
     * @param dest receives x and y, in [0, 1)
     * @return the density at the point, per unit of the square's area; positive
     */
    public double sample(double u, double v, double[] dest) {
        int row = marginal.find(0, v);
        int column = conditional.find(row, u);
        dest[0] = position(column, conditional.remainder(row, column, u), width);
        dest[1] = position(row, marginal.remainder(0, row, v), height);
        return cellDensity(column, row);
    }

    /** The density of {@link #sample} at a point of [0, 1)², per unit of the square's area. */
    public double density(double x, double y) {
        return cellDensity(cell(x, width), cell(y, height));
    }

    private double cellDensity(int column, int row) {
        return marginal.probability(0, row) * height * conditional.probability(row, column) * width;
    }

    private static double position(int cell, double remainder, int cells) {
        double position = Math.min((cell + remainder) / cells, Math.nextDown(1.0));
        // Rounding at the upper edge must not lead into the next cell, whose density may be 0.
        return cell(position, cells) == cell ? position : (cell + 0.5) / cells;
    }

    private static int cell(double position, int cells) {
        return Math.min((int) (position * cells), cells - 1);
    }
}
