package org.daybreak.tracing;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionSample;
import org.daybreak.core.light.Light;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.scene.RayCaster;

/**
 * Joins vertices of light subpaths to the lens (techniques with t = 1): finds where the edge meets the film, and splats the
 * contribution there. One object per worker.
 *
 * <p>A splat is f·cos·importance·throughput·visibility; the sum of splats over a pixel, divided by the number of light
 * subpaths traced (not of splats), is the pixel's mean radiance.
 */
final class LensConnection {
    /** An emitter at infinity stands this many scene sizes away: its parallax is below what a film position resolves. */
    private static final double FAR = 1e9;

    private final Camera camera;
    private final RayCaster caster;
    private final LensSample lens = new LensSample();
    private final CameraRay cameraRay = new CameraRay();
    private final Spectrum value = new Spectrum();
    private final double sceneSize;

    LensConnection(Camera camera, RayCaster caster) {
        this.camera = camera;
        this.caster = caster;
        Bounds bounds = caster.scene().bounds();
        sceneSize = bounds.isEmpty() ? 0 : 2 * bounds.boundingSphereRadius();
    }

    /**
     * Joins a scattering vertex to the lens (s ≥ 2).
     *
     * @param woX direction back along the light subpath
     * @param r throughput of the subpath up to the vertex, divided by all densities
     * @param u first number for the point on the lens
     * @return false if the contribution was not finite
     */
    boolean joinSurface(
            SurfacePoint p,
            Bsdf bsdf,
            double woX,
            double woY,
            double woZ,
            double r,
            double g,
            double b,
            double u,
            double v,
            SplatBuffer splats) {
        if (!camera.sampleLens(p.x, p.y, p.z, u, v, lens)) {
            return true;
        }
        Scattering.evaluate(bsdf, p, woX, woY, woZ, lens.wiX, lens.wiY, lens.wiZ, TransportMode.IMPORTANCE, value);
        return splat(r * lens.weight, g * lens.weight, b * lens.weight, p, splats);
    }

    /**
     * Joins the first vertex of a light subpath to the lens (s = 1): the emitter as it is seen directly. The density of the
     * direction that the subpath goes on with plays no part, as the direction here is another one.
     *
     * @param chosen probability with which the light was chosen
     * @return false if the contribution was not finite
     */
    boolean joinEmitter(Light light, EmissionSample y0, double chosen, double u, double v, SplatBuffer splats) {
        if (light.isDelta()) {
            return true;
        }
        if (light.isInfinite()) {
            return joinInfinite(light, y0, chosen, u, v, splats);
        }
        SurfacePoint p = y0.point;
        if (!camera.sampleLens(p.x, p.y, p.z, u, v, lens)) {
            return true;
        }
        light.radiance(p, lens.wiX, lens.wiY, lens.wiZ, value);
        double cosine = Math.abs(p.geometricCosine(lens.wiX, lens.wiY, lens.wiZ));
        double scale = cosine * lens.weight / (y0.densityPosition * chosen);
        return splat(scale, scale, scale, p, splats);
    }

    /**
     * For a light at infinity the direction of y₀ is what the lens sees, with its density per solid angle; its position on
     * the disk that covers the scene plays no part.
     */
    private boolean joinInfinite(
            Light light, EmissionSample y0, double chosen, double u, double v, SplatBuffer splats) {
        if (!camera.sampleRay(0.5 * camera.width(), 0.5 * camera.height(), u, v, cameraRay)) {
            return true;
        }
        double ox = cameraRay.ox;
        double oy = cameraRay.oy;
        double oz = cameraRay.oz;
        double far = FAR * Math.max(sceneSize, Math.max(Math.abs(ox), Math.max(Math.abs(oy), Math.abs(oz))));
        if (far == 0) {
            far = FAR;
        }
        if (!camera.sampleLens(ox - far * y0.dx, oy - far * y0.dy, oz - far * y0.dz, u, v, lens)) {
            return true;
        }
        light.radiance(y0.point, y0.dx, y0.dy, y0.dz, value);
        double perSolidAngle = lens.weight * lens.distance * lens.distance;
        double scale = perSolidAngle / (y0.densityDirection * chosen);
        value.scale(scale);
        if (value.isBlack()) {
            return true;
        }
        double visible = caster.transmittanceToInfinity(lens.point, -y0.dx, -y0.dy, -y0.dz);
        return visible == 0
                || splats.add(lens.filmX, lens.filmY, visible * value.r, visible * value.g, visible * value.b);
    }

    /** Multiplies the value in hand with factors, and with the visibility of the lens if there is anything to see. */
    private boolean splat(double r, double g, double b, SurfacePoint p, SplatBuffer splats) {
        double cr = r * value.r;
        double cg = g * value.g;
        double cb = b * value.b;
        if (cr == 0 && cg == 0 && cb == 0) {
            return true;
        }
        double visible = caster.transmittance(p, lens.point);
        return visible == 0 || splats.add(lens.filmX, lens.filmY, visible * cr, visible * cg, visible * cb);
    }
}
