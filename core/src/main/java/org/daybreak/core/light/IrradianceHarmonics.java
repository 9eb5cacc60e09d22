package org.daybreak.core.light;

/**
 * Irradiance of distant light as a function of the normal, to second order in spherical harmonics (Ramamoorthi and Hanrahan, “An
 * Efficient Representation for Irradiance Environment Maps”, SIGGRAPH 2001). Immutable.
 */
final class IrradianceHarmonics {
    /** A concentrated light makes the series negative behind it; some light may come from anywhere. */
    private static final double LEAST_SHARE = 0.01;

    /** Constant, linear (x, y, z) and quadratic (xy, yz, xz, 3z² − 1, x² − y²) coefficients. */
    private final double[] k;

    private final double fluence;

    private IrradianceHarmonics(double[] k, double fluence) {
        this.k = k;
        this.fluence = fluence;
    }

    /** Radiance integrated over all directions. */
    double fluence() {
        return fluence;
    }

    /** Approximate irradiance for a unit normal; positive if the fluence is. */
    double irradiance(double x, double y, double z) {
        double series = k[0]
                + k[1] * x
                + k[2] * y
                + k[3] * z
                + k[4] * x * y
                + k[5] * y * z
                + k[6] * x * z
                + k[7] * (3 * z * z - 1)
                + k[8] * (x * x - y * y);
        return Math.max(series, LEAST_SHARE * fluence);
    }

    /** Adds up distant lights. */
    static final class Builder {
        private final double[] sums = new double[9];

        /** Adds light of an amount (radiance times solid angle) from a unit direction. */
        void add(double amount, double x, double y, double z) {
            sums[0] += amount;
            sums[1] += amount * x;
            sums[2] += amount * y;
            sums[3] += amount * z;
            sums[4] += amount * x * y;
            sums[5] += amount * y * z;
            sums[6] += amount * x * z;
            sums[7] += amount * (3 * z * z - 1);
            sums[8] += amount * (x * x - y * y);
        }

        IrradianceHarmonics build() {
            // Squares of the harmonics' norms times π, 2π/3 and π/4, the coefficients of the clamped cosine.
            double[] k = new double[9];
            k[0] = sums[0] / 4;
            for (int i = 1; i <= 3; i++) {
                k[i] = sums[i] / 2;
            }
            for (int i = 4; i <= 6; i++) {
                k[i] = sums[i] * 15.0 / 16;
            }
            k[7] = sums[7] * 5.0 / 64;
            k[8] = sums[8] * 15.0 / 64;
            return new IrradianceHarmonics(k, sums[0]);
        }
    }
}
