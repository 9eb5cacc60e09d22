package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionDensity;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.EmissionGuide;

/**
 * The densities of a full path by every technique, from its geometry alone: slow, by the definitions, and with nothing of the
 * code that traces paths. Densities are per area, at infinity per solid angle; delta lobes count as {@link PathValues} says.
 */
final class PathRebuilder {
    private final FullPath path;
    private final Scene scene;
    private final Light light;
    private final EmissionGuide guide;
    private final boolean allLights;
    private final int splitting;
    private final int k;

    /** The first vertex from the lens that can be connected; k if there is none. */
    private final int fork;

    /** Whether paths can hit the lens. */
    final boolean lensHits;

    /** Density of x_i as sampled from x_{i−1}; of x₀ as the start of a light subpath; of the lens 0 if it cannot be hit. */
    final double[] fromLight;

    /** Density of x_i as sampled from x_{i+1}; of the lens 1 if it cannot be hit. */
    final double[] fromEye;

    /** Probability with which x₁ chooses the light, and with it the density of x₀ by next-event estimation. */
    double chosen;

    double incident;
    double nextEvent;

    /**
     * Computes all densities.
     *
     * @param guide how light subpaths leave the lights
     * @param allLights whether every light has its light subpath and light sample
     * @param lensHitsCount whether light paths that hit the lens count, if it has an area
     * @param splitting in how many ways eye subpaths go on from the first vertex that can be connected
     */
    PathRebuilder(FullPath path, EmissionGuide guide, boolean allLights, boolean lensHitsCount, int splitting) {
        this.path = path;
        this.guide = guide;
        scene = path.scene;
        light = scene.light(path.lightIndex);
        k = path.edgeCount();
        this.allLights = allLights;
        this.splitting = splitting;
        fork = fork();
        fromLight = new double[k + 1];
        fromEye = new double[k + 1];
        setEmission();
        setNextEvent();
        for (int i = 2; i < k; i++) {
            fromLight[i] = direction(i - 1, -1, TransportMode.IMPORTANCE) * toArea(i, i - 1);
        }
        CameraRay ray = new CameraRay();
        SurfacePoint lens = path.points[k];
        double[] last = path.edges[k - 1];
        assertTrue(
                path.camera.rayDensity(lens.x, lens.y, lens.z, -last[0], -last[1], -last[2], ray), "x_{k-1} is seen");
        lensHits = lensHitsCount && path.camera.hasLensArea();
        fromEye[k] = lensHits ? ray.densityPosition : 1;
        fromLight[k] = lensHits ? onLens() : 0;
        fromEye[k - 1] = fromFilm(ray);
        for (int i = k - 2; i >= 0; i--) {
            boolean missed = i == 0 && light.isDelta();
            fromEye[i] = missed ? 0 : direction(i + 1, 1, TransportMode.RADIANCE) * toArea(i, i);
        }
        if (fork < k && !bsdf(fork).maybeTransparent()) {
            fromEye[fork - 1] *= splitting;
        }
    }

    private int fork() {
        for (int i = k - 1; i > 0; i--) {
            if (bsdf(i).connectable()) {
                return i;
            }
        }
        return k;
    }

    FullPath path() {
        return path;
    }

    private void setEmission() {
        double[] e = path.edges[0];
        EmissionDensity emission = new EmissionDensity();
        guide.density(path.lightIndex, path.points[0], path.points[1], e[0], e[1], e[2], emission);
        double choice = allLights ? 1 : scene.lightSelection().emissionProbability(path.lightIndex);
        fromLight[0] = choice * (path.infinite ? emission.direction : emission.position);
        if (k == 1 && path.infinite && path.camera.isParallel()) {
            // All rays of the film have one direction: the film position is drawn instead.
            fromLight[0] = choice;
        }
        if (k > 1) {
            fromLight[1] = path.infinite
                    ? emission.position * cosine(1, 0)
                    : emission.direction * cosine(1, 0) / path.squares[0];
        }
    }

    private void setNextEvent() {
        if (k == 1) {
            nextEvent = fromLight[0];
            return;
        }
        SurfacePoint p = path.points[1];
        double[] e = path.edges[0];
        chosen = 1;
        if (!allLights) {
            boolean bothSides = bsdf(1).transmissive();
            double side = bothSides ? 0 : Math.signum(-(e[0] * p.nx + e[1] * p.ny + e[2] * p.nz));
            chosen = scene.lightSelection()
                    .probability(path.lightIndex, p.x, p.y, p.z, side * p.nx, side * p.ny, side * p.nz);
        }
        incident = light.isDelta() ? 1 : light.incidentDensity(p.x, p.y, p.z, path.points[0], -e[0], -e[1], -e[2]);
        nextEvent = chosen * incident * (light.isDelta() ? 1 : toArea(0, 0));
    }

    /** Density of the lens as sampled from x_{k−1}. */
    private double onLens() {
        if (k > 1) {
            return direction(k - 1, -1, TransportMode.IMPORTANCE) * toArea(k, k - 1);
        }
        double[] e = path.edges[0];
        EmissionDensity emission = new EmissionDensity();
        guide.density(path.lightIndex, path.points[0], path.points[1], e[0], e[1], e[2], emission);
        return path.infinite ? emission.position * cosine(1, 0) : emission.direction * toArea(1, 0);
    }

    /** Density of x_{k−1} as sampled from a film point that is uniform over the film. */
    private double fromFilm(CameraRay ray) {
        double[] e = path.edges[k - 1];
        boolean infinite = k == 1 && path.infinite;
        if (!path.camera.isParallel()) {
            return ray.densityDirection * (infinite ? 1 : cosine(k - 1, k - 1) / path.squares[k - 1]);
        }
        if (infinite) {
            return 1;
        }
        LensSample sample = new LensSample();
        SurfacePoint p = path.points[k - 1];
        assertTrue(path.camera.sampleLens(p.x, p.y, p.z, 0.5, 0.5, sample), "the camera sees x_{k-1}");
        return ray.densityPosition / Math.abs(dot(sample.point, e)) * cosine(k - 1, k - 1);
    }

    /**
     * Density per solid angle with which a walk goes on at a vertex.
     *
     * @param step −1 if it comes from the light, 1 if from the lens
     */
    private double direction(int vertex, int step, TransportMode mode) {
        double[] before = path.edges[vertex - 1];
        double[] after = path.edges[vertex];
        double[] wo = step < 0 ? new double[] {-before[0], -before[1], -before[2]} : after;
        double[] wi = step < 0 ? after : new double[] {-before[0], -before[1], -before[2]};
        SurfacePoint p = path.points[vertex];
        if (path.delta[vertex]) {
            return Math.abs(p.localZ(wi[0], wi[1], wi[2])) / eta(bsdf(vertex), p, wo, wi, mode);
        }
        return Scattering.density(bsdf(vertex), p, wo[0], wo[1], wo[2], wi[0], wi[1], wi[2], mode);
    }

    /** Ratio of the refractive indices of the delta lobe that leads from wo to wi. */
    private static double eta(Bsdf bsdf, SurfacePoint p, double[] wo, double[] wi, TransportMode mode) {
        BsdfSample sample = new BsdfSample();
        double best = 0.999;
        double eta = 0;
        int steps = 256;
        for (int i = 0; i < steps && best < 1 - 1e-12; i++) {
            double w = (i + 0.5) / steps;
            if (Scattering.sample(bsdf, p, wo[0], wo[1], wo[2], 0.5, 0.5, w, mode, sample)
                    && sample.delta
                    && !sample.passThrough) {
                double near = sample.wiX * wi[0] + sample.wiY * wi[1] + sample.wiZ * wi[2];
                if (near > best) {
                    best = near;
                    eta = sample.eta;
                }
            }
        }
        return eta;
    }

    private Bsdf bsdf(int vertex) {
        return scene.bsdf(path.points[vertex].shape);
    }

    /** Cosine at a vertex with one of its edges. */
    private double cosine(int vertex, int edge) {
        return Math.abs(dot(path.points[vertex], path.edges[edge]));
    }

    private static double dot(SurfacePoint p, double[] e) {
        return p.geometricCosine(e[0], e[1], e[2]);
    }

    /** Factor from a density per solid angle over an edge to that of a vertex at its end. */
    private double toArea(int vertex, int edge) {
        return vertex == 0 && path.infinite ? 1 : cosine(vertex, edge) / path.squares[edge];
    }

    /** Logarithm of the density of the whole path by technique s; −∞ for 0. */
    double logDensity(int s) {
        double sum = Math.log(s == 0 ? fromEye[0] : s == 1 ? nextEvent : fromLight[0]);
        for (int i = 1; i <= k; i++) {
            sum += Math.log(i < s ? fromLight[i] : fromEye[i]);
        }
        return sum;
    }

    /** Whether technique s can make the path at all: limits of depth are not asked. */
    boolean possible(int s, boolean lens) {
        if (s == k + 1) {
            return lensHits;
        }
        return s == 0 ? !light.isDelta() : path.joinable(s) && (s < k || lens);
    }

    /** Whether this is a light that the lens sees directly: joined to it only if eye subpaths cannot meet it. */
    boolean isDirectView() {
        return k == 1;
    }

    /**
     * The weight of technique s asked from the program.
     *
     * @param share as how many samples one of t = 1 counts; 0 without that technique
     */
    double weight(ComplementTracer complement, int s, double exponent, double share) {
        int t = k + 1 - s;
        if (t <= 1) {
            return weightAtLens(complement, s, exponent);
        }
        double[] e = s == 0 ? new double[3] : path.edges[s - 1];
        PathValues eye = eyePath(t, exponent, share);
        if (s == 0) {
            return complement.met(eye, t, path.lightIndex);
        }
        if (s == 1) {
            LightSample sample = new LightSample();
            sample.point.set(path.points[0]);
            sample.wiX = -e[0];
            sample.wiY = -e[1];
            sample.wiZ = -e[2];
            sample.distance = Math.sqrt(path.squares[0]);
            sample.delta = light.isDelta();
            sample.density = incident;
            return complement.lightSample(
                    eye, t, path.lightIndex, sample, chosen, direction(1, 1, TransportMode.RADIANCE));
        }
        return complement.connection(
                lightPath(s, exponent),
                s,
                eye,
                t,
                e[0],
                e[1],
                e[2],
                path.squares[s - 1],
                direction(s - 1, -1, TransportMode.IMPORTANCE),
                direction(s, 1, TransportMode.RADIANCE));
    }

    private double weightAtLens(ComplementTracer complement, int s, double exponent) {
        double[] e = path.edges[k - 1];
        LensSample lens = new LensSample();
        lens.point.set(path.points[k]);
        lens.wiX = e[0];
        lens.wiY = e[1];
        lens.wiZ = e[2];
        lens.densityPosition = fromEye[k];
        lens.density = fromEye[k] / toArea(k, k - 1);
        if (s == 1) {
            return complement.emitterAtLens(path.lightIndex, path.points[0], lens, fromLight[0], fromEye[0]);
        }
        if (s == k) {
            double density = lensHits ? direction(k - 1, -1, TransportMode.IMPORTANCE) : 0;
            return complement.lens(lightPath(s, exponent), s, lens, fromEye[k - 1], density);
        }
        PathValues values = lightPath(k, exponent);
        if (fork < k && !bsdf(fork).maybeTransparent()) {
            // A light subpath does not know where the eye subpath would split.
            values.reverse[fork - 1] /= splitting;
        }
        return complement.lensHit(values, lens, fromLight[k], fromEye[k - 1]);
    }

    /** The first vertices of the path as a light subpath. */
    PathValues lightPath(int s, double exponent) {
        PathValues values = new PathValues();
        values.reserve(s);
        values.setLength(s);
        values.infinite = path.infinite;
        values.deltaLight = light.isDelta();
        values.nextEventRatio = k > 1 && bsdf(1).connectable() ? nextEvent / fromLight[0] : 0;
        for (int i = 0; i < s; i++) {
            values.points[i].set(path.points[i]);
            values.forward[i] = fromLight[i];
            values.reverse[i] = fromEye[i];
            values.delta[i] = path.delta[i];
            values.light[i] = i == 0 ? path.lightIndex : scene.lightOf(path.points[i].shape);
            values.tail[i] = lightTail(i, exponent);
            if (i > 0) {
                values.bsdfs[i] = bsdf(i);
                values.connectable[i] = bsdf(i).connectable();
                values.backX[i] = -path.edges[i - 1][0];
                values.backY[i] = -path.edges[i - 1][1];
                values.backZ[i] = -path.edges[i - 1][2];
                values.toPrevious[i] = i == 1 && light.isDelta() ? 0 : toArea(i - 1, i - 1);
            }
        }
        return values;
    }

    /** The last vertices of the path as an eye subpath. */
    PathValues eyePath(int t, double exponent, double share) {
        PathValues values = new PathValues();
        values.reserve(t);
        values.setLength(t);
        values.infinite = t == k + 1 && path.infinite;
        values.fork = fork < k && k - fork < t ? k - fork : 0;
        for (int j = 0; j < t; j++) {
            int i = k - j;
            values.points[j].set(path.points[i]);
            values.forward[j] = fromEye[i];
            values.reverse[j] = fromLight[i];
            values.delta[j] = path.delta[i];
            values.light[j] = i == 0 ? path.lightIndex : -1;
            values.tail[j] = eyeTail(j, exponent, share);
            if (j > 0) {
                values.backX[j] = path.edges[i][0];
                values.backY[j] = path.edges[i][1];
                values.backZ[j] = path.edges[i][2];
                values.toPrevious[j] = j == 1 && !lensHits ? 0 : toArea(i + 1, i);
                if (i > 0) {
                    values.bsdfs[j] = bsdf(i);
                    values.connectable[j] = bsdf(i).connectable();
                }
            }
        }
        return values;
    }

    /** Σ over techniques that connect before x_i, or before that, of their density relative to the one before x_i. */
    private double lightTail(int i, double exponent) {
        double sum = 0;
        for (int s = 0; s <= i; s++) {
            if (s == 0 ? light.isDelta() : !path.joinable(s)) {
                continue;
            }
            double ratio = s == 0 ? fromEye[0] / fromLight[0] : s == 1 ? nextEvent / fromLight[0] : 1;
            if (i == 0) {
                ratio = 1;
            }
            for (int m = Math.max(s, 1); m < i; m++) {
                ratio *= fromEye[m] / fromLight[m];
            }
            sum += Math.pow(ratio, exponent);
        }
        return sum;
    }

    /** Σ over techniques that connect before z_j, or before that, as seen from the lens. */
    private double eyeTail(int j, double exponent, double share) {
        double sum = 0;
        for (int t = 0; t <= j; t++) {
            if (t == 0 ? !lensHits : (t == 1 && share == 0) || !path.joinable(k + 1 - t)) {
                continue;
            }
            double ratio = t == 1 ? share : 1;
            for (int m = t; m < j; m++) {
                ratio *= fromLight[k - m] / fromEye[k - m];
            }
            sum += Math.pow(ratio, exponent);
        }
        return sum;
    }
}
