package org.daybreak.scenes.mitsuba;

import javax.vecmath.Matrix4d;
import javax.vecmath.Vector3d;
import org.daybreak.scenes.mitsuba.Numbers.FormatException;

/** The elementary transforms of scene files as matrices that act on column vectors. */
final class Transforms {
    private Transforms() {}

    /** The identity. */
    static Matrix4d identity() {
        Matrix4d m = new Matrix4d();
        m.setIdentity();
        return m;
    }

    /** A translation. */
    static Matrix4d translation(double x, double y, double z) {
        Matrix4d m = identity();
        m.setTranslation(new Vector3d(x, y, z));
        return m;
    }

    /** A scaling along the axes. */
    static Matrix4d scaling(double x, double y, double z) {
        Matrix4d m = identity();
        m.m00 = x;
        m.m11 = y;
        m.m22 = z;
        return m;
    }

    /** A rotation, counter-clockwise seen against the axis (Rodrigues' formula). */
    static Matrix4d rotation(double axisX, double axisY, double axisZ, double degrees) throws FormatException {
        double length = Math.sqrt(axisX * axisX + axisY * axisY + axisZ * axisZ);
        if (!(length > 0) || Double.isInfinite(length)) {
            throw new FormatException("the axis of a rotation must not be zero");
        }
        double x = axisX / length;
        double y = axisY / length;
        double z = axisZ / length;
        double s = Math.sin(Math.toRadians(degrees));
        double c = Math.cos(Math.toRadians(degrees));
        double d = 1 - c;
        return new Matrix4d(
                c + x * x * d,
                x * y * d - z * s,
                x * z * d + y * s,
                0,
                x * y * d + z * s,
                c + y * y * d,
                y * z * d - x * s,
                0,
                x * z * d - y * s,
                y * z * d + x * s,
                c + z * z * d,
                0,
                0,
                0,
                0,
                1);
    }

    /** A matrix of 16 numbers, or of 9 for its linear part, row by row. */
    static Matrix4d matrix(double[] values) throws FormatException {
        if (values.length == 16) {
            return new Matrix4d(values);
        }
        if (values.length != 9) {
            throw new FormatException("a matrix must have 9 or 16 numbers but has " + values.length);
        }
        Matrix4d m = identity();
        for (int i = 0; i < 9; i++) {
            m.setElement(i / 3, i % 3, values[i]);
        }
        return m;
    }

    /**
     * A frame at the origin with +z to the target, +y as near as can be to up and +x to the left of a viewer.
     *
     * @param up need not be unit; zero leaves the choice to a fixed rule, that of Mitsuba
     */
    static Matrix4d lookAt(double[] origin, double[] target, double[] up) throws FormatException {
        Vector3d forward = new Vector3d(target[0] - origin[0], target[1] - origin[1], target[2] - origin[2]);
        if (!normalize(forward)) {
            throw new FormatException("origin and target of a lookat must differ");
        }
        Vector3d upwards = new Vector3d(up);
        if (up[0] == 0 && up[1] == 0 && up[2] == 0) {
            upwards = anyPerpendicular(forward);
        }
        Vector3d left = new Vector3d();
        left.cross(upwards, forward);
        if (!normalize(left)) {
            throw new FormatException("the up vector of a lookat must not be parallel to the viewing direction");
        }
        Vector3d newUp = new Vector3d();
        newUp.cross(forward, left);
        normalize(newUp);
        return new Matrix4d(
                left.x, newUp.x, forward.x, origin[0], left.y, newUp.y, forward.y, origin[1], left.z, newUp.z,
                forward.z, origin[2], 0, 0, 0, 1);
    }

    private static boolean normalize(Vector3d v) {
        double length = v.length();
        v.scale(1 / length);
        return length > 0 && !Double.isInfinite(length);
    }

    /** First tangent of Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017. */
    private static Vector3d anyPerpendicular(Vector3d n) {
        double sign = n.z >= 0 ? 1 : -1;
        double a = -1 / (sign + n.z);
        return new Vector3d(1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
    }
}
