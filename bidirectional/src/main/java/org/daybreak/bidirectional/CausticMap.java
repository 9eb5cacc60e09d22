package org.daybreak.bidirectional;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.Light;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.Dimensions;
import org.daybreak.tracing.LensConnection;
import org.jspecify.annotations.Nullable;

/**
 * The light image: what light subpaths bring to the lens, technique t = 1 (the thesis' class of that name, §4.2), and t = 0 where
 * they hit it by themselves. The film position is found and not chosen, so the contributions are splats, which the film gathers
 * apart, filters like samples and divides by the number of light subpaths. One object per worker; its splats go into the
 * buffer of the work unit.
 */
final class CausticMap {
    private final Scene scene;
    private final LensConnection lens;
    private final ComplementTracer complement;
    private final ConnectionRoulette roulette;
    private final LightDensities lights;
    private final boolean emitters;
    private final boolean lensArea;
    private final double perPixel;
    private final long minVertices;
    private final long maxVertices;
    private final Contribution contribution;
    private final Contribution.@Nullable Listener listener;
    private SplatBuffer splats = new SplatBuffer();
    private double lensU;
    private double lensV;
    private double luminance;
    private boolean finite;

    /**
     * Creates a map.
     *
     * @param minVertices smallest number of vertices of a full path
     * @param maxVertices largest number of vertices of a full path
     * @param emitters whether lights are joined to the lens themselves: {@link TechniqueLimits#emitterAtLens}
     */
    CausticMap(
            Scene scene,
            Camera camera,
            LensConnection lens,
            ComplementTracer complement,
            ConnectionRoulette roulette,
            LightDensities lights,
            Contribution contribution,
            Contribution.@Nullable Listener listener,
            long minVertices,
            long maxVertices,
            boolean emitters) {
        this.scene = scene;
        this.complement = complement;
        this.roulette = roulette;
        this.lights = lights;
        this.emitters = emitters;
        this.lens = lens;
        this.contribution = contribution;
        this.listener = listener;
        this.minVertices = minVertices;
        this.maxVertices = maxVertices;
        lensArea = camera.hasLensArea();
        perPixel = 1 / ((double) camera.width() * camera.height());
    }

    /** A sample begins, whose splats go into a buffer. */
    void beginSample(SplatBuffer buffer) {
        splats = buffer;
        luminance = 0;
        finite = true;
    }

    /** Luminance of the splats of the sample so far, as a share of the image: a splat reaches one pixel of all. */
    double luminance() {
        return luminance;
    }

    /** False if some contribution of the sample was not finite. */
    boolean finite() {
        return finite;
    }

    /**
     * Joins all vertices of a light subpath to the lens.
     *
     * @param path the subpath; of length 0 if nothing was emitted
     * @param index its light
     */
    void add(PathValues path, int index, int subpath, Sampler sampler) {
        if (minVertices <= 2 && maxVertices >= 2) {
            addEmitter(path, index, subpath, sampler);
        }
        for (int e = (int) Math.max(1, minVertices - 2); e < path.length() && e + 2 <= maxVertices; e++) {
            addVertex(path, e, index, subpath, sampler);
        }
    }

    /** Joins a vertex behind the first one of a light subpath to the lens, s ≥ 2. */
    void addVertex(PathValues path, int e, int index, int subpath, Sampler sampler) {
        if (!path.connectable[e]) {
            return;
        }
        lensU = 0.5;
        lensV = 0.5;
        if (lensArea) {
            sampler.setDimension(Dimensions.lightPath(path.surface[e], subpath) + 2);
            lensU = sampler.next();
            lensV = sampler.next();
        }
        SurfacePoint y = path.points[e];
        Bsdf bsdf = path.bsdfs[e];
        if (lens.aimFromSurface(y, bsdf, path.backX[e], path.backY[e], path.backZ[e], lensU, lensV)) {
            double weight = complement.lens(path, e + 1, lens.lens(), lens.filmDensity(), lens.scatteringDensity());
            splat(y, e + 1, index, weight, path.throughputR[e], path.throughputG[e], path.throughputB[e]);
        }
    }

    /** The emitter itself as the lens sees it, s = 1, where that is done. */
    void addEmitter(PathValues path, int index, int subpath, Sampler sampler) {
        Light light = scene.light(index);
        if (!emitters || light.isDelta()) {
            return;
        }
        lensU = 0.5;
        lensV = 0.5;
        if (lensArea) {
            sampler.setDimension(Dimensions.lightPathChoices(0, subpath) + 2);
            lensU = sampler.next();
            lensV = sampler.next();
        }
        if (light.isInfinite()) {
            sampler.setDimension(Dimensions.lightPath(0, subpath) + 2);
            double s = sampler.next();
            double t = sampler.next();
            double density = lens.aimFromInfinity(light, s, t, lensU, lensV);
            if (density > 0) {
                double chosen = lights.emissionChoice(index);
                double weight = complement.emitterAtLens(
                        index, path.points[0], lens.lens(), chosen * density, lens.filmDensity());
                splat(path.points[0], 1, index, weight, 1 / chosen, 1 / chosen, 1 / chosen);
            }
        } else if (path.length() > 0 && lens.aimFromEmitter(light, path.points[0], lensU, lensV)) {
            double density = path.forward[0];
            double weight = complement.emitterAtLens(index, path.points[0], lens.lens(), density, lens.filmDensity());
            splat(path.points[0], 1, index, weight, 1 / density, 1 / density, 1 / density);
        }
    }

    /** Adds what was aimed, times factors and the weight of technique (s, 1), if the lens sees the vertex. */
    private void splat(SurfacePoint y, int s, int index, double weight, double r, double g, double b) {
        Spectrum value = lens.value();
        double weighted = perPixel * weight * Spectrum.luminance(r * value.r, g * value.g, b * value.b);
        if (weighted == 0 && listener == null) {
            return;
        }
        double factor = weighted == 0 ? 1 : roulette.survive(weighted);
        if (factor == 0) {
            if (listener != null) {
                listener.leftOut(describe(s, 1, index, weight, r * value.r, g * value.g, b * value.b));
            }
            return;
        }
        double visible = lens.transmittance(y);
        if (visible == 0) {
            if (listener != null) {
                listener.occluded(describe(
                        s, 1, index, weight, factor * r * value.r, factor * g * value.g, factor * b * value.b));
            }
            return;
        }
        factor *= visible;
        if (listener != null) {
            listener.found(
                    describe(s, 1, index, weight, factor * r * value.r, factor * g * value.g, factor * b * value.b));
        }
        double scale = factor * weight;
        LensSample at = lens.lens();
        finite &= splats.add(at.filmX, at.filmY, scale * r * value.r, scale * g * value.g, scale * b * value.b);
        luminance += factor * weighted;
    }

    /**
     * Adds a light subpath whose next ray hits the lens, at {@link LensConnection#lens} (t = 0). Nothing is left to be tested for
     * occlusion.
     *
     * @param r red of the throughput along the ray
     * @param density density per area with which the subpath samples the point of the lens
     * @param filmDensity density of the subpath's end as sampled from the film
     */
    void addHit(PathValues path, double r, double g, double b, double density, double filmDensity) {
        int s = path.length() + 1;
        if (s < minVertices || s > maxVertices) {
            return;
        }
        LensSample at = lens.lens();
        double weight = complement.lensHit(path, at, density, filmDensity);
        double importance = at.weight * at.density;
        if (listener != null) {
            listener.found(describe(s, 0, path.light[0], weight, importance * r, importance * g, importance * b));
        }
        double scale = weight * importance;
        finite &= splats.add(at.filmX, at.filmY, scale * r, scale * g, scale * b);
        luminance += perPixel * scale * Spectrum.luminance(r, g, b);
    }

    private Contribution describe(int s, int t, int index, double weight, double r, double g, double b) {
        Contribution c = contribution;
        c.s = s;
        c.t = t;
        c.lightIndex = index;
        c.filmX = lens.lens().filmX;
        c.filmY = lens.lens().filmY;
        c.r = r;
        c.g = g;
        c.b = b;
        c.lensU = lensU;
        c.lensV = lensV;
        c.weight = weight;
        return c;
    }
}
