package org.daybreak.tracing;

/**
 * Which dimension of a sampler each decision of an eye path reads. Fixed addresses keep a decision in the same dimension
 * for all samples of a pixel, which is what makes low-discrepancy points work.
 *
 * <p>Groups of four aligned dimensions are stratified together, so a group holds what belongs to one integral: group 0 the
 * position in the pixel and the light point for the first vertex (direct light is a function of just these), group k the
 * direction scattered at vertex k and the light point for the vertex it leads to. Discrete choices, which need less, have
 * groups of their own.
 */
public final class Dimensions {
    /** The light point for the first vertex, after the position in the pixel. */
    public static final int FIRST_DIRECT = 2;

    private static final int GROUP = 4;
    private static final int CHOICES = 1 << 24;
    private static final int LIGHT_CHOICES = 1 << 26;
    private static final int FURTHER_LIGHTS = 1 << 28;
    private static final int LIGHT_PATHS = 1 << 29;

    /** So many vertices of a light subpath, and so many light subpaths of a sample, have dimensions of their own. */
    private static final int LIGHT_VERTICES = 1 << 10;

    private static final int LIGHT_SUBPATHS = 1 << 12;

    /** So many vertices have dimensions of their own; beyond that, numbers are used again. */
    private static final int VERTICES = 1 << 18;

    /** Added to the vertex number once a path has split: see {@link org.daybreak.core.sampling.Sampler#branch}. */
    public static final int SPLIT = VERTICES;

    private Dimensions() {}

    /** The first of: two for the direction scattered at a vertex, two for the light point of the vertex after it. */
    public static int scattering(int vertex) {
        return GROUP * (vertex & 2 * VERTICES - 1);
    }

    /** The first of two: lobe, Russian roulette. For vertex 0, the lens: the point on it. */
    public static int choices(int vertex) {
        return CHOICES + scattering(vertex);
    }

    /** The one that chooses a light at a vertex. */
    public static int lightChoice(int vertex) {
        return LIGHT_CHOICES + scattering(vertex);
    }

    /** The first of two for a light point when a vertex has several. */
    public static int lightPoint(int vertex, int light, int lights) {
        return FURTHER_LIGHTS + (GROUP * (vertex * lights + light) & (FURTHER_LIGHTS - 1));
    }

    /**
     * The first of four for a vertex of a light subpath: for vertex 0 the position on the light and the direction that it
     * leaves in, for others the direction scattered there (two) and the point on the lens it is joined to (two).
     *
     * @param subpath number of the light subpath within the sample
     */
    public static int lightPath(int vertex, int subpath) {
        return LIGHT_PATHS + GROUP * ((subpath & LIGHT_SUBPATHS - 1) * LIGHT_VERTICES + (vertex & LIGHT_VERTICES - 1));
    }

    /** The first of two at a vertex of a light subpath: lobe, Russian roulette. For vertex 0: the light. */
    public static int lightPathChoices(int vertex, int subpath) {
        return lightPath(vertex, subpath) + GROUP * LIGHT_VERTICES * LIGHT_SUBPATHS;
    }
}
