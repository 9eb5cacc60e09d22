package org.daybreak.core.material;

import org.daybreak.core.geometry.SurfacePoint;

/**
 * A material whose normal comes from a texture: red, green and blue are the components of the normal along s, t and n of the
 * shading frame, mapped from [−1,1] to [0,1]. The texture must be read without decoding (“raw”).
 */
public final class NormalMap extends PerturbedBsdf {
    /** Normals in or below the surface are brought up to this third component. */
    private static final double LEAST_Z = 1e-3;

    private final Texture normals;

    /**
     * Creates a normal map over a material.
     *
     * @param shadowed whether tilted facets shadow each other, which softens the edge of darkness
     */
    public NormalMap(Texture normals, Bsdf nested, boolean shadowed) {
        super(nested, shadowed);
        this.normals = normals;
    }

    @Override
    double slopeS(SurfacePoint point) {
        return (1 - 2 * normals.component(point, 0)) / z(point);
    }

    @Override
    double slopeT(SurfacePoint point) {
        return (1 - 2 * normals.component(point, 1)) / z(point);
    }

    private double z(SurfacePoint point) {
        return Math.max(LEAST_Z, 2 * normals.component(point, 2) - 1);
    }
}
