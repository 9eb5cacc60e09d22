package org.daybreak.scenes.build;

import javax.vecmath.Matrix4d;
import org.jspecify.annotations.Nullable;

/** Questions about transforms. */
final class Affine {
    /** Volume spanned by the unit row vectors below which a matrix is singular in double precision. */
    private static final double SMALLEST_VOLUME = 1e-12;

    /** How far from 1 the lengths and from 0 the cosines of a frame's axes may be: matrices in files are rounded. */
    private static final double FRAME_TOLERANCE = 1e-3;

    private Affine() {}

    /** What keeps a matrix from being an invertible affine transform, as the end of a sentence; null if nothing does. */
    static @Nullable String problem(Matrix4d m) {
        if (m.m30 != 0 || m.m31 != 0 || m.m32 != 0 || m.m33 != 1) {
            return " but is projective: its last row must be 0 0 0 1";
        }
        double lengths = length(m.m00, m.m01, m.m02) * length(m.m10, m.m11, m.m12) * length(m.m20, m.m21, m.m22);
        double determinant = linearDeterminant(m);
        if (!Double.isFinite(lengths) || !Double.isFinite(m.m03 + m.m13 + m.m23)) {
            return " but its numbers are too large";
        }
        if (!(Math.abs(determinant) > SMALLEST_VOLUME * lengths)) {
            return " but is singular: it has no inverse";
        }
        return null;
    }

    /** True if the transform exchanges left and right. */
    static boolean isMirroring(Matrix4d m) {
        return linearDeterminant(m) < 0;
    }

    /** True if the transform keeps angles: rotation, mirroring and one scale. */
    static boolean isSimilarity(Matrix4d m) {
        double scale = length(m.m00, m.m10, m.m20);
        Matrix4d unit = new Matrix4d(m);
        unit.mul(1 / scale);
        return hasOrthonormalAxes(unit, 1e-6);
    }

    /** True if the axes are orthogonal and of length 1 up to rounding in a file. */
    static boolean isRigid(Matrix4d m) {
        return hasOrthonormalAxes(m, FRAME_TOLERANCE);
    }

    private static boolean hasOrthonormalAxes(Matrix4d m, double tolerance) {
        double xx = m.m00 * m.m00 + m.m10 * m.m10 + m.m20 * m.m20;
        double yy = m.m01 * m.m01 + m.m11 * m.m11 + m.m21 * m.m21;
        double zz = m.m02 * m.m02 + m.m12 * m.m12 + m.m22 * m.m22;
        double xy = m.m00 * m.m01 + m.m10 * m.m11 + m.m20 * m.m21;
        double xz = m.m00 * m.m02 + m.m10 * m.m12 + m.m20 * m.m22;
        double yz = m.m01 * m.m02 + m.m11 * m.m12 + m.m21 * m.m22;
        return Math.abs(xx - 1) < 2 * tolerance
                && Math.abs(yy - 1) < 2 * tolerance
                && Math.abs(zz - 1) < 2 * tolerance
                && Math.abs(xy) < tolerance
                && Math.abs(xz) < tolerance
                && Math.abs(yz) < tolerance;
    }

    private static double linearDeterminant(Matrix4d m) {
        return m.m00 * (m.m11 * m.m22 - m.m12 * m.m21)
                - m.m01 * (m.m10 * m.m22 - m.m12 * m.m20)
                + m.m02 * (m.m10 * m.m21 - m.m11 * m.m20);
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
