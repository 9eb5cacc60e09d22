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
    private final double scale;
    private final boolean greenAgainstV;

    /**
     * Creates a normal map over a material, whose green component counts along t.
     *
     * @param shadowed whether tilted facets shadow each other, which softens the edge of darkness
     * @throws IllegalArgumentException if the nested material has a map over other texture coordinates
     */
    public NormalMap(Texture normals, Bsdf nested, boolean shadowed) {
        this(normals, 1, false, nested, shadowed);
    }

    /**
     * Creates a normal map over a material.
     *
     * @param scale factor on the components along s and t
     * @param greenAgainstV whether the green component counts along −∂p/∂v, which is ±t, as where v runs down the
     *     image and mirrored parts share a map (glTF); otherwise it counts along t
     * @param shadowed whether tilted facets shadow each other, which softens the edge of darkness
     * @throws IllegalArgumentException if the factor is not finite or the nested material has a map over other texture
     *     coordinates
     */
    public NormalMap(Texture normals, double scale, boolean greenAgainstV, Bsdf nested, boolean shadowed) {
        super(normals, nested, shadowed);
        if (!Double.isFinite(scale)) {
            throw new IllegalArgumentException("the scale of a normal map must be finite but is " + scale);
        }
        this.normals = normals;
        this.scale = scale;
        this.greenAgainstV = greenAgainstV;
    }

    @Override
    double slopeS(SurfacePoint point) {
        return scale * (1 - 2 * normals.component(point, 0)) / z(point);
    }

    @Override
    double slopeT(SurfacePoint point) {
        double slope = scale * (1 - 2 * normals.component(point, 1)) / z(point);
        return greenAgainstV && point.uvArea() > 0 ? -slope : slope;
    }

    private double z(SurfacePoint point) {
        return Math.max(LEAST_Z, 2 * normals.component(point, 2) - 1);
    }
}
