package org.daybreak.metropolis.strategy;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Frame;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Steps of a random walk over the vertices of a {@link LightPath}, from the light or from the lens: samples the
 * material at a vertex, or follows a delta lobe that is given, and traces to the next one. One object per worker.
 */
final class RandomWalk {
    /** Scattering at a mask that covers little is drawn again until it scatters; beyond this it counts as missed. */
    private static final int LARGEST_REPEATS = 1000;

    private final Scene scene;
    private final EdgeTracer edges;
    private final Failure failure;
    private final BsdfSample scattered = new BsdfSample();
    private final Frame frame = new Frame();

    /** Direction that was sampled last. */
    private double wx;

    private double wy;
    private double wz;

    RandomWalk(Scene scene, EdgeTracer edges, Failure failure) {
        this.scene = scene;
        this.edges = edges;
        this.failure = failure;
    }

    /**
     * Samples the material at a vertex for the next one: towards the lens on its way from the light, or towards the
     * light on its way from the lens. Sets the vertex's delta lobe, and the direction to go.
     *
     * @param towardsLight whether the walk comes from the lens
     */
    boolean scatter(LightPath y, int vertex, boolean towardsLight, RandomStream random) {
        SurfacePoint p = y.points[vertex];
        Bsdf bsdf = y.bsdfs[vertex];
        double woX = towardsLight ? y.dx[vertex] : -y.dx[vertex - 1];
        double woY = towardsLight ? y.dy[vertex] : -y.dy[vertex - 1];
        double woZ = towardsLight ? y.dz[vertex] : -y.dz[vertex - 1];
        TransportMode mode = towardsLight ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
        int repeats = 0;
        do {
            double u = random.nextDouble();
            double v = random.nextDouble();
            double w = random.nextDouble();
            if (++repeats > LARGEST_REPEATS || !Scattering.sample(bsdf, p, woX, woY, woZ, u, v, w, mode, scattered)) {
                return failure.because(Outcome.BLACK);
            }
        } while (scattered.passThrough);
        y.lobe[vertex] = scattered.delta ? scattered.lobe : -1;
        setDirection(scattered.wiX, scattered.wiY, scattered.wiZ);
        return true;
    }

    /** Follows the delta lobe that is set at a vertex; {@link #scatter} otherwise. */
    boolean follow(LightPath y, int vertex, boolean towardsLight) {
        SurfacePoint p = y.points[vertex];
        double woX = towardsLight ? y.dx[vertex] : -y.dx[vertex - 1];
        double woY = towardsLight ? y.dy[vertex] : -y.dy[vertex - 1];
        double woZ = towardsLight ? y.dz[vertex] : -y.dz[vertex - 1];
        TransportMode mode = towardsLight ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
        if (!Scattering.deltaLobe(y.bsdfs[vertex], p, woX, woY, woZ, y.lobe[vertex], mode, scattered)) {
            return failure.because(Outcome.KIND_CHANGED);
        }
        setDirection(scattered.wiX, scattered.wiY, scattered.wiZ);
        return true;
    }

    /**
     * Chooses whether a walk from the lens goes on by a delta lobe at a vertex, with the probabilities that the
     * material samples them with, and by which.
     *
     * @return false if it chooses none
     */
    boolean chooseLobe(LightPath y, int vertex, RandomStream random) {
        Bsdf bsdf = y.bsdfs[vertex];
        int lobes = bsdf.deltaLobes();
        y.lobe[vertex] = -1;
        if (lobes == 0) {
            return false;
        }
        double left = random.nextDouble() * y.opacity[vertex];
        for (int i = 0; i < lobes; i++) {
            left -= lobeProbability(y, vertex, bsdf, i);
            if (left < 0) {
                y.lobe[vertex] = i;
                return true;
            }
        }
        return false;
    }

    /** Probability with which {@link #chooseLobe} chooses none at a vertex of a path. */
    double stopProbability(LightPath y, int vertex) {
        if (vertex == 0 && y.infinite) {
            return 1;
        }
        Bsdf bsdf = scene.bsdf(y.points[vertex].shape);
        double sum = 0;
        for (int i = bsdf.deltaLobes() - 1; i >= 0; i--) {
            sum += lobeProbability(y, vertex, bsdf, i);
        }
        // A hole, at which no walk stops, has neither lobes nor opacity.
        return sum == 0 ? 1 : 1 - sum / y.opacity[vertex];
    }

    private double lobeProbability(LightPath y, int vertex, Bsdf bsdf, int lobe) {
        boolean there = Scattering.deltaLobe(
                bsdf,
                y.points[vertex],
                y.dx[vertex],
                y.dy[vertex],
                y.dz[vertex],
                lobe,
                TransportMode.RADIANCE,
                scattered);
        return there ? scattered.density : 0;
    }

    /** Sets the direction that the next vertex is traced along. */
    void setDirection(double x, double y, double z) {
        wx = x;
        wy = y;
        wz = z;
    }

    /** Room for the axes about a direction. */
    Frame frame() {
        return frame;
    }

    /** Traces along the direction that was set, from a vertex to the next one towards the lens. */
    boolean traceToEye(LightPath y, int vertex, RandomStream random) {
        y.dx[vertex] = wx;
        y.dy[vertex] = wy;
        y.dz[vertex] = wz;
        return edges.trace(y, vertex, vertex + 1, RayKind.SCATTERED, random);
    }

    /**
     * Traces along the direction that was set, from a vertex to the next one towards the light, which may lie at
     * infinity.
     */
    boolean traceToLight(LightPath y, int vertex, RandomStream random) {
        y.dx[vertex - 1] = -wx;
        y.dy[vertex - 1] = -wy;
        y.dz[vertex - 1] = -wz;
        return edges.trace(y, vertex, vertex - 1, RayKind.SCATTERED, random);
    }
}
