package org.daybreak.metropolis.strategy;

import org.daybreak.bidirectional.LightDensities;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionSample;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightChoice;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.light.LightSelection;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Outcome;
import org.daybreak.tracing.EmissionGuide;

/**
 * Makes the end x₀ of a {@link LightPath} on a light: as the start of a light subpath, by next-event estimation, or
 * where a walk from the lens has come to. One object per worker.
 */
final class LightEnd {
    private final Scene scene;
    private final LightSelection selection;
    private final EmissionGuide guide;
    private final EdgeTracer edges;
    private final Failure failure;
    private final EmissionSample emitted = new EmissionSample();
    private final LightSample incident = new LightSample();
    private final LightChoice choice = new LightChoice();

    LightEnd(Scene scene, EmissionGuide guide, EdgeTracer edges, Failure failure) {
        this.scene = scene;
        this.guide = guide;
        this.edges = edges;
        this.failure = failure;
        selection = scene.lightSelection();
    }

    /**
     * Starts a light subpath: chooses a light, samples x₀ and a direction, and traces to x₁.
     *
     * @return false if nothing leaves the light there, or nothing is met
     */
    boolean emit(LightPath y, RandomStream random) {
        int index = selection.chooseForEmission(random.nextDouble());
        if (index < 0) {
            return failure.because(Outcome.BLACK);
        }
        double u = random.nextDouble();
        double v = random.nextDouble();
        double s = random.nextDouble();
        double t = random.nextDouble();
        if (!guide.sample(index, u, v, s, t, emitted)) {
            return failure.because(Outcome.BLACK);
        }
        Light light = scene.light(index);
        y.light = index;
        y.infinite = light.isInfinite();
        y.deltaLight = light.isDelta();
        y.points[0].set(emitted.point);
        settle(y);
        y.dx[0] = emitted.dx;
        y.dy[0] = emitted.dy;
        y.dz[0] = emitted.dz;
        return edges.trace(y, 0, 1, RayKind.LIGHT, random);
    }

    /**
     * Samples x₀ for x₁: next-event estimation.
     *
     * @return false if no light can reach x₁ from the sample
     */
    boolean sample(LightPath y, RandomStream random) {
        SurfacePoint p = y.points[1];
        Bsdf bsdf = y.bsdfs[1];
        double side = LightDensities.side(p, bsdf, y.dx[1], y.dy[1], y.dz[1]);
        double number = random.nextDouble();
        if (!selection.choose(p.x, p.y, p.z, side * p.nx, side * p.ny, side * p.nz, number, choice)) {
            return failure.because(Outcome.BLACK);
        }
        Light light = scene.light(choice.light);
        double u = random.nextDouble();
        double v = random.nextDouble();
        if (!light.sampleIncident(p.x, p.y, p.z, u, v, incident)) {
            return failure.because(Outcome.BLACK);
        }
        y.light = choice.light;
        y.infinite = light.isInfinite();
        y.deltaLight = light.isDelta();
        y.points[0].set(incident.point);
        settle(y);
        y.dx[0] = -incident.wiX;
        y.dy[0] = -incident.wiY;
        y.dz[0] = -incident.wiZ;
        return true;
    }

    /**
     * Makes x₀ of a path that came from the lens a point on a light: the surface that was met or, if none was,
     * infinity.
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
        return y.light >= 0 || failure.because(Outcome.BLACK);
    }

    /** Number of lights among which {@link #land} chooses for a path. */
    int landings(LightPath y) {
        return y.infinite ? scene.environmentCount() : 1;
    }

    /**
     * Makes x₀ an end of the path, on a light that was sampled: it may have holes, which matters to walks that could
     * meet it.
     */
    void settle(LightPath y) {
        y.setEnd(0);
        if (!y.infinite && y.points[0].shape >= 0) {
            y.opacity[0] = edges.opacity(y.points[0]);
        }
    }
}
