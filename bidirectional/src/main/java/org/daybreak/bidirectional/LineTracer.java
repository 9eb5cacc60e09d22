package org.daybreak.bidirectional;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionSample;
import org.daybreak.core.light.Light;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Densities;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.Dimensions;
import org.daybreak.tracing.EmissionGuide;

/**
 * Traces one subpath, from the lens or from a light, and fills a {@link PathValues} (the thesis' class of that name; Veach 1997,
 * §10.1). One object per worker.
 *
 * <p>Where a ray meets an alpha mask, the sample of its material decides whether there is a vertex. If not, the ray goes
 * on and the vertex that it leads to takes the place; if so, its throughput is divided by the opacity for all that connects to it.
 */
public final class LineTracer {
    /** Even a path that loses nothing should end some day. */
    private static final double LARGEST_SURVIVAL = 0.95;

    /** Part of the throughput at the start below which Russian roulette thins paths out. */
    private static final double ROULETTE_THROUGHPUT = 0.5;

    /** Told of emission that an eye path meets, when the path ends there for the moment. */
    @FunctionalInterface
    interface Emission {
        /**
         * The last vertex of the path lies on a light, or at infinity in a scene with environment lights. The walk may pass
         * through it, so this is the time to gather what it emits.
         */
        void met(PathValues path);
    }

    /** Told of light paths whose ray hits the lens. */
    @FunctionalInterface
    interface LensHits {
        /**
         * The ray that leaves the last vertex of the path hits the lens, and goes on.
         *
         * @param r red of the throughput f/p along the ray
         * @param density density per area with which the path samples the point of the lens
         * @param filmDensity density of the last vertex as sampled from the film: per area, at infinity per solid angle
         */
        void hit(PathValues path, double r, double g, double b, double density, double filmDensity);
    }

    /** Told of emission and does not care. */
    static final Emission NO_EMISSION = path -> {};

    /** Told of hits of the lens and does not care. */
    static final LensHits NO_HITS = (path, r, g, b, density, filmDensity) -> {};

    private final Scene scene;
    private final Camera camera;
    private final RayCaster caster;
    private final LightDensities lights;
    private final EmissionGuide guide;
    private final double exponent;
    private final double lensTerm;
    private final boolean lensHits;
    private final LensSample lens;
    private LensHits hits = NO_HITS;
    private final int rrDepth;
    private final int splitting;
    private final double pixels;
    /** Density per area across the rays of a camera of parallel rays; 0 for others. */
    private final double parallelDensity;

    private final CameraRay cameraRay = new CameraRay();
    private final EmissionSample emission = new EmissionSample();
    private final BsdfSample scattered = new BsdfSample();

    /** The walk in hand. */
    private PathValues path = new PathValues();

    private TransportMode mode = TransportMode.RADIANCE;
    private boolean eye;
    private int subpath;
    private int maxVertices;
    private int dimensionShift;

    /** The ray to trace next, its density per solid angle, or per area across it if it is one of parallel rays. */
    private double dx;

    private double dy;
    private double dz;
    private double density;
    private boolean parallel;

    /** Where that ray starts: the last vertex, or a mask that was passed. */
    private SurfacePoint origin = new SurfacePoint();

    private RayKind kind = RayKind.CAMERA;

    private double r;
    private double g;
    private double b;
    private double start;
    private double etaScale;
    private int surface;

    /** Whether the material of the last vertex has been sampled as its mask was, and with which result. */
    private boolean maskSampled;

    private boolean scatters;

    private double survival;

    /** The walk as it was at the vertex where it splits. */
    private double forkX;

    private double forkY;
    private double forkZ;
    private double forkR;
    private double forkG;
    private double forkB;
    private double forkStart;
    private double forkEtaScale;
    private int forkSurface;
    private int forkMaxVertices;

    /**
     * Creates a tracer.
     *
     * @param caster of the worker
     * @param guide of the worker
     * @param lights of the worker
     * @param exponent of the heuristic
     * @param limits what can be sampled
     * @param lens set to the point of the lens where a light path hits it
     * @param rrDepth Russian roulette may end a subpath from this number of edges on
     * @param splitting number of ways in which eye subpaths go on from the first vertex that can be connected
     */
    LineTracer(
            Camera camera,
            RayCaster caster,
            EmissionGuide guide,
            LightDensities lights,
            double exponent,
            TechniqueLimits limits,
            LensSample lens,
            int rrDepth,
            int splitting) {
        this.scene = caster.scene();
        this.camera = camera;
        this.caster = caster;
        this.exponent = exponent;
        lensTerm = limits.lensTerm(exponent);
        lensHits = limits.lensHits();
        this.lens = lens;
        this.rrDepth = rrDepth;
        this.splitting = splitting;
        this.guide = guide;
        this.lights = lights;
        pixels = (double) camera.width() * camera.height();
        parallelDensity = camera.isParallel() ? parallelDensity() : 0;
    }

    /** The density that {@code LensConnection.filmDensity} has for such a camera: the same everywhere. */
    private double parallelDensity() {
        if (!camera.sampleRay(0.5 * camera.width(), 0.5 * camera.height(), 0.5, 0.5, cameraRay)) {
            return 0;
        }
        LensSample ahead = new LensSample();
        boolean seen = camera.sampleLens(
                cameraRay.ox + cameraRay.dx, cameraRay.oy + cameraRay.dy, cameraRay.oz + cameraRay.dz, 0.5, 0.5, ahead);
        return seen ? ahead.weight / pixels : 0;
    }

    /** The ray that the last eye subpath started with. */
    CameraRay cameraRay() {
        return cameraRay;
    }

    /**
     * Traces an eye subpath.
     *
     * @param lensU first number for the point on the lens
     * @param maxVertices largest number of vertices, at least 1
     * @param path receives the subpath, up to the vertex where it splits
     * @param met told of emission
     * @return false if the film position sees nothing
     */
    boolean traceEye(
            double filmX,
            double filmY,
            double lensU,
            double lensV,
            int maxVertices,
            Sampler sampler,
            PathValues path,
            Emission met) {
        path.setLength(0);
        if (!camera.sampleRay(filmX, filmY, lensU, lensV, cameraRay)) {
            return false;
        }
        SurfacePoint z0 = path.points[0];
        z0.x = cameraRay.ox;
        z0.y = cameraRay.oy;
        z0.z = cameraRay.oz;
        z0.gx = cameraRay.normalX;
        z0.gy = cameraRay.normalY;
        z0.gz = cameraRay.normalZ;
        z0.offset = 0;
        z0.shape = -1;
        double onLens = lensHits ? cameraRay.densityPosition : 1;
        path.start(cameraRay.weight, cameraRay.weight, cameraRay.weight, onLens, -1);
        path.tail[0] = lensHits ? 1 : 0;
        begin(path, TransportMode.RADIANCE, cameraRay.dx, cameraRay.dy, cameraRay.dz, maxVertices, 0);
        kind = RayKind.CAMERA;
        parallel = camera.isParallel();
        density = parallel ? parallelDensity : cameraRay.densityDirection;
        walk(sampler, met, true);
        return true;
    }

    /**
     * Goes on from the vertex where the last eye subpath has split ({@link PathValues#fork}), after the vertices up to there.
     *
     * @param split the eye subpath
     * @param branch which of the {@code splitting} ways
     */
    void traceBranch(PathValues split, int branch, Sampler sampler, Emission met) {
        sampler.branch(branch, splitting);
        path = split;
        mode = TransportMode.RADIANCE;
        eye = true;
        maxVertices = forkMaxVertices;
        maskSampled = false;
        path.setLength(path.fork + 1);
        dimensionShift = Dimensions.SPLIT;
        dx = forkX;
        dy = forkY;
        dz = forkZ;
        r = forkR / splitting;
        g = forkG / splitting;
        b = forkB / splitting;
        start = forkStart / splitting;
        etaScale = forkEtaScale;
        surface = forkSurface;
        if (scatter(sampler)) {
            walk(sampler, met, false);
        }
    }

    /**
     * Traces a light subpath.
     *
     * @param index the light
     * @param chosen probability with which it was chosen
     * @param subpath number of the light subpath within the sample: for dimensions
     * @param maxVertices largest number of vertices, at least 1
     * @param path receives the subpath; of length 0 if the light emits nothing
     * @param lensHit told of hits of the lens, which is one of so many vertices then
     */
    void traceLight(
            int index,
            double chosen,
            int subpath,
            int maxVertices,
            Sampler sampler,
            PathValues path,
            LensHits lensHit) {
        path.setLength(0);
        hits = lensHit;
        Light light = scene.light(index);
        sampler.setDimension(Dimensions.lightPath(0, subpath));
        double u = sampler.next();
        double v = sampler.next();
        double s = sampler.next();
        double t = sampler.next();
        if (!guide.sample(index, u, v, s, t, emission)) {
            return;
        }
        path.points[0].set(emission.point);
        boolean infinite = light.isInfinite();
        double first = infinite ? emission.densityDirection : emission.densityPosition;
        path.start(
                emission.weight.r / chosen,
                emission.weight.g / chosen,
                emission.weight.b / chosen,
                chosen * first,
                index);
        path.infinite = infinite;
        path.deltaLight = light.isDelta();
        path.tail[0] = path.deltaLight ? 0 : 1;
        begin(path, TransportMode.IMPORTANCE, emission.dx, emission.dy, emission.dz, maxVertices, subpath);
        kind = RayKind.LIGHT;
        parallel = infinite;
        density = infinite ? emission.densityPosition : emission.densityDirection;
        if (!emission.weight.isBlack()) {
            walk(sampler, NO_EMISSION, false);
        }
    }

    private void begin(
            PathValues newPath,
            TransportMode newMode,
            double startX,
            double startY,
            double startZ,
            int newMaxVertices,
            int newSubpath) {
        path = newPath;
        mode = newMode;
        eye = newMode == TransportMode.RADIANCE;
        subpath = newSubpath;
        maxVertices = newMaxVertices;
        dimensionShift = 0;
        dx = startX;
        dy = startY;
        dz = startZ;
        r = path.throughputR[0];
        g = path.throughputG[0];
        b = path.throughputB[0];
        start = Math.max(r, Math.max(g, b));
        etaScale = 1;
        surface = 0;
        origin = path.points[0];
    }

    /** Traces the ray in hand and goes on until the path ends or, if it may, splits. */
    private void walk(Sampler sampler, Emission met, boolean maySplit) {
        boolean more = path.length() < maxVertices;
        while (more && arrive(sampler, met)) {
            int i = path.length() - 1;
            if (maySplit && path.connectable[i]) {
                path.fork = i;
                if (splits(path, i)) {
                    saveFork();
                    return;
                }
                maySplit = false;
            }
            more = scatter(sampler);
        }
    }

    /** True if eye subpaths split at a vertex that is the first one from the lens which can be connected. */
    boolean splits(PathValues of, int vertex) {
        return splitting > 1 && !of.bsdfs[vertex].maybeTransparent();
    }

    private void saveFork() {
        path.splits = true;
        forkX = dx;
        forkY = dy;
        forkZ = dz;
        forkR = r;
        forkG = g;
        forkB = b;
        forkStart = start;
        forkEtaScale = etaScale;
        forkSurface = surface;
        forkMaxVertices = maxVertices;
    }

    /**
     * Traces the ray in hand to the next vertex and fills in what is known there.
     *
     * @return false if there is none
     */
    private boolean arrive(Sampler sampler, Emission met) {
        int i = path.length();
        path.reserve(i + 1);
        SurfacePoint from = path.points[i - 1];
        SurfacePoint here = path.points[i];
        while (true) {
            // Behind a mask that was passed, the origin is where the next hit will be written.
            double passed = lensHits && !eye ? squaredDistance(from, origin) : 0;
            boolean found = kind == RayKind.CAMERA
                    ? caster.trace(origin.x, origin.y, origin.z, dx, dy, dz, kind, here)
                    : caster.trace(origin, dx, dy, dz, kind, here);
            if (lensHits && !eye) {
                meetLens(i, from, passed, found ? squaredDistance(from, here) : Double.POSITIVE_INFINITY);
            }
            surface++;
            path.backX[i] = -dx;
            path.backY[i] = -dy;
            path.backZ[i] = -dz;
            path.throughputR[i] = r;
            path.throughputG[i] = g;
            path.throughputB[i] = b;
            path.surface[i] = surface + dimensionShift;
            if (!found) {
                escape(i, met);
                return false;
            }
            double squared = squaredDistance(from, here);
            double cosine = Math.abs(here.geometricCosine(dx, dy, dz));
            path.forward[i] = parallel ? density * cosine : Densities.solidAngleToArea(density, squared, cosine);
            path.toPrevious[i] =
                    i > 1 ? Densities.solidAngleToArea(1, squared, from.geometricCosine(dx, dy, dz)) : toFirst(squared);
            Bsdf bsdf = scene.bsdf(here.shape);
            path.bsdfs[i] = bsdf;
            path.connectable[i] = bsdf.connectable();
            path.delta[i] = false;
            path.light[i] = scene.lightOf(here.shape);
            path.setLength(i + 1);
            if (eye && path.light[i] >= 0) {
                met.met(path);
            }
            maskSampled = bsdf.maybeTransparent();
            if (!maskSampled) {
                break;
            }
            scatters = sample(bsdf, i, sampler);
            if (!scatters || !scattered.passThrough) {
                double opacity = 1 - bsdf.transparency(here);
                path.throughputR[i] = r / opacity;
                path.throughputG[i] = g / opacity;
                path.throughputB[i] = b / opacity;
                break;
            }
            path.setLength(i);
            origin = here;
            kind = RayKind.SCATTERED;
        }
        if (i == 1 && !eye) {
            path.nextEventRatio = path.connectable[1] ? lights.nextEvent(path) / path.forward[0] : 0;
        }
        return path.length() < maxVertices;
    }

    /**
     * Looks whether the ray in hand of a light subpath hits the lens.
     *
     * @param from the vertex that the ray comes from
     * @param passed squared distance from there to where the ray has its origin: at a mask if it has passed one
     * @param end squared distance to where it ends
     */
    private void meetLens(int i, SurfacePoint from, double passed, double end) {
        if (!camera.hitLens(from.x, from.y, from.z, dx, dy, dz, lens)) {
            return;
        }
        double squared = lens.distance * lens.distance;
        if (squared < passed || squared >= end) {
            return;
        }
        double cosine = lens.point.geometricCosine(dx, dy, dz);
        double onLens = parallel ? density * Math.abs(cosine) : Densities.solidAngleToArea(density, squared, cosine);
        double filmPerArea = lens.weight / pixels;
        double filmDensity =
                filmPerArea * (i == 1 && path.infinite ? squared : Math.abs(from.geometricCosine(dx, dy, dz)));
        hits.hit(path, r, g, b, onLens, filmDensity);
    }

    /** The ray in hand has left the scene: lights at infinity are a vertex for as long as it takes to gather them. */
    private void escape(int i, Emission met) {
        if (eye && scene.environmentCount() > 0) {
            path.infinite = true;
            // All directions that parallel rays have are one: see LensConnection.
            path.forward[i] = parallel ? 1 : density;
            path.light[i] = -1;
            path.setLength(i + 1);
            met.met(path);
            path.infinite = false;
            path.setLength(i);
        }
    }

    /** Samples the material of a vertex; its numbers for Russian roulette are drawn as well. */
    private boolean sample(Bsdf bsdf, int i, Sampler sampler) {
        int at = path.surface[i];
        double lobe = 0;
        survival = 0;
        if (i >= rrDepth || bsdf.choosesLobe()) {
            sampler.setDimension(eye ? Dimensions.choices(at) : Dimensions.lightPathChoices(at, subpath));
            lobe = sampler.next();
            survival = sampler.next();
        }
        sampler.setDimension(eye ? Dimensions.scattering(at) : Dimensions.lightPath(at, subpath));
        double u = sampler.next();
        double v = sampler.next();
        return Scattering.sample(bsdf, path.points[i], -dx, -dy, -dz, u, v, lobe, mode, scattered);
    }

    /**
     * Scatters at the last vertex.
     *
     * @return false if the path ends
     */
    private boolean scatter(Sampler sampler) {
        int i = path.length() - 1;
        SurfacePoint here = path.points[i];
        Bsdf bsdf = path.bsdfs[i];
        path.surface[i] = surface + dimensionShift;
        if (!(maskSampled ? scatters : sample(bsdf, i, sampler))) {
            return false;
        }
        r *= scattered.weight.r;
        g *= scattered.weight.g;
        b *= scattered.weight.b;
        double largest = Math.max(r, Math.max(g, b));
        if (largest == 0) {
            return false;
        }
        if (eye) {
            etaScale *= scattered.eta * scattered.eta;
        }
        if (i >= rrDepth) {
            double probability = Math.min(LARGEST_SURVIVAL, largest / (ROULETTE_THROUGHPUT * start * etaScale));
            if (survival >= probability) {
                return false;
            }
            r /= probability;
            g /= probability;
            b /= probability;
        }
        double nextX = scattered.wiX;
        double nextY = scattered.wiY;
        double nextZ = scattered.wiZ;
        double back;
        path.delta[i] = scattered.delta;
        path.lobe[i] = scattered.lobe;
        if (scattered.delta) {
            density = Math.abs(here.localZ(nextX, nextY, nextZ)) / scattered.eta;
            back = Math.abs(here.localZ(dx, dy, dz)) * scattered.eta;
        } else {
            density = scattered.density;
            TransportMode other = eye ? TransportMode.IMPORTANCE : TransportMode.RADIANCE;
            back = Scattering.density(bsdf, here, nextX, nextY, nextZ, -dx, -dy, -dz, other);
        }
        if (eye && i == path.fork && splits(path, i)) {
            density *= splitting;
        }
        path.reverse[i - 1] = back * path.toPrevious[i];
        path.tail[i] = tail(path, eye, i);
        dx = nextX;
        dy = nextY;
        dz = nextZ;
        parallel = false;
        origin = here;
        kind = RayKind.SCATTERED;
        return true;
    }

    /** T_i of {@link MisWeight#chain} for a vertex that the walk leaves, {@link PathValues#reverse} of the one before known. */
    private double tail(PathValues path, boolean eye, int i) {
        boolean edge = !path.delta[i] && !path.delta[i - 1];
        double admissible;
        if (i > 1) {
            admissible = edge ? 1 : 0;
        } else if (eye) {
            admissible = edge ? lensTerm : 0;
        } else {
            admissible = edge ? MisWeight.power(path.nextEventRatio, exponent) : 0;
        }
        double before = path.tail[i - 1];
        return before == 0
                ? admissible
                : admissible + MisWeight.power(path.reverse[i - 1] / path.forward[i - 1], exponent) * before;
    }

    /** {@link PathValues#toPrevious} of vertex 1. */
    private double toFirst(double squared) {
        if (eye ? !lensHits : path.deltaLight) {
            return 0;
        }
        return path.infinite ? 1 : Densities.solidAngleToArea(1, squared, path.points[0].geometricCosine(dx, dy, dz));
    }

    static double squaredDistance(SurfacePoint a, SurfacePoint b) {
        double x = b.x - a.x;
        double y = b.y - a.y;
        double z = b.z - a.z;
        return x * x + y * y + z * z;
    }
}
