package org.daybreak.tracing;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.scene.RayCaster;

/**
 * Joins vertices of light subpaths to the lens (techniques with t = 1): finds where the edge meets the film and what it
 * carries. One object per worker; light tracing and bidirectional path tracing share it.
 *
 * <p>A connection is <em>aimed</em> first, which leaves f·cos·importance/density in {@link #value}; whoever has weights or
 * Russian roulette to apply does so, and {@link #splat} tests visibility last and only if there is something to see. The sum of
 * splats over a pixel, divided by the number of light subpaths traced (not of splats), is the pixel's mean radiance.
 */
public final class LensConnection {
    /** An emitter at infinity stands this many scene sizes away: its parallax is below what a film position resolves. */
    private static final double FAR = 1e9;

    private final Camera camera;
    private final RayCaster caster;
    private final LensSample lens = new LensSample();
    private final CameraRay cameraRay = new CameraRay();
    private final LightSample sky = new LightSample();
    private final Spectrum value = new Spectrum();
    private final double pixels;
    private final double sceneSize;
    private double filmDensity;
    private double scatteringDensity;

    /** Creates what a worker needs to join vertices to the lens of a camera. */
    public LensConnection(Camera camera, RayCaster caster) {
        this.camera = camera;
        this.caster = caster;
        pixels = (double) camera.width() * camera.height();
        Bounds bounds = caster.scene().bounds();
        sceneSize = bounds.isEmpty() ? 0 : 2 * bounds.boundingSphereRadius();
    }

    /**
     * Aims from a scattering vertex (s ≥ 2).
     *
     * @param woX direction back along the light subpath
     * @param u first number for the point on the lens
     * @return false if nothing arrives: the lens does not see the point, or nothing scatters towards it
     */
    public boolean aimFromSurface(SurfacePoint p, Bsdf bsdf, double woX, double woY, double woZ, double u, double v) {
        if (!camera.sampleLens(p.x, p.y, p.z, u, v, lens)) {
            return false;
        }
        scatteringDensity = Scattering.evaluate(
                bsdf, p, woX, woY, woZ, lens.wiX, lens.wiY, lens.wiZ, TransportMode.IMPORTANCE, value);
        return complete(p);
    }

    /**
     * Aims from the first vertex of a light subpath (s = 1): the emitter as it is seen directly. The density of the
     * direction that the subpath goes on with plays no part, as the direction here is another one. The value is still to
     * be divided by the density of the point per area and by the probability of the light.
     *
     * @param light a light that is neither at infinity nor a single point
     * @return false if nothing arrives
     */
    public boolean aimFromEmitter(Light light, SurfacePoint y0, double u, double v) {
        if (!camera.sampleLens(y0.x, y0.y, y0.z, u, v, lens)) {
            return false;
        }
        light.radiance(y0, lens.wiX, lens.wiY, lens.wiZ, value);
        value.scale(Math.abs(y0.geometricCosine(lens.wiX, lens.wiY, lens.wiZ)));
        return complete(y0);
    }

    private boolean complete(SurfacePoint p) {
        if (value.isBlack()) {
            return false;
        }
        value.scale(lens.weight);
        filmDensity = lens.weight * Math.abs(p.geometricCosine(lens.wiX, lens.wiY, lens.wiZ)) / pixels;
        return true;
    }

    /**
     * Aims from a light at infinity (s = 1). It has no point that a subpath starts from and sees the lens by, so the
     * light's direction is sampled from the lens point. The value is divided by the density of that direction, but not yet by
     * the probability of the light.
     *
     * @param light a light at infinity that is not a single direction
     * @param s first number for the direction, with {@code t}
     * @return the density of the direction per solid angle; 1 for a camera of parallel rays, where the film position is drawn
     *     instead, as {@link #filmDensity} is then; 0 if nothing arrives
     */
    public double aimFromInfinity(Light light, double s, double t, double u, double v) {
        if (camera.isParallel()) {
            return aimFromFilm(light, s, t) ? 1 : 0;
        }
        // Any film position gives the lens point of u and v.
        if (!camera.sampleRay(0.5 * camera.width(), 0.5 * camera.height(), u, v, cameraRay)) {
            return 0;
        }
        double ox = cameraRay.ox;
        double oy = cameraRay.oy;
        double oz = cameraRay.oz;
        if (!light.sampleIncident(ox, oy, oz, s, t, sky)) {
            return 0;
        }
        double size = Math.max(sceneSize, Math.max(Math.abs(ox), Math.max(Math.abs(oy), Math.abs(oz))));
        double far = size > 0 ? FAR * size : FAR;
        if (!camera.sampleLens(ox + far * sky.wiX, oy + far * sky.wiY, oz + far * sky.wiZ, u, v, lens)) {
            return 0;
        }
        double perSolidAngle = lens.weight * lens.distance * lens.distance;
        lens.distance = Double.POSITIVE_INFINITY;
        lens.wiX = -sky.wiX;
        lens.wiY = -sky.wiY;
        lens.wiZ = -sky.wiZ;
        filmDensity = perSolidAngle / pixels;
        value.set(sky.weight);
        value.scale(perSolidAngle);
        return value.isBlack() ? 0 : sky.density;
    }

    /** The same for a camera of parallel rays: of all directions it sees one, so the film position is drawn instead. */
    private boolean aimFromFilm(Light light, double s, double t) {
        lens.filmX = s * camera.width();
        lens.filmY = t * camera.height();
        if (!camera.sampleRay(lens.filmX, lens.filmY, 0.5, 0.5, cameraRay)) {
            return false;
        }
        double dx = cameraRay.dx;
        double dy = cameraRay.dy;
        double dz = cameraRay.dz;
        SurfacePoint origin = lens.point;
        light.radiance(origin, -dx, -dy, -dz, value);
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
        lens.distance = Double.POSITIVE_INFINITY;
        lens.wiX = -dx;
        lens.wiY = -dy;
        lens.wiZ = -dz;
        value.scale(pixels);
        filmDensity = 1;
        return !value.isBlack();
    }

    /** The lens point, and where the edge meets the film. */
    public LensSample lens() {
        return lens;
    }

    /** What was aimed: f·|cos θ| (or radiance and cosine) times importance over the density of the lens point. */
    public Spectrum value() {
        return value;
    }

    /**
     * Density with which a camera ray from the lens point, its film point drawn uniformly over the whole film, arrives at
     * the vertex: per area; per solid angle for lights at infinity.
     */
    public double filmDensity() {
        return filmDensity;
    }

    /**
     * Density per solid angle with which the subpath, when it was last aimed {@linkplain #aimFromSurface from a surface}, would
     * have scattered towards the lens.
     */
    public double scatteringDensity() {
        return scatteringDensity;
    }

    /**
     * Splats what was aimed times factors, if the lens sees the vertex.
     *
     * @param p the vertex that was aimed from; for lights at infinity it plays no part
     * @return false if the contribution was not finite
     */
    public boolean splat(SurfacePoint p, double r, double g, double b, SplatBuffer splats) {
        double cr = r * value.r;
        double cg = g * value.g;
        double cb = b * value.b;
        if (cr == 0 && cg == 0 && cb == 0) {
            return true;
        }
        double visible = transmittance(p);
        return visible == 0 || splats.add(lens.filmX, lens.filmY, visible * cr, visible * cg, visible * cb);
    }

    /**
     * Fraction of light that gets from the vertex to the lens: a test for occlusion.
     *
     * @param p the vertex that was aimed from; for lights at infinity it plays no part
     */
    public double transmittance(SurfacePoint p) {
        return lens.distance == Double.POSITIVE_INFINITY
                ? caster.transmittanceToInfinity(lens.point, -lens.wiX, -lens.wiY, -lens.wiZ)
                : caster.transmittance(p, lens.point);
    }
}
