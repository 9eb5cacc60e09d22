package org.daybreak.core.scene;

import javax.vecmath.Matrix4d;

/**
 * A perspective camera as scenes describe it. In camera coordinates it looks along +z, +y is up and +x points to the left of
 * the image (Mitsuba's convention), so that a look-at transform is right-handed.
 *
 * @param toWorld camera-to-world transform
 * @param fieldOfViewDegrees full opening angle along the given axis
 * @param axis axis the opening angle refers to
 * @param apertureRadius radius of the thin lens in world units; 0 for a pinhole
 * @param focusDistance distance of the plane of focus along the viewing direction; unused by a pinhole
 */
public record CameraSettings(
        Matrix4d toWorld, double fieldOfViewDegrees, FovAxis axis, double apertureRadius, double focusDistance) {
    /** Axis of the image that an opening angle refers to. */
    public enum FovAxis {
        /** Image width. */
        X,
        /** Image height. */
        Y,
        /** The shorter side. */
        SMALLER,
        /** The longer side. */
        LARGER,
        /** The diagonal. */
        DIAGONAL
    }

    /** Copies the matrix and checks the numbers. */
    public CameraSettings {
        toWorld = new Matrix4d(toWorld);
        if (!(fieldOfViewDegrees > 0 && fieldOfViewDegrees < 180)) {
            throw new IllegalArgumentException(
                    "the field of view must lie between 0 and 180 degrees but is " + fieldOfViewDegrees);
        }
        if (!(apertureRadius >= 0) || Double.isInfinite(apertureRadius)) {
            throw new IllegalArgumentException("the aperture radius must not be negative but is " + apertureRadius);
        }
        if (apertureRadius > 0 && !(focusDistance > 0 && Double.isFinite(focusDistance))) {
            throw new IllegalArgumentException("the focus distance must be positive but is " + focusDistance);
        }
    }

    /** A pinhole camera with the opening angle across the image width. */
    public CameraSettings(Matrix4d toWorld, double fieldOfViewDegrees) {
        this(toWorld, fieldOfViewDegrees, FovAxis.X, 0, 1);
    }

    @Override
    public Matrix4d toWorld() {
        return new Matrix4d(toWorld);
    }
}
