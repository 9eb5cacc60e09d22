package org.daybreak.metropolis.chains;

/**
 * A factor on the target of the chains that depends on the film position: one over a rough image, so that chains visit all of
 * the image alike (thesis eq. 5.5; Veach 1997, §11.5). Immutable.
 */
public final class ImageImportance {
    /** The factor 1 everywhere. */
    public static final ImageImportance UNIFORM = new ImageImportance(1, 1, 1, new double[] {1});

    private final int width;
    private final int height;
    private final double cellSize;
    private final double[] factors;

    /**
     * Creates a factor that is constant in square cells.
     *
     * @param width number of cells in a row
     * @param height number of rows of cells
     * @param cellSize edge of a cell in pixels
     * @param factors by rows, positive
     */
    public ImageImportance(int width, int height, double cellSize, double[] factors) {
        this.width = width;
        this.height = height;
        this.cellSize = cellSize;
        this.factors = factors.clone();
    }

    /** The factor at a film position in pixels. */
    public double at(double filmX, double filmY) {
        if (factors.length == 1) {
            return factors[0];
        }
        int x = Math.min(width - 1, Math.max(0, (int) (filmX / cellSize)));
        int y = Math.min(height - 1, Math.max(0, (int) (filmY / cellSize)));
        return factors[y * width + x];
    }

    /** Writes the factor. */
    void save(StateWriter out) {
        out.put(width);
        out.put(height);
        out.put(cellSize);
        for (double factor : factors) {
            out.put(factor);
        }
    }

    /** Reads what {@link #save} has written. */
    static ImageImportance load(StateReader in) {
        int width = in.nextInt();
        int height = in.nextInt();
        double cellSize = in.nextDouble();
        double[] factors = new double[in.checkCount((long) width * height)];
        for (int i = 0; i < factors.length; i++) {
            factors[i] = in.nextDouble();
        }
        return new ImageImportance(width, height, cellSize, factors);
    }
}
