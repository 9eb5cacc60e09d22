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
        // The camera sees the point itself: at grazing angles that is not the ray's direction up to rounding.
        double[] d = atInfinity ? edges[0] : between(points[k - 1], lens);
        double cosine = Math.abs(points[k - 1].geometricCosine(d[0], d[1], d[2]));
        CameraRay ray = new CameraRay();
        double density;
        if (camera.isParallel()) {
            LensSample sample = new LensSample();
            SurfacePoint p = points[k - 1];
            density = 1;
            if (!atInfinity && camera.sampleLens(p.x, p.y, p.z, 0.5, 0.5, sample)) {
                camera.rayDensity(lens.x, lens.y, lens.z, -d[0], -d[1], -d[2], ray);
                density = ray.densityPosition * cosine / Math.abs(sample.point.geometricCosine(d[0], d[1], d[2]));
            }
        } else {
            camera.rayDensity(lens.x, lens.y, lens.z, -d[0], -d[1], -d[2], ray);
            density = ray.densityDirection * (atInfinity ? 1 : cosine / squares[k - 1]);
        }
        fromEye[k - 1] = density;
        fromEyeByLobe[k - 1] = density;
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
        double[] m = {eta * e[0] + l[0], eta * e[1] + l[1], eta * e[2] + l[2]};
        double length = Math.sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
        // What goes straight on bends by no more than the tolerance of manifold walks.
        return length < 1e-5
                ? Math.abs(p.localZ(of[0], of[1], of[2]))
                : Math.abs(of[0] * m[0] + of[1] * m[1] + of[2] * m[2]) / length;
    }

    /**
     * Solid angle of a thin bundle of rays on the light's side of a vertex with a delta lobe, per solid angle on the side of the lens: by
     * central differences. The ratio of densities of the two directions must be this.
     */
    double bundleRatio(int vertex) {
        double step = 1e-6;
        double[] e = toEye(vertex);
        double[] s = across(e);
        double[] ds = difference(vertex, e, s, step);
        double[] dt = difference(vertex, e, cross(e, s), step);
        return length(cross(ds, dt));
    }

    private double[] difference(int vertex, double[] e, double[] along, double step) {
        double[] ahead = lobeOf(vertex, e, along, step);
        double[] behind = lobeOf(vertex, e, along, -step);
        double[] d = new double[3];
        for (int i = 0; i < 3; i++) {
            d[i] = (ahead[i] - behind[i]) / (2 * step);
        }
        return d;
    }

    private double[] lobeOf(int vertex, double[] e, double[] along, double step) {
        double c = Math.cos(step);
        double s = Math.sin(step);
        BsdfSample lobe = new BsdfSample();
        boolean there = Scattering.deltaLobe(
                bsdf(vertex),
                points[vertex],
                c * e[0] + s * along[0],
                c * e[1] + s * along[1],
                c * e[2] + s * along[2],
                lobes[vertex],
                TransportMode.RADIANCE,
                lobe);
        return there ? new double[] {lobe.wiX, lobe.wiY, lobe.wiZ} : new double[] {Double.NaN, 0, 0};
    }

    /** Largest distance by which rays start above the ends of an edge between two vertices, relative to its length. */
    double lift(int b, int c) {
        double largest = 0;
        for (int i = Math.min(b, c); i < Math.max(b, c); i++) {
            largest = Math.max(largest, Math.max(points[i].offset, points[i + 1].offset) / Math.sqrt(squares[i]));
        }
        return largest;
    }

    /**
     * Area that b moves over per area of the first vertex behind c, when c's direction changes and the chain of delta lobes between them
     * is followed: by central differences.
     *
     * @param step of the direction, in radians; of lights at infinity relative to the length of the edge behind
     * @return NaN if a ray leaves the surfaces
     */
    double endPerFirst(int c, int b, double step) {
        int sign = b > c ? 1 : -1;
        double[] d = b > c ? edges[c] : toLight(c);
        double[] s = across(d);
        double[] t = cross(d, s);
        double[][] first = new double[2][];
        double[][] end = new double[2][];
        for (int i = 0; i < 2; i++) {
            double[] ahead = followed(c, b, sign, d, i == 0 ? s : t, step);
            double[] behind = followed(c, b, sign, d, i == 0 ? s : t, -step);
            first[i] = new double[3];
            end[i] = new double[3];
            for (int j = 0; j < 3; j++) {
                first[i][j] = ahead[j] - behind[j];
                end[i][j] = ahead[3 + j] - behind[3 + j];
            }
        }
        return length(cross(end[0], end[1])) / length(cross(first[0], first[1]));
    }

    /** The first vertex behind c and the last one, b, of a ray next to that of the path. */
    private double[] followed(int c, int b, int sign, double[] d, double[] along, double step) {
        double cosine = Math.cos(step);
        double sine = Math.sin(step);
        SurfacePoint here = new SurfacePoint();
        RayCaster caster = new RayCaster(scene);
        double[] ray = new double[3];
        boolean met;
        if (c == 0 && infinite) {
            double far = 0.01 * Math.sqrt(squares[1]);
            SurfacePoint p = points[1];
            met = caster.trace(
                    p.x - far * d[0] + far * step * along[0],
                    p.y - far * d[1] + far * step * along[1],
                    p.z - far * d[2] + far * step * along[2],
                    d[0],
                    d[1],
                    d[2],
                    RayKind.CAMERA,
                    here);
            System.arraycopy(d, 0, ray, 0, 3);
        } else {
            for (int i = 0; i < 3; i++) {
                ray[i] = cosine * d[i] + sine * along[i];
            }
            met = c == k
                    ? caster.trace(points[k].x, points[k].y, points[k].z, ray[0], ray[1], ray[2], RayKind.CAMERA, here)
                    : caster.trace(points[c], ray[0], ray[1], ray[2], RayKind.SCATTERED, here);
        }
        double[] both = new double[6];
        BsdfSample lobe = new BsdfSample();
        for (int i = c + sign; met && here.shape == points[i].shape; i += sign) {
            int at = i == c + sign ? 0 : 3;
            both[at] = here.x;
            both[at + 1] = here.y;
            both[at + 2] = here.z;
            if (i == b) {
                return both;
            }
            TransportMode mode = sign > 0 ? TransportMode.IMPORTANCE : TransportMode.RADIANCE;
            if (!Scattering.deltaLobe(bsdf(i), here, -ray[0], -ray[1], -ray[2], lobes[i], mode, lobe)) {
                break;
            }
            ray[0] = lobe.wiX;
            ray[1] = lobe.wiY;
            ray[2] = lobe.wiZ;
            met = caster.trace(here, ray[0], ray[1], ray[2], RayKind.SCATTERED, here);
        }
        both[0] = Double.NaN;
        return both;
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
