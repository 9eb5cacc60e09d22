package org.daybreak.core.material;

import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/** A number in [0,1] that may vary over the surface, with a short cut for constants. Of colours the luminance counts. */
final class UnitScalar {
    private final double constant;
    /** Null if constant. */
    private final @Nullable Texture varying;

    private final double maximum;
    private final boolean zero;

    /**
     * Checks and wraps a texture.
     *
     * @param name for the message
     * @throws IllegalArgumentException if the texture exceeds 1
     */
    UnitScalar(String name, Texture texture) {
        if (!(texture.maximum() <= 1)) {
            throw new IllegalArgumentException(name + " must be between 0 and 1 but reaches " + texture.maximum());
        }
        varying = texture.isConstant() ? null : texture;
        constant = texture.isConstant() ? texture.evaluateScalar(new SurfacePoint()) : 0;
        // The luminance of a grey exceeds it by rounding.
        maximum = texture.isConstant() ? constant : Math.min(1, texture.maximum() * (1 + 1e-15));
        zero = texture.maximum() == 0;
    }

    /** The value at a point. The luminance of white exceeds 1 by rounding, which is taken off. */
    double at(SurfacePoint point) {
        Texture texture = varying;
        return texture == null ? constant : Math.min(1, texture.evaluateScalar(point));
    }

    /** Upper bound of {@link #at}. */
    double maximum() {
        return maximum;
    }

    /** True unless constant. */
    boolean varies() {
        return varying != null;
    }

    /** True unless all are constant. */
    static boolean anyVaries(UnitScalar... scalars) {
        for (UnitScalar scalar : scalars) {
            if (scalar.varies()) {
                return true;
            }
        }
        return false;
    }

    /** True if 0 everywhere. */
    boolean isZero() {
        return zero;
    }
}
