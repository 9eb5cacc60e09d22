package org.daybreak.metropolis.strategy;

import java.util.Arrays;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.NullBsdf;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.StateReader;
import org.daybreak.metropolis.chains.StateWriter;

/**
 * A full path x₀…x_k from a light to the lens: a state of a chain. A structure of arrays that grows when a longer path comes
 * along; two of them per chain are filled in turn, and never made anew.
 *
 * <p><b>Measure.</b> Densities are per area; per solid angle for a light at infinity. A delta lobe stands in the density of the
 * vertex that it leads to, and in the contribution, with the factor |cos θ|·η′/η of the side that is left to in place of a density per
 * solid angle (as in {@code PathValues}): the conserved étendue makes what is infinite in them cancel up to just that. The probability of choosing the
 * lobe is kept apart ({@link #lobeFromLight}), as moves that keep the lobe do not choose.
 */
public final class LightPath {
    private static final int INITIAL_CAPACITY = 8;
    private static final Bsdf NOTHING = new NullBsdf();

    /** Number of vertices, k + 1. */
    int length;

    /** Vertices. */
    SurfacePoint[] points = new SurfacePoint[0];

    /** Materials; none that scatters at the ends. */
    Bsdf[] bsdfs = new Bsdf[0];

    /** Whether the material at a vertex scatters by other than delta lobes, too; false at the ends. */
    boolean[] connectable = new boolean[0];

    /** Index of the delta lobe that the path takes at a vertex; -1 where it scatters otherwise, and at the ends. */
    int[] lobe = new int[0];

    /** Fraction of light that does not pass straight through the surface at a vertex: 1 but for alpha masks. */
    double[] opacity = new double[0];

    /** Unit direction of edge i, from x_i to x_{i+1}. */
    double[] dx = new double[0];

    double[] dy = new double[0];
    double[] dz = new double[0];

    /** Squared length of edge i; infinite for one from infinity. */
    double[] squared = new double[0];

    /** Fraction of light that edge i lets pass: 1 but for alpha masks between its ends. */
    double[] clear = new double[0];

    /** What the path carries over vertex i, 0 &lt; i &lt; k: f·|cos θ| towards the light, or for a delta lobe what stands for it. */
    double[] scatterR = new double[0];

    double[] scatterG = new double[0];
    double[] scatterB = new double[0];

    /** Density of x_i as sampled from x_{i−1}, coming from x_{i−2}. Of x₀: of the start of light subpaths, the choice of the light included. */
    double[] fromLight = new double[0];

    /** Density of x_i as sampled from x_{i+1}, coming from x_{i+2}. Of x_k: 1; of x_{k−1}: with the film position drawn evenly. */
    double[] fromEye = new double[0];

    /** Probability of choosing the delta lobe at a vertex, coming from the light; 1 where there is none. */
    double[] lobeFromLight = new double[0];

    /** The same coming from the lens. */
    double[] lobeFromEye = new double[0];

    /** Density of x₀ when x₁ samples a point on a light. */
    double nextEvent;

    /** Index of the light; -1 while x₀ is none. */
    int light;

    /** True if x₀ lies at infinity: only its direction counts. */
    boolean infinite;

    /** True if no ray can hit x₀. */
    boolean deltaLight;

    /** Where the path meets the film, in pixels. */
    double filmX;

    double filmY;

    /** Numbers of the point on the lens. */
    double lensU;

    double lensV;

    /** Film area in square pixels per solid angle at the lens; 0 for a camera of parallel rays. */
    double filmPerSolidAngle;

    /** Emission that starts out along edge 0. */
    final Spectrum emission = new Spectrum();

    /** Contribution f relative to the film, without its visibility at first. */
    final Spectrum value = new Spectrum();

    /** Scalar contribution f*: luminance of {@link #value}. */
    double contribution;

    /** Creates an empty path. */
    public LightPath() {
        reserve(INITIAL_CAPACITY);
    }

    /** Number of edges, k. */
    public int edges() {
        return length - 1;
    }

    /** Film position in pixels. */
    public double filmX() {
        return filmX;
    }

    /** Film position in pixels, downwards. */
    public double filmY() {
        return filmY;
    }

    /** Contribution f. Not to be changed. */
    public Spectrum value() {
        return value;
    }

    /** Scalar contribution f*. */
    public double contribution() {
        return contribution;
    }

    /** A vertex, 0 on the light. Not to be changed. */
    public SurfacePoint point(int vertex) {
        return points[vertex];
    }

    /** True if the path takes a delta lobe at a vertex. */
    public boolean isDelta(int vertex) {
        return lobe[vertex] >= 0;
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
        connectable = Arrays.copyOf(connectable, capacity);
        lobe = Arrays.copyOf(lobe, capacity);
        opacity = Arrays.copyOf(opacity, capacity);
        dx = Arrays.copyOf(dx, capacity);
        dy = Arrays.copyOf(dy, capacity);
        dz = Arrays.copyOf(dz, capacity);
        squared = Arrays.copyOf(squared, capacity);
        clear = Arrays.copyOf(clear, capacity);
        scatterR = Arrays.copyOf(scatterR, capacity);
        scatterG = Arrays.copyOf(scatterG, capacity);
        scatterB = Arrays.copyOf(scatterB, capacity);
        fromLight = Arrays.copyOf(fromLight, capacity);
        fromEye = Arrays.copyOf(fromEye, capacity);
        lobeFromLight = Arrays.copyOf(lobeFromLight, capacity);
        lobeFromEye = Arrays.copyOf(lobeFromEye, capacity);
    }

    /** Sets a vertex that scatters by no delta lobe so far. */
    void setVertex(int vertex, Bsdf bsdf, double opaque) {
        bsdfs[vertex] = bsdf;
        connectable[vertex] = bsdf.connectable();
        lobe[vertex] = -1;
        opacity[vertex] = opaque;
        lobeFromLight[vertex] = 1;
        lobeFromEye[vertex] = 1;
    }

    /** Sets an end of the path: nothing scatters there. */
    void setEnd(int vertex) {
        setVertex(vertex, NOTHING, 1);
    }

    /** Takes over vertices of another path, with the edges after them and what is known of both. */
    void copy(LightPath from, int first, int count, int to) {
        reserve(to + count);
        for (int i = 0; i < count; i++) {
            points[to + i].set(from.points[first + i]);
        }
        System.arraycopy(from.bsdfs, first, bsdfs, to, count);
        System.arraycopy(from.connectable, first, connectable, to, count);
        System.arraycopy(from.lobe, first, lobe, to, count);
        System.arraycopy(from.opacity, first, opacity, to, count);
        System.arraycopy(from.dx, first, dx, to, count);
        System.arraycopy(from.dy, first, dy, to, count);
        System.arraycopy(from.dz, first, dz, to, count);
        System.arraycopy(from.squared, first, squared, to, count);
        System.arraycopy(from.clear, first, clear, to, count);
        System.arraycopy(from.scatterR, first, scatterR, to, count);
        System.arraycopy(from.scatterG, first, scatterG, to, count);
        System.arraycopy(from.scatterB, first, scatterB, to, count);
        System.arraycopy(from.fromLight, first, fromLight, to, count);
        System.arraycopy(from.fromEye, first, fromEye, to, count);
        System.arraycopy(from.lobeFromLight, first, lobeFromLight, to, count);
        System.arraycopy(from.lobeFromEye, first, lobeFromEye, to, count);
    }

    /** Takes over what belongs to the light of another path. */
    void copyLight(LightPath from) {
        light = from.light;
        infinite = from.infinite;
        deltaLight = from.deltaLight;
        nextEvent = from.nextEvent;
        emission.set(from.emission);
    }

    /** Takes over what belongs to the lens of another path. */
    void copyLens(LightPath from) {
        filmX = from.filmX;
        filmY = from.filmY;
        lensU = from.lensU;
        lensV = from.lensV;
        filmPerSolidAngle = from.filmPerSolidAngle;
    }

    /** Sets the direction and length of edge i from its ends. */
    void setEdge(int i) {
        SurfacePoint a = points[i];
        SurfacePoint b = points[i + 1];
        double x = b.x - a.x;
        double y = b.y - a.y;
        double z = b.z - a.z;
        double s = x * x + y * y + z * z;
        double inverse = 1 / Math.sqrt(s);
        dx[i] = x * inverse;
        dy[i] = y * inverse;
        dz[i] = z * inverse;
        squared[i] = s;
    }

    /** True if a path may join two subpaths at a vertex: it is an end, or scatters by no delta lobe. */
    boolean joins(int vertex) {
        return lobe[vertex] < 0;
    }

    /** Writes the path. */
    public void save(StateWriter out) {
        out.put(length);
        out.put(light);
        out.put((infinite ? 1 : 0) + (deltaLight ? 2 : 0));
        out.put(filmX);
        out.put(filmY);
        out.put(lensU);
        out.put(lensV);
        out.put(filmPerSolidAngle);
        out.put(nextEvent);
        save(emission, out);
        save(value, out);
        for (int i = 0; i < length; i++) {
            save(points[i], out);
            out.put(bsdfs[i] == NOTHING ? 0 : 1);
            out.put(lobe[i]);
            for (double[] array : arrays()) {
                out.put(array[i]);
            }
        }
    }

    /** Reads what {@link #save} has written. */
    public void load(StateReader in, Scene scene) {
        length = in.nextInt();
        reserve(length);
        light = in.nextInt();
        int flags = in.nextInt();
        infinite = (flags & 1) != 0;
        deltaLight = (flags & 2) != 0;
        filmX = in.nextDouble();
        filmY = in.nextDouble();
        lensU = in.nextDouble();
        lensV = in.nextDouble();
        filmPerSolidAngle = in.nextDouble();
        nextEvent = in.nextDouble();
        load(emission, in);
        load(value, in);
        contribution = value.luminance();
        for (int i = 0; i < length; i++) {
            load(points[i], in);
            bsdfs[i] = in.next() == 0 ? NOTHING : scene.bsdf(points[i].shape);
            connectable[i] = bsdfs[i].connectable();
            lobe[i] = in.nextInt();
            for (double[] array : arrays()) {
                array[i] = in.nextDouble();
            }
        }
    }

    private double[][] arrays() {
        return new double[][] {
            opacity,
            dx,
            dy,
            dz,
            squared,
            clear,
            scatterR,
            scatterG,
            scatterB,
            fromLight,
            fromEye,
            lobeFromLight,
            lobeFromEye
        };
    }

    private static void save(SurfacePoint p, StateWriter out) {
        out.put(p.x);
        out.put(p.y);
        out.put(p.z);
        out.put(p.gx);
        out.put(p.gy);
        out.put(p.gz);
        out.put(p.sx);
        out.put(p.sy);
        out.put(p.sz);
        out.put(p.tx);
        out.put(p.ty);
        out.put(p.tz);
        out.put(p.nx);
        out.put(p.ny);
        out.put(p.nz);
        out.put(p.u);
        out.put(p.v);
        out.put(p.uAlongS);
        out.put(p.uAlongT);
        out.put(p.vAlongS);
        out.put(p.vAlongT);
        out.put(p.u2);
        out.put(p.v2);
        out.put(p.colorR);
        out.put(p.colorG);
        out.put(p.colorB);
        out.put(p.offset);
        out.put(p.shape);
        out.put(p.primitive);
        out.put(p.instance);
    }

    private static void load(SurfacePoint p, StateReader in) {
        p.x = in.nextDouble();
        p.y = in.nextDouble();
        p.z = in.nextDouble();
        p.gx = in.nextDouble();
        p.gy = in.nextDouble();
        p.gz = in.nextDouble();
        p.sx = in.nextDouble();
        p.sy = in.nextDouble();
        p.sz = in.nextDouble();
        p.tx = in.nextDouble();
        p.ty = in.nextDouble();
        p.tz = in.nextDouble();
        p.nx = in.nextDouble();
        p.ny = in.nextDouble();
        p.nz = in.nextDouble();
        p.u = in.nextDouble();
        p.v = in.nextDouble();
        p.uAlongS = in.nextDouble();
        p.uAlongT = in.nextDouble();
        p.vAlongS = in.nextDouble();
        p.vAlongT = in.nextDouble();
        p.u2 = in.nextDouble();
        p.v2 = in.nextDouble();
        p.colorR = in.nextDouble();
        p.colorG = in.nextDouble();
        p.colorB = in.nextDouble();
        p.offset = in.nextDouble();
        p.shape = in.nextInt();
        p.primitive = in.nextInt();
        p.instance = in.nextInt();
    }

    private static void save(Spectrum spectrum, StateWriter out) {
        out.put(spectrum.r);
        out.put(spectrum.g);
        out.put(spectrum.b);
    }

    private static void load(Spectrum spectrum, StateReader in) {
        spectrum.set(in.nextDouble(), in.nextDouble(), in.nextDouble());
    }
}
