package org.daybreak.core.math;

import java.util.Arrays;
import java.util.Locale;
import javax.vecmath.Matrix4d;

/**
 * Invertible affine map x ↦ Mx + b, with its inverse. Immutable.
 *
 * <p>The {@code apply} methods write into {@code dest[0..2]} of the caller and allocate nothing. Their arguments are
 * read before the destination is written, so source and destination may be the same array.
 */
public final class Transform {
    private static final Transform IDENTITY = ofRows(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

    /**
     * A matrix counts as singular when its volume is this small a part of that of the box with the same edge lengths
     * (Hadamard's ratio), for its rows and for its columns. Rounding of a rank-deficient matrix leaves about 1e-16.
     */
    private static final double SINGULAR_RATIO = 1e-14;

    private final double m00;
    private final double m01;
    private final double m02;
    private final double m03;
    private final double m10;
    private final double m11;
    private final double m12;
    private final double m13;
    private final double m20;
    private final double m21;
    private final double m22;
    private final double m23;
    /** Rows of the inverse. */
    private final double i00;

    private final double i01;
    private final double i02;
    private final double i03;
    private final double i10;
    private final double i11;
    private final double i12;
    private final double i13;
    private final double i20;
    private final double i21;
    private final double i22;
    private final double i23;

    private final boolean mirroring;

    private Transform(double[] m, double[] inverse) {
        m00 = m[0];
        m01 = m[1];
        m02 = m[2];
        m03 = m[3];
        m10 = m[4];
        m11 = m[5];
        m12 = m[6];
        m13 = m[7];
        m20 = m[8];
        m21 = m[9];
        m22 = m[10];
        m23 = m[11];
        i00 = inverse[0];
        i01 = inverse[1];
        i02 = inverse[2];
        i03 = inverse[3];
        i10 = inverse[4];
        i11 = inverse[5];
        i12 = inverse[6];
        i13 = inverse[7];
        i20 = inverse[8];
        i21 = inverse[9];
        i22 = inverse[10];
        i23 = inverse[11];
        mirroring = normalisedDeterminant(m) < 0;
    }

    /** The map that changes nothing. */
    public static Transform identity() {
        return IDENTITY;
    }

    /**
     * The map with the given rows of the 3×4 matrix (M | b).
     *
     * @throws IllegalArgumentException if there are not 12 entries, an entry is not finite, or the matrix is singular
     */
    public static Transform ofRows(double... rows) {
        if (rows.length != 12) {
            throw new IllegalArgumentException("an affine matrix has 12 entries, not " + rows.length);
        }
        double[] m = rows.clone();
        return new Transform(m, invert(m));
    }

    /**
     * The map of a homogeneous matrix acting on column vectors.
     *
     * @throws IllegalArgumentException if the last row is not 0 0 0 1, an entry is not finite, or the matrix is
     *     singular
     */
    public static Transform of(Matrix4d m) {
        if (m.m30 != 0 || m.m31 != 0 || m.m32 != 0 || m.m33 != 1) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "not an affine matrix: its last row is %s %s %s %s instead of 0 0 0 1",
                    m.m30,
                    m.m31,
                    m.m32,
                    m.m33));
        }
        return ofRows(m.m00, m.m01, m.m02, m.m03, m.m10, m.m11, m.m12, m.m13, m.m20, m.m21, m.m22, m.m23);
    }

    /**
     * Translation by (x, y, z).
     *
     * @throws IllegalArgumentException if a component is not finite
     */
    public static Transform translate(double x, double y, double z) {
        return ofRows(1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z);
    }

    /**
     * Scaling along the axes.
     *
     * @throws IllegalArgumentException if a factor is 0 or not finite
     */
    public static Transform scale(double x, double y, double z) {
        return ofRows(x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0);
    }

    /**
     * Rotation about an axis through the origin, counter-clockwise when the axis points at the viewer. Multiples of a
     * quarter turn about a coordinate axis are exact.
     *
     * @param axisX x of the axis, which need not have unit length
     * @param axisY y of the axis
     * @param axisZ z of the axis
     * @param degrees angle in degrees
     * @throws IllegalArgumentException if the axis is zero or anything is not finite
     */
    public static Transform rotate(double axisX, double axisY, double axisZ, double degrees) {
        double length = length(axisX, axisY, axisZ);
        if (!(length > 0) || !Double.isFinite(length) || !Double.isFinite(degrees)) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "no rotation by %s degrees about the axis (%s, %s, %s)",
                    degrees,
                    axisX,
                    axisY,
                    axisZ));
        }
        double x = axisX / length;
        double y = axisY / length;
        double z = axisZ / length;
        double sin = sinDegrees(degrees);
        double cos = sinDegrees(degrees + 90);
        double k = 1 - cos;
        return ofRows(
                cos + k * x * x,
                k * x * y - sin * z,
                k * x * z + sin * y,
                0,
                k * x * y + sin * z,
                cos + k * y * y,
                k * y * z - sin * x,
                0,
                k * x * z - sin * y,
                k * y * z + sin * x,
                cos + k * z * z,
                0);
    }

    /**
     * Camera-to-world map in the convention of Mitsuba: the camera sits at the origin given and looks along its +z
     * axis at the target; its +x axis points to the left of the picture, its +y axis up.
     *
     * @throws IllegalArgumentException if origin and target coincide, {@code up} is zero or parallel to the view
     *     direction, or anything is not finite
     */
    public static Transform lookAt(
            double originX,
            double originY,
            double originZ,
            double targetX,
            double targetY,
            double targetZ,
            double upX,
            double upY,
            double upZ) {
        double dx = targetX - originX;
        double dy = targetY - originY;
        double dz = targetZ - originZ;
        double distance = length(dx, dy, dz);
        if (!(distance > 0) || !Double.isFinite(distance)) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "lookAt has no view direction: origin (%s, %s, %s), target (%s, %s, %s)",
                    originX,
                    originY,
                    originZ,
                    targetX,
                    targetY,
                    targetZ));
        }
        dx /= distance;
        dy /= distance;
        dz /= distance;
        double lx = Scalars.differenceOfProducts(upY, dz, upZ, dy);
        double ly = Scalars.differenceOfProducts(upZ, dx, upX, dz);
        double lz = Scalars.differenceOfProducts(upX, dy, upY, dx);
        double leftLength = length(lx, ly, lz);
        if (!(leftLength > 1e-12 * length(upX, upY, upZ)) || !Double.isFinite(leftLength)) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "lookAt has no upright: up (%s, %s, %s) is zero or parallel to the view direction (%s, %s, %s)",
                    upX,
                    upY,
                    upZ,
                    dx,
                    dy,
                    dz));
        }
        lx /= leftLength;
        ly /= leftLength;
        lz /= leftLength;
        double ux = dy * lz - dz * ly;
        double uy = dz * lx - dx * lz;
        double uz = dx * ly - dy * lx;
        return ofRows(lx, ux, dx, originX, ly, uy, dy, originY, lz, uz, dz, originZ);
    }

    /**
     * The map that applies {@code other} first and then this one.
     *
     * @throws IllegalArgumentException if the product overflows or underflows to a singular matrix
     */
    public Transform multiply(Transform other) {
        double[] m = product(rows(), other.rows());
        requireInvertible(m);
        // The product of the inverses keeps exact inverses exact, which inverting the product anew would not.
        double[] inverse = product(other.inverseRows(), inverseRows());
        requireFinite(inverse);
        return new Transform(m, inverse);
    }

    /** The inverse map. */
    public Transform inverse() {
        return new Transform(inverseRows(), rows());
    }

    /** Whether the map turns right-handed frames into left-handed ones: its determinant is negative. */
    public boolean isMirroring() {
        return mirroring;
    }

    /** Writes the image of a point. */
    public void applyPoint(double x, double y, double z, double[] dest) {
        dest[0] = m00 * x + m01 * y + m02 * z + m03;
        dest[1] = m10 * x + m11 * y + m12 * z + m13;
        dest[2] = m20 * x + m21 * y + m22 * z + m23;
    }

    /** Writes the image of a vector, to which the translation does not apply. */
    public void applyVector(double x, double y, double z, double[] dest) {
        dest[0] = m00 * x + m01 * y + m02 * z;
        dest[1] = m10 * x + m11 * y + m12 * z;
        dest[2] = m20 * x + m21 * y + m22 * z;
    }

    /**
     * Writes the image of a normal: the inverse transpose of M times the normal. The result is orthogonal to the
     * images of the tangents, is not normalised, and keeps its side also under mirroring.
     */
    public void applyNormal(double x, double y, double z, double[] dest) {
        dest[0] = i00 * x + i10 * y + i20 * z;
        dest[1] = i01 * x + i11 * y + i21 * z;
        dest[2] = i02 * x + i12 * y + i22 * z;
    }

    /** Writes the preimage of a point. */
    public void applyInversePoint(double x, double y, double z, double[] dest) {
        dest[0] = i00 * x + i01 * y + i02 * z + i03;
        dest[1] = i10 * x + i11 * y + i12 * z + i13;
        dest[2] = i20 * x + i21 * y + i22 * z + i23;
    }

    /** Writes the preimage of a vector. */
    public void applyInverseVector(double x, double y, double z, double[] dest) {
        dest[0] = i00 * x + i01 * y + i02 * z;
        dest[1] = i10 * x + i11 * y + i12 * z;
        dest[2] = i20 * x + i21 * y + i22 * z;
    }

    /** The 3×4 matrix, row by row, in a new array. */
    public double[] rows() {
        return new double[] {m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23};
    }

    /** The homogeneous matrix, in a new object. */
    public Matrix4d toMatrix4d() {
        return new Matrix4d(m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23, 0, 0, 0, 1);
    }

    /** Whether the other object is a transform with the same matrix. */
    @Override
    public boolean equals(Object other) {
        return other instanceof Transform transform && Arrays.equals(rows(), transform.rows());
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(rows());
    }

    @Override
    public String toString() {
        return "Transform" + Arrays.toString(rows());
    }

    private double[] inverseRows() {
        return new double[] {i00, i01, i02, i03, i10, i11, i12, i13, i20, i21, i22, i23};
    }

    private static double[] product(double[] a, double[] b) {
        double[] result = new double[12];
        for (int row = 0; row < 12; row += 4) {
            for (int column = 0; column < 4; column++) {
                result[row + column] = a[row] * b[column] + a[row + 1] * b[4 + column] + a[row + 2] * b[8 + column];
            }
            result[row + 3] += a[row + 3];
        }
        return result;
    }

    private static double[] invert(double[] m) {
        requireInvertible(m);
        // Working on M/s for a power of two s keeps the cofactors in range at any scale of the scene.
        double s = linearScale(m);
        double a = m[0] / s;
        double b = m[1] / s;
        double c = m[2] / s;
        double d = m[4] / s;
        double e = m[5] / s;
        double f = m[6] / s;
        double g = m[8] / s;
        double h = m[9] / s;
        double i = m[10] / s;
        double factor = 1 / determinant(a, b, c, d, e, f, g, h, i) / s;
        double[] r = new double[12];
        r[0] = Scalars.differenceOfProducts(e, i, f, h) * factor;
        r[1] = Scalars.differenceOfProducts(c, h, b, i) * factor;
        r[2] = Scalars.differenceOfProducts(b, f, c, e) * factor;
        r[4] = Scalars.differenceOfProducts(f, g, d, i) * factor;
        r[5] = Scalars.differenceOfProducts(a, i, c, g) * factor;
        r[6] = Scalars.differenceOfProducts(c, d, a, f) * factor;
        r[8] = Scalars.differenceOfProducts(d, h, e, g) * factor;
        r[9] = Scalars.differenceOfProducts(b, g, a, h) * factor;
        r[10] = Scalars.differenceOfProducts(a, e, b, d) * factor;
        for (int row = 0; row < 12; row += 4) {
            // Adding 0 turns −0 into +0.
            r[row + 3] = -(r[row] * m[3] + r[row + 1] * m[7] + r[row + 2] * m[11]) + 0.0;
        }
        requireFinite(r);
        return r;
    }

    private static void requireFinite(double[] m) {
        for (double entry : m) {
            if (!Double.isFinite(entry)) {
                throw new IllegalArgumentException("transform with an infinite or undefined entry or inverse");
            }
        }
    }

    private static void requireInvertible(double[] m) {
        for (double entry : m) {
            if (!Double.isFinite(entry)) {
                throw new IllegalArgumentException(
                        "transform with an infinite or undefined entry: " + Arrays.toString(m));
            }
        }
        double s = linearScale(m);
        double determinant = Math.abs(normalisedDeterminant(m));
        double rows = length(m[0] / s, m[1] / s, m[2] / s)
                * length(m[4] / s, m[5] / s, m[6] / s)
                * length(m[8] / s, m[9] / s, m[10] / s);
        double columns = length(m[0] / s, m[4] / s, m[8] / s)
                * length(m[1] / s, m[5] / s, m[9] / s)
                * length(m[2] / s, m[6] / s, m[10] / s);
        if (!(determinant > SINGULAR_RATIO * Math.min(rows, columns))) {
            throw new IllegalArgumentException("singular transform (it has no inverse): " + Arrays.toString(m));
        }
    }

    private static double normalisedDeterminant(double[] m) {
        double s = linearScale(m);
        return determinant(m[0] / s, m[1] / s, m[2] / s, m[4] / s, m[5] / s, m[6] / s, m[8] / s, m[9] / s, m[10] / s);
    }

    /** The power of two next below the largest entry of M; 1 for the zero matrix. */
    private static double linearScale(double[] m) {
        double max = 0;
        for (int i = 0; i < 11; i++) {
            if ((i & 3) != 3) {
                max = Math.max(max, Math.abs(m[i]));
            }
        }
        return max > 0 ? Math.scalb(1.0, Math.max(Math.getExponent(max), Double.MIN_EXPONENT)) : 1;
    }

    private static double determinant(
            double a, double b, double c, double d, double e, double f, double g, double h, double i) {
        return a * Scalars.differenceOfProducts(e, i, f, h)
                - b * Scalars.differenceOfProducts(d, i, f, g)
                + c * Scalars.differenceOfProducts(d, h, e, g);
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** The sine of an angle in degrees, exact for multiples of 90. */
    private static double sinDegrees(double degrees) {
        double reduced = Math.IEEEremainder(degrees, 360);
        if (reduced % 90 == 0) {
            return reduced == 90 ? 1 : reduced == -90 ? -1 : 0;
        }
        return Math.sin(Math.toRadians(reduced));
    }
}
