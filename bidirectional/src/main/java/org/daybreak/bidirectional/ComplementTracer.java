package org.daybreak.bidirectional;

import org.daybreak.core.camera.LensSample;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Densities;
import org.daybreak.core.scene.Scene;

/**
 * Fills in, for the vertices next to the edge that joins two subpaths, the densities of the other direction (the thesis' class of
 * that name), and weights the full path with them. One object per worker.
 *
 * <p>With the edge y_{s−1} z_{t−1} there are four: those of y_{s−1} and y_{s−2} as sampled from the eye, and of z_{t−1} and z_{t−2}
 * as sampled from the light. All others the subpaths have in themselves.
 */
final class ComplementTracer {
    private static final PathValues NONE = new PathValues();

    /** Products of single ratios to a higher power would leave the range of doubles, and 0 times infinity is no weight. */
    private static final double LARGEST_CHAINED = 4;

    private final Scene scene;
    private final LightDensities lights;
    private final TechniqueLimits limits;
    private final double exponent;
    private final int splitting;
    private final double lensTerm;
    private final CombinedPathValues combined = new CombinedPathValues();

    private PathValues light = NONE;
    private int s;
    private PathValues eye = NONE;
    private int t;

    /** Density of y_{s−1} as sampled from the eye subpath's end; for s = 1 of the point on the light, for s = 0 unused. */
    private double lightEnd;

    /** Density of y_{s−2} as sampled from y_{s−1}, coming from the eye subpath's end. */
    private double lightBefore;

    /**
     * Density of z_{t−1} as sampled from the light subpath's end; for s = 0 as the start of a light subpath. For t ≤ 1 that of the
     * lens, 0 if it cannot be hit.
     */
    private double eyeEnd;

    /** Density of z_{t−2} as sampled from z_{t−1}, coming from the light subpath's end. */
    private double eyeBefore;

    /** Density of the lens as sampled from the lens; for t ≤ 1. */
    private double onLens;

    /** Densities of the point on the light as the start of a light subpath, and by next-event estimation. */
    private double first;

    private double nextEvent;
    private boolean hittable;

    ComplementTracer(Scene scene, LightDensities lights, TechniqueLimits limits, double exponent, int splitting) {
        this.scene = scene;
        this.lights = lights;
        this.limits = limits;
        this.exponent = exponent;
        this.splitting = splitting;
        lensTerm = limits.lensTerm(exponent);
    }

    /**
     * Weight of an edge between two subpaths, s ≥ 2 and t ≥ 2.
     *
     * @param dx unit direction from y_{s−1} to z_{t−1}
     * @param squared squared length of the edge
     * @param densityFromLight density per solid angle with which y_{s−1} scatters along it
     * @param densityFromEye density per solid angle with which z_{t−1} scatters against it
     */
    double connection(
            PathValues lightPath,
            int lightVertices,
            PathValues eyePath,
            int eyeVertices,
            double dx,
            double dy,
            double dz,
            double squared,
            double densityFromLight,
            double densityFromEye) {
        join(lightPath, lightVertices, eyePath, eyeVertices);
        int e = lightVertices - 1;
        int f = eyeVertices - 1;
        SurfacePoint y = lightPath.points[e];
        SurfacePoint z = eyePath.points[f];
        lightEnd = samples(eyePath, f)
                * Densities.solidAngleToArea(densityFromEye, squared, y.geometricCosine(dx, dy, dz));
        eyeEnd = Densities.solidAngleToArea(densityFromLight, squared, z.geometricCosine(dx, dy, dz));
        lightBefore = densityBefore(lightPath, e, dx, dy, dz, TransportMode.RADIANCE);
        eyeBefore = densityBefore(eyePath, f, -dx, -dy, -dz, TransportMode.IMPORTANCE);
        return weight();
    }

    /**
     * Weight of an edge from a light subpath to the lens: t = 1, s ≥ 2.
     *
     * @param lens point of the lens
     * @param filmDensity density per area of y_{s−1} as sampled from the film
     * @param densityFromLight density per solid angle with which y_{s−1} scatters towards the lens
     */
    double lens(PathValues lightPath, int lightVertices, LensSample lens, double filmDensity, double densityFromLight) {
        join(lightPath, lightVertices, NONE, 1);
        int e = lightVertices - 1;
        lightEnd = filmDensity;
        lightBefore = samples(lightPath.bsdfs[e])
                * densityBefore(lightPath, e, lens.wiX, lens.wiY, lens.wiZ, TransportMode.RADIANCE);
        onLens = lens.densityPosition;
        eyeEnd = limits.lensHits() ? densityFromLight / lens.density * onLens : 0;
        eyeBefore = 0;
        return weight();
    }

    /**
     * Weight of a light that the lens sees directly, joined to it: t = 1, s = 1.
     *
     * @param index the light
     * @param onLight the point; of lights at infinity nothing but the direction counts
     * @param lens point of the lens
     * @param density density of the point on the light, or of the direction to a light at infinity
     * @param filmDensity the same as sampled from the film
     */
    double emitterAtLens(int index, SurfacePoint onLight, LensSample lens, double density, double filmDensity) {
        join(NONE, 1, NONE, 1);
        lightEnd = filmDensity;
        onLens = lens.densityPosition;
        eyeEnd = 0;
        if (limits.lensHits()) {
            lights.set(index, onLight, lens.point, -lens.wiX, -lens.wiY, -lens.wiZ, 1, 1);
            eyeEnd = lights.second;
        }
        first = density;
        nextEvent = density;
        hittable = true;
        return weight();
    }

    /**
     * Weight of a light subpath whose next ray hits the lens: t = 0.
     *
     * @param lens the point of the lens
     * @param density density per area with which the subpath samples it
     * @param filmDensity density of the subpath's end as sampled from the film
     */
    double lensHit(PathValues lightPath, LensSample lens, double density, double filmDensity) {
        join(lightPath, lightPath.length() + 1, NONE, 0);
        onLens = lens.densityPosition;
        lightEnd = onLens;
        lightBefore = filmDensity;
        eyeEnd = density;
        eyeBefore = 0;
        // Rare enough for the form that walks over the path, as the sums of light subpaths do not know where eye
        // subpaths would split.
        return MisWeight.weight(combine(), s, limits, exponent);
    }

    /**
     * Weight of a light sample at the end of an eye subpath (next-event estimation): s = 1, t ≥ 2.
     *
     * @param index the light
     * @param chosen probability with which it was chosen
     * @param densityFromEye density per solid angle with which z_{t−1} scatters towards the light
     */
    double lightSample(
            PathValues eyePath, int eyeVertices, int index, LightSample sample, double chosen, double densityFromEye) {
        join(NONE, 1, eyePath, eyeVertices);
        int f = eyeVertices - 1;
        SurfacePoint z = eyePath.points[f];
        lights.set(index, sample.point, z, sample.wiX, sample.wiY, sample.wiZ, chosen, sample.density);
        Light l = scene.light(index);
        hittable = !l.isDelta();
        double samples = samples(eyePath, f);
        if (!hittable) {
            lightEnd = 0;
        } else if (l.isInfinite()) {
            lightEnd = samples * densityFromEye;
        } else {
            double cosine = sample.point.geometricCosine(sample.wiX, sample.wiY, sample.wiZ);
            lightEnd = samples * Densities.solidAngleToArea(densityFromEye, sample.distance * sample.distance, cosine);
        }
        first = lights.first;
        nextEvent = lights.nextEvent;
        eyeEnd = lights.second;
        eyeBefore = densityBefore(eyePath, f, sample.wiX, sample.wiY, sample.wiZ, TransportMode.IMPORTANCE);
        return weight();
    }

    /**
     * Weight of an eye subpath that has met a light: s = 0, t ≥ 2.
     *
     * @param index the light
     */
    double met(PathValues eyePath, int eyeVertices, int index) {
        join(NONE, 0, eyePath, eyeVertices);
        int f = eyeVertices - 1;
        SurfacePoint onLight = eyePath.points[f];
        double wiX = -eyePath.backX[f];
        double wiY = -eyePath.backY[f];
        double wiZ = -eyePath.backZ[f];
        SurfacePoint from = eyePath.points[f - 1];
        hittable = true;
        if (f == 1) {
            lights.set(index, onLight, from, wiX, wiY, wiZ, 1, 1);
            first = eyePath.infinite && limits.parallelFilm() ? lights.emissionChoice(index) : lights.first;
            nextEvent = first;
            eyeEnd = first;
            eyeBefore = limits.lensHits() ? lights.second : 0;
            return weight();
        }
        double chosen = 0;
        double incident = 0;
        if (!eyePath.delta[f - 1]) {
            chosen = lights.choice(
                    index,
                    from,
                    eyePath.bsdfs[f - 1],
                    eyePath.backX[f - 1],
                    eyePath.backY[f - 1],
                    eyePath.backZ[f - 1]);
            incident = scene.light(index).incidentDensity(from.x, from.y, from.z, onLight, wiX, wiY, wiZ);
        }
        lights.set(index, onLight, from, wiX, wiY, wiZ, chosen, incident);
        first = lights.first;
        nextEvent = lights.nextEvent;
        eyeEnd = first;
        eyeBefore = lights.second;
        return weight();
    }

    /** In how many ways the eye subpath would go on from one of its vertices. */
    private int samples(PathValues eyePath, int vertex) {
        return vertex == eyePath.fork ? samples(eyePath.bsdfs[vertex]) : 1;
    }

    /** The same for the material of the first vertex from the lens that can be connected. */
    private int samples(Bsdf bsdf) {
        return bsdf.maybeTransparent() ? 1 : splitting;
    }

    private void join(PathValues lightPath, int lightVertices, PathValues eyePath, int eyeVertices) {
        light = lightPath;
        s = lightVertices;
        eye = eyePath;
        t = eyeVertices;
    }

    /** Density of the vertex before as sampled from a vertex, coming along a direction that points away from it. */
    private static double densityBefore(
            PathValues path, int vertex, double woX, double woY, double woZ, TransportMode mode) {
        double factor = path.toPrevious[vertex];
        return factor == 0
                ? 0
                : factor
                        * Scattering.density(
                                path.bsdfs[vertex],
                                path.points[vertex],
                                woX,
                                woY,
                                woZ,
                                path.backX[vertex],
                                path.backY[vertex],
                                path.backZ[vertex],
                                mode);
    }

    private double weight() {
        return exponent <= LARGEST_CHAINED && limits.leaveAll(s + t)
                ? chainedWeight()
                : MisWeight.weight(combine(), s, limits, exponent);
    }

    /** The weight by {@link MisWeight#chain}, for configurations whose limits of depth leave all techniques of the path. */
    double chainedWeight() {
        // All others are relative to the density of the technique in hand.
        double own = t == 1 ? lensTerm : 1;
        double sum = own;
        if (s >= 2) {
            int e = s - 1;
            double admissible = e == 1 ? power(light.nextEventRatio) : light.delta[e - 1] ? 0 : 1;
            sum += MisWeight.chain(
                    power(lightEnd / light.forward[e]),
                    admissible,
                    power(lightBefore / light.forward[e - 1]),
                    light.tail[e - 1]);
            sum += t >= 2 ? eyeChain(power(eyeEnd / eye.forward[t - 1])) : power(eyeEnd / onLens);
        } else if (s == 1) {
            sum += hittable ? power(lightEnd / nextEvent) : 0;
            sum += power(first / nextEvent)
                    * (t >= 2 ? eyeChain(power(eyeEnd / eye.forward[t - 1])) : power(eyeEnd / onLens));
        } else {
            double met = eye.forward[t - 1];
            if (t == 2) {
                sum += limits.emitterAtLens() ? power(first / met) : 0;
            } else {
                sum += eye.delta[t - 2] ? 0 : power(nextEvent / met);
            }
            sum += power(first / met) * power(eyeBefore / eye.forward[t - 2]) * eye.tail[t - 2];
        }
        return own / sum;
    }

    /** Σ over the techniques with fewer vertices from the eye, relative to one with z_{t−1} joined to the light side. */
    private double eyeChain(double ratio) {
        int f = t - 1;
        double admissible = f == 1 ? lensTerm : eye.delta[f - 1] ? 0 : 1;
        return MisWeight.chain(ratio, admissible, power(eyeBefore / eye.forward[f - 1]), eye.tail[f - 1]);
    }

    private double power(double ratio) {
        return MisWeight.power(ratio, exponent);
    }

    /** The full path in hand. */
    CombinedPathValues combine() {
        CombinedPathValues path = combined;
        int k = s + t - 1;
        path.setLength(k + 1);
        path.hittable = s >= 2 ? !light.deltaLight : hittable;
        for (int i = 0; i < s; i++) {
            path.fromLight[i] = s == 1 ? first : i == k && t == 0 ? eyeEnd : light.forward[i];
            path.fromEye[i] = i == s - 1 ? lightEnd : i == s - 2 ? lightBefore : light.reverse[i];
            path.delta[i] = i < s - 1 && light.delta[i];
        }
        for (int j = 0; j < t; j++) {
            int i = k - j;
            path.fromEye[i] = t == 1 ? onLens : eye.forward[j];
            path.fromLight[i] = j == t - 1 ? eyeEnd : j == t - 2 ? eyeBefore : eye.reverse[j];
            path.delta[i] = j > 0 && j < t - 1 && eye.delta[j];
        }
        path.nextEvent = s >= 2 ? light.nextEventRatio * light.forward[0] : nextEvent;
        if (t == 0) {
            complete(path, k);
        }
        return path;
    }

    /** What a light subpath that hits the lens does not know of the techniques with few vertices from the light. */
    private void complete(CombinedPathValues path, int k) {
        if (k == 1) {
            path.nextEvent = light.forward[0];
            return;
        }
        int fork = k - 1;
        while (fork > 0 && !light.connectable[fork]) {
            fork--;
        }
        if (fork > 0) {
            path.fromEye[fork - 1] *= samples(light.bsdfs[fork]);
        }
    }
}
