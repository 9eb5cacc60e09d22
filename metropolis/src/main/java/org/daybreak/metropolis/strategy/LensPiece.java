package org.daybreak.metropolis.strategy;

import org.daybreak.antialiasing.MetropolisAntiAliaser;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.metropolis.chains.Outcome;

/** What moves share that make the end of a path at the lens anew and keep its delta lobes: pure functions. */
final class LensPiece {
    private LensPiece() {}

    /** The first vertex from the lens that does not scatter by a delta lobe; 0 if that is the light. */
    static int diffuse(LightPath x) {
        return nextDiffuse(x, x.length - 1);
    }

    /** The first vertex on the way from a vertex to the light that does not scatter by a delta lobe. */
    static int nextDiffuse(LightPath x, int vertex) {
        int i = vertex - 1;
        while (i > 0 && !x.joins(i)) {
            i--;
        }
        return i;
    }

    /**
     * Moves the image point and follows the delta lobes to the first other vertex, with random numbers for alpha masks.
     *
     * @param y receives the lens and the vertices up to that one
     */
    static boolean perturbFilm(
            LightPath x, LightPath y, double smallest, double largest, PathBuilder builder, RandomStream random) {
        double r = MetropolisAntiAliaser.distance(smallest, largest, random.nextDouble());
        double phi = 2 * Math.PI * random.nextDouble();
        double filmX = x.filmX + r * Math.cos(phi);
        double filmY = x.filmY + r * Math.sin(phi);
        int k = x.length - 1;
        y.length = x.length;
        y.reserve(y.length);
        y.copyLens(x);
        boolean inside = filmX >= 0
                && filmY >= 0
                && filmX < builder.camera().width()
                && filmY < builder.camera().height();
        if (!inside) {
            return builder.fail(Outcome.OFF_FILM);
        }
        int d = diffuse(x);
        boolean met = builder.lens().look(y, k, filmX, filmY, random);
        return follow(x, y, k - 1, d, met, builder, random);
    }

    /**
     * Follows the delta lobes of a path from a vertex that a ray has just been traced to.
     *
     * @param at the vertex
     * @param to the vertex to reach
     * @param met whether the ray has met a surface
     */
    static boolean follow(
            LightPath x, LightPath y, int at, int to, boolean met, PathBuilder builder, RandomStream random) {
        int i = at;
        boolean found = met;
        while (found && i > to) {
            y.lobe[i] = x.lobe[i];
            found = builder.walk().follow(y, i, true) && builder.walk().traceToLight(y, i, random);
            i--;
        }
        if (to > 0) {
            return found && (y.bsdfs[to].connectable() || builder.fail(Outcome.KIND_CHANGED));
        }
        if (i > 0 || (!found && !builder.escaped())) {
            return false;
        }
        return builder.light().land(y, found, random);
    }

    /** Joins a vertex that was made anew to what stays on the side of the light, and evaluates the path. */
    static boolean join(LightPath x, LightPath y, int vertex, PathBuilder builder) {
        if (vertex == 0) {
            return builder.contribution().measure(y, 0, y.length);
        }
        y.copy(x, 0, vertex, 0);
        y.copyLight(x);
        y.clear[vertex - 1] = 1;
        if (vertex == 1 && y.infinite) {
            y.squared[0] = Double.POSITIVE_INFINITY;
        } else {
            y.setEdge(vertex - 1);
        }
        return builder.contribution().measure(y, vertex - 1, y.length)
                && builder.edges().reveal(y, vertex - 1);
    }

    /**
     * Density of the vertices from one up to another, given the film position or the direction that the first of them is found by, with
     * delta lobes that are not chosen.
     *
     * @param end the vertex after the last one; the number of vertices for the lens, whose density is 1
     */
    static double density(LightPath y, int end, int first) {
        double density = 1;
        for (int i = Math.min(end - 1, y.length - 2); i >= first; i--) {
            density *= y.fromEye[i] * y.clear[i] * y.opacity[i];
        }
        return density;
    }
}
