package org.daybreak.core.sampling;

/**
 * Sampler of Owen-scrambled Sobol′ points.
 *
 * <p>The dimensions are cut into groups of equal size. Each group is the first dimensions of the Sobol′ sequence, with
 * the order of its points shuffled and its coordinates scrambled, both by nested uniform scrambling with seeds of the
 * pixel and group ("padding"; Burley, JCGT 9(4), 2020, section 5). So within a group, the samples of each aligned block
 * of 2ᵐ indices are a scrambled (t, m, s)-net; two groups, or two pixels, are independent. Every prefix of the samples
 * is usable, and the prefixes of 2ᵐ samples are best. No total number of samples need be known.
 *
 * <p>Each number has 53 bits: 32 from the net, and below these 21 hashed ones, which continue the scrambling.
 */
public final class SobolSampler extends Sampler {
    private static final long SAMPLES = 1L << 32;

    private final long seed;
    private final StreamDomain domain;
    private final int groupSize;

    private long pixelIndex;
    private long pixelKey;
    private long groupKey;
    private int reversedSampleIndex;
    private int dimension;
    private int dimensionInGroup;
    private int pointIndex;

    /**
     * Creates a sampler.
     *
     * @param seed seed of the picture
     * @param domain domain of the pixels' seeds
     * @param groupSize dimensions per group, 1 … {@link Sobol#DIMENSIONS}; 4 is a good choice
     * @throws IllegalArgumentException if the group size is outside
     */
    public SobolSampler(long seed, StreamDomain domain, int groupSize) {
        if (groupSize < 1 || groupSize > Sobol.DIMENSIONS) {
            throw new IllegalArgumentException(
                    "dimensions per group must be 1 to " + Sobol.DIMENSIONS + ", not " + groupSize);
        }
        this.seed = seed;
        this.domain = domain;
        this.groupSize = groupSize;
        seatPixel(0);
        setDimension(0);
    }

    /** Moves to dimension 0 of a sample; its index must be below 2³². */
    @Override
    protected void seat(long pixelIndex, long sampleIndex) {
        if (sampleIndex < 0 || sampleIndex >= SAMPLES) {
            throw new IllegalArgumentException("sample index must be 0 to 2^32 - 1, not " + sampleIndex);
        }
        if (pixelIndex != this.pixelIndex) {
            seatPixel(pixelIndex);
        }
        reversedSampleIndex = Integer.reverse((int) sampleIndex);
        dimension = 0;
        enterGroup(0);
    }

    @Override
    public double next() {
        if (dimensionInGroup == groupSize) {
            enterGroup(dimension / groupSize);
        }
        dimension++;
        long seeds = Mixing.mix64(pixelKey + dimension * Mixing.GOLDEN_GAMMA);
        int bits = Integer.reverse(
                OwenScrambling.permuteReversed(Sobol.reversed(pointIndex, dimensionInGroup++), (int) seeds));
        int lower = bits ^ (int) (seeds >>> 32);
        lower = (lower ^ (lower >>> 16)) * 0x21F0AAAD;
        lower = (lower ^ (lower >>> 15)) * 0x735A2D97;
        return ((bits & 0xFFFFFFFFL) << 21 | lower >>> 11) * 0x1.0p-53;
    }

    @Override
    public int dimension() {
        return dimension;
    }

    @Override
    public void setDimension(int dimension) {
        this.dimension = dimension;
        int group = dimension / groupSize;
        enterGroup(group);
        dimensionInGroup = dimension - group * groupSize;
    }

    @Override
    public SobolSampler copy() {
        return new SobolSampler(seed, domain, groupSize);
    }

    private void seatPixel(long pixelIndex) {
        this.pixelIndex = pixelIndex;
        pixelKey = Mixing.hash(seed, domain, pixelIndex, 0);
        groupKey = Mixing.hash(seed, domain, pixelIndex, 1);
    }

    private void enterGroup(int group) {
        int shuffleSeed = (int) Mixing.mix64(groupKey + group * Mixing.GOLDEN_GAMMA);
        pointIndex = Integer.reverse(OwenScrambling.permuteReversed(reversedSampleIndex, shuffleSeed));
        dimensionInGroup = 0;
    }
}
