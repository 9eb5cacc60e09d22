package org.daybreak.bidirectional;

import java.util.Arrays;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.NullBsdf;

/**
 * A subpath (the thesis' class of that name): y₀y₁… from a light, or z₀z₁… from the lens. A structure of arrays, one entry per
 * vertex, filled by {@link LineTracer} and owned by one worker; it grows when a longer path comes along and is never made anew.
 *
 * <p>Vertex 0 lies on the light or the lens. A light at infinity has its direction in place of a position; so has the last
 * vertex of an eye subpath that left the scene.
 *
 * <p><b>Densities.</b> {@link #forward} of a vertex is its density as this walk sampled it, {@link #reverse} as a walk from
 * the other end would, both per area; per solid angle for vertices at infinity. A delta lobe stands in the densities of its
 * two neighbours with the factor |cos θ|·η′/η of the side that is left to (η′ there, η where the walk came from) in place of a
 * density per solid angle: the conserved étendue makes the infinite factors of the two directions cancel up to just that.
 * Its discrete probability, that of passing alpha masks and of surviving Russian roulette are the same in all ways to make a path, or left
 * out in all, and appear in neither; but the material of a mask that covers a part has the opacity in its density of scattering, so that
 * weights of paths which scatter there are not quite those of the true densities. Where an eye subpath splits into n, the density of the next vertex counts n times: there are n
 * samples of it.
 */
public final class PathValues {
    private static final int INITIAL_CAPACITY = 16;
    private static final Bsdf NOTHING = new NullBsdf();

    private int length;

    /** Vertices. */
    SurfacePoint[] points = new SurfacePoint[0];

    /** Materials of the vertices; none that scatters at vertex 0 and at infinity. */
    Bsdf[] bsdfs = new Bsdf[0];

    /** α of the subpath that ends here: f/p of all before the vertex, to be multiplied with what happens at it. */
    double[] throughputR = new double[0];

    double[] throughputG = new double[0];
    double[] throughputB = new double[0];

    /** Unit direction to the vertex before; undefined for vertex 0. */
    double[] backX = new double[0];

    double[] backY = new double[0];
    double[] backZ = new double[0];

    /**
     * Density as sampled by this walk; see the class comment. That of vertex 0 includes the choice of the light; of the lens it is
     * 1 if light paths that hit it have no part in the weights.
     */
    double[] forward = new double[0];

    /** Density as if sampled from the next vertex, coming from the one after; known for vertices with two after them. */
    double[] reverse = new double[0];

    /**
     * Factor from the density per solid angle of the direction from this vertex to the one before, to that one's density:
     * |cos θ|/d², or 1 at infinity; 0 if nothing can be sampled that hits it.
     */
    double[] toPrevious = new double[0];

    /** True if the walk went on from this vertex by a delta lobe. */
    boolean[] delta = new boolean[0];

    /** Index of the delta lobe, see {@link Bsdf#deltaLobe}, where {@link #delta} is true. */
    int[] lobe = new int[0];

    /** True if the material has a lobe that connections can use. */
    boolean[] connectable = new boolean[0];

    /** Index of the area light at the vertex, or -1. Of vertex 0 of a light subpath: the light. */
    int[] light = new int[0];

    /** Number of the surface among all that the walk has met, those it passed through included: for dimensions. */
    int[] surface = new int[0];

    /**
     * Σ over the techniques i that connect before this vertex, of their density relative to technique {@code vertex}, raised
     * to the exponent of the heuristic, with whether that one is admissible: see {@link MisWeight#chain}. Known where
     * {@link #reverse} of the vertex before is.
     */
    double[] tail = new double[0];

    /** Eye subpaths: the first vertex that can be connected; 0 if there is none yet. */
    int fork;

    /** True if the eye subpath splits at {@link #fork}, and ends there until it is continued. */
    boolean splits;

    /** True if the first vertex of this light subpath, or the last one of this eye subpath, lies at infinity. */
    boolean infinite;

    /** Light subpaths: true if no scattered ray can hit the light. */
    boolean deltaLight;

    /**
     * Light subpaths: density of y₀ when next-event estimation samples it from y₁, over its {@link #forward} density. 0 if y₁
     * cannot be connected.
     */
    double nextEventRatio;

    /** Creates an empty path. */
    public PathValues() {
        reserve(INITIAL_CAPACITY);
    }

    /** Number of vertices. */
    public int length() {
        return length;
    }

    void setLength(int length) {
        this.length = length;
    }

    /** A vertex. Valid until the next path is traced. */
    public SurfacePoint point(int vertex) {
        return points[vertex];
    }

    /** Material of a vertex. */
    public Bsdf bsdf(int vertex) {
        return bsdfs[vertex];
    }

    /** True if the walk went on from a vertex by a delta lobe. */
    public boolean isDelta(int vertex) {
        return delta[vertex];
    }

    /** Index of the delta lobe that the walk went on by from a vertex, if it did. */
    public int lobe(int vertex) {
        return lobe[vertex];
    }

    /** Index of the area light at a vertex, or -1. Of vertex 0 of a light subpath: the light. */
    public int light(int vertex) {
        return light[vertex];
    }

    /** True if the first vertex of this light subpath, or the last one of this eye subpath, lies at infinity. */
    public boolean isInfinite() {
        return infinite;
    }

    /** Direction, as x, y or z component, from a vertex to the one before. */
    public double back(int vertex, int component) {
        return component == 0 ? backX[vertex] : component == 1 ? backY[vertex] : backZ[vertex];
    }

    /** Makes room for so many vertices. */
    void reserve(int vertices) {
        int old = points.length;
        if (vertices <= old) {
            return;
        }
        int capacity = Math.max(vertices, 2 * old);
        points = Arrays.copyOf(points, capacity);
        bsdfs = Arrays.copyOf(bsdfs, capacity);
        for (int i = old; i < capacity; i++) {
            points[i] = new SurfacePoint();
            bsdfs[i] = NOTHING;
        }
        throughputR = Arrays.copyOf(throughputR, capacity);
        throughputG = Arrays.copyOf(throughputG, capacity);
        throughputB = Arrays.copyOf(throughputB, capacity);
        backX = Arrays.copyOf(backX, capacity);
        backY = Arrays.copyOf(backY, capacity);
        backZ = Arrays.copyOf(backZ, capacity);
        forward = Arrays.copyOf(forward, capacity);
        reverse = Arrays.copyOf(reverse, capacity);
        toPrevious = Arrays.copyOf(toPrevious, capacity);
        delta = Arrays.copyOf(delta, capacity);
        lobe = Arrays.copyOf(lobe, capacity);
        connectable = Arrays.copyOf(connectable, capacity);
        light = Arrays.copyOf(light, capacity);
        surface = Arrays.copyOf(surface, capacity);
        tail = Arrays.copyOf(tail, capacity);
    }

    /** Starts a path with its vertex 0, whose point the caller has set. */
    void start(double r, double g, double b, double density, int lightIndex) {
        length = 1;
        bsdfs[0] = NOTHING;
        throughputR[0] = r;
        throughputG[0] = g;
        throughputB[0] = b;
        forward[0] = density;
        delta[0] = false;
        connectable[0] = true;
        light[0] = lightIndex;
        surface[0] = 0;
        fork = 0;
        splits = false;
        infinite = false;
        deltaLight = false;
        nextEventRatio = 0;
    }
}
