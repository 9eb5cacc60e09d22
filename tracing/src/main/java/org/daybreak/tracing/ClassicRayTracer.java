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
 * Classic recursive ray tracing (Whitted 1980): at each surface one shadow ray goes to every light, and the ray goes on
 * only by ideal reflection or refraction. Emitters and environment are seen directly and through such surfaces. There is
 * no light that is scattered twice by rough or diffuse surfaces.
 *
 * <p>Where a surface both reflects and refracts, one of the two is followed at random with its probability, not both: the
 * mean is the same and the cost does not grow exponentially with the depth.
 */
final class ClassicRayTracer implements RayProcessor {
    private final Scene scene;
    private final Camera camera;
    private final RayCaster caster;
    private final DirectLight direct;
    private final int edgeLimit;
    private final int lights;
    private final boolean features;
    private final boolean lensArea;
    private final CameraRay cameraRay = new CameraRay();
    private final SurfacePoint here = new SurfacePoint();
    private final BsdfSample scattered = new BsdfSample();

    ClassicRayTracer(Scene scene, Camera camera, boolean features, ClassicRayTracerSettings settings) {
        this.scene = scene;
        this.camera = camera;
        this.features = features;
        caster = new RayCaster(scene);
        direct = new DirectLight(caster);
        edgeLimit = settings.edgeLimit();
        lights = scene.lightCount();
        lensArea = camera.hasLensArea();
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
        int edges = 1;
        boolean found = caster.trace(cameraRay.ox, cameraRay.oy, cameraRay.oz, dx, dy, dz, RayKind.CAMERA, here);
        for (int vertex = 1; ; vertex++) {
            if (!found) {
                direct.addEscaped(here, dx, dy, dz, r, g, b, Double.POSITIVE_INFINITY, radiance);
                return true;
            }
            int light = scene.lightOf(here.shape);
            if (light >= 0) {
                direct.addMet(light, here, dx, dy, dz, r, g, b, Double.POSITIVE_INFINITY, radiance);
            }
            Bsdf bsdf = scene.bsdf(here.shape);
            if (features && edges == 1) {
                out.setFeatures(bsdf, here, cameraRay);
            }
            boolean last = edges >= edgeLimit;
            if (!last && bsdf.connectable()) {
                gather(sampler, vertex, bsdf, dx, dy, dz, r, g, b, lightU, lightV, radiance);
            }
            if (last && !bsdf.maybeTransparent()) {
                return true;
            }
            sampler.setDimension(Dimensions.choices(vertex));
            double lobe = sampler.next();
            sampler.setDimension(Dimensions.scattering(vertex));
            double u = sampler.next();
            double v = sampler.next();
            lightU = sampler.next();
            lightV = sampler.next();
            if (!Scattering.sample(bsdf, here, -dx, -dy, -dz, u, v, lobe, TransportMode.RADIANCE, scattered)
                    || !scattered.delta) {
                return true;
            }
            if (scattered.passThrough) {
                out.features.hit &= edges > 1;
            } else if (last) {
                return true;
            } else {
                edges++;
            }
            r *= scattered.weight.r;
            g *= scattered.weight.g;
            b *= scattered.weight.b;
            if (r == 0 && g == 0 && b == 0) {
                return true;
            }
            dx = scattered.wiX;
            dy = scattered.wiY;
            dz = scattered.wiZ;
            found = caster.trace(here, dx, dy, dz, RayKind.SCATTERED, here);
        }
    }

    /** Direct light of all lights; the first light uses the numbers that are stratified with the ray. */
    private void gather(
            Sampler sampler,
            int vertex,
            Bsdf bsdf,
            double dx,
            double dy,
            double dz,
            double r,
            double g,
            double b,
            double firstU,
            double firstV,
            Spectrum radiance) {
        double u = firstU;
        double v = firstV;
        for (int i = 0; i < lights; i++) {
            if (i > 0) {
                sampler.setDimension(Dimensions.lightPoint(vertex, i, lights));
                u = sampler.next();
                v = sampler.next();
            }
            direct.addSampledAlone(i, here, bsdf, -dx, -dy, -dz, r, g, b, u, v, radiance);
        }
    }
}
