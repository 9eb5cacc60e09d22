package org.daybreak.antialiasing;

import org.daybreak.core.sampling.Mixing;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.sampling.StreamDomain;

/** Each pair of dimensions (2j, 2j + 1) is a jittered grid of strata, in a random order of its own per pixel and pair. */
final class StratifiedSampler extends Sampler {
    private final long seed;
    private final int columns;
    private final int rows;
    private final RandomStream stream;
    private long blockKey;
    private int indexInBlock;
    private int dimension;

    StratifiedSampler(long seed, int columns, int rows) {
        this.seed = seed;
        this.columns = columns;
        this.rows = rows;
        stream = new RandomStream(seed, StreamDomain.PIXEL, 0, 0);
    }

    @Override
    protected void seat(long pixelIndex, long sampleIndex) {
        int strata = columns * rows;
        stream.seat(seed, StreamDomain.PIXEL, pixelIndex, sampleIndex);
        // The order of the strata must not hang on the same bits as the jitter: they are hashed with another seed.
        blockKey = Mixing.hash(Mixing.mix64(seed), StreamDomain.PIXEL, pixelIndex, sampleIndex / strata);
        indexInBlock = (int) (sampleIndex % strata);
        dimension = 0;
    }

    @Override
    public double next() {
        int pair = dimension >> 1;
        int stratum = Strata.permute(indexInBlock, columns * rows, Mixing.absorb(blockKey, pair));
        boolean first = (dimension & 1) == 0;
        dimension++;
        double jitter = stream.nextDouble();
        return first
                ? Strata.within(stratum % columns, columns, jitter)
                : Strata.within(stratum / columns, rows, jitter);
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
    public StratifiedSampler copy() {
        return new StratifiedSampler(seed, columns, rows);
    }
}
