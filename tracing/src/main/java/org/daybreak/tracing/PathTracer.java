package org.daybreak.tracing;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/**
 * Unidirectional path tracing (Kajiya 1986; thesis, chapter 3): at each vertex light is gathered by next-event estimation
 * and by the scattered ray meeting an emitter, combined with the power heuristic ({@link DirectLight}). Russian roulette
 * ends paths. Nothing is clamped.
 *
 * <p>At the first vertex that scatters diffusely the path splits (Arvo and Kirk 1990): direct light there is found by one light
 * sample with little variance, while what comes from further bounces, caustics above all, needs many directions; so several go on
 * from one camera ray.
 *
 * <p>Points where the path goes straight through an alpha mask are neither vertices of the path nor edges' ends: they count
 * for no depth, and weights refer to the vertex before.
 */
final class PathTracer implements RayProcessor {
    /** Even a path that loses nothing should end some day. */
    static final double LARGEST_SURVIVAL = 0.95;

    /**
     * Throughput below which Russian roulette thins paths out. With 1, the first decision after several bounces ends most
     * paths at once and makes the few that survive several times as heavy; at ½ the variance of the Cornell room with spheres is a
     * fifth lower for 7 % more rays.
     */
    static final double ROULETTE_THROUGHPUT = 0.5;

    private final Scene scene;
    private final Camera camera;
    private final RayCaster caster;
    private final DirectLight direct;
    private final int edgeLimit;
    private final int rrDepth;
    private final int splitting;
    private final boolean features;
    private final boolean lensArea;
    private final boolean severalLights;
    private final boolean lit;
    private final CameraRay cameraRay = new CameraRay();
    private final SurfacePoint here = new SurfacePoint();
    private final SurfacePoint fork = new SurfacePoint();
    private final BsdfSample scattered = new BsdfSample();

    /** The path in hand: direction of the last ray, and whether it has met a surface. */
    private double dx;

    private double dy;
    private double dz;
    private boolean found;

    /** Throughput up to the last ray, share of a split path included. */
    private double r;

    private double g;
    private double b;

    /** Number of paths that share the throughput: Russian roulette judges a path as if it were alone. */
    private double shareScale;

    /** Product of (η_i/η_t)²: radiance is scaled by it, and is scaled back when the path leaves the medium again. */
    private double etaScale;

    /** Density per solid angle of the last ray; infinite if no light sample could have found what it meets. */
    private double scatterDensity;

    private int edges;

    /** Numbers for the light point of the next vertex. */
    private double lightU;

    private double lightV;

    PathTracer(Scene scene, Camera camera, boolean features, PathTracerSettings settings) {
        this.scene = scene;
        this.camera = camera;
        this.features = features;
        caster = new RayCaster(scene);
        direct = new DirectLight(caster);
        edgeLimit = settings.edgeLimit();
        rrDepth = settings.rrDepth();
        splitting = settings.splitting();
        lensArea = camera.hasLensArea();
        lit = scene.lightCount() > 0;
        severalLights = scene.lightCount() > 1;
    }

    @Override
    public long rays(RayKind kind) {
        return caster.count(kind);
    }

    @Override
    public boolean trace(double filmX, double filmY, Sampler sampler, RaySample out, SplatBuffer splats) {
        out.radiance.setZero();
        out.features.hit = false;
        lightU = sampler.next();
        lightV = sampler.next();
        double lensU = 0.5;
        double lensV = 0.5;
        if (lensArea) {
            sampler.setDimension(Dimensions.choices(0));
            lensU = sampler.next();
            lensV = sampler.next();
        }
        if (edgeLimit == 0 || !camera.sampleRay(filmX, filmY, lensU, lensV, cameraRay)) {
            return true;
        }
        dx = cameraRay.dx;
        dy = cameraRay.dy;
        dz = cameraRay.dz;
        r = cameraRay.weight;
        g = r;
        b = r;
        etaScale = 1;
        shareScale = 1;
        scatterDensity = Double.POSITIVE_INFINITY;
        edges = 1;
        found = caster.trace(cameraRay.ox, cameraRay.oy, cameraRay.oz, dx, dy, dz, RayKind.CAMERA, here);
        for (int vertex = 1; arrive(vertex, sampler, out); vertex++) {
            Bsdf bsdf = scene.bsdf(here.shape);
            if (splitting > 1 && bsdf.connectable() && !bsdf.maybeTransparent()) {
                split(vertex, sampler, out);
                return true;
            }
            if (!scatter(vertex, sampler, out)) {
                return true;
            }
        }
        return true;
    }

    /** Follows several paths from the vertex that was arrived at; each has an equal share of the throughput. */
    private void split(int vertex, Sampler sampler, RaySample out) {
        fork.set(here);
        direct.keepNormal();
        double forkX = dx;
        double forkY = dy;
        double forkZ = dz;
        double forkR = r / splitting;
        double forkG = g / splitting;
        double forkB = b / splitting;
        double forkEtaScale = etaScale;
        int forkEdges = edges;
        shareScale = splitting;
        for (int path = 0; path < splitting; path++) {
            here.set(fork);
            direct.recallNormal();
            dx = forkX;
            dy = forkY;
            dz = forkZ;
            r = forkR;
            g = forkG;
            b = forkB;
            etaScale = forkEtaScale;
            edges = forkEdges;
            sampler.branch(path, splitting);
            int at = vertex + Dimensions.SPLIT;
            while (scatter(at, sampler, out)) {
                at++;
                if (!arrive(at, sampler, out)) {
                    break;
                }
            }
        }
    }

    /**
     * Gathers the light at the end of the ray in hand: what an emitter there sends along it, and what a light sample
     * contributes.
     *
     * @param vertex number of the vertex, for {@link Dimensions}
     * @return false if the path ends here
     */
    private boolean arrive(int vertex, Sampler sampler, RaySample out) {
        if (!found) {
            direct.addEscaped(here, dx, dy, dz, r, g, b, scatterDensity, out.radiance);
            return false;
        }
        int light = scene.lightOf(here.shape);
        if (light >= 0) {
            direct.addMet(light, here, dx, dy, dz, r, g, b, scatterDensity, out.radiance);
        }
        Bsdf bsdf = scene.bsdf(here.shape);
        if (features && edges == 1) {
            out.setFeatures(bsdf, here, cameraRay);
        }
        if (edges >= edgeLimit) {
            return bsdf.maybeTransparent();
        }
        if (lit && bsdf.connectable()) {
            double choice = 0.5;
            if (severalLights) {
                sampler.setDimension(Dimensions.lightChoice(vertex));
                choice = sampler.next();
            }
            direct.addSampled(here, bsdf, -dx, -dy, -dz, r, g, b, choice, lightU, lightV, out.radiance);
        }
        return true;
    }

    /**
     * Scatters the path at the vertex in hand and traces the next ray.
     *
     * @param vertex number of the vertex, for {@link Dimensions}
     * @return false if the path ends here
     */
    private boolean scatter(int vertex, Sampler sampler, RaySample out) {
        Bsdf bsdf = scene.bsdf(here.shape);
        boolean roulette = edges >= rrDepth;
        double lobe = 0;
        double survival = 0;
        if (roulette || bsdf.choosesLobe()) {
            sampler.setDimension(Dimensions.choices(vertex));
            lobe = sampler.next();
            survival = sampler.next();
        }
        sampler.setDimension(Dimensions.scattering(vertex));
        double u = sampler.next();
        double v = sampler.next();
        lightU = sampler.next();
        lightV = sampler.next();
        if (!Scattering.sample(bsdf, here, -dx, -dy, -dz, u, v, lobe, TransportMode.RADIANCE, scattered)) {
            return false;
        }
        r *= scattered.weight.r;
        g *= scattered.weight.g;
        b *= scattered.weight.b;
        if (scattered.passThrough) {
            out.features.hit &= edges > 1;
        } else {
            if (edges >= edgeLimit) {
                return false;
            }
            edges++;
            etaScale *= scattered.eta * scattered.eta;
            scatterDensity = scattered.delta ? Double.POSITIVE_INFINITY : scattered.density;
            direct.leave(here);
            if (roulette) {
                double throughput = shareScale * Math.max(r, Math.max(g, b));
                double probability = Math.min(LARGEST_SURVIVAL, throughput / (ROULETTE_THROUGHPUT * etaScale));
                if (survival >= probability) {
                    return false;
                }
                r /= probability;
                g /= probability;
                b /= probability;
            }
        }
        if (r == 0 && g == 0 && b == 0) {
            return false;
        }
        dx = scattered.wiX;
        dy = scattered.wiY;
        dz = scattered.wiZ;
        found = caster.trace(here, dx, dy, dz, RayKind.SCATTERED, here);
        return true;
    }
}
