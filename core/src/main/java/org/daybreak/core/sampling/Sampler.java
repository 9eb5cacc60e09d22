package org.daybreak.core.sampling;

/**
 * Source of the uniform numbers of one sample of a pixel: a point of the infinite-dimensional unit cube, read one
 * coordinate after the other.
 *
 * <p>The numbers depend on the seed, pixel, sample index and dimension only. Mutable, not safe for threads: each worker
 * has its own {@link #copy()}.
 */
public abstract class Sampler {
    private long pixelIndex;
    private long sampleIndex;

    /** Creates a sampler; it must be {@linkplain #start started} before use. */
    protected Sampler() {}

    /**
     * Moves to dimension 0 of a sample.
     *
     * @param pixelIndex any number that identifies the pixel
     * @param sampleIndex index of the sample in its pixel, from 0; each prefix of the indices is a good set of samples
     * @throws IllegalArgumentException if the sampler has no sample of this index
     */
    public final void start(long pixelIndex, long sampleIndex) {
        this.pixelIndex = pixelIndex;
        this.sampleIndex = sampleIndex;
        seat(pixelIndex, sampleIndex);
    }

    /**
     * Moves to dimension 0 of one of several continuations of the current sample. In each dimension the branches of all
     * samples of a pixel together are one good set: branch k of sample i has the numbers of sample
     * {@code i·branches + k}. So what goes on from a path that splits must read dimensions that the path before does not
     * read in any sample, or they would share numbers.
     *
     * @param branch 0 … {@code branches} − 1
     * @throws IllegalArgumentException if the sampler has no sample of the resulting index
     */
    public final void branch(int branch, int branches) {
        seat(pixelIndex, sampleIndex * branches + branch);
    }

    /** Moves to dimension 0 of the numbers with a pixel and index: what {@link #start} documents. */
    protected abstract void seat(long pixelIndex, long sampleIndex);

    /** The coordinate of the current dimension, in [0, 1), and moves to the next dimension. */
    public abstract double next();

    /** The dimension that {@link #next()} will return. */
    public abstract int dimension();

    /**
     * Chooses the dimension that {@link #next()} will return. An algorithm that gives each of its decisions a known
     * dimension keeps them aligned between samples, whatever number of dimensions each decision uses.
     *
     * @param dimension from 0
     */
    public abstract void setDimension(int dimension);

    /** A sampler with the same seed and settings, and so the same numbers, for another worker. Not started. */
    public abstract Sampler copy();
}
