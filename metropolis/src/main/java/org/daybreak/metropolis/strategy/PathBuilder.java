package org.daybreak.metropolis.strategy;

import java.util.Arrays;
import org.daybreak.bidirectional.Contribution;
import org.daybreak.bidirectional.LightDensities;
import org.daybreak.bidirectional.PathValues;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionSample;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightChoice;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.light.LightSelection;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Densities;
import org.daybreak.core.math.Frame;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Outcome;
import org.daybreak.tracing.EmissionGuide;

/**
 * Builds pieces of {@link LightPath}s: samples and traces single vertices, joins what was built, and evaluates contribution and
 * densities. All moves go through here, so their paths cannot differ in their conventions. One object per worker.
 *
 * <p>The order is always: place all new vertices (each knows its surface and, if it was sampled so, its delta lobe), {@link #measure}
 * what is between, {@link #reveal} the edges that no ray was traced along.
 */
public final class PathBuilder {
    /** Scattering at a mask that covers little is drawn again until it scatters; beyond this it counts as missed. */
    private static final int LARGEST_REPEATS = 1000;

    /** So many vertices a walk may have whose length is not known beforehand. */
    private static final int LONGEST_WALK = 64;

    /** Below this squared length η·wo + wi is what manifold walks leave of the angle of a lobe that goes straight on. */
    private static final double SMALLEST_FACET = 1e-10;

    private final Scene scene;
    private final Camera camera;
    private final RayCaster caster;
    private final LightSelection selection;
    private final EmissionGuide guide;
    private final LightDensities lights;
    private final double pixels;

    private final CameraRay cameraRay = new CameraRay();
    private final LensSample lens = new LensSample();
    private final EmissionSample emitted = new EmissionSample();
    private final LightSample incident = new LightSample();
    private final LightChoice choice = new LightChoice();
    private final BsdfSample scattered = new BsdfSample();
    private final Spectrum spectrum = new Spectrum();
    private final SurfacePoint veil = new SurfacePoint();

    private final Frame frame = new Frame();
    private final ChainPieces chains;
    private final LightPath scratchPath = new LightPath();

    /** Why the last operation has failed. */
    private Outcome failure = Outcome.MISSED;

    private boolean escaped;

    /** Direction that was sampled last. */
    private double wx;

    private double wy;
    private double wz;

    /** Creates what a worker needs. */
    public PathBuilder(Scene scene, Camera camera) {
        this.scene = scene;
        this.camera = camera;
        caster = new RayCaster(scene);
        chains = new ChainPieces(caster);
        selection = scene.lightSelection();
        guide = new EmissionGuide(scene);
        lights = new LightDensities(scene, guide, false);
        pixels = (double) camera.width() * camera.height();
        scratchPath.reserve(LONGEST_WALK);
        scratchPath.length = LONGEST_WALK;
    }

    /** The scene. */
    public Scene scene() {
        return scene;
    }

    /** The camera. */
    public Camera camera() {
        return camera;
    }

    /** Room for a walk from the lens whose length is not known beforehand: the lens is its last vertex. */
    LightPath scratchPath() {
        return scratchPath;
    }

    /** Room for a frame. */
    Frame frame() {
        return frame;
    }

    /** Chains of delta lobes between two vertices. */
    ChainPieces chains() {
        return chains;
    }

    /** Number of rays of a kind traced so far. */
    public long rays(RayKind kind) {
        return caster.count(kind);
    }

    /** True if the last ray was traced and has left the scene. */
    boolean escaped() {
        return escaped;
    }

    /** Why the last operation that returned false has failed. */
    public Outcome failure() {
        return failure;
    }

    boolean fail(Outcome why) {
        escaped = false;
        failure = why;
        return false;
    }

    // Placing vertices

    /**
     * Starts a light subpath: chooses a light, samples x₀ and a direction, and traces to x₁ if that is asked for.
     *
     * @param second whether x₁ is needed
     */
    boolean emit(LightPath y, boolean second, RandomStream random) {
        int index = selection.chooseForEmission(random.nextDouble());
        if (index < 0) {
            return fail(Outcome.BLACK);
        }
        double u = random.nextDouble();
        double v = random.nextDouble();
        double s = random.nextDouble();
        double t = random.nextDouble();
        if (!guide.sample(index, u, v, s, t, emitted)) {
            return fail(Outcome.BLACK);
        }
        Light light = scene.light(index);
        y.light = index;
        y.infinite = light.isInfinite();
        y.deltaLight = light.isDelta();
        y.points[0].set(emitted.point);
        setLight(y);
        y.dx[0] = emitted.dx;
        y.dy[0] = emitted.dy;
        y.dz[0] = emitted.dz;
        if (!second) {
            return true;
        }
        return trace(y, 0, 1, RayKind.LIGHT, random);
    }

    /**
     * Samples x₀ for x₁: next-event estimation.
     *
     * @return false if no light can reach x₁ from the sample
     */
    boolean sampleLight(LightPath y, RandomStream random) {
        SurfacePoint p = y.points[1];
        Bsdf bsdf = y.bsdfs[1];
        double side = LightDensities.side(p, bsdf, y.dx[1], y.dy[1], y.dz[1]);
        double number = random.nextDouble();
        if (!selection.choose(p.x, p.y, p.z, side * p.nx, side * p.ny, side * p.nz, number, choice)) {
            return fail(Outcome.BLACK);
        }
        Light light = scene.light(choice.light);
        double u = random.nextDouble();
        double v = random.nextDouble();
        if (!light.sampleIncident(p.x, p.y, p.z, u, v, incident)) {
            return fail(Outcome.BLACK);
        }
        y.light = choice.light;
        y.infinite = light.isInfinite();
        y.deltaLight = light.isDelta();
        y.points[0].set(incident.point);
        setLight(y);
        y.dx[0] = -incident.wiX;
        y.dy[0] = -incident.wiY;
        y.dz[0] = -incident.wiZ;
        return true;
    }

    /**
     * Sets the lens and a film position, and traces to x_{k−1}; with k = 1 that may lie at infinity.
     *
     * @param k index of the lens
     */
    boolean look(LightPath y, int k, double filmX, double filmY, RandomStream random) {
        y.filmX = filmX;
        y.filmY = filmY;
        if (!camera.sampleRay(filmX, filmY, y.lensU, y.lensV, cameraRay)) {
            return fail(Outcome.OFF_FILM);
        }
        SurfacePoint z = y.points[k];
        z.x = cameraRay.ox;
        z.y = cameraRay.oy;
        z.z = cameraRay.oz;
        z.gx = cameraRay.dx;
        z.gy = cameraRay.dy;
        z.gz = cameraRay.dz;
        z.offset = 0;
        z.shape = -1;
        y.setEnd(k);
        y.dx[k - 1] = -cameraRay.dx;
        y.dy[k - 1] = -cameraRay.dy;
        y.dz[k - 1] = -cameraRay.dz;
        return trace(y, k, k - 1, RayKind.CAMERA, random);
    }

    /** Draws a point on the lens. */
    void sampleLens(LightPath y, RandomStream random) {
        y.lensU = random.nextDouble();
        y.lensV = random.nextDouble();
    }

    /**
     * Joins x_{k−1} to the point on the lens.
     *
     * @return false if that lies outside of the film
     */
    boolean aim(LightPath y, int k) {
        SurfacePoint p = y.points[k - 1];
        if (!camera.sampleLens(p.x, p.y, p.z, y.lensU, y.lensV, lens)) {
            return fail(Outcome.OFF_FILM);
        }
        y.points[k].set(lens.point);
        y.setEnd(k);
        y.filmX = lens.filmX;
        y.filmY = lens.filmY;
        return true;
    }

    /**
     * Samples the material at a vertex for the next one: towards the lens on its way from the light, or towards the light on its
     * way from the lens. Sets the vertex's delta lobe, and the direction to go.
     *
     * @param towardsLight whether the walk comes from the lens
     */
    boolean scatter(LightPath y, int vertex, boolean towardsLight, RandomStream random) {
        SurfacePoint p = y.points[vertex];
        Bsdf bsdf = y.bsdfs[vertex];
        double woX = towardsLight ? y.dx[vertex] : -y.dx[vertex - 1];
        double woY = towardsLight ? y.dy[vertex] : -y.dy[vertex - 1];
        double woZ = towardsLight ? y.dz[vertex] : -y.dz[vertex - 1];
        TransportMode mode = towardsLight ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
        int repeats = 0;
        do {
            double u = random.nextDouble();
            double v = random.nextDouble();
            double w = random.nextDouble();
            if (++repeats > LARGEST_REPEATS || !Scattering.sample(bsdf, p, woX, woY, woZ, u, v, w, mode, scattered)) {
                return fail(Outcome.BLACK);
            }
        } while (scattered.passThrough);
        y.lobe[vertex] = scattered.delta ? scattered.lobe : -1;
        setDirection(scattered.wiX, scattered.wiY, scattered.wiZ);
        return true;
    }

    /** Follows the delta lobe that is set at a vertex; {@link #scatter} otherwise. */
    boolean follow(LightPath y, int vertex, boolean towardsLight) {
        SurfacePoint p = y.points[vertex];
        double woX = towardsLight ? y.dx[vertex] : -y.dx[vertex - 1];
        double woY = towardsLight ? y.dy[vertex] : -y.dy[vertex - 1];
        double woZ = towardsLight ? y.dz[vertex] : -y.dz[vertex - 1];
        TransportMode mode = towardsLight ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
        if (!Scattering.deltaLobe(y.bsdfs[vertex], p, woX, woY, woZ, y.lobe[vertex], mode, scattered)) {
            return fail(Outcome.KIND_CHANGED);
        }
        setDirection(scattered.wiX, scattered.wiY, scattered.wiZ);
        return true;
    }

    /**
     * Chooses whether a walk from the lens goes on by a delta lobe at a vertex, with the probabilities that the material samples them
     * with, and by which.
     *
     * @return false if it chooses none
     */
    boolean chooseLobe(LightPath y, int vertex, RandomStream random) {
        Bsdf bsdf = y.bsdfs[vertex];
        int lobes = bsdf.deltaLobes();
        y.lobe[vertex] = -1;
        if (lobes == 0) {
            return false;
        }
        double left = random.nextDouble() * y.opacity[vertex];
        for (int i = 0; i < lobes; i++) {
            left -= lobeProbability(y, vertex, bsdf, i);
            if (left < 0) {
                y.lobe[vertex] = i;
                return true;
            }
        }
        return false;
    }

    /** Probability with which {@link #chooseLobe} chooses none at a vertex of a path. */
    double stopProbability(LightPath y, int vertex) {
        if (vertex == 0 && y.infinite) {
            return 1;
        }
        Bsdf bsdf = scene.bsdf(y.points[vertex].shape);
        double sum = 0;
        for (int i = bsdf.deltaLobes() - 1; i >= 0; i--) {
            sum += lobeProbability(y, vertex, bsdf, i);
        }
        // A hole, at which no walk stops, has neither lobes nor opacity.
        return sum == 0 ? 1 : 1 - sum / y.opacity[vertex];
    }

    private double lobeProbability(LightPath y, int vertex, Bsdf bsdf, int lobe) {
        boolean there = Scattering.deltaLobe(
                bsdf,
                y.points[vertex],
                y.dx[vertex],
                y.dy[vertex],
                y.dz[vertex],
                lobe,
                TransportMode.RADIANCE,
                scattered);
        return there ? scattered.density : 0;
    }

    /** Sets the direction that the next vertex is traced along. */
    void setDirection(double x, double y, double z) {
        wx = x;
        wy = y;
        wz = z;
    }

    /** Traces along the direction that was set, from a vertex to the next one towards the lens. */
    boolean traceToEye(LightPath y, int vertex, RandomStream random) {
        y.dx[vertex] = wx;
        y.dy[vertex] = wy;
        y.dz[vertex] = wz;
        return trace(y, vertex, vertex + 1, RayKind.SCATTERED, random);
    }

    /** Traces along the direction that was set, from a vertex to the next one towards the light, which may lie at infinity. */
    boolean traceToLight(LightPath y, int vertex, RandomStream random) {
        y.dx[vertex - 1] = -wx;
        y.dy[vertex - 1] = -wy;
        y.dz[vertex - 1] = -wz;
        return trace(y, vertex, vertex - 1, RayKind.SCATTERED, random);
    }

    /**
     * Traces along the edge between two vertices, whose direction is set; passes alpha masks by chance.
     *
     * @param to one more or less than {@code from}
     * @return false if nothing is met
     */
    private boolean trace(LightPath y, int from, int to, RayKind kind, RandomStream random) {
        int edge = Math.min(from, to);
        double sign = to > from ? 1 : -1;
        double x = sign * y.dx[edge];
        double yy = sign * y.dy[edge];
        double z = sign * y.dz[edge];
        SurfacePoint a = y.points[from];
        SurfacePoint b = y.points[to];
        double clear = 1;
        boolean found = kind == RayKind.CAMERA
                ? caster.trace(a.x, a.y, a.z, x, yy, z, kind, b)
                : caster.trace(a, x, yy, z, kind, b);
        while (found) {
            Bsdf bsdf = scene.bsdf(b.shape);
            double transparency = bsdf.maybeTransparent() ? bsdf.transparency(b) : 0;
            if (transparency == 0 || random.nextDouble() >= transparency) {
                y.setVertex(to, bsdf, 1 - transparency);
                y.clear[edge] = clear;
                double ex = b.x - a.x;
                double ey = b.y - a.y;
                double ez = b.z - a.z;
                y.squared[edge] = from == 0 && y.infinite ? Double.POSITIVE_INFINITY : ex * ex + ey * ey + ez * ez;
                return true;
            }
            clear *= transparency;
            veil.set(b);
            found = caster.trace(veil, x, yy, z, RayKind.SCATTERED, b);
        }
        y.clear[edge] = clear;
        y.squared[edge] = Double.POSITIVE_INFINITY;
        fail(Outcome.MISSED);
        escaped = true;
        return false;
    }

    /**
     * Makes x₀ of a path that came from the lens a point on a light: the surface that was met or, if none was, infinity.
     *
     * @param met whether the last ray has met a surface
     * @param random chooses among several lights at infinity
     * @return false if there is no light
     */
    boolean land(LightPath y, boolean met, RandomStream random) {
        if (met) {
            y.light = scene.lightOf(y.points[0].shape);
            y.infinite = false;
        } else {
            int count = scene.environmentCount();
            y.light = count == 0 ? -1 : scene.environment(count == 1 ? 0 : random.nextInt(count));
            y.infinite = true;
            y.points[0].offset = 0;
            y.points[0].shape = -1;
        }
        y.deltaLight = false;
        double opaque = met ? y.opacity[0] : 1;
        y.setEnd(0);
        y.opacity[0] = opaque;
        return y.light >= 0 || fail(Outcome.BLACK);
    }

    /** Number of lights among which {@link #land} chooses for a path. */
    int landings(LightPath y) {
        return y.infinite ? scene.environmentCount() : 1;
    }

    // Taking over

    /**
     * Builds a path that bidirectional path tracing has found.
     *
     * @return false if it carries nothing after all, as rounding may have it
     */
    public boolean assemble(Contribution found, LightPath y) {
        int s = found.lightVertices();
        int t = found.eyeVertices();
        int k = s + t - 1;
        y.length = k + 1;
        y.reserve(k + 1);
        Light light = scene.light(found.lightIndex());
        y.light = found.lightIndex();
        y.infinite = light.isInfinite();
        y.deltaLight = light.isDelta();
        y.filmX = found.filmX();
        y.filmY = found.filmY();
        y.lensU = found.lensU();
        y.lensV = found.lensV();
        PathValues subpath = found.light();
        boolean sampled = s == 1 && t >= 2;
        for (int i = 0; i < s; i++) {
            y.points[i].set(sampled ? found.lightSample().point : subpath.point(i));
            if (i > 0) {
                setVertex(y, i, subpath, i, i < s - 1);
            }
        }
        PathValues eye = found.eye();
        for (int j = 0; j < t; j++) {
            int i = k - j;
            y.points[i].set(t == 1 ? found.lens().point : eye.point(j));
            if (j > 0 && i > 0) {
                setVertex(y, i, eye, j, j < t - 1);
            }
        }
        setLight(y);
        y.setEnd(k);
        if (y.infinite) {
            setFirstEdge(y, found, s, t, sampled);
        }
        for (int i = y.infinite ? 1 : 0; i < k; i++) {
            y.setEdge(i);
            // Rays start a little above surfaces: where one was traced, it is not quite the line from point to point.
            if (i + 1 < s) {
                setDirection(y, i, subpath, i + 1, -1);
            } else if (i >= s) {
                setDirection(y, i, eye, k - i, 1);
            }
        }
        Arrays.fill(y.clear, 0, k, 1);
        if (!measure(y, 0, k)) {
            return false;
        }
        if (scene.maybeTransparent()) {
            for (int i = 0; i < k; i++) {
                if (!reveal(y, i)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Sets the direction of an edge from a light at infinity. */
    private static void setFirstEdge(LightPath y, Contribution found, int s, int t, boolean sampled) {
        y.squared[0] = Double.POSITIVE_INFINITY;
        if (sampled) {
            y.dx[0] = -found.lightSample().wiX;
            y.dy[0] = -found.lightSample().wiY;
            y.dz[0] = -found.lightSample().wiZ;
            return;
        }
        // The direction back from the vertex at infinity of an eye subpath is that of travel; that of a light subpath's
        // second
        // vertex points to the light.
        if (s == 0) {
            setDirection(y, 0, found.eye(), t - 1, 1);
        } else {
            setDirection(y, 0, found.light(), 1, -1);
        }
    }

    /** Sets the direction of an edge from that back from a vertex of a subpath, or the opposite. */
    private static void setDirection(LightPath y, int edge, PathValues path, int vertex, int sign) {
        y.dx[edge] = sign * path.back(vertex, 0);
        y.dy[edge] = sign * path.back(vertex, 1);
        y.dz[edge] = sign * path.back(vertex, 2);
    }

    /** Makes x₀ an end of the path, on a light that was sampled: it may have holes, which matters to walks that could meet it. */
    private void setLight(LightPath y) {
        y.setEnd(0);
        if (!y.infinite && y.points[0].shape >= 0) {
            y.opacity[0] = opacity(y.points[0]);
        }
    }

    private void setVertex(LightPath y, int vertex, PathValues from, int index, boolean inner) {
        y.setVertex(vertex, from.bsdf(index), opacity(from.point(index)));
        if (inner && from.isDelta(index)) {
            y.lobe[vertex] = from.lobe(index);
        }
    }

    private double opacity(SurfacePoint p) {
        Bsdf bsdf = scene.bsdf(p.shape);
        return bsdf.maybeTransparent() ? 1 - bsdf.transparency(p) : 1;
    }

    // Evaluating

    /**
     * Computes what depends on some vertices: scattering and densities of theirs and of their neighbours, then the contribution
     * without the visibility of edges that {@link #reveal} is still to test.
     *
     * @param first lowest vertex that is new or has a new neighbour
     * @param last highest such vertex
     * @return false if the path carries nothing
     */
    boolean measure(LightPath y, int first, int last) {
        int k = y.length - 1;
        if (last >= k - 1 && !measureLens(y, k)) {
            return fail(Outcome.OFF_FILM);
        }
        for (int i = Math.max(1, first); i <= Math.min(last, k - 1); i++) {
            if (!measureVertex(y, i)) {
                return fail(Outcome.BLACK);
            }
        }
        if (first <= 1 && !measureLight(y, k)) {
            return fail(Outcome.BLACK);
        }
        return sum(y, k) || fail(Outcome.BLACK);
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
        y.fromEye[i - 1] = i == 1 && y.deltaLight ? 0 : perEye * towardsLight(y, i - 1);
        if (i + 1 < y.length - 1) {
            SurfacePoint next = y.points[i + 1];
            y.fromLight[i + 1] = Densities.solidAngleToArea(perLight, y.squared[i], next.geometricCosine(ex, ey, ez));
        }
        return true;
    }

    /**
     * |wi·m| for the normal m that a delta lobe reflects or refracts at, which need not be that of shading: maps of normals turn it.
     * It lies along η·wo + wi; what goes straight on has none, and any normal will do.
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

    /** Factor from solid angle at x_{i+1} to the measure of x_i. */
    static double towardsLight(LightPath y, int i) {
        if (i == 0 && y.infinite) {
            return 1;
        }
        return Densities.solidAngleToArea(1, y.squared[i], y.points[i].geometricCosine(y.dx[i], y.dy[i], y.dz[i]));
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
            factor *= (i == 1 && y.deltaLight ? 1 : towardsLight(y, i - 1)) * y.clear[i];
        }
        factor *= y.clear[0];
        y.value.set(r * factor, g * factor, b * factor);
        y.contribution = y.value.luminance();
        return y.contribution > 0 && y.contribution < Double.POSITIVE_INFINITY;
    }

    /**
     * Tests an edge that was joined, not traced, for occlusion, and multiplies the contribution with the fraction that it lets
     * pass. Its {@code clear} must be 1 so far.
     */
    boolean reveal(LightPath y, int edge) {
        double visible = edge == 0 && y.infinite
                ? caster.transmittanceToInfinity(y.points[1], -y.dx[0], -y.dy[0], -y.dz[0])
                : caster.transmittance(y.points[edge], y.points[edge + 1]);
        if (visible == 0) {
            return fail(Outcome.OCCLUDED);
        }
        y.clear[edge] = visible;
        if (visible != 1) {
            y.value.scale(visible);
            y.contribution *= visible;
        }
        return true;
    }

    // Densities of ways to build a piece

    /**
     * Density with which a walk from vertex {@code from} (a vertex that stays, or -1 for the start of a light subpath) towards the
     * lens makes the vertices up to {@code to}, choices of delta lobes and what alpha masks decide included.
     */
    static double walkFromLight(LightPath y, int from, int to) {
        double density = 1;
        for (int i = from + 1; i <= to; i++) {
            density *= y.fromLight[i];
            if (i > 0) {
                density *= y.lobeFromLight[i - 1] * y.clear[i - 1];
            }
        }
        return to == from ? 1 : density * y.opacity[to] / (from < 0 ? 1 : y.opacity[from]);
    }

    /** The same from the lens side: the vertices from {@code to} up to {@code from} − 1; {@code from} may be k + 1 for the start on the lens. */
    static double walkFromEye(LightPath y, int from, int to) {
        double density = 1;
        for (int i = from - 1; i >= to; i--) {
            density *= y.fromEye[i];
            if (i < y.length - 1) {
                density *= y.lobeFromEye[i + 1] * y.clear[i];
            }
        }
        return to == from ? 1 : density * y.opacity[to] / (from > y.length - 1 ? 1 : y.opacity[from]);
    }
}
