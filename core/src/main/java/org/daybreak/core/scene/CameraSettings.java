package org.daybreak.core.scene;

import javax.vecmath.Matrix4d;

/**
 * A camera as scenes describe it. In camera coordinates it looks along +z, +y is up and +x points to the left of
 * the image (Mitsuba's convention), so that a look-at transform is right-handed.
 *
 * @param toWorld camera-to-world transform; scale and shear only for orthographic cameras, whose image shows −1 to 1 across
 *     its width
 * @param projection how it maps space to the film; the next four parameters are for perspective cameras only
 * @param fieldOfViewDegrees full opening angle along the given axis
 * @param axis axis the opening angle refers to
 * @param apertureRadius radius of the thin lens in world units; 0 for a pinhole
 * @param focusDistance distance of the plane of focus along the viewing direction; unused by a pinhole
 * @param shiftX how far the film is shifted to the right against the axis, in film widths (Mitsuba's
 *     {@code principal_point_offset_x}); for perspective cameras only
 * @param shiftY how far it is shifted down, in film heights
 * @param pixelAspect width of a pixel over its height; not for environment cameras
 */
public record CameraSettings(
        Matrix4d toWorld,
        Projection projection,
        double fieldOfViewDegrees,
        FovAxis axis,
        double apertureRadius,
        double focusDistance,
        double shiftX,
        double shiftY,
        double pixelAspect) {
    /** How space is mapped to the film. */
    public enum Projection {
        /** Through a pinhole or a thin lens. */
        PERSPECTIVE,
        /** By parallel rays. */
        ORTHOGRAPHIC,
        /** All directions, equirectangular. */
        ENVIRONMENT
    }

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
        if (!Double.isFinite(shiftX) || !Double.isFinite(shiftY)) {
            throw new IllegalArgumentException("the shift of the film must be finite but is " + shiftX + ", " + shiftY);
        }
        if (!(pixelAspect > 0) || Double.isInfinite(pixelAspect)) {
            throw new IllegalArgumentException("the aspect of pixels must be positive but is " + pixelAspect);
        }
    }

    /** A perspective camera with square pixels and the axis in the middle of the film. */
    public CameraSettings(
            Matrix4d toWorld, double fieldOfViewDegrees, FovAxis axis, double apertureRadius, double focusDistance) {
        this(toWorld, Projection.PERSPECTIVE, fieldOfViewDegrees, axis, apertureRadius, focusDistance, 0, 0, 1);
    }

    /** A camera of parallel rays. */
    public static CameraSettings orthographic(Matrix4d toWorld) {
        return new CameraSettings(toWorld, Projection.ORTHOGRAPHIC, 45, FovAxis.X, 0, 1, 0, 0, 1);
    }

    /** A camera that sees all directions. */
    public static CameraSettings environment(Matrix4d toWorld) {
        return new CameraSettings(toWorld, Projection.ENVIRONMENT, 45, FovAxis.X, 0, 1, 0, 0, 1);
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
