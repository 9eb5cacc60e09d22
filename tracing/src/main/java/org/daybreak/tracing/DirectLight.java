package org.daybreak.tracing;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightChoice;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.light.LightSelection;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.Scene;

/**
 * Light that reaches a vertex straight from emitters, by both techniques: a light point sampled for the vertex (next-event
 * estimation), and emitters that a scattered ray meets. Both are weighted with the power heuristic, exponent 2 (Veach 1997,
 * §9.2.3), so the two methods here belong together. One object per worker.
 */
final class DirectLight {
    private static final int KNOWN = 16;

    private final Scene scene;
    private final LightSelection selection;
    /** With one light there is nothing to choose, and its estimate at each vertex would cost as much as sampling it. */
    private final boolean single;

    private final RayCaster caster;
    private final LightChoice chosen = new LightChoice();
    private final LightSample light = new LightSample();
    private final Spectrum value = new Spectrum();

    /** The vertex that the current ray was scattered at, and the normal that lights were chosen with there. */
    private double fromX;

    private double fromY;
    private double fromZ;
    private double fromNx;
    private double fromNy;
    private double fromNz;

    /** Normal for the choice of lights at the vertex in hand; 0 if it may transmit. */
    private double nx;

    private double ny;
    private double nz;

    /** Number of the vertex in hand, of all at which lights were sampled; and of the one that the ray was scattered at. */
    private long vertex = 1;

    private long vertices = 1;
    private long from = 1;

    /** Probabilities of lights at some vertices: of paths that split, many leave the scene from the same one. */
    private final long[] knownAt = new long[KNOWN];

    private final int[] knownLight = new int[KNOWN];
    private final double[] known = new double[KNOWN];

    private long keptVertex;
    private double keptNx;
    private double keptNy;
    private double keptNz;

    DirectLight(RayCaster caster) {
        this.caster = caster;
        scene = caster.scene();
        selection = scene.lightSelection();
        single = scene.lightCount() == 1;
        chosen.probability = 1;
    }

    /**
     * Notes that the path goes on from a vertex at which {@link #addSampled} was called last: lights that the ray meets are
     * weighted against the light samples of that vertex.
     */
    void leave(SurfacePoint p) {
        fromX = p.x;
        fromY = p.y;
        fromZ = p.z;
        fromNx = nx;
        fromNy = ny;
        fromNz = nz;
        from = vertex;
    }

    /** Keeps the normal that lights were chosen with at the vertex in hand, for paths that will start there later. */
    void keepNormal() {
        keptNx = nx;
        keptNy = ny;
        keptNz = nz;
        keptVertex = vertex;
    }

    /** Goes back to the vertex of {@link #keepNormal}. */
    void recallNormal() {
        nx = keptNx;
        ny = keptNy;
        nz = keptNz;
        vertex = keptVertex;
    }

    /**
     * Adds what one light, chosen among all, contributes at a vertex by next-event estimation.
     *
     * @param p the vertex
     * @param throughputR throughput of the path up to the vertex
     * @param choice number that chooses the light
     * @param u first number for the point on it
     */
    void addSampled(
            SurfacePoint p,
            Bsdf bsdf,
            double woX,
            double woY,
            double woZ,
            double throughputR,
            double throughputG,
            double throughputB,
            double choice,
            double u,
            double v,
            Spectrum radiance) {
        vertex = ++vertices;
        double side = bsdf.transmissive() ? 0 : Math.signum(p.localZ(woX, woY, woZ));
        nx = side * p.nx;
        ny = side * p.ny;
        nz = side * p.nz;
        if (!single && !selection.choose(p.x, p.y, p.z, nx, ny, nz, choice, chosen)) {
            return;
        }
        if (!scene.light(chosen.light).sampleIncident(p.x, p.y, p.z, u, v, light)) {
            return;
        }
        double scatterDensity = Scattering.evaluate(
                bsdf, p, woX, woY, woZ, light.wiX, light.wiY, light.wiZ, TransportMode.RADIANCE, value);
        value.mul(light.weight);
        double r = throughputR * value.r;
        double g = throughputG * value.g;
        double b = throughputB * value.b;
        if (r == 0 && g == 0 && b == 0) {
            return;
        }
        double weight = light.delta ? 1 : powerHeuristic(chosen.probability * light.density, scatterDensity);
        weight *= visibility(p) / chosen.probability;
        if (weight != 0) {
            radiance.r += weight * r;
            radiance.g += weight * g;
            radiance.b += weight * b;
        }
    }

    /**
     * Adds what one light contributes at a vertex, by one sample of it alone and without weights.
     *
     * @param index the light
     */
    void addSampledAlone(
            int index,
            SurfacePoint p,
            Bsdf bsdf,
            double woX,
            double woY,
            double woZ,
            double throughputR,
            double throughputG,
            double throughputB,
            double u,
            double v,
            Spectrum radiance) {
        if (!scene.light(index).sampleIncident(p.x, p.y, p.z, u, v, light)) {
            return;
        }
        Scattering.evaluate(bsdf, p, woX, woY, woZ, light.wiX, light.wiY, light.wiZ, TransportMode.RADIANCE, value);
        value.mul(light.weight);
        double r = throughputR * value.r;
        double g = throughputG * value.g;
        double b = throughputB * value.b;
        if (r == 0 && g == 0 && b == 0) {
            return;
        }
        double visible = visibility(p);
        if (visible != 0) {
            radiance.r += visible * r;
            radiance.g += visible * g;
            radiance.b += visible * b;
        }
    }

    /**
     * Adds the emission of a light that a ray has met, if any.
     *
     * @param index the light
     * @param hit the point on it; ignored by lights at infinity
     * @param dx unit direction of the ray
     * @param scatterDensity density per solid angle with which the vertex that was left scattered the ray; infinite if no light
     *     sample could have found this path, after a camera or a delta lobe
     */
    void addMet(
            int index,
            SurfacePoint hit,
            double dx,
            double dy,
            double dz,
            double throughputR,
            double throughputG,
            double throughputB,
            double scatterDensity,
            Spectrum radiance) {
        Light met = scene.light(index);
        met.radiance(hit, -dx, -dy, -dz, value);
        if (value.isBlack()) {
            return;
        }
        double weight = 1;
        if (scatterDensity < Double.POSITIVE_INFINITY) {
            double chosen = single ? 1 : probability(index);
            double density = chosen * met.incidentDensity(fromX, fromY, fromZ, hit, dx, dy, dz);
            weight = powerHeuristic(scatterDensity, density);
        }
        radiance.r += weight * throughputR * value.r;
        radiance.g += weight * throughputG * value.g;
        radiance.b += weight * throughputB * value.b;
    }

    /** Probability with which a light would be chosen at the vertex that the ray was scattered at. */
    private double probability(int index) {
        int slot = (int) (from + index) & KNOWN - 1;
        if (knownAt[slot] != from || knownLight[slot] != index) {
            knownAt[slot] = from;
            knownLight[slot] = index;
            double probability = from == vertices ? chosen.probabilityOf(index) : -1;
            known[slot] = probability >= 0
                    ? probability
                    : selection.probability(index, fromX, fromY, fromZ, fromNx, fromNy, fromNz);
        }
        return known[slot];
    }

    /** Adds the emission of all lights at infinity for a ray that leaves the scene; parameters as {@link #addMet}. */
    void addEscaped(
            SurfacePoint any,
            double dx,
            double dy,
            double dz,
            double throughputR,
            double throughputG,
            double throughputB,
            double scatterDensity,
            Spectrum radiance) {
        for (int i = 0; i < scene.environmentCount(); i++) {
            addMet(
                    scene.environment(i),
                    any,
                    dx,
                    dy,
                    dz,
                    throughputR,
                    throughputG,
                    throughputB,
                    scatterDensity,
                    radiance);
        }
    }

    /** The one occlusion query of a connection; the last step, as it costs most. */
    private double visibility(SurfacePoint p) {
        return light.distance == Double.POSITIVE_INFINITY
                ? caster.transmittanceToInfinity(p, light.wiX, light.wiY, light.wiZ)
                : caster.transmittance(p, light.point);
    }

    /** Weight of a technique with density a against one with density b, a > 0; finite also for huge densities. */
    private static double powerHeuristic(double a, double b) {
        if (b <= a) {
            double ratio = b / a;
            return 1 / (1 + ratio * ratio);
        }
        double ratio = a / b;
        double squared = ratio * ratio;
        return squared / (1 + squared);
    }
}
