package org.daybreak.core.scene;

import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.geometry.SurfaceDifferential;
import org.daybreak.core.geometry.SurfacePoint;

/** Turns hits of the two-level acceleration structure into surface points. Immutable. */
final class SurfaceResolver {
    private final PrimitiveSet world;
    private final LevelGeometry geometry;
    private final LevelGeometry[] geometryOfInstance;
    private final PrimitiveSet[] setOfInstance;

    /**
     * Creates a resolver.
     *
     * @param world the top level
     * @param geometry its triangles and quadrics
     * @param geometryOfInstance what each of its instances places
     * @param setOfInstance the primitives of what each of its instances places
     */
    SurfaceResolver(
            PrimitiveSet world,
            LevelGeometry geometry,
            LevelGeometry[] geometryOfInstance,
            PrimitiveSet[] setOfInstance) {
        this.world = world;
        this.geometry = geometry;
        this.geometryOfInstance = geometryOfInstance;
        this.setOfInstance = setOfInstance;
    }

    /**
     * Resolves a hit.
     *
     * @param ray the query with its answer
     * @param refinement scratch space of the worker
     * @param hit receives the point
     */
    void resolve(Ray ray, HitRefinement refinement, SurfacePoint hit) {
        int instance = ray.instance;
        hit.instance = instance;
        if (instance < 0) {
            refinement.refine(world, ray, world);
            geometry.complete(refinement, ray.primitive, null, hit);
        } else {
            refinement.refine(world, ray, setOfInstance[instance]);
            geometryOfInstance[instance].complete(refinement, ray.primitive, world.instance(instance), hit);
        }
    }

    /**
     * Fills in how the surface goes on around a resolved point.
     *
     * @return false if the point is on no surface, or one without a normal
     */
    boolean differential(SurfacePoint point, SurfaceDifferential out) {
        int instance = point.instance;
        return instance < 0
                ? geometry.differential(point, null, out)
                : geometryOfInstance[instance].differential(point, world.instance(instance), out);
    }
}
