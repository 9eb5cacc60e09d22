package org.daybreak.core.geometry;

/** Facts about the linear part of 3×4 matrices, row by row. */
final class LinearMaps {
    /** Relative deviation from a similarity that counts as rounding of a matrix in a scene file. */
    private static final double ROUNDING = 1e-6;

    private LinearMaps() {}

    static double determinant(double[] m) {
        return m[0] * (m[5] * m[10] - m[6] * m[9])
                - m[1] * (m[4] * m[10] - m[6] * m[8])
                + m[2] * (m[4] * m[9] - m[5] * m[8]);
    }

    /** Whether the map is a rotation or mirroring times a uniform scale: MᵀM is a multiple of the identity. */
    static boolean isSimilarity(double[] m) {
        double xx = columns(m, 0, 0);
        double yy = columns(m, 1, 1);
        double zz = columns(m, 2, 2);
        double most = ROUNDING * Math.max(xx, Math.max(yy, zz));
        return Math.abs(xx - yy) <= most
                && Math.abs(yy - zz) <= most
                && Math.abs(columns(m, 0, 1)) <= most
                && Math.abs(columns(m, 0, 2)) <= most
                && Math.abs(columns(m, 1, 2)) <= most;
    }

    /**
     * Largest |Mx| for unit x, rounded up: the root of the largest eigenvalue of MᵀM (Smith, “Eigenvalues of a symmetric 3×3
     * matrix”, CACM 4(4), 1961).
     */
    static double largestStretch(double[] m) {
        double xy = columns(m, 0, 1);
        double xz = columns(m, 0, 2);
        double yz = columns(m, 1, 2);
        double mean = (columns(m, 0, 0) + columns(m, 1, 1) + columns(m, 2, 2)) / 3;
        double xx = columns(m, 0, 0) - mean;
        double yy = columns(m, 1, 1) - mean;
        double zz = columns(m, 2, 2) - mean;
        double p = Math.sqrt((xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz)) / 6);
        if (!(p > 0)) {
            return Math.sqrt(mean);
        }
        double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
        double r = Math.max(-1, Math.min(1, determinant / (2 * p * p * p)));
        double largest = mean + 2 * p * Math.cos(Math.acos(r) / 3);
        return Math.sqrt(largest) * (1 + 1e-9);
    }

    private static double columns(double[] m, int i, int j) {
        return m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j];
    }
}
