package org.daybreak.core.accel;

/** Affine maps as 12 doubles, the rows of a 3×4 matrix one after the other. */
final class Affine {
    private Affine() {}

    /**
     * Checks that both matrices are finite and that they are inverse to each other.
     *
     * @throws IllegalArgumentException if not
     */
    static void check(double[] objectToWorld, double[] worldToObject) {
        checkFinite(objectToWorld, "objectToWorld");
        checkFinite(worldToObject, "worldToObject");
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 4; column++) {
                double sum = column == 3 ? worldToObject[4 * row + 3] : 0;
                double magnitude = Math.abs(sum);
                for (int k = 0; k < 3; k++) {
                    double product = worldToObject[4 * row + k] * objectToWorld[4 * k + column];
                    sum += product;
                    magnitude += Math.abs(product);
                }
                double expected = row == column ? 1 : 0;
                if (!(Math.abs(sum - expected) <= 1e-6 * Math.max(1, magnitude))) {
                    throw new IllegalArgumentException("worldToObject is not the inverse of objectToWorld: the product"
                            + " has " + sum + " at row " + row + ", column " + column + " instead of " + expected);
                }
            }
        }
    }

    private static void checkFinite(double[] matrix, String name) {
        if (matrix.length != 12) {
            throw new IllegalArgumentException(name + " has " + matrix.length + " entries instead of 12");
        }
        for (int i = 0; i < 12; i++) {
            if (!Double.isFinite(matrix[i])) {
                throw new IllegalArgumentException(name + " holds " + matrix[i] + " at entry " + i);
            }
        }
    }

    /**
     * Inverse of an affine map.
     *
     * @throws IllegalArgumentException if the map is singular or not finite
     */
    static double[] invert(double[] m) {
        checkFinite(m, "transform");
        double c00 = m[5] * m[10] - m[6] * m[9];
        double c01 = m[6] * m[8] - m[4] * m[10];
        double c02 = m[4] * m[9] - m[5] * m[8];
        double determinant = m[0] * c00 + m[1] * c01 + m[2] * c02;
        double inverse = 1 / determinant;
        double[] r = new double[12];
        r[0] = c00 * inverse;
        r[1] = (m[2] * m[9] - m[1] * m[10]) * inverse;
        r[2] = (m[1] * m[6] - m[2] * m[5]) * inverse;
        r[4] = c01 * inverse;
        r[5] = (m[0] * m[10] - m[2] * m[8]) * inverse;
        r[6] = (m[2] * m[4] - m[0] * m[6]) * inverse;
        r[8] = c02 * inverse;
        r[9] = (m[1] * m[8] - m[0] * m[9]) * inverse;
        r[10] = (m[0] * m[5] - m[1] * m[4]) * inverse;
        for (int row = 0; row < 12; row += 4) {
            r[row + 3] = -(r[row] * m[3] + r[row + 1] * m[7] + r[row + 2] * m[11]);
        }
        for (double entry : r) {
            if (!Double.isFinite(entry)) {
                throw new IllegalArgumentException("transform is singular: its determinant is " + determinant);
            }
        }
        return r;
    }

    /** Greatest float not above the value. */
    static float roundDown(double value) {
        float rounded = (float) value;
        return rounded > value ? Math.nextDown(rounded) : rounded;
    }

    /** Least float not below the value. */
    static float roundUp(double value) {
        float rounded = (float) value;
        return rounded < value ? Math.nextUp(rounded) : rounded;
    }
}
