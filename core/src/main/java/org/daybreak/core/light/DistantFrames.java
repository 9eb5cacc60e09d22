package org.daybreak.core.light;

import org.daybreak.core.math.Transform;

/** Rotations of directions, row by row. Pure functions. */
final class DistantFrames {
    private DistantFrames() {}

    /**
     * The rotation or reflection of a transform.
     *
     * @throws IllegalArgumentException if it shears or scales unevenly
     */
    static double[] rotation(Transform toWorld) {
        double[] r = toWorld.rows();
        double[] m = {r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10]};
        double squared = m[0] * m[0] + m[3] * m[3] + m[6] * m[6];
        for (int i = 0; i < 3; i++) {
            for (int j = i; j < 3; j++) {
                double dot = m[i] * m[j] + m[3 + i] * m[3 + j] + m[6 + i] * m[6 + j];
                if (!(Math.abs(dot - (i == j ? squared : 0)) < 1e-4 * squared)) {
                    throw new IllegalArgumentException("the transform of a sky must not shear or scale unevenly");
                }
            }
        }
        double scale = 1 / Math.sqrt(squared);
        for (int i = 0; i < 9; i++) {
            m[i] *= scale;
        }
        return m;
    }

    static void toWorld(double[] m, double x, double y, double z, double[] dest) {
        dest[0] = m[0] * x + m[1] * y + m[2] * z;
        dest[1] = m[3] * x + m[4] * y + m[5] * z;
        dest[2] = m[6] * x + m[7] * y + m[8] * z;
    }

    static double localX(double[] m, double wx, double wy, double wz) {
        return m[0] * wx + m[3] * wy + m[6] * wz;
    }

    static double localY(double[] m, double wx, double wy, double wz) {
        return m[1] * wx + m[4] * wy + m[7] * wz;
    }

    static double localZ(double[] m, double wx, double wy, double wz) {
        return m[2] * wx + m[5] * wy + m[8] * wz;
    }
}
