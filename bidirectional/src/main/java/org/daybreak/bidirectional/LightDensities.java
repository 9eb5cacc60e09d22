package org.daybreak.bidirectional;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionDensity;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSelection;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.math.Densities;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.EmissionGuide;

/** Densities of points on lights and of the rays that leave them, with the choice of the light. One object per worker. */
public final class LightDensities {
    private final Scene scene;
    private final LightSelection selection;
    private final boolean all;
    private final EmissionGuide guide;
    private final EmissionDensity emission = new EmissionDensity();

    /** Density of x₀ as the start of a light subpath: per area, at infinity per solid angle; choice of the light included. */
    public double first;

    /** Density of x₁ given x₀, per area. */
    public double second;

    /** Density of x₀ by next-event estimation from x₁, as {@link #first}. */
    public double nextEvent;

    /**
     * Creates the densities of a worker.
     *
     * @param all whether each light is sampled, rather than one that is chosen
     */
    public LightDensities(Scene scene, EmissionGuide guide, boolean all) {
        this.scene = scene;
        this.guide = guide;
        this.all = all;
        selection = scene.lightSelection();
    }

    /** Probability with which a vertex chooses a light for next-event estimation. */
    public double choice(int light, SurfacePoint p, Bsdf bsdf, double woX, double woY, double woZ) {
        if (all) {
            return 1;
        }
        double side = side(p, bsdf, woX, woY, woZ);
        return selection.probability(light, p.x, p.y, p.z, side * p.nx, side * p.ny, side * p.nz);
    }

    /** Factor on the shading normal that lights are chosen with: 0 if the material may transmit, else the side of wo. */
    public static double side(SurfacePoint p, Bsdf bsdf, double woX, double woY, double woZ) {
        return bsdf.transmissive() ? 0 : Math.signum(p.localZ(woX, woY, woZ));
    }

    /** Density of y₀ of a light subpath when next-event estimation samples it from y₁. */
    double nextEvent(PathValues path) {
        SurfacePoint y0 = path.points[0];
        SurfacePoint y1 = path.points[1];
        Light light = scene.light(path.light[0]);
        double wiX = path.backX[1];
        double wiY = path.backY[1];
        double wiZ = path.backZ[1];
        // Materials that do not transmit scatter to the side that the light comes from.
        double chosen = choice(path.light[0], y1, path.bsdfs[1], wiX, wiY, wiZ);
        if (light.isDelta()) {
            return chosen;
        }
        return chosen * light.incidentDensity(y1.x, y1.y, y1.z, y0, wiX, wiY, wiZ) * path.toPrevious[1];
    }

    /**
     * Sets all three for a vertex x₁ and a point x₀ on a light.
     *
     * @param index the light
     * @param onLight the point; of lights at infinity nothing but the direction counts
     * @param wiX unit direction from x₁ to x₀
     * @param chosen probability with which x₁ chooses the light
     * @param incident density per solid angle with which the light then samples the direction; 1 for delta lights
     */
    public void set(
            int index,
            SurfacePoint onLight,
            SurfacePoint p,
            double wiX,
            double wiY,
            double wiZ,
            double chosen,
            double incident) {
        Light light = scene.light(index);
        guide.density(index, onLight, p, -wiX, -wiY, -wiZ, emission);
        double probability = emissionChoice(index);
        double cosine = p.geometricCosine(wiX, wiY, wiZ);
        if (light.isInfinite()) {
            first = probability * emission.direction;
            second = emission.position * Math.abs(cosine);
            nextEvent = chosen * incident;
            return;
        }
        double squared = LineTracer.squaredDistance(p, onLight);
        first = probability * emission.position;
        second = Densities.solidAngleToArea(emission.direction, squared, cosine);
        nextEvent = light.isDelta()
                ? chosen * incident
                : chosen * Densities.solidAngleToArea(incident, squared, onLight.geometricCosine(wiX, wiY, wiZ));
    }

    /** Probability with which light subpaths start from a light. */
    public double emissionChoice(int light) {
        return all ? 1 : selection.emissionProbability(light);
    }
}
