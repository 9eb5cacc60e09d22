package org.daybreak.core.sampling;

/** Sampler of independent uniform random numbers. */
public final class IndependentSampler extends Sampler {
    private final long seed;
    private final StreamDomain domain;
    private final RandomStream stream;

    /** Creates a sampler for the streams of a seed and domain. */
    public IndependentSampler(long seed, StreamDomain domain) {
        this.seed = seed;
        this.domain = domain;
        stream = new RandomStream(seed, domain, 0, 0);
    }

    @Override
    protected void seat(long pixelIndex, long sampleIndex) {
        stream.seat(seed, domain, pixelIndex, sampleIndex);
    }

    @Override
    public double next() {
        return stream.nextDouble();
    }

    @Override
    public int dimension() {
        return (int) stream.position();
    }

    @Override
    public void setDimension(int dimension) {
        stream.skipTo(dimension);
    }

    @Override
    public IndependentSampler copy() {
        return new IndependentSampler(seed, domain);
    }
}
