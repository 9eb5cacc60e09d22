package org.daybreak.tracing;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.color.Spectrum;
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
    private final boolean features;
    private final boolean lensArea;
    private final boolean severalLights;
    private final boolean lit;
    private final CameraRay cameraRay = new CameraRay();
    private final SurfacePoint here = new SurfacePoint();
    private final BsdfSample scattered = new BsdfSample();

    PathTracer(Scene scene, Camera camera, boolean features, PathTracerSettings settings) {
        this.scene = scene;
        this.camera = camera;
        this.features = features;
        caster = new RayCaster(scene);
        direct = new DirectLight(caster);
        edgeLimit = settings.edgeLimit();
        rrDepth = settings.rrDepth();
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
        Spectrum radiance = out.radiance;
        radiance.setZero();
        out.features.hit = false;
        double lightU = sampler.next();
        double lightV = sampler.next();
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
        double dx = cameraRay.dx;
        double dy = cameraRay.dy;
        double dz = cameraRay.dz;
        double r = cameraRay.weight;
        double g = r;
        double b = r;
        // Product of (η_i/η_t)²: radiance is scaled by it, and is scaled back when the path leaves the medium again.
        double etaScale = 1;
        double scatterDensity = Double.POSITIVE_INFINITY;
        int edges = 1;
        boolean found = caster.trace(cameraRay.ox, cameraRay.oy, cameraRay.oz, dx, dy, dz, RayKind.CAMERA, here);
        for (int vertex = 1; ; vertex++) {
            if (!found) {
                direct.addEscaped(here, dx, dy, dz, r, g, b, scatterDensity, radiance);
                return true;
            }
            int light = scene.lightOf(here.shape);
            if (light >= 0) {
                direct.addMet(light, here, dx, dy, dz, r, g, b, scatterDensity, radiance);
            }
            Bsdf bsdf = scene.bsdf(here.shape);
            if (features && edges == 1) {
                out.setFeatures(bsdf, here, cameraRay);
            }
            boolean last = edges >= edgeLimit;
            if (last && !bsdf.maybeTransparent()) {
                return true;
            }
            boolean roulette = edges >= rrDepth;
            sampler.setDimension(Dimensions.choices(vertex));
            double lobe = bsdf.choosesLobe() ? sampler.next() : 0;
            double lightChoice = severalLights || roulette ? sampler.next() : 0.5;
            double survival = roulette ? sampler.next() : 0;
            if (lit && !last && bsdf.connectable()) {
                direct.addSampled(here, bsdf, -dx, -dy, -dz, r, g, b, lightChoice, lightU, lightV, radiance);
            }
            sampler.setDimension(Dimensions.scattering(vertex));
            double u = sampler.next();
            double v = sampler.next();
            lightU = sampler.next();
            lightV = sampler.next();
            if (!Scattering.sample(bsdf, here, -dx, -dy, -dz, u, v, lobe, TransportMode.RADIANCE, scattered)) {
                return true;
            }
            r *= scattered.weight.r;
            g *= scattered.weight.g;
            b *= scattered.weight.b;
            if (scattered.passThrough) {
                out.features.hit &= edges > 1;
            } else {
                if (last) {
                    return true;
                }
                edges++;
                etaScale *= scattered.eta * scattered.eta;
                scatterDensity = scattered.delta ? Double.POSITIVE_INFINITY : scattered.density;
                direct.leave(here);
                if (roulette) {
                    double probability =
                            Math.min(LARGEST_SURVIVAL, Math.max(r, Math.max(g, b)) / (ROULETTE_THROUGHPUT * etaScale));
                    if (survival >= probability) {
                        return true;
                    }
                    r /= probability;
                    g /= probability;
                    b /= probability;
                }
            }
            if (r == 0 && g == 0 && b == 0) {
                return true;
            }
            dx = scattered.wiX;
            dy = scattered.wiY;
            dz = scattered.wiZ;
            found = caster.trace(here, dx, dy, dz, RayKind.SCATTERED, here);
        }
    }
}
