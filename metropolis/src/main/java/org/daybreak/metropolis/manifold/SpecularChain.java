package org.daybreak.metropolis.manifold;

import java.util.Arrays;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.TransportMode;

/**
 * Vertices that scatter in delta lobes, between two ends. A structure of arrays, owned by one worker; it grows when a longer chain comes
 * along. The caller sets the ends, {@link #mode}, {@link #setLength}, {@link #points} and {@link #lobes}; the rest follows from
 * {@link SpecularManifold#follow}.
 */
public final class SpecularChain {
    /** x_a, where rays start. */
    public final ChainEnd start = new ChainEnd();

    /** x_b. */
    public final ChainEnd end = new ChainEnd();

    /** The vertices between the ends, from the start on. */
    public SurfacePoint[] points = new SurfacePoint[0];

    /** The delta lobe of each vertex ({@code Bsdf.deltaLobe}). */
    public int[] lobes = new int[0];

    /** What the chain carries when followed from its start. */
    public TransportMode mode = TransportMode.RADIANCE;

    /** Product of what the lobes reflect or transmit, in {@link #mode}. */
    public final Spectrum throughput = new Spectrum();

    /** Refractive index on the side of the vertex before over that on the side of the next one. */
    double[] eta = new double[0];

    /** True if a vertex sends to the other side of the surface. */
    boolean[] transmits = new boolean[0];

    /** Unit direction in which the lobe of the last vertex leads. */
    double lastX;

    double lastY;
    double lastZ;

    private int length;

    /** Creates a chain without vertices. */
    public SpecularChain() {}

    /** Number of vertices between the ends. */
    public int length() {
        return length;
    }

    /** Sets the number of vertices between the ends and makes room for them. */
    public void setLength(int vertices) {
        length = vertices;
        int old = points.length;
        if (vertices <= old) {
            return;
        }
        int capacity = Math.max(vertices, 2 * old);
        points = Arrays.copyOf(points, capacity);
        for (int i = old; i < capacity; i++) {
            points[i] = new SurfacePoint();
        }
        lobes = Arrays.copyOf(lobes, capacity);
        eta = Arrays.copyOf(eta, capacity);
        transmits = Arrays.copyOf(transmits, capacity);
    }

    /** Takes over another chain. */
    public void set(SpecularChain o) {
        setLength(o.length);
        start.set(o.start);
        end.set(o.end);
        mode = o.mode;
        throughput.set(o.throughput);
        lastX = o.lastX;
        lastY = o.lastY;
        lastZ = o.lastZ;
        for (int i = 0; i < length; i++) {
            points[i].set(o.points[i]);
        }
        System.arraycopy(o.lobes, 0, lobes, 0, length);
        System.arraycopy(o.eta, 0, eta, 0, length);
        System.arraycopy(o.transmits, 0, transmits, 0, length);
    }
}
