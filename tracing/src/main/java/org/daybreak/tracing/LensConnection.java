package org.daybreak.tracing;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionSample;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSample;
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
    private final LightSample sky = new LightSample();
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
     * @param light a light that is neither at infinity nor a single point
     * @param chosen probability with which the light was chosen
     * @return false if the contribution was not finite
     */
    boolean joinEmitter(Light light, EmissionSample y0, double chosen, double u, double v, SplatBuffer splats) {
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
     * Joins a light at infinity to the lens (s = 1). It has no point that a subpath starts from and sees the lens by, so the
     * light's direction is sampled from the lens point.
     *
     * @param light a light at infinity that is not a single direction
     * @param chosen probability with which the light was chosen
     * @param s first number for the direction, with {@code t}
     * @return false if the contribution was not finite
     */
    boolean joinInfinite(Light light, double chosen, double s, double t, double u, double v, SplatBuffer splats) {
        if (camera.isParallel()) {
            return joinInfiniteFromFilm(light, chosen, s, t, splats);
        }
        // Any film position gives the lens point of u and v.
        if (!camera.sampleRay(0.5 * camera.width(), 0.5 * camera.height(), u, v, cameraRay)) {
            return true;
        }
        double ox = cameraRay.ox;
        double oy = cameraRay.oy;
        double oz = cameraRay.oz;
        if (!light.sampleIncident(ox, oy, oz, s, t, sky)) {
            return true;
        }
        double size = Math.max(sceneSize, Math.max(Math.abs(ox), Math.max(Math.abs(oy), Math.abs(oz))));
        double far = size > 0 ? FAR * size : FAR;
        if (!camera.sampleLens(ox + far * sky.wiX, oy + far * sky.wiY, oz + far * sky.wiZ, u, v, lens)) {
            return true;
        }
        double scale = lens.weight * lens.distance * lens.distance / chosen;
        double r = scale * sky.weight.r;
        double g = scale * sky.weight.g;
        double b = scale * sky.weight.b;
        if (r == 0 && g == 0 && b == 0) {
            return true;
        }
        double visible = caster.transmittanceToInfinity(lens.point, sky.wiX, sky.wiY, sky.wiZ);
        return visible == 0 || splats.add(lens.filmX, lens.filmY, visible * r, visible * g, visible * b);
    }

    /** The same for a camera of parallel rays: of all directions it sees one, so the film position is drawn instead. */
    private boolean joinInfiniteFromFilm(Light light, double chosen, double s, double t, SplatBuffer splats) {
        double filmX = s * camera.width();
        double filmY = t * camera.height();
        if (!camera.sampleRay(filmX, filmY, 0.5, 0.5, cameraRay)) {
            return true;
        }
        double dx = cameraRay.dx;
        double dy = cameraRay.dy;
        double dz = cameraRay.dz;
        light.radiance(lens.point, -dx, -dy, -dz, value);
        if (value.isBlack()) {
            return true;
        }
        SurfacePoint origin = lens.point;
        origin.x = cameraRay.ox;
        origin.y = cameraRay.oy;
        origin.z = cameraRay.oz;
        origin.gx = dx;
        origin.gy = dy;
        origin.gz = dz;
        origin.offset = 0;
        origin.shape = -1;
        origin.primitive = -1;
        origin.instance = -1;
        double scale = (double) camera.width() * camera.height() / chosen;
        double visible = scale * caster.transmittanceToInfinity(origin, dx, dy, dz);
        return visible == 0 || splats.add(filmX, filmY, visible * value.r, visible * value.g, visible * value.b);
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
