package org.daybreak.core.material;

import org.daybreak.core.geometry.SurfacePoint;

/**
 * A material whose normal is that of the surface displaced by a texture, though nothing is displaced (Blinn 1978,
 * “Simulation of Wrinkled Surfaces”): its slope is the texture's gradient over the surface.
 */
public final class BumpMap extends PerturbedBsdf {
    private final Texture height;
    private final double scale;

    /**
     * Creates a bump map over a material.
     *
     * @param height displacement along the normal; of colours the luminance counts
     * @param scale world units per unit of the texture
     * @param shadowed whether tilted facets shadow each other, which softens the edge of darkness
     * @throws IllegalArgumentException if the scale is not finite or the texture has no derivatives
     */
    public BumpMap(Texture height, double scale, Bsdf nested, boolean shadowed) {
        super(nested, shadowed);
        if (!Double.isFinite(scale)) {
            throw new IllegalArgumentException("the scale of a bump map must be finite but is " + scale);
        }
        if (!height.differentiable()) {
            throw new IllegalArgumentException("the texture of a bump map must be a function of texture coordinates");
        }
        this.height = height;
        this.scale = scale;
    }

    @Override
    double slopeS(SurfacePoint point) {
        return point.uLength == 0 ? 0 : scale * height.derivativeU(point) / point.uLength;
    }

    @Override
    double slopeT(SurfacePoint point) {
        return point.vAlongT == 0
                ? 0
                : (scale * height.derivativeV(point) - point.vAlongS * slopeS(point)) / point.vAlongT;
    }
}
