package org.daybreak.metropolis.strategy;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionDensity;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.EmissionGuide;

/**
 * A full path x₀…x_k, reduced to its geometry: vertices, directions of the edges, which delta lobes it takes, the film position. All
 * else is computed from that anew, by the definitions and slowly, and with nothing of the code that builds and moves paths.
 *
 * <p>Directions are taken over, as rays start a little above surfaces: the line between two points is not quite the ray's. Delta
 * lobes stand in densities and in the contribution as {@link LightPath} says; the ratio of the two directions is that of the solid angles
 * of two thin bundles of rays, which {@link #bundleRatio} measures.
 */
final class PlainPath {
    /**
     * Steps of finite differences of chains, in radians: the smallest is far above rounding. Curved mirrors of a hundred thousand triangles
     * need steps as small as that, to stay on one.
     */
    private static final double LARGEST_STEP = 0x1p-15;

    private static final double SMALLEST_STEP = 0x1p-23;

    /** Differences of two steps that differ by more than this part do not tell: the chain is near a fold. */
    static final double AGREEMENT = 1e-5;

    /** What goes straight on bends by no more than the tolerance of manifold walks. */
    private static final double SMALLEST_FACET = 1e-5;

    /** What manifold walks leave of an angle, and rounding. */
    private static final double WALK_ERROR = 1e-8;

    final Scene scene;
    final Camera camera;
    final int k;
    final SurfacePoint[] points;

    /** Unit direction from x_i to x_{i+1}. */
    final double[][] edges;

    final double[] squares;
    final int[] lobes;
    final int light;
    final boolean infinite;
    final boolean deltaLight;
    final double filmX;
    final double filmY;

    /** Fraction of light that each edge lets pass. */
    final double[] clear;

    /** Fraction of light that does not pass straight through at each vertex. */
    final double[] opacity;

    /** Density of x_{i} as sampled from x_{i+1}, given that the walk scatters there, with the choice of a lobe if any. */
    final double[] fromEye;

    /** Density of x_{i} as sampled from x_{i−1}, alike. */
    final double[] fromLight;

    /** What {@link #fromEye} is if delta lobes are given and not chosen. */
    final double[] fromEyeByLobe;

    /** What {@link #fromLight} is if delta lobes are given and not chosen. */
    final double[] fromLightByLobe;

    /** Density of x₀ as x₁ samples a point on a light. */
    double nextEvent;

    /** Scalar contribution f*. */
    double contribution;

    PlainPath(Scene scene, Camera camera, EmissionGuide guide, LightPath path) {
        this.scene = scene;
        this.camera = camera;
        k = path.length - 1;
        light = path.light;
        infinite = scene.light(light).isInfinite();
        deltaLight = scene.light(light).isDelta();
        filmX = path.filmX;
        filmY = path.filmY;
        points = new SurfacePoint[k + 1];
        lobes = new int[k + 1];
        edges = new double[k][];
        squares = new double[k];
        clear = new double[k];
        opacity = new double[k + 1];
        fromEye = new double[k + 1];
        fromLight = new double[k + 1];
        fromEyeByLobe = new double[k + 1];
        fromLightByLobe = new double[k + 1];
        for (int i = 0; i <= k; i++) {
            points[i] = new SurfacePoint();
            points[i].set(path.points[i]);
            lobes[i] = i == 0 || i == k ? -1 : path.lobe[i];
            boolean surface = i < k && points[i].shape >= 0 && !(i == 0 && infinite);
            opacity[i] = surface ? 1 - bsdf(i).transparency(points[i]) : 1;
        }
        RayCaster caster = new RayCaster(scene);
        for (int i = 0; i < k; i++) {
            edges[i] = new double[] {path.dx[i], path.dy[i], path.dz[i]};
            double x = points[i + 1].x - points[i].x;
            double y = points[i + 1].y - points[i].y;
            double z = points[i + 1].z - points[i].z;
            squares[i] = i == 0 && infinite ? Double.POSITIVE_INFINITY : x * x + y * y + z * z;
            clear[i] = !scene.maybeTransparent()
                    ? 1
                    : i == 0 && infinite
                            ? caster.transmittanceToInfinity(points[1], -edges[0][0], -edges[0][1], -edges[0][2])
                            : caster.transmittance(points[i], points[i + 1]);
        }
        setLensDensity();
        setLightDensities(guide);
        setScattering();
    }

    /** Whether light passes along an edge that was joined. One that was traced may graze what its rays started above. */
    boolean passes(int edge) {
        RayCaster caster = new RayCaster(scene);
        double[] d = edges[0];
        return (edge == 0 && infinite)
                ? caster.transmittanceToInfinity(points[1], -d[0], -d[1], -d[2]) > 0
                : caster.transmittance(points[edge], points[edge + 1]) > 0;
    }

    Bsdf bsdf(int vertex) {
        return scene.bsdf(points[vertex].shape);
    }

    boolean isDelta(int vertex) {
        return lobes[vertex] >= 0;
    }

    /** Solid angle at one end of an edge per measure of the vertex at its other end. */
    double perVertex(int vertex, int edge) {
        return vertex == 0 && infinite ? 1 : cosine(vertex, edge) / squares[edge];
    }

    private double cosine(int vertex, int edge) {
        double[] d = edges[edge];
        return Math.abs(points[vertex].geometricCosine(d[0], d[1], d[2]));
    }

    private double[] toEye(int vertex) {
        return edges[vertex];
    }

    private double[] toLight(int vertex) {
        double[] d = edges[vertex - 1];
        return new double[] {-d[0], -d[1], -d[2]};
    }

    /** x_{k−1} from a film point that is uniform over the film. */
    private void setLensDensity() {
        fromEye[k] = 1;
        fromEyeByLobe[k] = 1;
        SurfacePoint lens = points[k];
        boolean atInfinity = k == 1 && infinite;
        SurfacePoint p = points[k - 1];
        CameraRay ray = new CameraRay();
        double density;
        if (camera.isParallel()) {
            // All rays have one direction. That to the point seen is another one if it lay on the edge of a triangle:
            // such are kept off edges.
            double[] d = edges[k - 1];
            LensSample sample = new LensSample();
            density = 1;
            if (!atInfinity && camera.sampleLens(p.x, p.y, p.z, 0.5, 0.5, sample)) {
                SurfacePoint seenFrom = sample.point;
                camera.rayDensity(seenFrom.x, seenFrom.y, seenFrom.z, -d[0], -d[1], -d[2], ray);
                density = ray.densityPosition
                        * cosine(k - 1, k - 1)
                        / Math.abs(seenFrom.geometricCosine(d[0], d[1], d[2]));
            }
        } else {
            double[] d = towardsLens();
            camera.rayDensity(lens.x, lens.y, lens.z, -d[0], -d[1], -d[2], ray);
            density = ray.densityDirection
                    * (atInfinity ? 1 : Math.abs(p.geometricCosine(d[0], d[1], d[2])) / squares[k - 1]);
        }
        fromEye[k - 1] = density;
        fromEyeByLobe[k - 1] = density;
    }

    /**
     * Direction from x_{k−1} to the lens. The camera sees the point itself: it was kept off the edges of its triangle, so that is not the
     * ray's direction up to rounding.
     */
    double[] towardsLens() {
        return k == 1 && infinite ? edges[0] : between(points[k - 1], points[k]);
    }

    private static double[] between(SurfacePoint a, SurfacePoint b) {
        double x = b.x - a.x;
        double y = b.y - a.y;
        double z = b.z - a.z;
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    private void setLightDensities(EmissionGuide guide) {
        if (k == 1) {
            return;
        }
        Light source = scene.light(light);
        double[] d = edges[0];
        EmissionDensity emission = new EmissionDensity();
        guide.density(light, points[0], points[1], d[0], d[1], d[2], emission);
        double choice = scene.lightSelection().emissionProbability(light);
        fromLight[0] = choice * (infinite ? emission.direction : emission.position);
        fromLight[1] = infinite ? emission.position * cosine(1, 0) : emission.direction * cosine(1, 0) / squares[0];
        fromLightByLobe[1] = fromLight[1];
        if (isDelta(1)) {
            return;
        }
        SurfacePoint p = points[1];
        double[] eye = toEye(1);
        double side = bsdf(1).transmissive() ? 0 : Math.signum(p.nx * eye[0] + p.ny * eye[1] + p.nz * eye[2]);
        double chosen = scene.lightSelection().probability(light, p.x, p.y, p.z, side * p.nx, side * p.ny, side * p.nz);
        nextEvent = deltaLight
                ? chosen
                : chosen * source.incidentDensity(p.x, p.y, p.z, points[0], -d[0], -d[1], -d[2]) * perVertex(0, 0);
    }

    private void setScattering() {
        Spectrum product = new Spectrum();
        Spectrum factor = new Spectrum();
        Light source = scene.light(light);
        if (deltaLight) {
            LightSample sample = new LightSample();
            source.sampleIncident(points[1].x, points[1].y, points[1].z, 0.5, 0.5, sample);
            product.set(sample.weight);
        } else {
            source.radiance(points[0], edges[0][0], edges[0][1], edges[0][2], product);
        }
        product.scale(fromEye[k - 1] * clear[0]);
        BsdfSample lobe = new BsdfSample();
        for (int i = 1; i < k; i++) {
            double[] e = toEye(i);
            double[] l = toLight(i);
            SurfacePoint p = points[i];
            double towardsLight;
            double towardsEye;
            double chooseToLight = 1;
            double chooseToEye = 1;
            if (isDelta(i)) {
                Scattering.deltaLobe(bsdf(i), p, l[0], l[1], l[2], lobes[i], TransportMode.IMPORTANCE, lobe);
                chooseToEye = lobe.density / opacity[i];
                Scattering.deltaLobe(bsdf(i), p, e[0], e[1], e[2], lobes[i], TransportMode.RADIANCE, lobe);
                chooseToLight = lobe.density / opacity[i];
                double eta = lobe.eta;
                towardsLight = cosineToFacet(p, l, e, l, eta) / eta;
                towardsEye = cosineToFacet(p, e, e, l, eta) * eta;
                factor.set(lobe.weight);
                factor.scale(towardsLight);
            } else {
                Scattering.evaluate(bsdf(i), p, e[0], e[1], e[2], l[0], l[1], l[2], TransportMode.RADIANCE, factor);
                towardsLight =
                        Scattering.density(bsdf(i), p, e[0], e[1], e[2], l[0], l[1], l[2], TransportMode.RADIANCE)
                                / opacity[i];
                towardsEye =
                        Scattering.density(bsdf(i), p, l[0], l[1], l[2], e[0], e[1], e[2], TransportMode.IMPORTANCE)
                                / opacity[i];
            }
            boolean metByNone = i == 1 && deltaLight;
            fromEyeByLobe[i - 1] = metByNone ? 0 : towardsLight * perVertex(i - 1, i - 1);
            fromEye[i - 1] = fromEyeByLobe[i - 1] * chooseToLight;
            if (i + 1 < k) {
                fromLightByLobe[i + 1] = towardsEye * perVertex(i + 1, i);
                fromLight[i + 1] = fromLightByLobe[i + 1] * chooseToEye;
            }
            product.set(product.r * factor.r, product.g * factor.g, product.b * factor.b);
            product.scale((metByNone ? 1 : perVertex(i - 1, i - 1)) * clear[i]);
        }
        contribution = product.luminance();
    }

    /** |cos| of a direction to the normal of the facet that reflects or refracts e to l. */
    private static double cosineToFacet(SurfacePoint p, double[] of, double[] e, double[] l, double eta) {
        double[] m = facet(e, l, eta);
        double length = length(m);
        return length < SMALLEST_FACET
                ? Math.abs(p.localZ(of[0], of[1], of[2]))
                : Math.abs(of[0] * m[0] + of[1] * m[1] + of[2] * m[2]) / length;
    }

    /** A vector along the normal of the facet that reflects or refracts e to l; none if that goes straight on. */
    private static double[] facet(double[] e, double[] l, double eta) {
        return new double[] {eta * e[0] + l[0], eta * e[1] + l[1], eta * e[2] + l[2]};
    }

    /**
     * Solid angle of a thin bundle of rays on the light's side of a vertex with a delta lobe, per solid angle on the side of the lens: by
     * central differences. The ratio of densities of the two directions must be this.
     */
    double bundleRatio(int vertex) {
        double step = 1e-6;
        double[] e = toEye(vertex);
        double[] s = across(e);
        SurfacePoint p = turned(vertex);
        double[] ds = difference(vertex, p, e, s, step);
        double[] dt = difference(vertex, p, e, cross(e, s), step);
        return length(cross(ds, dt));
    }

    /**
     * A vertex, turned so that its delta lobe leads from one edge of the path to the other, as it does but for what rays started above the
     * surfaces: at grazing angles bundles are not the same.
     */
    private SurfacePoint turned(int vertex) {
        SurfacePoint p = new SurfacePoint();
        p.set(points[vertex]);
        double[] e = toEye(vertex);
        double[] l = toLight(vertex);
        BsdfSample lobe = new BsdfSample();
        Scattering.deltaLobe(bsdf(vertex), p, e[0], e[1], e[2], lobes[vertex], TransportMode.RADIANCE, lobe);
        double[] before = facet(e, new double[] {lobe.wiX, lobe.wiY, lobe.wiZ}, lobe.eta);
        double[] after = facet(e, l, lobe.eta);
        double lengths = length(before) * length(after);
        if (lengths < SMALLEST_FACET * SMALLEST_FACET) {
            return p;
        }
        double[] axis = cross(before, after);
        double cosine = (before[0] * after[0] + before[1] * after[1] + before[2] * after[2]) / lengths;
        for (int i = 0; i < 3; i++) {
            axis[i] /= lengths;
        }
        double[] s = turned(axis, cosine, p.sx, p.sy, p.sz);
        double[] t = turned(axis, cosine, p.tx, p.ty, p.tz);
        double[] n = turned(axis, cosine, p.nx, p.ny, p.nz);
        p.sx = s[0];
        p.sy = s[1];
        p.sz = s[2];
        p.tx = t[0];
        p.ty = t[1];
        p.tz = t[2];
        p.nx = n[0];
        p.ny = n[1];
        p.nz = n[2];
        return p;
    }

    /** A vector turned about an axis, whose length is the sine of the angle. */
    private static double[] turned(double[] axis, double cosine, double x, double y, double z) {
        double[] once = cross(axis, new double[] {x, y, z});
        double[] twice = cross(axis, once);
        double part = 1 / (1 + cosine);
        return new double[] {x + once[0] + part * twice[0], y + once[1] + part * twice[1], z + once[2] + part * twice[2]
        };
    }

    private double[] difference(int vertex, SurfacePoint p, double[] e, double[] along, double step) {
        double[] ahead = lobeOf(vertex, p, e, along, step);
        double[] behind = lobeOf(vertex, p, e, along, -step);
        double[] d = new double[3];
        for (int i = 0; i < 3; i++) {
            d[i] = (ahead[i] - behind[i]) / (2 * step);
        }
        return d;
    }

    private double[] lobeOf(int vertex, SurfacePoint p, double[] e, double[] along, double step) {
        double c = Math.cos(step);
        double s = Math.sin(step);
        BsdfSample lobe = new BsdfSample();
        boolean there = Scattering.deltaLobe(
                bsdf(vertex),
                p,
                c * e[0] + s * along[0],
                c * e[1] + s * along[1],
                c * e[2] + s * along[2],
                lobes[vertex],
                TransportMode.RADIANCE,
                lobe);
        return there ? new double[] {lobe.wiX, lobe.wiY, lobe.wiZ} : new double[] {Double.NaN, 0, 0};
    }

    /**
     * Area that b moves over per area of the first vertex behind c, when c's direction changes and the chain of delta lobes between them
     * is followed: by central differences of two steps, extrapolated to none.
     *
     * <p>The rays of the differences go through the vertices themselves, as those of the path do but for rounding: they start on the surface,
     * and not above it. What is left of the lobe's direction to the next vertex, as the rays that found the chain did start above surfaces,
     * is left over as well from the rays next to it.
     *
     * @return NaN if that is not differentiable, or cannot be told
     */
    double endPerFirst(int c, int b) {
        double[][] left = leftOver(c, b);
        for (double step = LARGEST_STEP; step > SMALLEST_STEP; step *= 0.25) {
            double coarse = endPerFirst(c, b, left, step);
            double fine = endPerFirst(c, b, left, 0.25 * step);
            if (Math.abs(fine - coarse) < AGREEMENT * fine) {
                return (16 * fine - coarse) / 15;
            }
        }
        return Double.NaN;
    }

    /**
     * @param step of the direction, in radians; of lights at infinity relative to a distance before the first vertex
     * @return NaN if a ray leaves the surfaces, or the smooth pieces of them that the vertices of the path lie on
     */
    private double endPerFirst(int c, int b, double[][] left, double step) {
        double[] d = direction(c, b);
        double[] s = across(d);
        double[] t = cross(d, s);
        double[][] first = new double[2][];
        double[][] end = new double[2][];
        for (int i = 0; i < 2; i++) {
            double[] ahead = followed(c, b, left, d, i == 0 ? s : t, step);
            double[] behind = followed(c, b, left, d, i == 0 ? s : t, -step);
            first[i] = new double[3];
            end[i] = new double[3];
            for (int j = 0; j < 3; j++) {
                first[i][j] = ahead[j] - behind[j];
                end[i][j] = ahead[3 + j] - behind[3 + j];
            }
        }
        return length(cross(end[0], end[1])) / length(cross(first[0], first[1]));
    }

    /** Direction from a vertex to its neighbour on the way to another: along the line between them, not that of a ray above it. */
    private double[] direction(int from, int to) {
        int next = to > from ? from + 1 : from - 1;
        return from == 0 && infinite ? edges[0] : between(points[from], points[next]);
    }

    /** What is left over at each vertex between c and b. */
    private double[][] leftOver(int c, int b) {
        int sign = b > c ? 1 : -1;
        double[][] left = new double[k + 1][];
        for (int i = c + sign; i != b; i += sign) {
            double[] d = i - sign == 0 && infinite ? edges[0] : between(points[i - sign], points[i]);
            left[i] = leftOver(i, new double[] {-d[0], -d[1], -d[2]}, direction(i, b), mode(sign));
        }
        return left;
    }

    /**
     * The part along the surface of the direction to the next vertex, less that of the lobe there: 0 but that rays start above surfaces.
     * Along the surface as what a lobe keeps is that part; across it a grazing lobe magnifies all.
     *
     * @param back direction to the vertex before
     */
    private double[] leftOver(int vertex, double[] back, double[] next, TransportMode mode) {
        SurfacePoint p = points[vertex];
        BsdfSample lobe = new BsdfSample();
        if (!Scattering.deltaLobe(bsdf(vertex), p, back[0], back[1], back[2], lobes[vertex], mode, lobe)) {
            return new double[] {Double.NaN, 0, 0};
        }
        double x = next[0] - lobe.wiX;
        double y = next[1] - lobe.wiY;
        double z = next[2] - lobe.wiZ;
        double across = p.localZ(x, y, z);
        return new double[] {x - across * p.nx, y - across * p.ny, z - across * p.nz};
    }

    /**
     * What is left over of the direction at a vertex with a delta lobe, relative to by how much rays may start, and points lie, off the lines
     * between the vertices: for a path that follows its lobes a few times that.
     */
    double relativeLeftOver(int vertex) {
        double[] back = direction(vertex, k);
        double[] next = vertex == 1 && infinite ? toLight(1) : direction(vertex, 0);
        double off = 0;
        for (int i = vertex - 1; i <= vertex; i++) {
            off += (points[i].offset + points[i + 1].offset) / Math.sqrt(squares[i]);
        }
        return length(leftOver(vertex, back, next, TransportMode.RADIANCE)) / (off + WALK_ERROR);
    }

    private static TransportMode mode(int sign) {
        return sign > 0 ? TransportMode.IMPORTANCE : TransportMode.RADIANCE;
    }

    /** The first vertex behind c and the last one, b, of a ray next to that of the path. */
    private double[] followed(int c, int b, double[][] left, double[] d, double[] along, double step) {
        int sign = b > c ? 1 : -1;
        double cosine = Math.cos(step);
        double sine = Math.sin(step);
        SurfacePoint here = new SurfacePoint();
        RayCaster caster = new RayCaster(scene);
        double[] ray = new double[3];
        double[] nothing = {Double.NaN, 0, 0, 0, 0, 0};
        if (c == 0 && infinite) {
            double far = 0.01 * Math.sqrt(squares[1]);
            SurfacePoint p = points[1];
            here.x = p.x - far * d[0] + far * step * along[0];
            here.y = p.y - far * d[1] + far * step * along[1];
            here.z = p.z - far * d[2] + far * step * along[2];
            System.arraycopy(d, 0, ray, 0, 3);
        } else {
            here.set(points[c]);
            for (int i = 0; i < 3; i++) {
                ray[i] = cosine * d[i] + sine * along[i];
            }
        }
        double[] both = new double[6];
        BsdfSample lobe = new BsdfSample();
        for (int i = c + sign; i != b; i += sign) {
            if (!reach(caster, here, ray, points[i])) {
                return nothing;
            }
            if (i == c + sign) {
                both[0] = here.x;
                both[1] = here.y;
                both[2] = here.z;
            }
            if (!Scattering.deltaLobe(bsdf(i), here, -ray[0], -ray[1], -ray[2], lobes[i], mode(sign), lobe)) {
                return nothing;
            }
            turn(here, lobe, left[i], ray);
        }
        // Masks may stand before b. Its surface is as good as its tangent plane.
        SurfacePoint last = points[b];
        double distance = last.geometricCosine(last.x - here.x, last.y - here.y, last.z - here.z)
                / last.geometricCosine(ray[0], ray[1], ray[2]);
        both[3] = here.x + distance * ray[0];
        both[4] = here.y + distance * ray[1];
        both[5] = here.z + distance * ray[2];
        return both;
    }

    /**
     * Goes along a ray that starts at a point to the smooth piece of surface that another one lies on.
     *
     * @param here receives where that is
     */
    private static boolean reach(RayCaster caster, SurfacePoint here, double[] ray, SurfacePoint there) {
        double x = here.x;
        double y = here.y;
        double z = here.z;
        // As high above the surface as rays must start, but on the line.
        double start = here.offset == 0 ? 0 : here.offset / Math.abs(here.geometricCosine(ray[0], ray[1], ray[2]));
        if (!caster.trace(
                        x + start * ray[0],
                        y + start * ray[1],
                        z + start * ray[2],
                        ray[0],
                        ray[1],
                        ray[2],
                        RayKind.CAMERA,
                        here)
                || here.shape != there.shape
                || here.primitive != there.primitive
                || here.instance != there.instance) {
            return false;
        }
        // Points near the edges of triangles are moved away from them, off the ray: by up to four times the offset.
        double[] d = {here.x - x, here.y - y, here.z - z};
        double rounding = 0x1p-48 * (length(d) + Math.abs(here.x) + Math.abs(here.y) + Math.abs(here.z));
        return length(cross(d, ray)) < 1e-3 * here.offset + rounding;
    }

    /** Sets the direction of a lobe, with what is left over added along the surface. */
    private static void turn(SurfacePoint p, BsdfSample lobe, double[] left, double[] ray) {
        double s = p.localX(lobe.wiX + left[0], lobe.wiY + left[1], lobe.wiZ + left[2]);
        double t = p.localY(lobe.wiX + left[0], lobe.wiY + left[1], lobe.wiZ + left[2]);
        double n = Math.copySign(Math.sqrt(1 - s * s - t * t), p.localZ(lobe.wiX, lobe.wiY, lobe.wiZ));
        ray[0] = s * p.sx + t * p.tx + n * p.nx;
        ray[1] = s * p.sy + t * p.ty + n * p.ny;
        ray[2] = s * p.sz + t * p.tz + n * p.nz;
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    /** A unit vector at right angles to another. */
    private static double[] across(double[] e) {
        double[] a = Math.abs(e[0]) < 0.7 ? new double[] {0, -e[2], e[1]} : new double[] {e[2], 0, -e[0]};
        double length = length(a);
        return new double[] {a[0] / length, a[1] / length, a[2] / length};
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /** Ratio of the factors by which a delta lobe stands in the densities towards the lens and towards the light. */
    double factorRatio(int vertex) {
        return fromLightByLobe[vertex + 1]
                / perVertex(vertex + 1, vertex)
                * perVertex(vertex - 1, vertex - 1)
                / fromEyeByLobe[vertex - 1];
    }
}
