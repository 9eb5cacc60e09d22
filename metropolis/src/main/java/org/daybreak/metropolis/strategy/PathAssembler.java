package org.daybreak.metropolis.strategy;

import java.util.Arrays;
import org.daybreak.bidirectional.Contribution;
import org.daybreak.bidirectional.PathValues;
import org.daybreak.core.light.Light;
import org.daybreak.core.scene.Scene;

/**
 * Takes over paths that bidirectional path tracing has found, as the states that chains start from (Veach 1997,
 * §11.3.1). One object per worker.
 */
final class PathAssembler {
    private final Scene scene;
    private final LightEnd light;
    private final EdgeTracer edges;
    private final MeasurementContribution contribution;

    PathAssembler(Scene scene, LightEnd light, EdgeTracer edges, MeasurementContribution contribution) {
        this.scene = scene;
        this.light = light;
        this.edges = edges;
        this.contribution = contribution;
    }

    /**
     * Builds a path that bidirectional path tracing has found.
     *
     * @return false if it carries nothing after all, as rounding may have it
     */
    boolean assemble(Contribution found, LightPath y) {
        int s = found.lightVertices();
        int t = found.eyeVertices();
        int k = s + t - 1;
        y.length = k + 1;
        y.reserve(k + 1);
        Light emitter = scene.light(found.lightIndex());
        y.light = found.lightIndex();
        y.infinite = emitter.isInfinite();
        y.deltaLight = emitter.isDelta();
        y.filmX = found.filmX();
        y.filmY = found.filmY();
        y.lensU = found.lensU();
        y.lensV = found.lensV();
        PathValues subpath = found.light();
        boolean sampled = s == 1 && t >= 2;
        for (int i = 0; i < s; i++) {
            y.points[i].set(sampled ? found.lightSample().point : subpath.point(i));
            if (i > 0) {
                setVertex(y, i, subpath, i, i < s - 1);
            }
        }
        PathValues eye = found.eye();
        for (int j = 0; j < t; j++) {
            int i = k - j;
            y.points[i].set(t == 1 ? found.lens().point : eye.point(j));
            if (j > 0 && i > 0) {
                setVertex(y, i, eye, j, j < t - 1);
            }
        }
        light.settle(y);
        y.setEnd(k);
        if (y.infinite) {
            setFirstEdge(y, found, s, t, sampled);
        }
        for (int i = y.infinite ? 1 : 0; i < k; i++) {
            y.setEdge(i);
            // Rays start a little above surfaces: where one was traced, it is not quite the line from point to point.
            if (i + 1 < s) {
                setDirection(y, i, subpath, i + 1, -1);
            } else if (i >= s) {
                setDirection(y, i, eye, k - i, 1);
            }
        }
        Arrays.fill(y.clear, 0, k, 1);
        if (!contribution.measure(y, 0, k)) {
            return false;
        }
        if (scene.maybeTransparent()) {
            for (int i = 0; i < k; i++) {
                if (!edges.reveal(y, i)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Sets the direction of an edge from a light at infinity. */
    private static void setFirstEdge(LightPath y, Contribution found, int s, int t, boolean sampled) {
        y.squared[0] = Double.POSITIVE_INFINITY;
        if (sampled) {
            y.dx[0] = -found.lightSample().wiX;
            y.dy[0] = -found.lightSample().wiY;
            y.dz[0] = -found.lightSample().wiZ;
            return;
        }
        // The direction back from the vertex at infinity of an eye subpath is that of travel; that of a light subpath's
        // second vertex points to the light.
        if (s == 0) {
            setDirection(y, 0, found.eye(), t - 1, 1);
        } else {
            setDirection(y, 0, found.light(), 1, -1);
        }
    }

    /** Sets the direction of an edge from that back from a vertex of a subpath, or the opposite. */
    private static void setDirection(LightPath y, int edge, PathValues path, int vertex, int sign) {
        y.dx[edge] = sign * path.back(vertex, 0);
        y.dy[edge] = sign * path.back(vertex, 1);
        y.dz[edge] = sign * path.back(vertex, 2);
    }

    private void setVertex(LightPath y, int vertex, PathValues from, int index, boolean inner) {
        y.setVertex(vertex, from.bsdf(index), edges.opacity(from.point(index)));
        if (inner && from.isDelta(index)) {
            y.lobe[vertex] = from.lobe(index);
        }
    }
}
