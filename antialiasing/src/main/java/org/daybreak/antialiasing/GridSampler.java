package org.daybreak.antialiasing;

import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.sampling.StreamDomain;

/**
 * The first two dimensions are a grid of n×n cells, visited row by row and then again; all others are independent random
 * numbers.
 */
final class GridSampler extends Sampler {
    private final long seed;
    private final int cellsPerSide;
    private final boolean jitter;
    private final RandomStream stream;
    private long cell;
    private int dimension;

    /**
     * Creates a sampler.
     *
     * @param jitter a random point of each cell instead of its centre
     */
    GridSampler(long seed, int cellsPerSide, boolean jitter) {
        this.seed = seed;
        this.cellsPerSide = cellsPerSide;
        this.jitter = jitter;
        stream = new RandomStream(seed, StreamDomain.PIXEL, 0, 0);
    }

    @Override
    protected void seat(long pixelIndex, long sampleIndex) {
        stream.seat(seed, StreamDomain.PIXEL, pixelIndex, sampleIndex);
        cell = sampleIndex % ((long) cellsPerSide * cellsPerSide);
        dimension = 0;
    }

    @Override
    public double next() {
        double u = stream.nextDouble();
        if (dimension >= 2) {
            dimension++;
            return u;
        }
        long index = dimension == 0 ? cell % cellsPerSide : cell / cellsPerSide;
        dimension++;
        return Strata.within(index, cellsPerSide, jitter ? u : 0.5);
    }

    @Override
    public int dimension() {
        return dimension;
    }

    @Override
    public void setDimension(int dimension) {
        this.dimension = dimension;
        stream.skipTo(dimension);
    }

    @Override
    public GridSampler copy() {
        return new GridSampler(seed, cellsPerSide, jitter);
    }
}
