package org.daybreak.tracing;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionSample;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSelection;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.sampling.SobolSampler;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/**
 * Traces light subpaths and joins each of their vertices to the lens. One object per worker.
 *
 * <p>All subpaths of a render are one Sobol′ sequence: its first group of dimensions are position and direction on the
 * light, group k the direction scattered at vertex k with the choice of lobe and Russian roulette.
 */
final class LightTracer {
    private static final int GROUP = 4;
    /** Dimensions of choices that are made apart: the light and the points on the lens. */
    private static final int APART = 1 << 24;

    private final Scene scene;
    private final LightSelection selection;
    private final RayCaster caster;
    private final LensConnection lens;
    private final EmissionGuide guide;
    private final SobolSampler sampler;
    private final int edgeLimit;
    private final int rrDepth;
    private final boolean lensArea;
    private final EmissionSample emission = new EmissionSample();
    private final SurfacePoint here = new SurfacePoint();
    private final BsdfSample scattered = new BsdfSample();

    LightTracer(Scene scene, Camera camera, long seed, LightTracerSettings settings) {
        this.scene = scene;
        selection = scene.lightSelection();
        caster = new RayCaster(scene);
        lens = new LensConnection(camera, caster);
        guide = new EmissionGuide(scene);
        lensArea = camera.hasLensArea();
        sampler = new SobolSampler(seed, StreamDomain.LIGHT_PATH, GROUP);
        edgeLimit = settings.edgeLimit();
        rrDepth = settings.rrDepth();
    }

    long rays(RayKind kind) {
        return caster.count(kind);
    }

    /**
     * Traces one light subpath.
     *
     * @param path index of the subpath
     * @return false if a splat was not finite and has been left out
     */
    boolean trace(long path, SplatBuffer splats) {
        sampler.start(path >>> 32, path & 0xFFFF_FFFFL);
        double positionU = sampler.next();
        double positionV = sampler.next();
        double directionU = sampler.next();
        double directionV = sampler.next();
        sampler.setDimension(APART);
        int index = selection.chooseForEmission(sampler.next());
        if (index < 0 || edgeLimit == 0) {
            return true;
        }
        double chosen = selection.emissionProbability(index);
        Light light = scene.light(index);
        double lensU = lensArea ? sampler.next() : 0.5;
        double lensV = lensArea ? sampler.next() : 0.5;
        boolean finite = true;
        if (light.isInfinite() && !light.isDelta()) {
            if (lens.aimFromInfinity(light, directionU, directionV, lensU, lensV) > 0) {
                finite = lens.splat(emission.point, 1 / chosen, 1 / chosen, 1 / chosen, splats);
            }
        }
        if (!guide.sample(index, positionU, positionV, directionU, directionV, emission)) {
            return finite;
        }
        if (!light.isInfinite() && !light.isDelta()) {
            if (lens.aimFromEmitter(light, emission.point, lensU, lensV)) {
                double scale = 1 / (emission.densityPosition * chosen);
                finite = lens.splat(emission.point, scale, scale, scale, splats);
            }
        }
        if (edgeLimit >= 2) {
            finite &= walk(chosen, splats);
        }
        return finite;
    }

    /** Follows the subpath from the emission sample on. */
    private boolean walk(double chosen, SplatBuffer splats) {
        double r = emission.weight.r / chosen;
        double g = emission.weight.g / chosen;
        double b = emission.weight.b / chosen;
        double start = Math.max(r, Math.max(g, b));
        double dx = emission.dx;
        double dy = emission.dy;
        double dz = emission.dz;
        boolean finite = true;
        boolean found = start > 0 && caster.trace(emission.point, dx, dy, dz, RayKind.LIGHT, here);
        int edges = 1;
        for (int vertex = 1; found; vertex++) {
            Bsdf bsdf = scene.bsdf(here.shape);
            if (bsdf.connectable()) {
                double lensU = 0.5;
                double lensV = 0.5;
                if (lensArea) {
                    sampler.setDimension(APART + GROUP * vertex);
                    lensU = sampler.next();
                    lensV = sampler.next();
                }
                if (lens.aimFromSurface(here, bsdf, -dx, -dy, -dz, lensU, lensV)) {
                    finite &= lens.splat(here, r, g, b, splats);
                }
            }
            // The next vertex would be joined by one more edge still.
            boolean last = edges > edgeLimit - 2;
            if (last && !bsdf.maybeTransparent()) {
                return finite;
            }
            sampler.setDimension(GROUP * vertex);
            double u = sampler.next();
            double v = sampler.next();
            double lobe = sampler.next();
            if (!Scattering.sample(bsdf, here, -dx, -dy, -dz, u, v, lobe, TransportMode.IMPORTANCE, scattered)) {
                return finite;
            }
            r *= scattered.weight.r;
            g *= scattered.weight.g;
            b *= scattered.weight.b;
            if (!scattered.passThrough) {
                if (last) {
                    return finite;
                }
                if (edges >= rrDepth) {
                    double probability = Math.min(
                            PathTracer.LARGEST_SURVIVAL,
                            Math.max(r, Math.max(g, b)) / (PathTracer.ROULETTE_THROUGHPUT * start));
                    if (sampler.next() >= probability) {
                        return finite;
                    }
                    r /= probability;
                    g /= probability;
                    b /= probability;
                }
                edges++;
            }
            if (r == 0 && g == 0 && b == 0) {
                return finite;
            }
            dx = scattered.wiX;
            dy = scattered.wiY;
            dz = scattered.wiZ;
            found = caster.trace(here, dx, dy, dz, RayKind.SCATTERED, here);
        }
        return finite;
    }
}
