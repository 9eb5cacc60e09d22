package org.daybreak.core.accel;

/**
 * The primitives of a set that are no triangles, laid out for traversal: quadrics, then instances, numbered from 0.
 * They are tested one at a time, in double precision. For implementations of {@link Intersector}.
 */
public final class OtherPrimitives {
    private final int triangleCount;
    private final int quadricCount;
    private final int[] kinds;
    private final double[] tapers;
    private final double[] worldToObject;
    private final Instance[] instances;

    /** Copies what traversal needs. */
    public OtherPrimitives(PrimitiveSet set) {
        triangleCount = set.triangleCount();
        quadricCount = set.quadricCount();
        kinds = new int[quadricCount];
        tapers = new double[quadricCount];
        worldToObject = new double[12 * quadricCount];
        for (int i = 0; i < quadricCount; i++) {
            kinds[i] = set.quadric(i).tag();
            tapers[i] = set.quadric(i).taper();
            set.quadric(i).copyWorldToObject(worldToObject, 12 * i);
        }
        instances = new Instance[set.instanceCount()];
        for (int i = 0; i < instances.length; i++) {
            instances[i] = set.instance(i);
        }
    }

    /**
     * Looks for the closest hit before {@code tMax}; if there is one, writes it to the result fields of the ray.
     *
     * @param index number of the primitive less the number of triangles
     * @return whether there is one
     */
    public boolean intersect(Ray ray, int index, double tMax) {
        if (index < quadricCount) {
            double t = Quadric.intersect(
                    kinds[index],
                    tapers[index],
                    worldToObject,
                    12 * index,
                    ray.ox,
                    ray.oy,
                    ray.oz,
                    ray.dx,
                    ray.dy,
                    ray.dz,
                    tMax);
            if (t < tMax) {
                ray.t = t;
                ray.primitive = triangleCount + index;
                ray.instance = -1;
                return true;
            }
            return false;
        }
        int number = index - quadricCount;
        Instance instance = instances[number];
        Ray nested = ray.nested();
        instance.toObject(ray, nested);
        nested.tMax = tMax;
        if (instance.child().intersect(nested)) {
            ray.t = nested.t;
            ray.primitive = nested.primitive;
            ray.instance = number;
            return true;
        }
        return false;
    }

    /** Whether the ray hits the primitive before {@code tMax}. */
    public boolean occluded(Ray ray, int index, double tMax) {
        if (index < quadricCount) {
            return Quadric.intersect(
                            kinds[index],
                            tapers[index],
                            worldToObject,
                            12 * index,
                            ray.ox,
                            ray.oy,
                            ray.oz,
                            ray.dx,
                            ray.dy,
                            ray.dz,
                            tMax)
                    < tMax;
        }
        Instance instance = instances[index - quadricCount];
        Ray nested = ray.nested();
        instance.toObject(ray, nested);
        nested.tMax = tMax;
        return instance.child().occluded(nested);
    }

    /** Memory held, in bytes, without the levels that the instances place. */
    public long memoryBytes() {
        return 12L * kinds.length + 8L * worldToObject.length + 8L * instances.length;
    }
}
