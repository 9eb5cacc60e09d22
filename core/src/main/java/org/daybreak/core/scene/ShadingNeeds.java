package org.daybreak.core.scene;

import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.TangentFrame;
import org.daybreak.core.material.Texture;
import org.jspecify.annotations.Nullable;

/**
 * What the points of a shape must offer beyond position and normal.
 *
 * @param textured texture coordinates, which cost arc functions on quadrics
 * @param frame what the shading frame must lie along
 */
record ShadingNeeds(boolean textured, TangentFrame frame) {
    /** What a material and the light it may stand on need. */
    static ShadingNeeds of(Bsdf material, @Nullable Texture radiance) {
        boolean textured = material.textured() || (radiance != null && !radiance.isConstant());
        return new ShadingNeeds(textured, material.tangentFrame());
    }
}
