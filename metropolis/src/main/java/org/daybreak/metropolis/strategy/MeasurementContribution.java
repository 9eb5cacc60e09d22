package org.daybreak.metropolis.strategy;

import org.daybreak.bidirectional.LightDensities;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Densities;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Outcome;
import org.daybreak.tracing.EmissionGuide;

/**
 * Evaluates whole paths: the measurement contribution function f (Veach 1997, eq. 8.7), and the densities of all
 * vertices as walks from both ends sample them, in the measures of {@link LightPath}. f is relative to the film, so
 * that its integral over all paths is the mean of the image (§11.3). One object per worker.
 */
final class MeasurementContribution {
    /** Below this squared length η·wo + wi is what manifold walks leave of the angle of a lobe that goes straight on. */
    private static final double SMALLEST_FACET = 1e-10;

    private final Scene scene;
    private final Camera camera;
    private final LightDensities lights;
    private final Failure failure;
    private final double pixels;
    private final CameraRay cameraRay = new CameraRay();
    private final LensSample lens = new LensSample();
    private final LightSample incident = new LightSample();
    private final BsdfSample scattered = new BsdfSample();
    private final Spectrum spectrum = new Spectrum();

    MeasurementContribution(Scene scene, Camera camera, EmissionGuide guide, Failure failure) {
        this.scene = scene;
        this.camera = camera;
        this.failure = failure;
        lights = new LightDensities(scene, guide, false);
        pixels = (double) camera.width() * camera.height();
    }

    /**
     * Computes what depends on some vertices: scattering and densities of theirs and of their neighbours, then the
     * contribution without the visibility of edges that {@link EdgeTracer#reveal} is still to test.
     *
     * @param first lowest vertex that is new or has a new neighbour
     * @param last highest such vertex
     * @return false if the path carries nothing
     */
    boolean measure(LightPath y, int first, int last) {
        int k = y.length - 1;
        if (last >= k - 1 && !measureLens(y, k)) {
            return failure.because(Outcome.OFF_FILM);
        }
        for (int i = Math.max(1, first); i <= Math.min(last, k - 1); i++) {
            if (!measureVertex(y, i)) {
                return failure.because(Outcome.BLACK);
            }
        }
        if (first <= 1 && !measureLight(y, k)) {
            return failure.because(Outcome.BLACK);
        }
        return sum(y, k) || failure.because(Outcome.BLACK);
    }

    /** Sets the density of x_{k−1} from the film. */
    private boolean measureLens(LightPath y, int k) {
        y.fromEye[k] = 1;
        SurfacePoint p = y.points[k - 1];
        if (k == 1 && y.infinite) {
            if (!camera.sampleRay(y.filmX, y.filmY, y.lensU, y.lensV, cameraRay)) {
                return false;
            }
            y.filmPerSolidAngle = camera.isParallel() ? 0 : pixels * cameraRay.densityDirection;
            y.fromEye[0] = camera.isParallel() ? 1 : cameraRay.densityDirection;
            return true;
        }
        if (!camera.sampleLens(p.x, p.y, p.z, y.lensU, y.lensV, lens)) {
            return false;
        }
        y.filmPerSolidAngle = camera.isParallel() ? 0 : lens.weight * lens.distance * lens.distance;
        y.fromEye[k - 1] = lens.weight * Math.abs(p.geometricCosine(lens.wiX, lens.wiY, lens.wiZ)) / pixels;
        return true;
    }

    private boolean measureVertex(LightPath y, int i) {
        SurfacePoint p = y.points[i];
        Bsdf bsdf = y.bsdfs[i];
        double ex = y.dx[i];
        double ey = y.dy[i];
        double ez = y.dz[i];
        double lx = -y.dx[i - 1];
        double ly = -y.dy[i - 1];
        double lz = -y.dz[i - 1];
        double perEye;
        double perLight;
        if (y.lobe[i] < 0) {
            perEye = Scattering.evaluate(bsdf, p, ex, ey, ez, lx, ly, lz, TransportMode.RADIANCE, spectrum);
            y.lobeFromEye[i] = 1;
            y.lobeFromLight[i] = 1;
            perLight = spectrum.isBlack()
                    ? 0
                    : Scattering.density(bsdf, p, lx, ly, lz, ex, ey, ez, TransportMode.IMPORTANCE);
        } else {
            if (!Scattering.deltaLobe(bsdf, p, lx, ly, lz, y.lobe[i], TransportMode.IMPORTANCE, scattered)) {
                return false;
            }
            y.lobeFromLight[i] = scattered.density;
            if (!Scattering.deltaLobe(bsdf, p, ex, ey, ez, y.lobe[i], TransportMode.RADIANCE, scattered)) {
                return false;
            }
            y.lobeFromEye[i] = scattered.density;
            double eta = scattered.eta;
            perEye = facetCosine(p, ex, ey, ez, lx, ly, lz, eta) / eta;
            perLight = facetCosine(p, lx, ly, lz, ex, ey, ez, 1 / eta) * eta;
            spectrum.set(scattered.weight);
            spectrum.scale(perEye);
        }
        if (spectrum.isBlack()) {
            return false;
        }
        y.scatterR[i] = spectrum.r;
        y.scatterG[i] = spectrum.g;
        y.scatterB[i] = spectrum.b;
        y.fromEye[i - 1] = i == 1 && y.deltaLight ? 0 : perEye * WalkDensities.towardsLight(y, i - 1);
        if (i + 1 < y.length - 1) {
            SurfacePoint next = y.points[i + 1];
            y.fromLight[i + 1] = Densities.solidAngleToArea(perLight, y.squared[i], next.geometricCosine(ex, ey, ez));
        }
        return true;
    }

    /**
     * |wi·m| for the normal m that a delta lobe reflects or refracts at, which need not be that of shading: maps of
     * normals turn it. It lies along η·wo + wi; what goes straight on has none, and any normal will do.
     *
     * @param eta η: refractive index on wo's side over that on wi's side
     */
    private static double facetCosine(
            SurfacePoint p, double woX, double woY, double woZ, double wiX, double wiY, double wiZ, double eta) {
        double x = eta * woX + wiX;
        double y = eta * woY + wiY;
        double z = eta * woZ + wiZ;
        double squaredLength = x * x + y * y + z * z;
        return squaredLength > SMALLEST_FACET
                ? Math.abs(wiX * x + wiY * y + wiZ * z) / Math.sqrt(squaredLength)
                : Math.abs(p.localZ(wiX, wiY, wiZ));
    }

    /** Sets emission and the densities of x₀ and x₁ from the light. */
    private boolean measureLight(LightPath y, int k) {
        Light light = scene.light(y.light);
        SurfacePoint next = y.points[1];
        double wiX = -y.dx[0];
        double wiY = -y.dy[0];
        double wiZ = -y.dz[0];
        if (y.deltaLight) {
            if (!light.sampleIncident(next.x, next.y, next.z, 0.5, 0.5, incident)) {
                return false;
            }
            y.emission.set(incident.weight);
        } else {
            light.radiance(y.points[0], y.dx[0], y.dy[0], y.dz[0], y.emission);
        }
        if (y.emission.isBlack()) {
            return false;
        }
        if (k == 1) {
            y.fromLight[0] = 0;
            y.nextEvent = 0;
            return true;
        }
        double chosen = 0;
        double perSolidAngle = 0;
        if (y.lobe[1] < 0) {
            chosen = lights.choice(y.light, next, y.bsdfs[1], y.dx[1], y.dy[1], y.dz[1]);
            perSolidAngle =
                    y.deltaLight ? 1 : light.incidentDensity(next.x, next.y, next.z, y.points[0], wiX, wiY, wiZ);
        }
        lights.set(y.light, y.points[0], next, wiX, wiY, wiZ, chosen, perSolidAngle);
        y.fromLight[0] = lights.first;
        y.fromLight[1] = lights.second;
        y.nextEvent = lights.nextEvent;
        return true;
    }

    /** The product of all factors: contribution relative to the film. */
    private static boolean sum(LightPath y, int k) {
        double r = y.emission.r;
        double g = y.emission.g;
        double b = y.emission.b;
        double factor = y.fromEye[k - 1];
        for (int i = k - 1; i > 0; i--) {
            r *= y.scatterR[i];
            g *= y.scatterG[i];
            b *= y.scatterB[i];
            factor *= (i == 1 && y.deltaLight ? 1 : WalkDensities.towardsLight(y, i - 1)) * y.clear[i];
        }
        factor *= y.clear[0];
        y.value.set(r * factor, g * factor, b * factor);
        y.contribution = y.value.luminance();
        return y.contribution > 0 && y.contribution < Double.POSITIVE_INFINITY;
    }
}
