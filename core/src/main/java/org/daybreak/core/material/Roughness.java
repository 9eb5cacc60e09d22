package org.daybreak.core.material;

import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * Roughness α of microfacets: the same in all directions, or one number along x and another along y of a shading frame that
 * lies along the texture coordinates. Immutable.
 */
public final class Roughness {
    private final double alphaU;
    private final double alphaV;
    /** Null if constant. */
    private final @Nullable Texture textureU;

    private final @Nullable Texture textureV;
    private final boolean anisotropic;

    private Roughness(Texture u, Texture v) {
        anisotropic = u != v;
        textureU = u.isConstant() ? null : u;
        textureV = v.isConstant() ? null : v;
        SurfacePoint anywhere = new SurfacePoint();
        alphaU = u.isConstant() ? Microfacet.requireAlpha(u.evaluateScalar(anywhere)) : requireMaximum(u);
        alphaV = v.isConstant() ? Microfacet.requireAlpha(v.evaluateScalar(anywhere)) : requireMaximum(v);
    }

    /**
     * The same roughness in all directions.
     *
     * @throws IllegalArgumentException if it is outside [{@link Microfacet#MIN_ALPHA}, {@link Microfacet#MAX_ALPHA}]
     */
    public static Roughness of(double alpha) {
        return of(ConstantTexture.grey(Microfacet.requireAlpha(alpha)));
    }

    /**
     * A roughness that varies over the surface but not with the direction.
     *
     * @param alpha its values; of colours the luminance counts. Values of a varying texture below {@link
     *     Microfacet#MIN_ALPHA} are taken as that
     * @throws IllegalArgumentException if a constant is outside [{@link Microfacet#MIN_ALPHA}, {@link
     *     Microfacet#MAX_ALPHA}] or a varying texture exceeds the latter
     */
    public static Roughness of(Texture alpha) {
        return new Roughness(alpha, alpha);
    }

    /**
     * A roughness that differs between the directions of the texture coordinates.
     *
     * @param alphaU values along u, as for {@link #of(Texture)}
     * @param alphaV values across, along v where the coordinates are orthogonal
     * @throws IllegalArgumentException as {@link #of(Texture)}
     */
    public static Roughness of(Texture alphaU, Texture alphaV) {
        Roughness both = new Roughness(alphaU, alphaV);
        boolean equal = alphaU.isConstant() && alphaV.isConstant() && both.alphaU == both.alphaV;
        return equal ? of(alphaU) : both;
    }

    private static double requireMaximum(Texture texture) {
        double maximum = texture.maximum();
        if (!(maximum <= Microfacet.MAX_ALPHA)) {
            throw new IllegalArgumentException(
                    "alpha must be at most " + Microfacet.MAX_ALPHA + " but its texture reaches " + maximum);
        }
        return maximum;
    }

    /** Roughness along x of the shading frame at a point. */
    double alongU(SurfacePoint point) {
        Texture texture = textureU;
        return texture == null ? alphaU : Math.max(Microfacet.MIN_ALPHA, texture.evaluateScalar(point));
    }

    /**
     * Roughness along y of the shading frame at a point.
     *
     * @param alongU what {@link #alongU} returned there
     */
    double alongV(SurfacePoint point, double alongU) {
        if (!anisotropic) {
            return alongU;
        }
        Texture texture = textureV;
        return texture == null ? alphaV : Math.max(Microfacet.MIN_ALPHA, texture.evaluateScalar(point));
    }

    /** True unless both numbers are constant. */
    boolean varies() {
        return textureU != null || textureV != null;
    }

    /** The frame in which the two numbers have a meaning, if they differ. */
    TangentFrame tangentFrame() {
        return anisotropic ? TangentFrame.ANY_UVS : TangentFrame.ARBITRARY;
    }
}
