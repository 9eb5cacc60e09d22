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
     * @throws IllegalArgumentException if the scale is not finite, the texture has no derivatives, or the nested material has a
     *     map over other texture coordinates
     */
    public BumpMap(Texture height, double scale, Bsdf nested, boolean shadowed) {
        super(height, nested, shadowed);
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
        double byU = scale * height.derivativeU(point);
        if (point.uAlongT == 0) {
            return point.uAlongS == 0 ? 0 : byU / point.uAlongS;
        }
        return (byU * point.vAlongT - scale * height.derivativeV(point) * point.uAlongT) / point.uvArea();
    }

    @Override
    double slopeT(SurfacePoint point) {
        double byV = scale * height.derivativeV(point);
        if (point.uAlongT == 0) {
            return point.vAlongT == 0 ? 0 : (byV - point.vAlongS * slopeS(point)) / point.vAlongT;
        }
        return (byV * point.uAlongS - scale * height.derivativeU(point) * point.vAlongS) / point.uvArea();
    }
}
