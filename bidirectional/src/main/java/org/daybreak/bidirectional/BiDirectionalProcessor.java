package org.daybreak.bidirectional;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightChoice;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.light.LightSelection;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.Dimensions;
import org.daybreak.tracing.EmissionGuide;
import org.daybreak.tracing.LensConnection;
import org.daybreak.tracing.RayProcessor;
import org.daybreak.tracing.RaySample;
import org.jspecify.annotations.Nullable;

/**
 * One sample of bidirectional path tracing (Veach 1997, chapter 10; thesis §4.1): traces an eye and a light subpath, joins each
 * vertex of one to each of the other, and adds up Σ w_{s,t} α_s^L c_{s,t} α_t^E (thesis eq. 4.1–4.5).
 *
 * <p>Techniques: s = 0, the eye subpath meets a light; s = 1, a point on a light is sampled for the eye vertex; t = 1, the light
 * vertex is joined to the lens, see {@link CausticMap}; t = 0, the light subpath hits the lens; others join y_{s−1} and
 * z_{t−1}. Occlusion is tested last, for contributions that are not zero.
 */
public final class BiDirectionalProcessor implements RayProcessor {
    /**
     * What a vertex costs besides its ray, in occlusion tests: sampling, densities, weights and sums. Half a
     * microsecond ({@code benchmarks/triangle_growth.py}), while a test takes 30 ns among a dozen triangles and 100 ns among a
     * thousand.
     */
    private static final int VERTEX_COST = 8;

    private final Scene scene;
    private final RayCaster caster;
    private final LightSelection selection;
    private final LightDensities lights;
    private final LineTracer lines;
    private final ComplementTracer complement;
    private final CausticMap causticMap;
    private final ConnectionRoulette roulette;
    private final TechniqueLimits limits;
    private final long minVertices;
    private final long maxVertices;
    private final boolean allLights;
    private final int splitting;
    private final boolean features;
    private final boolean lensArea;
    private final PathValues eye = new PathValues();
    private final PathValues light = new PathValues();
    private final LightChoice choice = new LightChoice();
    private final LightSample lightSample = new LightSample();
    private final Spectrum value = new Spectrum();
    private final Spectrum lightValue = new Spectrum();
    private final LineTracer.Emission emission = this::addMet;
    private final LineTracer.LensHits lensHit;
    private final LineTracer.Emission emissionAtEnd = this::addMetAtEnd;
    private final Spectrum radiance = new Spectrum();
    private double sampleX;
    private double sampleY;
    private double lensU;
    private double lensV;
    /** Number of vertices of the eye subpath if it is that of technique s = 0 alone. */
    private int end;

    private final Contribution contribution;
    private final Contribution.@Nullable Listener listener;
    private final @Nullable PathFilter filter;

    /**
     * Creates a processor.
     *
     * @param listener told of all contributions; null if nobody listens
     */
    public BiDirectionalProcessor(
            Scene scene,
            Camera camera,
            boolean features,
            BidirectionalSettings settings,
            Contribution.@Nullable Listener listener) {
        this(scene, camera, features, settings, settings.rouletteFrom(), listener);
    }

    /**
     * Creates a processor with a Russian roulette of its own.
     *
     * @param rouletteFrom number of edges from which on Russian roulette may end subpaths
     */
    BiDirectionalProcessor(
            Scene scene,
            Camera camera,
            boolean features,
            BidirectionalSettings settings,
            int rouletteFrom,
            Contribution.@Nullable Listener listener) {
        this(scene, camera, features, settings, rouletteFrom, listener, null, settings.connectionRoulette());
    }

    /**
     * Creates a processor with a given roulette for occlusion tests, in place of the one that the settings want.
     *
     * @param listener told of all contributions; null if nobody listens
     */
    BiDirectionalProcessor(
            Scene scene,
            Camera camera,
            boolean features,
            BidirectionalSettings settings,
            Contribution.@Nullable Listener listener,
            ConnectionRoulette roulette) {
        this(scene, camera, features, settings, settings.rouletteFrom(), listener, null, roulette);
    }

    /**
     * A processor for a part of the light.
     *
     * @param settings without light subpaths at the lens
     * @param filter which paths count
     */
    static BiDirectionalProcessor filtered(
            Scene scene, Camera camera, boolean features, BidirectionalSettings settings, PathFilter filter) {
        return new BiDirectionalProcessor(
                scene,
                camera,
                features,
                settings,
                settings.rouletteFrom(),
                null,
                filter,
                settings.connectionRoulette());
    }

    private BiDirectionalProcessor(
            Scene scene,
            Camera camera,
            boolean features,
            BidirectionalSettings settings,
            int rouletteFrom,
            Contribution.@Nullable Listener listener,
            @Nullable PathFilter filter,
            ConnectionRoulette roulette) {
        this.scene = scene;
        this.features = features;
        caster = new RayCaster(scene);
        selection = scene.lightSelection();
        allLights = settings.allLights();
        EmissionGuide guide = new EmissionGuide(scene);
        lights = new LightDensities(scene, guide, allLights);
        limits = settings.limits(camera);
        minVertices = settings.minDepth() + 1L;
        maxVertices = settings.maxVertices();
        splitting = settings.eyeBranches();
        double exponent = settings.heuristicExponent();
        LensConnection lens = new LensConnection(camera, caster);
        lines = new LineTracer(camera, caster, guide, lights, exponent, limits, lens.lens(), rouletteFrom, splitting);
        complement = new ComplementTracer(scene, lights, limits, exponent, splitting);
        this.roulette = roulette;
        contribution = new Contribution(light, eye, lightSample, lens.lens(), complement);
        this.listener = listener;
        this.filter = filter;
        causticMap = new CausticMap(
                scene,
                camera,
                lens,
                complement,
                roulette,
                lights,
                contribution,
                listener,
                minVertices,
                maxVertices,
                limits.emitterAtLens());
        lensHit = causticMap::addHit;
        lensArea = camera.hasLensArea();
    }

    @Override
    public long rays(RayKind kind) {
        return caster.count(kind);
    }

    @Override
    public void beginUnit() {
        roulette.beginUnit();
    }

    @Override
    public boolean trace(double filmX, double filmY, Sampler sampler, RaySample out, SplatBuffer splats) {
        begin(filmX, filmY, sampler, out, splats);
        sampler.setDimension(Dimensions.lightPathChoices(0, 0));
        double lightChoice = sampler.next();
        roulette.beginSample(sampler.next());
        long raysBefore = caster.total();
        long shadowBefore = caster.count(RayKind.SHADOW);
        boolean sees = limits.maxEyeVertices() > 1
                && lines.traceEye(filmX, filmY, lensU, lensV, limits.maxEyeVertices(), sampler, eye, emission);
        if (!sees) {
            eye.setLength(0);
        } else if (features && eye.length() > 1) {
            out.setFeatures(eye.bsdfs[1], eye.points[1], lines.cameraRay());
        }
        if (listener != null) {
            listener.traced(eye, -1);
        }
        if (allLights) {
            for (int i = 0; i < scene.lightCount(); i++) {
                addLight(i, i, 1, sampler);
            }
        } else {
            int index = selection.chooseForEmission(lightChoice);
            if (index >= 0) {
                addLight(index, 0, selection.emissionProbability(index), sampler);
            }
        }
        out.radiance.set(radiance);
        roulette.endSample(
                radiance.luminance() + causticMap.luminance(),
                cost(caster.total() - raysBefore, caster.count(RayKind.SHADOW) - shadowBefore));
        return causticMap.finite();
    }

    /** Cost of a sample in units of occlusion tests. */
    private static long cost(long rays, long shadow) {
        return rays + VERTEX_COST * (rays - shadow);
    }

    private void begin(double filmX, double filmY, Sampler sampler, RaySample out, SplatBuffer splats) {
        out.radiance.setZero();
        out.features.hit = false;
        radiance.setZero();
        causticMap.beginSample(splats);
        sampleX = filmX;
        sampleY = filmY;
        lensU = 0.5;
        lensV = 0.5;
        if (lensArea) {
            sampler.setDimension(Dimensions.choices(0));
            lensU = sampler.next();
            lensV = sampler.next();
        }
    }

    /**
     * Computes what technique (s, t) alone brings, with its weight, from the numbers that {@link #trace} would use for it, and
     * traces no more than it needs. The technique must be within the limits of depth.
     *
     * @return false if a splat was not finite and has been left out
     */
    boolean traceTechnique(
            int s, int t, double filmX, double filmY, Sampler sampler, RaySample out, SplatBuffer splats) {
        begin(filmX, filmY, sampler, out, splats);
        eye.setLength(0);
        if (s >= 2 || t == 1) {
            sampler.setDimension(Dimensions.lightPathChoices(0, 0));
            int index = selection.chooseForEmission(sampler.next());
            if (index < 0) {
                return true;
            }
            lines.traceLight(index, selection.emissionProbability(index), 0, s, sampler, light, LineTracer.NO_HITS);
            if (s == 1) {
                causticMap.addEmitter(light, index, 0, sampler);
                return causticMap.finite();
            }
            if (light.length() < s || !light.connectable[s - 1]) {
                return true;
            }
            if (t == 1) {
                causticMap.addVertex(light, s - 1, index, 0, sampler);
                return causticMap.finite();
            }
        }
        end = t;
        LineTracer.Emission met = s == 0 ? emissionAtEnd : LineTracer.NO_EMISSION;
        boolean sees = lines.traceEye(filmX, filmY, lensU, lensV, t, sampler, eye, met);
        int f = t - 1;
        if (s > 0 && sees && eye.length() == t && eye.connectable[f]) {
            if (s == 1) {
                addSampledLight(f, sampler);
            } else {
                connect(s - 1, f);
            }
        }
        out.radiance.set(radiance);
        return true;
    }

    private void addMetAtEnd(PathValues path) {
        if (path.length() == end) {
            addMet(path);
        }
    }

    /** Adds what a light subpath contributes, in all ways with s ≥ 1. */
    private void addLight(int index, int subpath, double chosen, Sampler sampler) {
        if (limits.maxLightVertices() < 1) {
            return;
        }
        lines.traceLight(index, chosen, subpath, limits.maxLightVertices(), sampler, light, lensHit);
        if (listener != null) {
            listener.traced(light, index);
        }
        if (limits.lens()) {
            causticMap.add(light, index, subpath, sampler);
        }
        addVertices(1, index, sampler);
        if (eye.length() > 0 && eye.splits) {
            int next = eye.length();
            for (int branch = 0; branch < splitting; branch++) {
                lines.traceBranch(eye, branch, sampler, emission);
                if (listener != null) {
                    listener.traced(eye, -1);
                }
                addVertices(next, index, sampler);
            }
        }
    }

    /** Adds what the light subpath, or a light sample, contributes at the vertices of the eye subpath from one on. */
    private void addVertices(int first, int index, Sampler sampler) {
        for (int f = first; f < eye.length() && f + 2 <= maxVertices; f++) {
            if (!eye.connectable[f]) {
                continue;
            }
            if (f + 2 >= minVertices) {
                if (allLights) {
                    addSampledLight(f, index, sampler);
                } else {
                    addSampledLight(f, sampler);
                }
            }
            for (int e = (int) Math.max(1, minVertices - 2 - f); e < light.length() && e + f + 2 <= maxVertices; e++) {
                if (light.connectable[e]) {
                    connect(e, f);
                }
            }
        }
    }

    /** Technique s = 0: the eye subpath ends on a light for the moment. */
    private void addMet(PathValues path) {
        int last = path.length() - 1;
        if (path.length() > maxVertices
                || path.length() < minVertices
                || (filter != null && !filter.counts(light, 0, path, path.length()))) {
            return;
        }
        if (path.infinite) {
            for (int i = 0; i < scene.environmentCount(); i++) {
                addMet(path, last, scene.environment(i));
            }
        } else {
            addMet(path, last, path.light[last]);
        }
    }

    private void addMet(PathValues path, int last, int index) {
        scene.light(index).radiance(path.points[last], path.backX[last], path.backY[last], path.backZ[last], value);
        if (!value.isBlack()) {
            add(0, last, index, 1, complement.met(path, last + 1, index));
        }
    }

    /** Technique s = 1 with one light chosen among all. */
    private void addSampledLight(int f, Sampler sampler) {
        SurfacePoint p = eye.points[f];
        Bsdf bsdf = eye.bsdfs[f];
        int surface = eye.surface[f];
        double number = 0.5;
        if (scene.lightCount() > 1) {
            sampler.setDimension(Dimensions.lightChoice(surface));
            number = sampler.next();
        }
        double side = LightDensities.side(p, bsdf, eye.backX[f], eye.backY[f], eye.backZ[f]);
        if (!selection.choose(p.x, p.y, p.z, side * p.nx, side * p.ny, side * p.nz, number, choice)) {
            return;
        }
        sampler.setDimension(Dimensions.scattering(surface - 1) + 2);
        double u = sampler.next();
        double v = sampler.next();
        addSampledLight(f, choice.light, choice.probability, u, v);
    }

    /** Technique s = 1 with a given light. */
    private void addSampledLight(int f, int index, Sampler sampler) {
        sampler.setDimension(Dimensions.lightPoint(eye.surface[f], index, scene.lightCount()));
        double u = sampler.next();
        double v = sampler.next();
        addSampledLight(f, index, 1, u, v);
    }

    private void addSampledLight(int f, int index, double chosen, double u, double v) {
        if (filter != null && !filter.counts(light, 1, eye, f + 1)) {
            return;
        }
        SurfacePoint p = eye.points[f];
        Light sampled = scene.light(index);
        if (!sampled.sampleIncident(p.x, p.y, p.z, u, v, lightSample)) {
            return;
        }
        double density = Scattering.evaluate(
                eye.bsdfs[f],
                p,
                eye.backX[f],
                eye.backY[f],
                eye.backZ[f],
                lightSample.wiX,
                lightSample.wiY,
                lightSample.wiZ,
                TransportMode.RADIANCE,
                value);
        value.mul(lightSample.weight);
        if (value.isBlack()) {
            return;
        }
        double weight = complement.lightSample(eye, f + 1, index, lightSample, chosen, density);
        double factor = survive(1, f, index, 1 / chosen, weight);
        if (factor == 0) {
            return;
        }
        double visible = lightSample.distance == Double.POSITIVE_INFINITY
                ? caster.transmittanceToInfinity(p, lightSample.wiX, lightSample.wiY, lightSample.wiZ)
                : caster.transmittance(p, lightSample.point);
        join(1, f, index, factor, visible, weight);
    }

    /** Techniques with s, t ≥ 2: y_e joined to z_f. */
    private void connect(int e, int f) {
        if (filter != null && !filter.counts(light, e + 1, eye, f + 1)) {
            return;
        }
        SurfacePoint y = light.points[e];
        SurfacePoint z = eye.points[f];
        double dx = z.x - y.x;
        double dy = z.y - y.y;
        double dz = z.z - y.z;
        double squared = dx * dx + dy * dy + dz * dz;
        double inverse = 1 / Math.sqrt(squared);
        dx *= inverse;
        dy *= inverse;
        dz *= inverse;
        if (!(squared > 0)) {
            return;
        }
        double densityFromLight = Scattering.evaluate(
                light.bsdfs[e],
                y,
                light.backX[e],
                light.backY[e],
                light.backZ[e],
                dx,
                dy,
                dz,
                TransportMode.IMPORTANCE,
                lightValue);
        if (lightValue.isBlack()) {
            return;
        }
        double densityFromEye = Scattering.evaluate(
                eye.bsdfs[f],
                z,
                eye.backX[f],
                eye.backY[f],
                eye.backZ[f],
                -dx,
                -dy,
                -dz,
                TransportMode.RADIANCE,
                value);
        if (value.isBlack()) {
            return;
        }
        value.set(
                value.r * lightValue.r * light.throughputR[e],
                value.g * lightValue.g * light.throughputG[e],
                value.b * lightValue.b * light.throughputB[e]);
        double weight =
                complement.connection(light, e + 1, eye, f + 1, dx, dy, dz, squared, densityFromLight, densityFromEye);
        double factor = survive(e + 1, f, light.light[0], 1 / squared, weight);
        if (factor != 0) {
            join(e + 1, f, light.light[0], factor, caster.transmittance(y, z), weight);
        }
    }

    /**
     * Plays the roulette for the value in hand at an eye vertex.
     *
     * @param factor on the value
     * @param weight of the contribution
     * @return the factor, divided by the probability of survival; 0 if there is nothing to test for occlusion
     */
    private double survive(int s, int f, int lightIndex, double factor, double weight) {
        double weighted = factor * weight;
        if (weighted == 0) {
            return listener == null ? 0 : factor;
        }
        double luminance = weighted
                * Spectrum.luminance(
                        value.r * eye.throughputR[f], value.g * eye.throughputG[f], value.b * eye.throughputB[f]);
        double survived = roulette.survive(luminance);
        if (survived == 0 && listener != null) {
            describe(s, f, lightIndex, factor, weight);
            listener.leftOut(contribution);
        }
        return factor * survived;
    }

    /** Adds the value in hand times the throughput of eye vertex f, a factor and the weight of technique (s, f + 1). */
    private void add(int s, int f, int lightIndex, double factor, double weight) {
        if (listener != null) {
            describe(s, f, lightIndex, factor, weight);
            listener.found(contribution);
        }
        double weighted = factor * weight;
        radiance.r += weighted * value.r * eye.throughputR[f];
        radiance.g += weighted * value.g * eye.throughputG[f];
        radiance.b += weighted * value.b * eye.throughputB[f];
    }

    /** {@link #add} for an edge of which a fraction is visible. */
    private void join(int s, int f, int lightIndex, double factor, double visible, double weight) {
        if (visible != 0) {
            add(s, f, lightIndex, visible * factor, weight);
        } else if (listener != null) {
            describe(s, f, lightIndex, factor, weight);
            listener.occluded(contribution);
        }
    }

    private void describe(int s, int f, int lightIndex, double factor, double weight) {
        contribution.s = s;
        contribution.t = f + 1;
        contribution.filmX = sampleX;
        contribution.filmY = sampleY;
        contribution.lensU = lensU;
        contribution.lensV = lensV;
        contribution.lightIndex = lightIndex;
        contribution.r = factor * value.r * eye.throughputR[f];
        contribution.g = factor * value.g * eye.throughputG[f];
        contribution.b = factor * value.b * eye.throughputB[f];
        contribution.weight = weight;
    }
}
