package org.daybreak.antialiasing;

import java.util.List;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.Sampler;

/**
 * The thesis' super-sampling: a pixel is cut into n×n cells with a sample in each, n² samples per pixel (section 3.3). Only
 * the position in the pixel is stratified; the paths use independent numbers.
 */
public final class GridSampling implements AntialiasingFactory {
    private static final int LARGEST_GRID = 4096;

    /** Creates the factory. */
    public GridSampling() {}

    @Override
    public String id() {
        return "grid";
    }

    @Override
    public String description() {
        return "a grid of n x n samples in each pixel";
    }

    @Override
    public List<Parameter> parameters() {
        return List.of(
                Parameter.integer(
                        "gridSize",
                        "Grid size of super sampling",
                        0,
                        0,
                        LARGEST_GRID,
                        "Cells per side; a pixel gets the square of this many samples, or whole multiples of that if more"
                                + " are asked for. 0 takes the smallest grid with as many samples as asked for."),
                Parameter.flag(
                        "jitter",
                        "Jitter within cells",
                        true,
                        "Sample a random point of each cell instead of its centre."));
    }

    @Override
    public Antialiasing create(ParameterValues values) {
        return new Method(values.integer("gridSize"), values.flag("jitter"));
    }

    private record Method(int gridSize, boolean jitter) implements Antialiasing {
        @Override
        public String id() {
            return "grid";
        }

        @Override
        public long samplesPerPixel(long requested) {
            long cells = (long) cellsPerSide(requested) * cellsPerSide(requested);
            return (requested + cells - 1) / cells * cells;
        }

        @Override
        public Sampler newSampler(long seed, long samplesPerPixel) {
            return new GridSampler(seed, cellsPerSide(samplesPerPixel), jitter);
        }

        private int cellsPerSide(long requested) {
            return gridSize > 0 ? gridSize : (int) Math.min(LARGEST_GRID, Math.ceil(Math.sqrt((double) requested)));
        }
    }
}
