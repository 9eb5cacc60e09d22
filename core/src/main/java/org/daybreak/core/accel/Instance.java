package org.daybreak.core.accel;

/**
 * A placed copy of an indexed level. The level must hold no instances itself: there are two levels, deeper graphs are
 * flattened by who builds the {@link PrimitiveSet}.
 */
public final class Instance {
    private final double[] objectToWorld;
    private final double[] worldToObject;
    private final Intersector child;

    /**
     * Creates an instance.
     *
     * @param objectToWorld rows of the 3×4 matrix that places the level; any invertible affine map
     * @param worldToObject its inverse
     * @param child index of the level, in its own coordinates
     * @throws IllegalArgumentException if an entry is not finite or the maps are not inverse to each other
     */
    public Instance(double[] objectToWorld, double[] worldToObject, Intersector child) {
        Affine.check(objectToWorld, worldToObject);
        this.objectToWorld = objectToWorld.clone();
        this.worldToObject = worldToObject.clone();
        this.child = child;
    }

    /**
     * Creates an instance, computing the inverse map.
     *
     * @param objectToWorld rows of the 3×4 matrix that places the level
     * @param child index of the level, in its own coordinates
     * @throws IllegalArgumentException if an entry is not finite or the map is singular
     */
    public Instance(double[] objectToWorld, Intersector child) {
        this(objectToWorld, Affine.invert(objectToWorld), child);
    }

    /** Index of the level, in its own coordinates. */
    public Intersector child() {
        return child;
    }

    /** Entry of the map from object to world; row-major 3×4. */
    public double objectToWorld(int entry) {
        return objectToWorld[entry];
    }

    /** Entry of the map from world to object; row-major 3×4. */
    public double worldToObject(int entry) {
        return worldToObject[entry];
    }

    /**
     * Sets the origin and direction of a ray of the level from one of the world. The direction keeps its length in
     * object space, so that t means the same on both levels.
     */
    void toObject(Ray world, Ray object) {
        double[] m = worldToObject;
        object.ox = m[0] * world.ox + m[1] * world.oy + m[2] * world.oz + m[3];
        object.oy = m[4] * world.ox + m[5] * world.oy + m[6] * world.oz + m[7];
        object.oz = m[8] * world.ox + m[9] * world.oy + m[10] * world.oz + m[11];
        object.dx = m[0] * world.dx + m[1] * world.dy + m[2] * world.dz;
        object.dy = m[4] * world.dx + m[5] * world.dy + m[6] * world.dz;
        object.dz = m[8] * world.dx + m[9] * world.dy + m[10] * world.dz;
    }

    /** Writes conservative bounds: minimum x, y, z, maximum x, y, z; an empty level gives +∞ and −∞. */
    void bounds(double[] target) {
        float[] box = new float[6];
        child.bounds(box);
        for (int axis = 0; axis < 3; axis++) {
            double low = objectToWorld[4 * axis + 3];
            double high = low;
            double magnitude = Math.abs(low);
            for (int k = 0; k < 3; k++) {
                double a = objectToWorld[4 * axis + k] * box[k];
                double b = objectToWorld[4 * axis + k] * box[k + 3];
                low += Math.min(a, b);
                high += Math.max(a, b);
                magnitude += Math.max(Math.abs(a), Math.abs(b));
            }
            boolean empty = !(box[0] <= box[3]);
            target[axis] = empty ? Double.POSITIVE_INFINITY : low - 0x1p-48 * magnitude;
            target[axis + 3] = empty ? Double.NEGATIVE_INFINITY : high + 0x1p-48 * magnitude;
        }
    }
}
