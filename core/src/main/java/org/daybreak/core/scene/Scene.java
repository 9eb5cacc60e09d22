package org.daybreak.core.scene;

import java.util.List;
import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.geometry.BoundingSphere;
import org.daybreak.core.geometry.SurfaceDifferential;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSelection;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.math.Bounds;

/**
 * A compiled scene: geometry with its acceleration structure, materials, lights and camera. Immutable and thread-safe;
 * made by {@link SceneCompiler}.
 */
public final class Scene {
    private final Intersector intersector;
    private final SurfaceResolver surfaces;
    private final Bsdf[] bsdfs;
    private final int[] lightOfShape;
    private final Light[] lights;
    private final int[] environmentLights;
    private final LightSelection lightSelection;
    private final Camera camera;
    private final FilmSettings film;
    private final Bounds bounds;
    private final List<BoundingSphere> deltaSpheres;
    private final boolean maybeTransparent;
    /** Shapes that rays may find a hole in: not lights, whose light does not depend on the material. */
    private final boolean[] mayHaveHoles;

    Scene(
            Intersector intersector,
            SurfaceResolver surfaces,
            Bsdf[] bsdfs,
            int[] lightOfShape,
            Light[] lights,
            LightSelection lightSelection,
            Camera camera,
            FilmSettings film,
            Bounds bounds,
            List<BoundingSphere> deltaSpheres) {
        this.intersector = intersector;
        this.surfaces = surfaces;
        this.bsdfs = bsdfs;
        this.lightOfShape = lightOfShape;
        this.lights = lights;
        this.environmentLights = java.util.stream.IntStream.range(0, lights.length)
                .filter(i -> lights[i].isInfinite() && !lights[i].isDelta())
                .toArray();
        this.lightSelection = lightSelection;
        this.camera = camera;
        this.film = film;
        this.bounds = bounds;
        this.deltaSpheres = deltaSpheres;
        boolean transparent = false;
        mayHaveHoles = new boolean[bsdfs.length];
        for (int i = 0; i < bsdfs.length; i++) {
            transparent |= bsdfs[i].maybeTransparent();
            mayHaveHoles[i] = bsdfs[i].maybeTransparent() && lightOfShape[i] < 0;
        }
        this.maybeTransparent = transparent;
    }

    /** The acceleration structure. */
    public Intersector intersector() {
        return intersector;
    }

    /**
     * Turns a hit that the intersector reported into a surface point, recomputed in double precision.
     *
     * @param ray the query with its answer; a hit
     * @param refinement scratch space of the worker
     * @param hit receives the point
     */
    public void resolve(Ray ray, HitRefinement refinement, SurfacePoint hit) {
        surfaces.resolve(ray, refinement, hit);
    }

    /**
     * Fills in how the surface goes on around a point: tangents and the derivatives of both normals. Costs about as much as
     * resolving a hit, and nothing to who does not ask.
     *
     * @param point a point that {@link #resolve} has filled
     * @param out receives the differential; where the answer is false, its tangents are still those of the point
     * @return false if it is not known: at the tip of a cone, on materials whose normals a texture tilts
     *     ({@link Bsdf#tiltsNormal}), and for points that no hit was resolved to, as those drawn from lights and lenses
     */
    public boolean differential(SurfacePoint point, SurfaceDifferential out) {
        return surfaces.differential(point, out) && !bsdfs[point.shape].tiltsNormal();
    }

    /** Number of shapes; indices of {@link SurfacePoint#shape} run below it. */
    public int shapeCount() {
        return bsdfs.length;
    }

    /** Material of a shape. */
    public Bsdf bsdf(int shape) {
        return bsdfs[shape];
    }

    /** Index of the area light on a shape, or -1. */
    public int lightOf(int shape) {
        return lightOfShape[shape];
    }

    /** Number of lights. */
    public int lightCount() {
        return lights.length;
    }

    /** A light. */
    public Light light(int index) {
        return lights[index];
    }

    /** Number of lights at infinity that rays leaving the scene can hit. */
    public int environmentCount() {
        return environmentLights.length;
    }

    /** Light index of one of the lights at infinity that rays leaving the scene can hit. */
    public int environment(int i) {
        return environmentLights[i];
    }

    /** How lights are chosen. */
    public LightSelection lightSelection() {
        return lightSelection;
    }

    /** The camera. */
    public Camera camera() {
        return camera;
    }

    /** Size and filter of the film. */
    public FilmSettings film() {
        return film;
    }

    /** Bounds of all geometry; empty bounds if there is none. */
    public Bounds bounds() {
        return bounds;
    }

    /**
     * A few spheres that hold all geometry of ideal mirrors and glass: where light is thrown that only a path from the light finds
     * well.
     */
    public List<BoundingSphere> deltaSpheres() {
        return deltaSpheres;
    }

    /** True for materials that scatter in delta lobes alone, other than straight on. */
    static boolean isDelta(Bsdf bsdf) {
        return !bsdf.connectable() && !bsdf.maybeTransparent();
    }

    /** True if there is nothing at a point of a shape: light passes straight through all of it, and none is emitted. */
    boolean isHole(SurfacePoint point) {
        return mayHaveHoles[point.shape] && bsdfs[point.shape].transparency(point) == 1;
    }

    /** True if some material lets part of the light pass straight through. */
    public boolean maybeTransparent() {
        return maybeTransparent;
    }
}
